//! The points that signs are asked for.

use std::cmp::Ordering;

use glam::DVec3;

use super::doubled::between;
use super::whole::compare_exactly;
use crate::perturb::compare;

/// A point on a segment: `from + share (to - from)`, exactly.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SegmentPoint3 {
    from: DVec3,
    to: DVec3,
    share: f64,
    /// The place, rounded.
    near: DVec3,
    /// The place less `near`, up to [`LOST`] of the coordinates of the ends.
    rest: DVec3,
}

/// What the rest does not tell of a place, as a share of the coordinates of its segment.
pub(super) const LOST: f64 = f64::EPSILON * f64::EPSILON * 16.0;

impl SegmentPoint3 {
    /// The point at `share` of the way from `from` to `to`, which are accepted points. A share below 0 counts as 0, one above 1
    /// as 1, and one that is not a number as 0.
    #[must_use]
    pub fn new(from: DVec3, to: DVec3, share: f64) -> Self {
        // The least share keeps products within the range of doubles.
        let share = if share > f64::EPSILON * f64::EPSILON {
            share.min(1.0)
        } else {
            0.0
        };
        let axis = |a: f64, b: f64| between(a, b, share);
        let (x, y, z) = (axis(from.x, to.x), axis(from.y, to.y), axis(from.z, to.z));
        Self {
            from,
            to,
            share,
            near: DVec3::new(x.0, y.0, z.0),
            rest: DVec3::new(x.1, y.1, z.1),
        }
    }

    /// The ends of the segment.
    #[must_use]
    pub const fn ends(&self) -> [DVec3; 2] {
        [self.from, self.to]
    }

    /// How far along the segment it is, from 0 to 1.
    #[must_use]
    pub const fn share(&self) -> f64 {
        self.share
    }

    /// The place, rounded to the nearest double but for rare ties.
    #[must_use]
    pub const fn rounded(&self) -> DVec3 {
        self.near
    }

    pub(super) const fn rest(&self) -> DVec3 {
        self.rest
    }
}

/// A point of space: one given by accepted coordinates, or one exactly on a segment between two such.
#[derive(Clone, Copy, Debug)]
pub enum ExactPoint3<'a> {
    /// At these coordinates.
    Given(DVec3),
    /// On a segment.
    OnSegment(&'a SegmentPoint3),
}

impl ExactPoint3<'_> {
    /// The place, rounded.
    #[must_use]
    #[inline]
    pub const fn rounded(&self) -> DVec3 {
        match self {
            Self::Given(place) => *place,
            Self::OnSegment(point) => point.rounded(),
        }
    }

    /// The place less what it is rounded, and how much of it may be missing in each coordinate.
    #[inline]
    pub(super) fn rest(&self) -> (DVec3, DVec3) {
        match self {
            Self::Given(_) => (DVec3::ZERO, DVec3::ZERO),
            Self::OnSegment(point) => {
                let [from, to] = point.ends();
                (point.rest(), LOST * from.abs().max(to.abs()))
            }
        }
    }

    /// The order of places by `x`, then `y`, then `z`, exactly; that of [`Lexicographic3`](crate::Lexicographic3) for given
    /// points.
    #[must_use]
    pub fn cmp_lexicographic(&self, other: &Self) -> Ordering {
        let (here, there) = (self.rounded(), other.rounded());
        if let (Self::Given(_), Self::Given(_)) = (self, other) {
            return compare(here.x, there.x)
                .then_with(|| compare(here.y, there.y))
                .then_with(|| compare(here.z, there.z));
        }
        let ((rest, lost), (other_rest, other_lost)) = (self.rest(), other.rest());
        for axis in 0..3 {
            let apart = (here[axis] - there[axis]) + (rest[axis] - other_rest[axis]);
            // Twice the rests are more than what rounding them can do.
            let unsure = lost[axis]
                + other_lost[axis]
                + f64::EPSILON * (apart.abs() + 2.0 * (rest[axis].abs() + other_rest[axis].abs()));
            if apart.abs() > 4.0 * unsure {
                return apart.total_cmp(&0.0);
            }
            let order = compare_exactly(self, other, axis);
            if order.is_ne() {
                return order;
            }
        }
        Ordering::Equal
    }
}
