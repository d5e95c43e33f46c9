//! A cavity is replaced by the star of the new vertex.
//!
//! Each facet `[a, b, c]` of the boundary, as seen from the tetrahedron outside, faces a new tetrahedron
//! `[v, a', b', c']`, the same corners as seen from inside. Its facet 0 is glued to the outside, the
//! others to its neighbours in the star: each edge of the boundary is met twice, and a table finds the facet on it
//! that was met first.

use super::cavity::Cavity3;
use super::mesh::TetMesh;
use crate::ids::{FacetId, TetId, VertexId};

/// Corners 1, 2, 3 of a new tetrahedron: the edge from `corner` to `corner + 1` is across which facet.
pub(super) const ACROSS: [(usize, usize, usize); 3] = [(1, 2, 3), (2, 3, 1), (3, 1, 2)];

/// The key of an edge.
fn edge(a: VertexId, b: VertexId) -> u64 {
    (a.max(b).slot() as u64) << 32 | a.min(b).slot() as u64
}

impl TetMesh {
    /// Replaces the tetrahedra of `cavity` by those between `v` and its boundary.
    ///
    /// Afterwards [`Cavity3::tets`] are the new ones, with `v` as corner 0 and their homes settled. They
    /// take the ids of the cavity, then vacant ones, then new ones; ids left over are vacated. Answers
    /// `false`, with nothing changed, when ids run out.
    pub(super) fn fill(&mut self, cavity: &mut Cavity3, v: VertexId) -> bool {
        let count = cavity.boundary.len();
        let missing = count.saturating_sub(cavity.tets.len() + self.vacant.len());
        if self.tets.len() + missing > TetId::LIMIT {
            return false;
        }
        let corners: Vec<[VertexId; 4]> = cavity
            .boundary
            .iter()
            .map(|&outer| {
                let [a, b, c] = self.facet_vertices(self.twin(outer));
                [v, a, b, c]
            })
            .collect();
        self.take_slots(cavity, count);
        cavity.edges.clear();
        for ((&t, new), &outer) in cavity.tets.iter().zip(&corners).zip(&cavity.boundary) {
            self.put(t, *new, t.facets());
            self.glue(outer, t.facet(0));
            for (from, to, facet) in ACROSS {
                let facet = t.facet(facet);
                let met = cavity.edges.meet(edge(new[from], new[to]), facet.raw());
                if let Some(partner) = met {
                    self.glue(facet, FacetId::from_raw(partner));
                }
            }
            self.settle(t);
        }
        debug_assert!(
            cavity
                .tets
                .iter()
                .flat_map(|t| t.facets())
                .all(|f| self.twin(f) != f),
            "the boundary of a cavity is closed"
        );
        true
    }

    /// Makes `cavity.tets` the ids of `count` tetrahedra to be stored.
    fn take_slots(&mut self, cavity: &mut Cavity3, count: usize) {
        for &t in cavity.tets.iter().skip(count) {
            self.vacate(t);
        }
        cavity.tets.truncate(count);
        while cavity.tets.len() < count {
            let t = self.vacant.pop().unwrap_or_else(|| {
                let t = TetId::new(self.tets.len());
                self.put(t, [VertexId::GHOST; 4], t.facets());
                t
            });
            cavity.tets.push(t);
        }
    }
}
