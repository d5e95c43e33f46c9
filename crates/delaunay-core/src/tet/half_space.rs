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
    /// Both are scaled by one power of two; parts of the normal 2^1022 times smaller than its longest, and limits beyond
    /// the range of doubles, do not survive that exactly.
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
            let HalfSpace { normal, limit } = half_space;
            assert!((limit / normal.x - 0.5).abs() < 1e-3, "{size}");
            assert_eq!((normal.y, normal.z), (0.0, 0.0));
        }
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
