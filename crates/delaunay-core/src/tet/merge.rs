//! Two vertices of a subcomplex become one.
//!
//! Somebody has found out, in rounded numbers, which tetrahedra there would be. Exact signs check that they are those of
//! Delaunay: they fill the place of those that go, and no circumsphere contains the apex of a neighbour.

use super::exchange::Plan;
use super::sight::Sight3;
use super::subcomplex::Subcomplex3;
use crate::ids::{FacetId, TetId, VertexId};
use geo_predicates::{Sign, check_point3, orient3d};
use glam::DVec3;
use rustc_hash::FxHashSet;

/// An exchange of tetrahedra that makes one vertex of two.
#[derive(Clone, Debug, Default)]
pub struct Merge {
    /// Where the vertex is.
    pub point: DVec3,
    /// The tetrahedra that go.
    pub gone: Vec<TetId>,
    /// The corners of those that come, right-handed. The vertex has the id of the first of the two.
    pub made: Vec<[VertexId; 4]>,
}

impl Subcomplex3 {
    /// Makes one vertex of two: `u` moves, and `v` goes. Gives the ids of the new tetrahedra.
    ///
    /// `None`, with nothing changed, unless the new tetrahedra are right-handed, fill the place of those gone, have all corners
    /// of theirs but `v`, and are Delaunay, among themselves and with the tetrahedra round them; when `u` or `v` is a corner of
    /// a tetrahedron that stays; when the point is not accepted; and when ids run out. Whether the point is inside the
    /// diametral sphere of a boundary facet is not asked. Exact. Takes time proportional to the number of tetrahedra, times its
    /// logarithm.
    pub fn merge(&mut self, [u, v]: [VertexId; 2], merge: &Merge) -> Option<Vec<TetId>> {
        let Merge { point, gone, made } = merge;
        check_point3(0, *point).ok()?;
        let outer = self.outer_of(gone, [u, v])?;
        if !self.keeps_corners(gone, made, v) {
            return None;
        }
        let plan = self.mesh.plan_exchange(gone, &outer, made)?;
        // Adding zero turns -0.0 into 0.0.
        let before = std::mem::replace(&mut self.coords[u.slot()], point + DVec3::ZERO);
        if !self.is_delaunay(&plan, made) {
            self.coords[u.slot()] = before;
            return None;
        }
        let new = self.mesh.carry_out(plan, gone, made);
        self.forget(v);
        Some(new)
    }

    /// The facets round tetrahedra, each by its outer side; `None` unless they are distinct real ones, with all that is
    /// round the vertices `inner`.
    fn outer_of(&self, tets: &[TetId], inner: [VertexId; 2]) -> Option<Vec<FacetId>> {
        let mesh = &self.mesh;
        let hole: FxHashSet<TetId> = tets.iter().copied().collect();
        let is_real = |&t: &TetId| mesh.contains_tet(t) && !mesh.is_ghost_tet(t);
        if hole.len() < tets.len() || !tets.iter().all(is_real) {
            return None;
        }
        let sides = tets.iter().flat_map(|t| t.facets()).map(|f| mesh.twin(f));
        let outer: Vec<FacetId> = sides.filter(|f| !hole.contains(&f.tet())).collect();
        let mut round = outer.iter().flat_map(|&f| mesh.facet_vertices(f));
        let has = |&v: &VertexId| tets.iter().any(|&t| mesh.tet_vertices(t).contains(&v));
        let inside = inner.iter().all(has) && !round.any(|v| inner.contains(&v));
        inside.then_some(outer)
    }

    /// Whether tetrahedra have the same corners as those gone, all but `lost`.
    fn keeps_corners(&self, gone: &[TetId], made: &[[VertexId; 4]], lost: VertexId) -> bool {
        let before = gone.iter().flat_map(|&t| self.mesh.tet_vertices(t));
        let mut before: Vec<VertexId> = before.filter(|&v| v != lost).collect();
        let mut after = made.as_flattened().to_vec();
        for corners in [&mut before, &mut after] {
            corners.sort_unstable();
            corners.dedup();
        }
        before == after
    }

    /// Whether the tetrahedra of an exchange would be right-handed, and Delaunay across all their facets that are no boundary.
    fn is_delaunay(&self, plan: &Plan, made: &[[VertexId; 4]]) -> bool {
        let corners = |t: TetId| match plan.slots.iter().position(|&slot| slot == t) {
            Some(index) => made[index],
            None => self.mesh.tet_vertices(t),
        };
        let mut pairs = plan.pairs.iter();
        let mut made = made.iter();
        made.all(|&corners| self.is_right_handed(corners))
            && pairs.all(|&(f, g)| {
                let [behind, ahead] = [f, g].map(|f| corners(f.tet()));
                behind[3].is_ghost() || self.is_locally_delaunay(behind, ahead[g.corner()])
            })
    }

    /// Whether four vertices are the corners of a tetrahedron of positive volume.
    pub(super) fn is_right_handed(&self, corners: [VertexId; 4]) -> bool {
        let [a, b, c, d] = corners.map(|v| self.point(v));
        orient3d(a, b, c, d) == Sign::Positive
    }

    /// Whether the apex across a facet of a tetrahedron is not in conflict with it, or there is none.
    pub(super) fn is_locally_delaunay(&self, corners: [VertexId; 4], apex: VertexId) -> bool {
        apex.is_ghost() || {
            let sight = Sight3::new(self.coords.as_slice(), self.filter, self.point(apex));
            !sight.in_real_conflict(corners)
        }
    }
}
