//! Triangles glued along half-edges: connectivity only, no coordinates.
//!
//! ```text
//!             c                half-edge 4f     runs from corner 0 to corner 1
//!           /   \              half-edge 4f + 1 runs from corner 1 to corner 2
//!   4f+2  /   f   \  4f+1      half-edge 4f + 2 runs from corner 2 to corner 0
//!       /           \
//!      a ----------- b         corners [a, b, c] counterclockwise, f on the left of all three
//!            4f
//! ```
//!
//! A face is one record of 24 bytes: three origins and three twins. Everything else about a
//! half-edge is arithmetic on its number, see [`HalfEdgeId`].

use crate::ids::{FaceId, HalfEdgeId, VertexId};

/// What is stored of a face: the origin and the twin of its three half-edges.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Face {
    pub(super) origin: [VertexId; 3],
    pub(super) twin: [HalfEdgeId; 3],
}

impl Face {
    /// No face.
    pub(super) const VACANT: Self = Self {
        origin: [VertexId::GHOST; 3],
        twin: [HalfEdgeId::NONE; 3],
    };
}

/// Triangles glued along half-edges into a closed surface: connectivity only, no coordinates.
///
/// Invariants ([`check`](TriMesh::check) names the first one broken):
/// 1. `twin(twin(h)) == h` and `twin(h) != h`;
/// 2. `twin(h)` runs from `target(h)` to `origin(h)`;
/// 3. [`outgoing`](TriMesh::outgoing) of a vertex leaves that vertex.
///
/// Methods that take an id panic when the mesh has no such element: ids come from the mesh, and a
/// face or half-edge id is good until faces are next added, refilled or removed.
///
/// ```
/// use delaunay_core::{TriMesh, VertexId};
///
/// // Two triangles glued back to back: the smallest closed surface.
/// let [a, b, c] = [0, 1, 2].map(VertexId::new);
/// let mut mesh = TriMesh::default();
/// let front = mesh.push_face([a, b, c]);
/// let back = mesh.push_face([a, c, b]);
/// for (i, j) in [(0, 2), (1, 1), (2, 0)] {
///     mesh.glue(front.half_edge(i), back.half_edge(j));
/// }
/// mesh.half_edges().for_each(|h| mesh.set_outgoing(h));
/// assert_eq!(mesh.check(), Ok(()));
/// assert_eq!(mesh.neighbors(a).count(), 2);
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct TriMesh {
    pub(super) faces: Vec<Face>,
    /// By vertex slot, the ghost in front; empty while a bulk build runs.
    pub(super) outgoing: Vec<HalfEdgeId>,
}

impl TriMesh {
    /// The vertex that `h` leaves.
    #[must_use]
    pub fn origin(&self, h: HalfEdgeId) -> VertexId {
        self.faces[h.face().index()].origin[h.corner()]
    }

    /// The vertex that `h` runs to.
    #[must_use]
    pub fn target(&self, h: HalfEdgeId) -> VertexId {
        self.origin(h.next())
    }

    /// The vertex across the face of `h`: the corner that `h` does not touch.
    #[must_use]
    pub fn apex(&self, h: HalfEdgeId) -> VertexId {
        self.origin(h.prev())
    }

    /// The other side of the edge of `h`.
    #[must_use]
    pub fn twin(&self, h: HalfEdgeId) -> HalfEdgeId {
        self.faces[h.face().index()].twin[h.corner()]
    }

    /// The half-edge that follows `h` counterclockwise round its face.
    #[must_use]
    pub fn next(&self, h: HalfEdgeId) -> HalfEdgeId {
        h.next()
    }

    /// The half-edge before `h` counterclockwise round its face.
    #[must_use]
    pub fn prev(&self, h: HalfEdgeId) -> HalfEdgeId {
        h.prev()
    }

    /// The face on the left of `h`.
    #[must_use]
    pub fn face(&self, h: HalfEdgeId) -> FaceId {
        h.face()
    }

    /// The corners of `f`, counterclockwise, from corner 0.
    #[must_use]
    pub fn face_vertices(&self, f: FaceId) -> [VertexId; 3] {
        self.faces[f.index()].origin
    }

    /// Whether the vertex at infinity is a corner of `f`.
    #[must_use]
    pub fn is_ghost_face(&self, f: FaceId) -> bool {
        self.face_vertices(f).contains(&VertexId::GHOST)
    }

    /// The half-edge of the ghost face `f` whose two ends are real, with the hull on its right.
    ///
    /// `None` when `f` is not a ghost.
    #[must_use]
    pub fn ghost_base(&self, f: FaceId) -> Option<HalfEdgeId> {
        let ghost = self.face_vertices(f).iter().position(|&v| v.is_ghost())?;
        Some(f.half_edge(ghost).next())
    }

    /// The number of faces, ghosts included.
    #[must_use]
    pub fn face_count(&self) -> usize {
        self.faces.len()
    }

    /// All faces, ghosts included, by id.
    pub fn faces(
        &self,
    ) -> impl ExactSizeIterator<Item = FaceId> + DoubleEndedIterator + Clone + use<> {
        (0..self.faces.len()).map(FaceId::new)
    }

    /// All half-edges, those of ghosts included, by id.
    pub fn half_edges(&self) -> impl Iterator<Item = HalfEdgeId> + Clone + use<> {
        self.faces().flat_map(FaceId::half_edges)
    }

