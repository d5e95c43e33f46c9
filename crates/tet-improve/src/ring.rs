//! The tetrahedra round an edge.
//!
//! ```text
//!          v2 --- v1             seen from b: the edge ab in the middle, the link of the edge round it,
//!         /  \ t1 / \            counterclockwise. Tetrahedron i is a, b, v_i, v_(i+1).
//!        / t2 \  / t0\
//!      v3 ---- ab --- v0
//! ```

use delaunay_core::{Complex3, TetId, VertexId};

/// The edges of a tetrahedron, each followed by the other corners such that all four are right-handed.
pub(crate) const EDGES: [[usize; 4]; 6] = [
    [0, 1, 2, 3],
    [0, 2, 3, 1],
    [0, 3, 1, 2],
    [1, 2, 0, 3],
    [1, 3, 2, 0],
    [2, 3, 0, 1],
];

/// The ring of an edge inside.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Ring {
    pub(crate) edge: [VertexId; 2],
    pub(crate) tets: Vec<TetId>,
    /// The link of the edge.
    pub(crate) link: Vec<VertexId>,
}

impl Ring {
    /// That of edge `number` of `t`, see [`EDGES`]; `None` when the edge is on the boundary or more than `limit` tetrahedra
    /// are round it.
    pub(crate) fn of(complex: &Complex3, t: TetId, number: usize, limit: usize) -> Option<Self> {
        let mesh = complex.mesh();
        let [a, b, behind, ahead] = EDGES[number].map(|corner| mesh.tet_vertices(t)[corner]);
        let mut ring = Self {
            edge: [a, b],
            tets: vec![t],
            link: vec![behind],
        };
        let (mut exit, mut vertex) = (t.facet(EDGES[number][2]), ahead);
        loop {
            let entry = mesh.twin(exit);
            let here = entry.tet();
            if here == t {
                return Some(ring);
            }
            if mesh.is_ghost_tet(here) || ring.tets.len() == limit {
                return None;
            }
            ring.tets.push(here);
            ring.link.push(vertex);
            exit = here.facet(mesh.corner_of(here, vertex)?);
            vertex = mesh.apex(entry);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn edges_and_the_other_corners_are_right_handed() {
        for order in EDGES {
            let pairs = (0..4).flat_map(|i| (i + 1..4).map(move |j| (i, j)));
            let inversions = pairs.filter(|&(i, j)| order[i] > order[j]).count();
            assert_eq!(inversions % 2, 0, "{order:?}");
        }
    }
}
