//! Removal of a vertex: the hole that its star leaves is filled with the triangulation of its link
//! (Devillers and Teillaud 2003, *Perturbations and vertex removal*).
//!
//! The vertices of the link are triangulated on their own, ghosts included, with the same ties. Because
//! ties depend on coordinates alone, every edge of the link is an edge of that triangulation and its
//! faces inside the link are those that fill the hole. Link vertices are numbered in order round the
//! hole, so an edge of the link is recognised by its ends: `i -> i + 1`.
//!
//! What comes back: `remove(v)` followed by the insertion of the same point gives the point its id
//! again and restores the faces, so the [`canonical`](super::TriMesh::canonical) meshes are equal bit
//! for bit. Face ids are not restored: the faces that remain move to keep ids dense.

use super::delaunay::Delaunay2;
use super::mesh::TriMesh;
use crate::error::{BuildError, RemoveError};
use crate::ids::{FaceId, HalfEdgeId, VertexId};
use glam::DVec2;

impl Delaunay2 {
    /// Removes `v` from the triangulation.
    ///
    /// Its id goes to the next vertex inserted; ids vacated later are taken first. The faces that fill
    /// the hole take ids of the star, and the last two faces may move into the two ids left over. Input
    /// points that were duplicates of `v` are forgotten with it. Takes d log d time for a vertex of
    /// degree d, and log n for each of its duplicates.
    ///
    /// # Errors
    /// [`RemoveError`] when `v` is no vertex, or the rest would lie on one line; nothing has changed
    /// then.
    ///
    /// ```
    /// # use delaunay_core::{Delaunay2, RemoveError, VertexId};
    /// # use glam::DVec2;
    /// let points = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0], [1.0, 2.0]];
    /// let mut delaunay = Delaunay2::build(&points.map(DVec2::from))?;
    /// let before = delaunay.mesh().canonical();
    /// delaunay.remove(VertexId::new(4))?;
    /// assert_eq!(delaunay.faces().count(), 2);
    /// let _ = delaunay.insert(DVec2::new(1.0, 2.0))?;
    /// assert_eq!(delaunay.mesh().canonical(), before);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn remove(&mut self, v: VertexId) -> Result<(), RemoveError> {
        if !self.contains_vertex(v) {
            return Err(RemoveError::NoSuchVertex { vertex: v });
        }
        let hole = Hole::of(&self.mesh, v);
        let patch = match Delaunay2::build(&hole.real_points(self)) {
            Ok(link) => link.mesh,
            Err(BuildError::Flat(_)) if !hole.is_all(&self.mesh) => hole.flat_patch(),
            Err(_) => return Err(RemoveError::RestIsFlat { vertex: v }),
        };
        hole.close(&patch, &hole.faces_inside(&patch), &mut self.mesh);
        self.mesh.forget_vertex(v);
        self.duplicates.forget(v);
        self.vacant.push(v);
        self.guide.note_change();
        Ok(())
    }
}

/// What the removal of a vertex did to the faces.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Refilled {
    /// The new faces.
    pub made: Vec<FaceId>,
    /// The faces that took the ids left over, each by its id before and after; one may move twice, one after the other.
    /// New faces may be among them; `made` has their last ids.
    pub moved: Vec<(FaceId, FaceId)>,
}

impl Refilled {
    /// Takes note that the face `old` becomes `new`.
    pub(super) fn note_move(&mut self, old: FaceId, new: FaceId) {
        if old != new {
            self.moved.push((old, new));
            let made = self.made.iter_mut().filter(|f| **f == old);
            made.for_each(|f| *f = new);
        }
    }
}

/// The hole that the star of a vertex leaves.
#[derive(Clone, Debug)]
pub(super) struct Hole {
    /// The star, whose slots are filled again; two are left over.
    pub(super) star: Vec<FaceId>,
    /// The vertices round the hole, counterclockwise, the ghost first if it is one of them.
    vertices: Vec<VertexId>,
    /// For each of `vertices` the half-edge outside the hole that ends there.
    outer: Vec<HalfEdgeId>,
}

impl Hole {
    pub(super) fn of(mesh: &TriMesh, v: VertexId) -> Self {
        let mut link: Vec<HalfEdgeId> = mesh.link(v).collect();
        if let Some(ghost) = link.iter().position(|&h| mesh.origin(h).is_ghost()) {
            link.rotate_left(ghost);
        }
        Self {
            star: link.iter().map(|h| h.face()).collect(),
            vertices: link.iter().map(|&h| mesh.origin(h)).collect(),
            outer: link.iter().map(|&h| mesh.twin(h)).collect(),
        }
    }