    /// A half-edge that leaves `v`; `None` when `v` is not in the mesh.
    #[must_use]
    pub fn outgoing(&self, v: VertexId) -> Option<HalfEdgeId> {
        let h = *self.outgoing.get(v.slot())?;
        (h != HalfEdgeId::NONE).then_some(h)
    }

    /// The half-edge from `from` to `to`, if there is an edge between them.
    ///
    /// Takes time proportional to the degree of `from`.
    #[must_use]
    pub fn find_half_edge(&self, from: VertexId, to: VertexId) -> Option<HalfEdgeId> {
        self.around(from).find(|&h| self.target(h) == to)
    }
}

/// Surgery. Between calls the invariants may be broken; the caller restores them.
impl TriMesh {
    /// Adds a face that is not glued to anything yet: each half-edge is its own twin.
    ///
    /// # Panics
    /// When there are [`FaceId::LIMIT`] faces already.
    pub fn push_face(&mut self, corners: [VertexId; 3]) -> FaceId {
        let f = FaceId::new(self.faces.len());
        self.faces.push(Face {
            origin: corners,
            twin: f.half_edges(),
        });
        f
    }

    /// Makes `g` and `h` twins.
    pub fn glue(&mut self, g: HalfEdgeId, h: HalfEdgeId) {
        self.set_twin(g, h);
        self.set_twin(h, g);
    }

    /// Makes `h` the half-edge that [`outgoing`](TriMesh::outgoing) gives for its origin.
    ///
    /// Vertices are numbered without great gaps: one whose number is far beyond the corners of all faces gets no
    /// half-edge, so that a wild id asks for no memory; [`check`](TriMesh::check) names it.
    pub fn set_outgoing(&mut self, h: HalfEdgeId) {
        let slot = self.origin(h).slot();
        if slot > self.outgoing.len() + 3 * self.faces.len() {
            return;
        }
        if slot >= self.outgoing.len() {
            self.outgoing.resize(slot + 1, HalfEdgeId::NONE);
        }
        self.outgoing[slot] = h;
    }

    /// Finds an outgoing half-edge for every vertex, the one with the smallest id, and none for
    /// vertices without a face.
    ///
    /// `slots` is one more than the greatest vertex index, plus one for the ghost.
    pub(crate) fn index_vertices(&mut self, slots: usize) {
        self.outgoing.clear();
        self.outgoing.resize(slots, HalfEdgeId::NONE);
        for (index, face) in self.faces.iter().enumerate().rev() {
            let f = FaceId::new(index);
            for corner in (0..3).rev() {
                self.outgoing[face.origin[corner].slot()] = f.half_edge(corner);
            }
        }
    }

    /// Removes `f` by moving the last face into its place: the last face takes the id `f`.
    ///
    /// No half-edge outside may be glued to `f` any more, and no vertex have its outgoing half-edge there.
    ///
    /// # Panics
    /// When there is no face `f`.
    pub fn swap_remove_face(&mut self, f: FaceId) {
        let last = FaceId::new(self.faces.len() - 1);
        self.faces.swap_remove(f.index());
        if f == last {
            return;
        }
        for (old, new) in last.half_edges().into_iter().zip(f.half_edges()) {
            let twin = self.twin(new);
            let moved = f.half_edge(twin.corner());
            self.glue(new, if twin.face() == last { moved } else { twin });
            let slot = self.origin(new).slot();
            if self.outgoing.get(slot) == Some(&old) {
                self.outgoing[slot] = new;
            }
        }
    }

    /// Makes `v` a vertex of no face.
    pub(super) fn forget_vertex(&mut self, v: VertexId) {
        if let Some(outgoing) = self.outgoing.get_mut(v.slot()) {
            *outgoing = HalfEdgeId::NONE;
        }
    }

    pub(super) fn set_twin(&mut self, h: HalfEdgeId, twin: HalfEdgeId) {
        self.faces[h.face().index()].twin[h.corner()] = twin;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The last face, glued to itself or to nothing, once looked for its twins in the slot it had left.
    #[test]
    fn a_face_that_is_its_own_neighbor_moves_with_its_twins() {
        let corners = [0, 1, 2].map(VertexId::new);
        let mut mesh = TriMesh::default();
        let first = mesh.push_face(corners);
        let last = mesh.push_face(corners);
        mesh.glue(last.half_edge(0), last.half_edge(1));
        mesh.swap_remove_face(first);
        let twins = first.half_edges().map(|h| mesh.twin(h).corner());
        assert_eq!((mesh.face_count(), twins), (1, [1, 0, 2]));
        assert!(
            first
                .half_edges()
                .iter()
                .all(|&h| mesh.twin(h).face() == first)
        );
    }

    #[test]
    fn a_wild_vertex_asks_for_no_memory_and_is_named() {
        let wild = VertexId::new(VertexId::LIMIT - 1);
        let mut mesh = TriMesh::default();
        let front = mesh.push_face([VertexId::new(0), VertexId::new(1), wild]);
        let back = mesh.push_face([VertexId::new(0), wild, VertexId::new(1)]);
        for (i, j) in [(0, 2), (1, 1), (2, 0)] {
            mesh.glue(front.half_edge(i), back.half_edge(j));
        }
        mesh.half_edges().for_each(|h| mesh.set_outgoing(h));
        assert!(mesh.outgoing.len() < 100);
        let vertex = wild;
        assert_eq!(
            mesh.check(),
            Err(super::super::check::Violation::Outgoing { vertex })
        );
    }

    #[test]
    fn a_face_record_takes_24_bytes() {
        assert_eq!(size_of::<Face>(), 24);
    }
}
