//! A piece of a complex, taken out to try changes on and put back when they are good.
//!
//! ```text
//!     ·───·───·───·                       The piece has a boundary of its own, with ghosts, so no change reaches beyond it.
//!    / \ / \▒/▒\ / \        ·───·         What is done to it may move, add and remove vertices inside and
//!   ·───·───·───·───·  <──   ▒\▒/▒        triangles; the edges of its rim are there afterwards too, and
//!    \ / \ / \▒/ \ /           ·          that is where it is glued in again.
//! ```

use super::complex::Complex2;
use super::mesh::{Face, TriMesh};
use super::subcomplex::across_outside;
use crate::ids::{FaceId, HalfEdgeId, VertexId};
use rustc_hash::FxHashMap;

/// A piece of a complex and where it came from.
///
/// ```
/// use delaunay_core::{Complex2, Delaunay2, Subcomplex2, VertexId};
/// use glam::DVec2;
///
/// let corners = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0], [1.0, 2.0]].map(DVec2::from);
/// let mut square = Complex2::of(Subcomplex2::of(&Delaunay2::build(&corners)?, |_| true));
/// let all: Vec<_> = square.faces().collect();
/// let piece = square.piece(&all);
/// let inner = piece.local(VertexId::new(4)).unwrap();
///
/// let mut changed = piece.complex().clone();
/// changed.remove(inner);
/// square.put_back(&piece, &changed);
/// assert_eq!((square.faces().count(), square.check()), (2, Ok(())));
/// # Ok::<(), delaunay_core::BuildError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Piece2 {
    complex: Complex2,
    /// By vertex of the piece, that of the whole.
    vertices: Vec<VertexId>,
    locals: FxHashMap<VertexId, VertexId>,
    /// The faces of the whole that make the piece.
    faces: Vec<FaceId>,
    /// The rim: ends in the piece, with the piece on the left, and the half-edge on the other side.
    rim: Vec<([VertexId; 2], HalfEdgeId)>,
}

impl Piece2 {
    /// The piece as it was taken out. Its vertices are numbered on their own; those on its rim are fixed.
    #[must_use]
    pub fn complex(&self) -> &Complex2 {
        &self.complex
    }

    /// The vertex of the piece that a vertex of the whole is; `None` when it is not in the piece.
    #[must_use]
    pub fn local(&self, v: VertexId) -> Option<VertexId> {
        self.locals.get(&v).copied()
    }

    /// The vertices of the whole that are in the piece, by vertex of the piece.
    #[must_use]
    pub fn vertices(&self) -> &[VertexId] {
        &self.vertices
    }
}

impl Complex2 {
    /// Takes out the triangles listed, none twice and no ghost. Takes time proportional to their number, and at a rim
    /// vertex to its degree for each rim edge.
    ///
    /// # Panics
    /// When there is no such face.
    #[must_use]
    pub fn piece(&self, faces: &[FaceId]) -> Piece2 {
        let old = self.mesh();
        let renamed: FxHashMap<FaceId, FaceId> = faces
            .iter()
            .enumerate()
            .map(|(k, &f)| (f, FaceId::new(k)))
            .collect();
        let (mut vertices, mut locals) = (Vec::new(), FxHashMap::default());
        let mut mesh = TriMesh::default();
        for &f in faces {
            let corners = old.face_vertices(f).map(|v| {
                *locals.entry(v).or_insert_with(|| {
                    vertices.push(v);
                    VertexId::new(vertices.len() - 1)
                })
            });
            mesh.push_face(corners);
        }
        let inside = |h: HalfEdgeId| Some(renamed.get(&h.face())?.half_edge(h.corner()));
        let mut rim = Vec::new();
        let mut ghosts = FxHashMap::default();
        for h in faces.iter().flat_map(|f| f.half_edges()) {
            let Some(here) = inside(h) else { continue };
            if let Some(twin) = inside(old.twin(h)) {
                mesh.set_twin(here, twin);
            } else {
                let ends = [mesh.origin(here), mesh.target(here)];
                let ghost = mesh.push_face([ends[1], ends[0], VertexId::GHOST]);
                mesh.glue(here, ghost.half_edge(0));
                ghosts.insert(h, ghost);
                rim.push((h, ends, old.twin(h)));
            }
        }
        for (h, ..) in &rim {
            let before = across_outside(old, *h, |g| inside(g).is_some());
            if let (Some(ghost), Some(other)) = (ghosts.get(h), ghosts.get(&before)) {
                mesh.glue(ghost.half_edge(1), other.half_edge(2));
            }
        }
        let coords = [VertexId::GHOST].iter().chain(&vertices);
        let coords = coords.map(|v| self.place_of(*v)).collect();
        mesh.index_vertices(vertices.len() + 1);
        Piece2 {
            complex: Self::in_boundary(coords, mesh, Vec::new()),
            vertices,
            locals,
            faces: faces.to_vec(),
            rim: rim
                .into_iter()
                .map(|(_, ends, outer)| (ends, outer))
                .collect(),
        }
    }

