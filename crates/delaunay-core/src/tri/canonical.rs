//! One numbering of the faces for each set of faces, to compare meshes bit for bit.

use super::mesh::TriMesh;
use crate::ids::{FaceId, HalfEdgeId, VertexId};

impl TriMesh {
    /// The same mesh in canonical form: every face starts at its smallest corner (the ghost is the
    /// smallest of all), and the faces are sorted by their corners.
    ///
    /// Two meshes with the same faces over the same vertex ids have equal canonical forms, twins and
    /// outgoing half-edges included, whatever the order in which their faces were made. Takes
    /// n log n time.
    #[must_use]
    pub fn canonical(&self) -> Self {
        let mut order: Vec<([VertexId; 3], HalfEdgeId)> = self
            .faces()
            .map(|f| self.smallest_corner_first(f))
            .collect();
        order.sort_unstable();
        let mut renamed = vec![HalfEdgeId::NONE; 4 * self.face_count()];
        for (rank, &(_, first)) in order.iter().enumerate() {
            let old = [first, first.next(), first.prev()];
            for (old, new) in old.into_iter().zip(FaceId::new(rank).half_edges()) {
                renamed[old.index()] = new;
            }
        }
        let mut mesh = Self {
            faces: Vec::with_capacity(self.face_count()),
            outgoing: Vec::new(),
        };
        for (corners, first) in order {
            let f = mesh.push_face(corners);
            mesh.faces[f.index()].twin =
                [first, first.next(), first.prev()].map(|h| renamed[self.twin(h).index()]);
        }
        mesh.index_vertices(self.outgoing.len());
        mesh
    }

    /// The corners of `f` from the smallest on, and the half-edge that leaves it.
    fn smallest_corner_first(&self, f: FaceId) -> ([VertexId; 3], HalfEdgeId) {
        let mut corners = self.face_vertices(f);
        let mut first = f.half_edge(0);
        while corners[0] > corners[1] || corners[0] > corners[2] {
            corners.rotate_left(1);
            first = first.next();
        }
        (corners, first)
    }
}
