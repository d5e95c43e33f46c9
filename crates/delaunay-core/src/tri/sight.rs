//! Vertices as seen from one point: every question of walk and cavity, with exact answers.
//!
//! A vertex is met as a vector from the point, computed once and carried along, so a test loads one
//! new vertex and decides with an inlined floating-point filter; what the filter leaves open goes the
//! exact way, out of line. The ghost is seen as a vector that is not a number: the filter never
//! decides for it, so only the slow path needs to know about ghosts.

use crate::ids::VertexId;
use geo_predicates::filter::{Cross, Filter2, Relative2, raised_inside};
use geo_predicates::{Sign, in_circle_perturbed, orient2d};
use glam::DVec2;

/// The vertices of a triangulation as seen from a point.
#[derive(Clone, Copy)]
pub(super) struct Sight<'a> {
    coords: &'a [DVec2],
    filter: Filter2,
    from: DVec2,
}

/// A vertex and the vector to it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Seen {
    pub(super) vertex: VertexId,
    pub(super) arm: Relative2,
}

impl<'a> Sight<'a> {
    /// What `from` sees of points given by vertex slot; it may be any point that the filter is valid for.
    #[inline(always)]
    pub(super) fn new(coords: &'a [DVec2], filter: Filter2, from: DVec2) -> Self {
        Self {
            coords,
            filter,
            from,
        }
    }

    /// The point that looks.
    #[inline(always)]
    pub(super) fn from(&self) -> DVec2 {
        self.from
    }

    #[inline(always)]
    pub(super) fn see(&self, vertex: VertexId) -> Seen {
        let arm = Relative2::new(self.coords[vertex.slot()], self.from);
        Seen { vertex, arm }
    }

    /// On which side of the line from `a` to `b`, two real vertices, the point lies; `Positive` is
    /// the left.
    #[inline(always)]
    pub(super) fn side(&self, a: &Seen, b: &Seen) -> Sign {
        match self.filter.orient_relative(&a.arm, &b.arm) {
            Some(sign) => sign,
            None => self.exact_side(a.vertex, b.vertex),
        }
    }

    /// Whether the point is in conflict with the face `b`, `a`, `apex`, which lies beyond the edge
    /// `a -> b` as seen from the point; `ba` is the cross of `b` and `a`.
    ///
    /// The ways out of line take ids, not references, so that what is seen stays in registers.
    #[inline(always)]
    pub(super) fn in_conflict(&self, [b, a, apex]: [&Seen; 3], ba: Cross) -> bool {
        let crosses = [a.arm.cross(&apex.arm), apex.arm.cross(&b.arm), ba];
        self.in_conflict_crossed([b, a, apex], crosses)
    }

    /// As [`in_conflict`](Self::in_conflict), from all three crosses.
    #[inline(always)]
    pub(super) fn in_conflict_crossed(
        &self,
        [b, a, apex]: [&Seen; 3],
        crosses: [Cross; 3],
    ) -> bool {
        let corners = [&b.arm, &a.arm, &apex.arm];
        match self.filter.in_circle_crossed(corners, crosses) {
            Some(Sign::Positive) => true,
            Some(Sign::Negative) => false,
            Some(Sign::Zero) => raised_inside(&a.arm, &b.arm, &apex.arm),
            None => self.exact_conflict([b.vertex, a.vertex, apex.vertex]),
        }
    }

    /// Conflict with any face, its corners counterclockwise; ghosts included.
    #[cold]
    #[inline(never)]
    pub(super) fn exact_conflict(&self, [a, b, c]: [VertexId; 3]) -> bool {
        if a.is_ghost() {
            self.ghost_conflict(b, c)
        } else if b.is_ghost() {
            self.ghost_conflict(c, a)
        } else if c.is_ghost() {
            self.ghost_conflict(a, b)
        } else {
            let [a, b, c] = [a, b, c].map(|v| self.point(v));
            in_circle_perturbed(a, b, c, self.from)
        }
    }

    /// Whether the point is strictly on the left of `a -> b`, where the ghost is, or strictly between
    /// the two.
    fn ghost_conflict(&self, a: VertexId, b: VertexId) -> bool {
        match self.side(&self.see(a), &self.see(b)) {
            Sign::Positive => true,
            Sign::Negative => false,
            Sign::Zero => strictly_between(self.point(a), self.point(b), self.from),
        }
    }

    #[cold]
    #[inline(never)]
    fn exact_side(&self, a: VertexId, b: VertexId) -> Sign {
        orient2d(self.point(a), self.point(b), self.from)
    }

    pub(super) fn point(&self, v: VertexId) -> DVec2 {
        self.coords[v.slot()]
    }
}

/// Whether `p` is between `a` and `b` and equal to neither, given that the three are on a line.
fn strictly_between(a: DVec2, b: DVec2, p: DVec2) -> bool {
    precedes(a, p) == precedes(p, b) && p != a && p != b
}

/// Whether `a` comes before `b` in lexicographic order: along any line, one of its two directions.
pub(super) fn precedes(a: DVec2, b: DVec2) -> bool {
    (a.x, a.y) < (b.x, b.y)
}
