//! Empty circles and empty spheres: which points lie inside the ball through others.

use crate::orient::{coord, coord3};
use crate::sign::Sign;
use glam::{DVec2, DVec3};

/// Side of the circle through `a`, `b`, `c` on which `d` lies.
///
/// `Positive` when `d` is strictly inside the circle of the counterclockwise `a`, `b`, `c`; swapping
/// two of them flips the sign. `Zero` exactly when the four points are on one circle or line.
/// Exact for accepted coordinates (see [`coordinate`](crate::coordinate)).
#[inline]
#[must_use]
pub fn in_circle(a: DVec2, b: DVec2, c: DVec2, d: DVec2) -> Sign {
    Sign::of(robust::incircle(coord(a), coord(b), coord(c), coord(d)))
}

/// Side of the sphere through `a`, `b`, `c`, `d` on which `e` lies.
///
/// `Positive` when `e` is strictly inside the sphere of the right-handed `a`, `b`, `c`, `d`;
/// swapping two of them flips the sign. `Zero` exactly when the five points are on one sphere or
/// plane. Exact for accepted coordinates (see [`coordinate`](crate::coordinate)).
#[inline]
#[must_use]
pub fn in_sphere(a: DVec3, b: DVec3, c: DVec3, d: DVec3, e: DVec3) -> Sign {
    -Sign::of(robust::insphere(
        coord3(a),
        coord3(b),
        coord3(c),
        coord3(d),
        coord3(e),
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_inside_of_a_counterclockwise_circle_is_positive() {
        let [a, b, c] = [DVec2::ZERO, DVec2::X, DVec2::Y];
        assert_eq!(in_circle(a, b, c, DVec2::splat(0.5)), Sign::Positive);
        assert_eq!(in_circle(b, a, c, DVec2::splat(0.5)), Sign::Negative);
        assert_eq!(in_circle(a, b, c, DVec2::ONE), Sign::Zero);
        assert_eq!(in_circle(a, b, c, DVec2::splat(1.5)), Sign::Negative);
    }

    #[test]
    fn the_inside_of_a_right_handed_sphere_is_positive() {
        let [a, b, c, d] = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z];
        assert_eq!(in_sphere(a, b, c, d, DVec3::splat(0.5)), Sign::Positive);
        assert_eq!(in_sphere(b, a, c, d, DVec3::splat(0.5)), Sign::Negative);
        assert_eq!(in_sphere(a, b, c, d, DVec3::ONE), Sign::Zero);
        assert_eq!(in_sphere(a, b, c, d, DVec3::splat(1.5)), Sign::Negative);
    }
}
