//! Boxes along the axes: a quick answer to whether two things can meet.

use glam::DVec3;

/// The smallest box along the axes that holds something.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bounds {
    pub(super) low: DVec3,
    pub(super) high: DVec3,
}

impl Bounds {
    /// The box that holds nothing.
    pub(super) const NOTHING: Self = Self {
        low: DVec3::INFINITY,
        high: DVec3::NEG_INFINITY,
    };

    /// The box round these places.
    pub(super) fn of(places: impl IntoIterator<Item = DVec3>) -> Self {
        let with = |bounds: Self, p| bounds.with(Self { low: p, high: p });
        places.into_iter().fold(Self::NOTHING, with)
    }

    /// The box round both.
    pub(super) fn with(self, other: Self) -> Self {
        Self {
            low: self.low.min(other.low),
            high: self.high.max(other.high),
        }
    }

    /// Lengths of the sides.
    pub(super) fn size(self) -> DVec3 {
        self.high - self.low
    }

    /// The middle, rounded.
    pub(super) fn middle(self) -> DVec3 {
        0.5 * self.low + 0.5 * self.high
    }

    /// What two boxes that meet have in common.
    pub(super) fn common(self, other: Self) -> Self {
        Self {
            low: self.low.max(other.low),
            high: self.high.min(other.high),
        }
    }

    /// Whether the boxes have a point in common. Exact.
    #[inline]
    pub(super) fn meets(self, other: Self) -> bool {
        self.low.cmple(other.high).all() && other.low.cmple(self.high).all()
    }
}
