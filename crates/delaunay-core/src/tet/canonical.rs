//! One numbering of the tetrahedra for each set of tetrahedra, to compare meshes bit for bit.

use super::mesh::{Tet, TetMesh};
use crate::ids::{FacetId, TetId, VertexId};

impl TetMesh {
    /// The same mesh in canonical form: the corners of every tetrahedron are in ascending order, except
    /// that the ghost stays corner 3 and that corners 0 and 1 are swapped where the order would be
    /// left-handed; the tetrahedra are sorted by their corners, ids are dense.
    ///
    /// Two meshes with the same tetrahedra over the same vertex ids have equal canonical forms, twins
    /// and homes included, whatever the order in which their tetrahedra were made. Takes n log n time.
    #[must_use]
    pub fn canonical(&self) -> Self {
        let mut order: Vec<([VertexId; 4], TetId, [usize; 4])> = self
            .tets()
            .map(|t| {
                let corners = canonical_corners(self.tet_vertices(t));
                (corners.map(|c| self.tet_vertices(t)[c]), t, corners)
            })
            .collect();
        order.sort_unstable();
        let mut renamed = vec![FacetId::new(0); 4 * self.tet_slots()];
        for (rank, (_, old, corners)) in order.iter().enumerate() {
            for (new, &corner) in TetId::new(rank).facets().into_iter().zip(corners) {
                renamed[old.facet(corner).index()] = new;
            }
        }
        let tets = order.iter().map(|&(vertex, old, corners)| Tet {
            vertex,
            twin: corners.map(|corner| renamed[self.twin(old.facet(corner)).index()]),
        });
        let mut mesh = Self {
            tets: tets.collect(),
            vacant: Vec::new(),
            homes: Vec::new(),
        };
        mesh.index_vertices(self.homes.len());
        mesh
    }
}

/// The corners in canonical order, by their numbers; an even permutation of them.
fn canonical_corners(vertices: [VertexId; 4]) -> [usize; 4] {
    let mut corners = [0, 1, 2, 3];
    // The ghost sorts before all others: sort it to the end.
    corners.sort_unstable_by_key(|&c| (vertices[c].is_ghost(), vertices[c]));
    let pairs = (0..4).flat_map(|i| (i + 1..4).map(move |j| (i, j)));
    if pairs.filter(|&(i, j)| corners[i] > corners[j]).count() % 2 == 1 {
        corners.swap(0, 1);
    }
    corners
}
