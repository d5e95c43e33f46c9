//! Removal of a vertex: the hole that its star leaves is filled with the triangulation of its link
//! (Devillers and Teillaud 2003, *Perturbations and vertex removal*).
//!
//! The vertices of the link are triangulated on their own, ghosts included, with the same ties. Because
//! ties depend on coordinates alone, every facet of the link is a facet of that triangulation. Inserted
//! there, the vertex would have the same star as before; so the tetrahedra that fill the hole are its
//! cavity in the triangulation of its link.
//!
//! A link on one plane has no triangulation. Then the vertex was the only one on its side of the plane,
//! and ghosts on the facets of the link fill the hole.
//!
//! What comes back: `remove(v)` followed by the insertion of the same point gives the point its id
//! again and restores the tetrahedra, so the [`canonical`](super::TetMesh::canonical) meshes are equal
//! bit for bit.

use super::delaunay::Delaunay3;
use super::mesh::TetMesh;
use crate::error::{BuildError, RemoveError};
use crate::ids::{FacetId, TetId, VertexId};
use glam::DVec3;

/// Greatest number of link vertices to be triangulated as they come, in quadratic time at worst.
const FEW: usize = 256;

impl Delaunay3 {
    /// Removes `v` from the triangulation.
    ///
    /// Its id goes to the next vertex inserted; ids vacated later are taken first. The tetrahedra that
    /// fill the hole take ids of the star, then vacant and new ones; ids left over are vacated, all other
    /// tetrahedra keep theirs. Input points that were duplicates of `v` are forgotten with it.
    ///
    /// Takes the time to triangulate the neighbours of `v`, of which there are about 15 in evenly spread
    /// points, and log n for each of its duplicates.
    ///
    /// # Errors
    /// [`RemoveError`] when `v` is no vertex, the rest would lie on one plane, or ids run out; nothing
    /// has changed then.
    ///
    /// ```
    /// # use delaunay_core::{Delaunay3, VertexId};
    /// # use glam::DVec3;
    /// let points = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z, DVec3::splat(0.2)];
    /// let mut delaunay = Delaunay3::build(&points)?;
    /// let before = delaunay.mesh().canonical();
    /// delaunay.remove(VertexId::new(4))?;
    /// assert_eq!(delaunay.tets().count(), 1);
    /// let _ = delaunay.insert(DVec3::splat(0.2))?;
    /// assert_eq!(delaunay.mesh().canonical(), before);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn remove(&mut self, v: VertexId) -> Result<(), RemoveError> {
        if !self.contains_vertex(v) {
            return Err(RemoveError::NoSuchVertex { vertex: v });
        }
        let hole = Hole::of(&self.mesh, v);
        let patch = match self.triangulate_few_or_many(&hole.real)? {
            Some(link) => hole.cavity_in(&link, self.point(v)),
            None if hole.is_all(&self.mesh) => {
                return Err(RemoveError::RestIsFlat { vertex: v });
            }
            None => hole.ghosts(&self.mesh),
        };
        let limit = TetId::LIMIT;
        let closed = self.mesh.exchange(&hole.star, &hole.outer, &patch);
        closed.ok_or(RemoveError::TooManyTets { limit })?;
        self.mesh.forget_vertex(v);
        self.duplicates.forget(v);
        self.vacant.push(v);
        self.vertex_count -= 1;
        self.guide.note_change();
        Ok(())
    }

    /// The triangulation of some vertices, numbered as given; `None` when they lie on one plane.
    fn triangulate_few_or_many(&self, vertices: &[VertexId]) -> Result<Option<Self>, RemoveError> {
        let points = vertices.iter().map(|&v| self.point(v));
        if vertices.len() <= FEW {
            return Ok(Self::grow_few(points).ok());
        }
        match Self::build(&points.collect::<Vec<DVec3>>()) {
            Ok(link) => Ok(Some(link)),
            Err(BuildError::Flat(_)) => Ok(None),
            Err(_) => Err(RemoveError::TooManyTets {
                limit: TetId::LIMIT,
            }),
        }
    }
}

/// The hole that the star of a vertex leaves.
pub(super) struct Hole {
    pub(super) star: Vec<TetId>,
    /// The facets round the hole, each by its outer side.
    pub(super) outer: Vec<FacetId>,
    /// The vertices round the hole, each once, without the ghost.
    pub(super) real: Vec<VertexId>,
}

impl Hole {
    pub(super) fn of(mesh: &TetMesh, v: VertexId) -> Self {
        let (mut star, mut outer) = (Vec::new(), Vec::new());
        let mut real = Vec::new();
        for facet in mesh.link(v) {
            star.push(facet.tet());
            outer.push(mesh.twin(facet));
            real.extend(mesh.facet_vertices(facet));
        }
        real.sort_unstable();
        real.dedup();
        real.retain(|v| !v.is_ghost());
        Self { star, outer, real }
    }

    /// Whether all tetrahedra of the mesh are in the hole: nothing but ghosts lies round it.
    fn is_all(&self, mesh: &TetMesh) -> bool {
        self.outer.iter().all(|f| mesh.is_ghost_tet(f.tet()))
    }

    /// The patch for a hole whose vertex was at `p`: the cavity of `p` among the vertices of the link.
    pub(super) fn cavity_in(&self, link: &Delaunay3, p: DVec3) -> Vec<[VertexId; 4]> {
        // Slot 0 is the ghost in both numberings.
        let name = |v: VertexId| match v.slot().checked_sub(1) {
            Some(index) => self.real[index],
            None => VertexId::GHOST,
        };
        let cavity = link.cavity(p).unwrap_or_default();
        let tets = cavity.tets().iter();
        tets.map(|&t| link.mesh.tet_vertices(t).map(name)).collect()
    }

    /// The patch for a hole whose vertices lie on one plane: a ghost on each facet of the plane.
    fn ghosts(&self, mesh: &TetMesh) -> Vec<[VertexId; 4]> {
        let facets = self.outer.iter().map(|&f| mesh.facet_vertices(f));
        let real = facets.filter(|corners| !corners.contains(&VertexId::GHOST));
        real.map(|[a, b, c]| [a, b, c, VertexId::GHOST]).collect()
    }
}
