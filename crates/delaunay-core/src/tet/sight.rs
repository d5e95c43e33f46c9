//! Vertices as seen from one point: every question of walk and cavity, with exact answers.
//!
//! A floating-point filter decides nearly always; what it leaves open goes the exact way. The ghost is
//! seen as a vector that is not a number: the filter never decides for it.

use super::mesh::TetMesh;
use crate::ids::{TetId, VertexId};
use geo_predicates::filter::{Filter3, Relative3};
use geo_predicates::{Sign, in_sphere_perturbed, orient3d};
use glam::DVec3;

/// Where vertices are; not numbers for the ghost.
pub(super) trait Places: Copy {
    fn place(self, v: VertexId) -> DVec3;
}

/// By vertex slot, the ghost in front.
impl Places for &[DVec3] {
    #[inline(always)]
    fn place(self, v: VertexId) -> DVec3 {
        self[v.slot()]
    }
}

/// The vertices of a triangulation as seen from a point.
#[derive(Clone, Copy)]
pub(super) struct Sight3<P> {
    places: P,
    filter: Filter3,
    from: DVec3,
}

impl<P: Places> Sight3<P> {
    /// What `from` sees. It may be any accepted point, unless the filter is special: then one of those
    /// that the filter was made for.
    #[inline(always)]
    pub(super) fn new(places: P, filter: Filter3, from: DVec3) -> Self {
        Self {
            places,
            filter,
            from,
        }
    }

    /// The point that sees.
    pub(super) fn from(&self) -> DVec3 {
        self.from
    }

    #[inline(always)]
    pub(super) fn see(&self, vertex: VertexId) -> Relative3 {
        Relative3::new(self.places.place(vertex), self.from)
    }

    /// On which side of the plane through three real vertices the point lies; `Positive` is where they
    /// turn counterclockwise, the outside of a tetrahedron whose facet they are.
    pub(super) fn side(&self, corners: [VertexId; 3]) -> Sign {
        self.seen_side(corners, corners.map(|v| self.see(v)))
    }

    /// [`side`](Self::side) of vertices already seen.
    #[inline(always)]
    pub(super) fn seen_side(&self, corners: [VertexId; 3], [a, b, c]: [Relative3; 3]) -> Sign {
        match self.filter.orient_relative(&a, &b, &c) {
            Some(sign) => sign,
            None => self.exact_side(corners),
        }
    }

    /// Whether the point is in conflict with the tetrahedron `t` of `mesh`: see
    /// [`in_conflict_with`](Self::in_conflict_with).
    pub(super) fn in_conflict(&self, mesh: &TetMesh, t: TetId) -> bool {
        self.in_conflict_with(mesh.tet_vertices(t), || {
            mesh.tet_vertices(mesh.neighbor(t, 3))
        })
    }

    /// Whether the point is in conflict with a tetrahedron: inside its circumsphere, ties broken.
    ///
    /// The circumball of a ghost is the open half-space outside its hull facet, together with what the
    /// circumball of the tetrahedron `behind` the facet cuts out of its plane: the circumdisk of the
    /// facet.
    pub(super) fn in_conflict_with(
        &self,
        [a, b, c, d]: [VertexId; 4],
        behind: impl FnOnce() -> [VertexId; 4],
    ) -> bool {
        if d.is_ghost() {
            return match self.side([a, b, c]) {
                Sign::Positive => true,
                Sign::Negative => false,
                Sign::Zero => self.in_real_conflict(behind()),
            };
        }
        self.in_real_conflict([a, b, c, d])
    }

    /// Whether the point is in conflict with the tetrahedron of four real vertices.
    pub(super) fn in_real_conflict(&self, corners: [VertexId; 4]) -> bool {
        self.in_real_conflict_or(corners, |_, _| None)
    }

    /// [`in_real_conflict`](Self::in_real_conflict), with a second filter for `in_sphere` between the
    /// first one and the exact predicate.
    #[inline(always)]
    pub(super) fn in_real_conflict_or(
        &self,
        corners: [VertexId; 4],
        second: impl FnOnce([DVec3; 4], DVec3) -> Option<Sign>,
    ) -> bool {
        let places = corners.map(|v| self.places.place(v));
        let [a, b, c, d] = places.map(|place| Relative3::new(place, self.from));
        if let Some(inside) = self.filter.in_exact_sphere([&a, &b, &c, &d]) {
            return inside;
        }
        let sign = self.filter.in_sphere_relative(&a, &b, &c, &d);
        match sign.or_else(|| second(places, self.from)) {
            Some(Sign::Positive) => true,
            Some(Sign::Negative) => false,
            Some(Sign::Zero) | None => self.exact_conflict(corners),
        }
    }

    #[cold]
    #[inline(never)]
    fn exact_conflict(&self, corners: [VertexId; 4]) -> bool {
        let [a, b, c, d] = corners.map(|v| self.places.place(v));
        in_sphere_perturbed(a, b, c, d, self.from)
    }

    #[cold]
    #[inline(never)]
    fn exact_side(&self, corners: [VertexId; 3]) -> Sign {
        let [a, b, c] = corners.map(|v| self.places.place(v));
        orient3d(a, b, c, self.from)
    }
}
