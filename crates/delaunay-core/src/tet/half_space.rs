//! Half-spaces: what convex polyhedra are clipped by.

use glam::DVec3;
use thiserror::Error;

/// The points `x` with `x · normal <= limit`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HalfSpace {
    pub(super) normal: DVec3,
    pub(super) limit: f64,
}

/// Why a normal and a limit do not make a half-space.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
pub enum HalfSpaceError {
    /// A number is infinite or NaN.
    #[error("the half-space x · {normal} <= {limit} has a number that is not finite")]
    NotFinite {
        /// As given.
        normal: DVec3,
        /// As given.
        limit: f64,
    },
    /// The normal is zero: it has no direction.
    #[error("the normal of the half-space is zero")]
    NoNormal,
}

impl HalfSpace {
    /// The points `x` with `x · normal <= limit`; the normal, of any length, points outwards.
    ///
    /// # Errors
    /// [`HalfSpaceError`] when a number is not finite or the normal is zero.
    pub fn new(normal: DVec3, limit: f64) -> Result<Self, HalfSpaceError> {
        if !(normal.is_finite() && limit.is_finite()) {
            return Err(HalfSpaceError::NotFinite { normal, limit });
        }
        let longest = normal.abs().max_element();
        if longest == 0.0 {
            return Err(HalfSpaceError::NoNormal);
        }
        // With a normal near unit length no product with an accepted coordinate overflows.
        let lift = if longest < f64::MIN_POSITIVE {
            LIFT
        } else {
            1.0
        };
        let unit = power_of_two_below(longest * lift);
        Ok(Self {
            normal: normal * lift / unit,
            limit: (limit * lift / unit).clamp(f64::MIN, f64::MAX),
        })
    }

    /// The points that are not nearer to `other` than to the origin.
    pub(super) fn nearer_to_origin(other: DVec3) -> Self {
        Self {
            normal: other,
            limit: other.length_squared() / 2.0,
        }
    }

    /// The other side of the plane.
    #[must_use]
    pub fn complement(&self) -> Self {
        Self {
            normal: -self.normal,
            limit: -self.limit,
        }
    }

    /// The normal, which points outwards; not of unit length.
    #[must_use]
    pub fn normal(&self) -> DVec3 {
        self.normal
    }

    /// How far `x` is beyond the plane, in units of the length of the normal; not positive inside.
    #[inline]
    pub(super) fn height(&self, x: DVec3) -> f64 {
        x.dot(self.normal) - self.limit
    }

    /// The [height](Self::height) of `x`; 0 when rounding may have moved `x` or the plane by as much.
    ///
    /// Planes that coincide up to rounding then do not cut each other: where they did, faces would lie one upon
    /// the other, and signs of heights would contradict each other by more than rounding later.
    #[inline]
    pub(super) fn rise(&self, x: DVec3) -> f64 {
        const ROUNDING: f64 = 1.0 / (1_u64 << 47) as f64;
        let height = self.height(x);
        if height.abs() > ROUNDING * self.size_at(x) {
            height
        } else {
            0.0
        }
    }

    /// Whether `x`, a corner of a polyhedron, may be in the plane or above it; of a polyhedron with many corners close
    /// together, where they are known less well.
    #[inline]
    pub(super) fn may_reach(&self, x: DVec3) -> bool {
        const ROUNDING: f64 = 1.0 / (1_u64 << 36) as f64;
        self.height(x) > -ROUNDING * self.size_at(x)
    }

    /// The size of the terms of which the height of `x` is the sum.
    #[inline]
    fn size_at(&self, x: DVec3) -> f64 {
        x.abs().dot(self.normal.abs()) + self.limit.abs()
    }

    /// The same half-space in coordinates relative to `origin`.
    pub(super) fn seen_from(&self, origin: DVec3) -> Self {
        Self {
            normal: self.normal,
            limit: self.limit - self.normal.dot(origin),
        }
    }
}

/// Makes the smallest numbers normal ones.
const LIFT: f64 = (1_u64 << 54) as f64;

/// The power of two at or below a positive normal number.
fn power_of_two_below(x: f64) -> f64 {
    const EXPONENT: u64 = 0x7ff << 52;
    f64::from_bits(x.to_bits() & EXPONENT)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_half_space_of_any_size_keeps_its_plane() {
        for size in [1.0, 1e-320, 1e300] {
            let half_space = HalfSpace::new(DVec3::X * size, 0.5 * size).unwrap();
            let height = |x| half_space.height(x) / half_space.normal().length();
            assert!((height(DVec3::X) - 0.5).abs() < 1e-3, "{size}");
            assert!((height(DVec3::new(0.0, 7.0, 9.0)) + 0.5).abs() < 1e-3);
        }
    }

    #[test]
    fn a_plane_beyond_all_numbers_keeps_all_or_nothing() {
        let far = |limit| HalfSpace::new(DVec3::X * 1e-300, limit).unwrap();
        assert!(far(1e100).height(DVec3::splat(1e60)) < 0.0);
        assert!(far(-1e100).height(DVec3::splat(-1e60)) > 0.0);
    }

    #[test]
    fn half_spaces_without_a_plane_are_refused() {
        let refused = |normal, limit| HalfSpace::new(normal, limit).unwrap_err();
        assert_eq!(refused(DVec3::ZERO, 1.0), HalfSpaceError::NoNormal);
        insta::assert_snapshot!(refused(DVec3::ZERO, 1.0), @"the normal of the half-space is zero");
        insta::assert_snapshot!(refused(DVec3::new(0.0, f64::INFINITY, 1.0), 1.0), @"the half-space x · [0, inf, 1] <= 1 has a number that is not finite");
        assert!(matches!(
            refused(DVec3::X, f64::NAN),
            HalfSpaceError::NotFinite { .. }
        ));
    }
}