    /// Puts a piece back with what has been changed in it. The whole must not have changed since the piece was taken out, and
    /// `changed` must come from it by moves, flips, insertions and removals.
    ///
    /// Vertices that are new in the piece get ids of the whole; faces take ids of the piece, then new ones, and the last
    /// faces move into ids left over.
    pub fn put_back(&mut self, piece: &Piece2, changed: &Self) {
        let names = self.names_of(piece, changed);
        let made: Vec<FaceId> = changed.faces().collect();
        let mut slots = piece.faces.clone();
        slots.sort_unstable();
        let left_over = slots.split_off(made.len().min(slots.len()));
        while slots.len() < made.len() {
            slots.push(self.mesh_mut().push_face([VertexId::GHOST; 3]));
        }
        let slot_of: FxHashMap<FaceId, FaceId> = made.iter().copied().zip(slots).collect();
        let there = |h: HalfEdgeId| Some(slot_of.get(&h.face())?.half_edge(h.corner()));
        for &f in &made {
            let origin = changed.mesh().face_vertices(f).map(|v| names[v.index()]);
            let twins = f.half_edges().map(|h| there(changed.mesh().twin(h)));
            let slot = slot_of[&f];
            let own = slot.half_edges();
            let twin = [0, 1, 2].map(|k| twins[k].unwrap_or(own[k]));
            self.mesh_mut().faces[slot.index()] = Face { origin, twin };
            own.into_iter()
                .for_each(|h| self.mesh_mut().set_outgoing(h));
        }
        for &([a, b], outer) in &piece.rim {
            // Along a cut a ghost has a half-edge with these ends, too.
            let leaving = changed.mesh().around(a);
            let mut here = leaving.filter(|&h| changed.mesh().target(h) == b);
            if let Some(here) = here.find_map(there) {
                self.mesh_mut().glue(here, outer);
            }
        }
        for f in left_over.into_iter().rev() {
            self.mesh_mut().swap_remove_face(f);
        }
    }

    /// The vertices of the whole that those of a changed piece are; removes and moves what is removed and moved.
    fn names_of(&mut self, piece: &Piece2, changed: &Self) -> Vec<VertexId> {
        let mut names = piece.vertices.clone();
        for (k, &v) in piece.vertices.iter().enumerate() {
            let local = VertexId::new(k);
            match changed.mesh().outgoing(local) {
                Some(_) => self.put(v, changed.point(local)),
                None => self.forget(v),
            }
        }
        for k in names.len()..changed.points().len() {
            let local = VertexId::new(k);
            names.push(match changed.mesh().outgoing(local) {
                Some(_) => self.name_vertex(changed.point(local)),
                None => VertexId::GHOST,
            });
        }
        // A vertex that was removed and whose id another one took in the piece is that one.
        names
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tri::{Delaunay2, Subcomplex2};
    use glam::DVec2;

    fn grid() -> Complex2 {
        let places = (0..64).map(|i| {
            let [x, y] = [i % 8, i / 8].map(f64::from);
            DVec2::new(x + 0.1 * (3.0 * y).sin(), y + 0.1 * (5.0 * x).cos())
        });
        let delaunay = Delaunay2::build(&places.collect::<Vec<_>>()).unwrap();
        Complex2::of(Subcomplex2::of(&delaunay, |_| true))
    }

    fn around(complex: &Complex2, v: usize) -> Vec<FaceId> {
        let mesh = complex.mesh();
        let mut faces: Vec<FaceId> = mesh
            .neighbors(VertexId::new(v))
            .filter(|w| !w.is_ghost())
            .flat_map(|w| mesh.star(w))
            .filter(|&f| !mesh.is_ghost_face(f))
            .collect();
        faces.sort_unstable();
        faces.dedup();
        faces
    }

    #[test]
    fn a_piece_put_back_unchanged_changes_nothing() {
        for v in 0..64 {
            let mut whole = grid();
            let before = whole.mesh().canonical();
            let piece = whole.piece(&around(&whole, v));
            assert_eq!(piece.complex().check(), Ok(()), "{v}");
            let same = piece.complex().clone();
            whole.put_back(&piece, &same);
            assert_eq!(whole.check(), Ok(()));
            assert_eq!(whole.mesh().canonical(), before);
        }
    }

    #[test]
    fn what_is_done_to_a_piece_is_done_to_the_whole() {
        let mut whole = grid();
        let area = |complex: &Complex2| {
            let areas = complex.faces().map(|f| {
                let [a, b, c] = complex.triangle(f);
                (b - a).perp_dot(c - a)
            });
            areas.sum::<f64>()
        };
        let before = area(&whole);
        for v in [9, 18, 27, 36, 45, 54] {
            let piece = whole.piece(&around(&whole, v));
            let mut changed = piece.complex().clone();
            let inner: Vec<VertexId> = changed.inner_vertices().collect();
            let first = changed.faces().next().unwrap();
            let center = changed.triangle(first).into_iter().sum::<DVec2>() / 3.0;
            let removed = v % 2 == 0 && inner.first().is_some_and(|&v| changed.remove(v).is_some());
            let inserted = !removed && changed.insert(center, first).is_some();
            let h = changed
                .mesh()
                .half_edges()
                .find(|&h| changed.clone().flip(h).is_some());
            assert!(changed.flip(h.unwrap()).is_some());
            let count = whole.faces().count();
            whole.put_back(&piece, &changed);
            assert_eq!(whole.check(), Ok(()));
            let grown = 2 * usize::from(inserted) + count - 2 * usize::from(removed);
            assert_eq!(whole.faces().count(), grown);
            assert!((area(&whole) - before).abs() < 1e-9);
        }
    }
}
