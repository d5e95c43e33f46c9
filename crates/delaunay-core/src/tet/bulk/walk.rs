//! The walk of a bulk build: it stops at the first tetrahedron whose circumsphere surely contains the
//! point, since any tetrahedron of the cavity will do to dig from.
//!
//! Otherwise it is the visibility walk of [`locate`](crate::tet::locate): it crosses facets that have the
//! point strictly outside, and ends for the same reason.

use super::inserter::Inserter;
use crate::ids::{TetId, VertexId};
use crate::tet::mesh::FACET_CORNERS;
use crate::tet::sight::Sight3;
use geo_predicates::Sign;
use glam::DVec3;

/// Where a walk ended.
pub(super) enum Walk {
    /// In a tetrahedron in conflict with the point.
    Conflict(TetId),
    /// At a vertex in the place of the point.
    Vertex(VertexId),
    /// At the border of the part.
    Border,
}

impl<const SHARED: bool> Inserter<SHARED> {
    /// Walks to `p` from `start`, a real tetrahedron with two corners of this part.
    #[inline(always)]
    pub(super) fn walk(&self, p: DVec3, start: TetId) -> Walk {
        let mut t = start;
        let mut entry = 4;
        loop {
            let tet = self.arena.tet(t);
            if tet.vertex[3].is_ghost() || self.arena.sphere(t).surely_contains(p) {
                return Walk::Conflict(t);
            }
            let places = tet.vertex.map(|v| self.arena.place(v));
            let exit = (0..4)
                .find(|&corner| corner != entry && self.is_outside(p, places, tet.vertex, corner));
            let Some(corner) = exit else {
                let here = (0..4).find(|&i| places[i] == p);
                return here.map_or(Walk::Conflict(t), |i| Walk::Vertex(tet.vertex[i]));
            };
            if SHARED && !self.may_read_across(FACET_CORNERS[corner].map(|i| tet.vertex[i])) {
                return Walk::Border;
            }
            let twin = tet.twin[corner];
            t = twin.tet();
            entry = twin.corner();
        }
    }

    /// Whether `p` is strictly outside the facet opposite `corner`.
    #[inline(always)]
    fn is_outside(
        &self,
        p: DVec3,
        places: [DVec3; 4],
        vertices: [VertexId; 4],
        corner: usize,
    ) -> bool {
        let facet = FACET_CORNERS[corner];
        let [a, b, c] = facet.map(|i| places[i]);
        let sign = self.box_filter.orient3d(a, b, c, p);
        let sign = sign.unwrap_or_else(|| self.side(p, facet.map(|i| vertices[i])));
        sign == Sign::Positive
    }

    #[cold]
    #[inline(never)]
    fn side(&self, p: DVec3, facet: [VertexId; 3]) -> Sign {
        Sight3::new(self.arena, self.filter, p).side(facet)
    }

    /// Whether the tetrahedron across a facet with these corners has two real corners of this part.
    #[inline(always)]
    fn may_read_across(&self, facet: [VertexId; 3]) -> bool {
        let own = facet.map(|v| usize::from(!v.is_ghost() && self.arena.part(v) == self.part));
        own[0] + own[1] + own[2] >= 2
    }
}