    /// The real vertices round the hole.
    pub(super) fn real(&self) -> &[VertexId] {
        match self.vertices.split_first() {
            Some((first, rest)) if first.is_ghost() => rest,
            _ => &self.vertices,
        }
    }

    fn real_points(&self, delaunay: &Delaunay2) -> Vec<DVec2> {
        self.real().iter().map(|&v| delaunay.point(v)).collect()
    }

    /// Whether all triangles of the mesh are in the hole: nothing but ghosts lies round it.
    fn is_all(&self, mesh: &TriMesh) -> bool {
        self.outer.iter().all(|h| mesh.is_ghost_face(h.face()))
    }

    /// The patch for a hole whose real vertices lie on one line: a ghost on each edge of the line.
    fn flat_patch(&self) -> TriMesh {
        let mut patch = TriMesh::default();
        for end in 1..self.real().len() {
            let corners = [VertexId::new(end - 1), VertexId::new(end), VertexId::GHOST];
            let ghost = patch.push_face(corners);
            if ghost.index() > 0 {
                let before = FaceId::new(ghost.index() - 1);
                patch.glue(before.half_edge(1), ghost.half_edge(2));
            }
        }
        patch
    }

    /// Fills the hole with the faces `inside` of `patch`, those that [`faces_inside`](Self::faces_inside) gives.
    ///
    /// Vertex `i` of the patch is `real()[i]`.
    pub(super) fn close(&self, patch: &TriMesh, inside: &[FaceId], mesh: &mut TriMesh) -> Refilled {
        debug_assert_eq!(inside.len() + 2, self.star.len());
        let mut slots = vec![None; patch.face_count()];
        for (&f, &slot) in inside.iter().zip(&self.star) {
            slots[f.index()] = Some(slot);
            mesh.faces[slot.index()].origin = patch.face_vertices(f).map(|v| self.name(v));
        }
        for f in inside {
            for h in f.half_edges() {
                let Some(slot) = slots[f.index()] else {
                    continue;
                };
                let here = slot.half_edge(h.corner());
                let twin = patch.twin(h);
                match (self.link_edge(patch, h), slots[twin.face().index()]) {
                    (Some(edge), _) => mesh.glue(here, self.outer[edge]),
                    (None, Some(slot)) => mesh.glue(here, slot.half_edge(twin.corner())),
                    (None, None) => {}
                }
                mesh.set_outgoing(here);
            }
        }
        let (made, left_over) = self.star.split_at(inside.len());
        let mut refilled = Refilled {
            made: made.to_vec(),
            moved: Vec::new(),
        };
        let mut left_over = left_over.to_vec();
        left_over.sort_unstable();
        for f in left_over.into_iter().rev() {
            refilled.note_move(FaceId::new(mesh.face_count() - 1), f);
            mesh.swap_remove_face(f);
        }
        refilled
    }

    /// The faces of the patch inside the link: reached from one of them across other edges.
    pub(super) fn faces_inside(&self, patch: &TriMesh) -> Vec<FaceId> {
        let mut seen = vec![false; patch.face_count()];
        let mut inside = Vec::new();
        let first = patch
            .half_edges()
            .find(|&h| self.link_edge(patch, h).is_some());
        let mut pending: Vec<FaceId> = first.map(HalfEdgeId::face).into_iter().collect();
        while let Some(f) = pending.pop() {
            if std::mem::replace(&mut seen[f.index()], true) {
                continue;
            }
            inside.push(f);
            let inner = f.half_edges().into_iter();
            let inner = inner.filter(|&h| self.link_edge(patch, h).is_none());
            pending.extend(inner.map(|h| patch.twin(h).face()));
        }
        inside
    }

    /// The number of the link edge that the half-edge `h` of the patch lies on, hole on its left.
    fn link_edge(&self, patch: &TriMesh, h: HalfEdgeId) -> Option<usize> {
        let start = self.place(patch.origin(h))?;
        let end = self.place(patch.target(h))?;
        (end == (start + 1) % self.vertices.len()).then_some(start)
    }

    /// The vertex that `v` of the patch stands for.
    pub(super) fn name(&self, v: VertexId) -> VertexId {
        self.real()
            .get(v.index())
            .copied()
            .unwrap_or(VertexId::GHOST)
    }

    /// Where the vertex `v` of the patch comes in `vertices`; `None` for the ghost of the patch
    /// when it is not one of them.
    fn place(&self, v: VertexId) -> Option<usize> {
        let ghosts = self.vertices.len() - self.real().len();
        match v.is_ghost() {
            true => (ghosts == 1).then_some(0),
            false => Some(v.index() + ghosts),
        }
    }
}
