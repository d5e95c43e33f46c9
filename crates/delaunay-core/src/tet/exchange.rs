//! Tetrahedra give way to others with the same boundary: the surgery behind removals and flips.
//!
//! New tetrahedra are given by their corners alone. Sorted by corners, the facets of the new
//! tetrahedra and those around the hole come in pairs, the two sides of one facet next to each other:
//!
//! ```text
//!   [1, 2, 5]  t7.0 ,  t3.2        a facet between two new tetrahedra
//!   [1, 2, 8]  t7.3 ,  t1.1        a facet of the boundary: t1 is outside
//! ```

use super::mesh::TetMesh;
use crate::ids::{FacetId, TetId, VertexId};

/// One side of a facet, found by its corners.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Side {
    /// The corners in ascending order, packed: those of dozens of facets are sorted.
    corners: u128,
    /// Whether ascending is counterclockwise, seen from outside the tetrahedron of `facet`.
    ascending: bool,
    facet: FacetId,
}

impl Side {
    fn new(mut corners: [VertexId; 3], facet: FacetId) -> Self {
        let mut ascending = true;
        for (i, j) in [(0, 1), (1, 2), (0, 1)] {
            if corners[i] > corners[j] {
                corners.swap(i, j);
                ascending = !ascending;
            }
        }
        let packed = corners
            .into_iter()
            .fold(0, |packed, v| packed << 32 | v.slot() as u128);
        Self {
            corners: packed,
            ascending,
            facet,
        }
    }

    fn is_twin_of(&self, other: &Self) -> bool {
        self.corners == other.corners && self.ascending != other.ascending
    }
}

/// An exchange to be made.
pub(super) struct Plan {
    /// The ids of the new tetrahedra.
    pub(super) slots: Vec<TetId>,
    /// The facets to be glued to each other, two of the new tetrahedra or one and one round the hole.
    pub(super) pairs: Vec<(FacetId, FacetId)>,
}

impl TetMesh {
    /// Replaces the tetrahedra `gone` by some with the corners `made`, right-handed and with the ghost
    /// last; `outer` are the facets round the hole, each by its outer side.
    ///
    /// Gives the ids of the new tetrahedra: first those of `gone`, then vacant ones, then new ones; ids
    /// left over are vacated. Their corners have found a home there. `None`, with nothing changed, when
    /// ids run out or the new tetrahedra do not have the boundary `outer`.
    pub(super) fn exchange(
        &mut self,
        gone: &[TetId],
        outer: &[FacetId],
        made: &[[VertexId; 4]],
    ) -> Option<Vec<TetId>> {
        let plan = self.plan_exchange(gone, outer, made)?;
        Some(self.carry_out(plan, gone, made))
    }

    /// How an [`exchange`](Self::exchange) would go; nothing changes.
    pub(super) fn plan_exchange(
        &self,
        gone: &[TetId],
        outer: &[FacetId],
        made: &[[VertexId; 4]],
    ) -> Option<Plan> {
        let slots = self.slots_for(gone, made.len())?;
        let pairs = self.pair(&slots, outer, made)?;
        Some(Plan { slots, pairs })
    }

    /// Makes an exchange as planned; nothing has changed since.
    pub(super) fn carry_out(
        &mut self,
        plan: Plan,
        gone: &[TetId],
        made: &[[VertexId; 4]],
    ) -> Vec<TetId> {
        let Plan { slots, pairs } = plan;
        for &t in gone.iter().skip(made.len()) {
            self.vacate(t);
        }
        let taken = slots.len().saturating_sub(gone.len());
        self.vacant
            .truncate(self.vacant.len().saturating_sub(taken));
        for (&t, &corners) in slots.iter().zip(made) {
            self.put(t, corners, t.facets());
            self.settle(t);
        }
        for (f, g) in pairs {
            self.glue(f, g);
        }
        slots
    }

    /// The ids that `count` tetrahedra in the place of `gone` get; nothing is taken yet.
    fn slots_for(&self, gone: &[TetId], count: usize) -> Option<Vec<TetId>> {
        let missing = count.saturating_sub(gone.len() + self.vacant.len());
        if self.tets.len() + missing > TetId::LIMIT {
            return None;
        }
        let vacant = self.vacant.iter().rev().copied();
        let new = (self.tets.len()..self.tets.len() + missing).map(TetId::new);
        let slots = gone.iter().copied().chain(vacant).chain(new);
        Some(slots.take(count).collect())
    }

    /// The facets to be glued to each other; `None` unless each has one partner.
    fn pair(
        &self,
        slots: &[TetId],
        outer: &[FacetId],
        made: &[[VertexId; 4]],
    ) -> Option<Vec<(FacetId, FacetId)>> {
        let around = outer.iter().map(|&f| Side::new(self.facet_vertices(f), f));
        let new = slots.iter().zip(made).flat_map(|(t, corners)| {
            let facets = t.facets().into_iter().zip(super::mesh::FACET_CORNERS);
            facets.map(|(f, facet)| Side::new(facet.map(|corner| corners[corner]), f))
        });
        let mut sides: Vec<Side> = around.chain(new).collect();
        sides.sort_unstable();
        let (pairs, rest) = sides.as_chunks::<2>();
        let twins = pairs.iter().all(|[a, b]| a.is_twin_of(b));
        // Three sides of one facet would show as two unlike neighbours or as a repeated pair.
        let distinct = pairs.windows(2).all(|w| w[0][0].corners != w[1][0].corners);
        let matched = rest.is_empty() && twins && distinct;
        matched.then(|| pairs.iter().map(|[a, b]| (a.facet, b.facet)).collect())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tet::simplex::glue_simplex;

    fn simplex() -> TetMesh {
        let mut mesh = TetMesh::default();
        glue_simplex(&mut mesh, [0, 1, 2, 3].map(VertexId::new));
        mesh.index_vertices(5);
        mesh
    }

    #[test]
    fn a_tetrahedron_is_split_into_four_and_made_whole_again() {
        let mut mesh = simplex();
        let before = mesh.canonical();
        let t = mesh.tets().find(|&t| !mesh.is_ghost_tet(t)).unwrap();
        let corners = mesh.tet_vertices(t);
        let outer = t.facets().map(|f| mesh.twin(f));
        let star = t.facets().map(|f| {
            let [a, b, c] = mesh.facet_vertices(f);
            [VertexId::new(4), a, b, c]
        });
        let split = mesh.exchange(&[t], &outer, &star).unwrap();
        assert_eq!((split[0], mesh.check(), mesh.tet_count()), (t, Ok(()), 8));
        let outer: Vec<FacetId> = mesh.link(VertexId::new(4)).map(|f| mesh.twin(f)).collect();
        assert_eq!(mesh.exchange(&split, &outer, &[corners]), Some(vec![t]));
        mesh.forget_vertex(VertexId::new(4));
        assert_eq!((mesh.check(), mesh.tet_count()), (Ok(()), 5));
        assert_eq!(mesh.canonical().tets, before.tets);
    }

    #[test]
    fn tetrahedra_with_another_boundary_are_refused() {
        let mut mesh = simplex();
        let before = mesh.clone();
        let t = mesh.tets().next().unwrap();
        let [a, b, c, d] = mesh.tet_vertices(t);
        let outer = t.facets().map(|f| mesh.twin(f));
        let twice = [[a, b, c, d], [a, b, c, d]];
        for made in [&[[b, a, c, d]][..], &[], &twice] {
            assert_eq!(mesh.exchange(&[t], &outer, made), None);
        }
        assert_eq!(mesh, before);
    }
}
