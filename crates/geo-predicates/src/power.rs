//! Weighted in-circle and in-sphere tests, for power diagrams and regular triangulations.
//!
//! A point `p` of weight `w` is a circle (sphere) of squared radius `w` round `p`, lifted to the
//! height `|p|^2 - w`. With equal weights the tests are those of `in_circle` and `in_sphere`.

use crate::sign::Sign;
use crate::unbounded::{cross, det3, dot, least_exponent, minus, scaled, sign};
use glam::{DVec2, DVec3};
use num_bigint::BigInt;

/// A point of the plane with a weight, in squared units of length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WeightedPoint2 {
    /// Position, within the range of [`check_points2`](crate::check_points2).
    pub point: DVec2,
    /// Squared radius, within the range of [`check_weights`](crate::check_weights).
    pub weight: f64,
}

/// A point of space with a weight, in squared units of length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WeightedPoint3 {
    /// Position, within the range of [`check_points3`](crate::check_points3).
    pub point: DVec3,
    /// Squared radius, within the range of [`check_weights`](crate::check_weights).
    pub weight: f64,
}

/// Side of the circle orthogonal to the counterclockwise `a`, `b`, `c` on which `d` lies.
///
/// `Positive` when the lifted `d` is strictly below the plane of the lifted `a`, `b`, `c`: the
/// triangle `abc` cannot be in a regular triangulation together with `d`. Swapping two of the
/// first three flips the sign. Exact for accepted coordinates and weights.
#[must_use]
pub fn power_circle(
    a: WeightedPoint2,
    b: WeightedPoint2,
    c: WeightedPoint2,
    d: WeightedPoint2,
) -> Sign {
    let corners = [a, b, c, d];
    let exponent = common_exponent(
        &corners.map(|p| p.point.to_array()).concat(),
        &corners.map(|p| p.weight),
    );
    let points = corners.map(|p| scaled(p.point.to_array(), exponent));
    let weights = scaled(corners.map(|p| p.weight), 2 * exponent);
    let rows: [[BigInt; 2]; 3] = std::array::from_fn(|i| minus(&points[i], &points[3]));
    let lifts: [BigInt; 3] =
        std::array::from_fn(|i| dot(&rows[i], &rows[i]) - (&weights[i] - &weights[3]));
    let area = |i: usize, j: usize| cross([&rows[i][0], &rows[i][1]], [&rows[j][0], &rows[j][1]]);
    sign(&(&lifts[0] * area(1, 2) + &lifts[1] * area(2, 0) + &lifts[2] * area(0, 1)))
}

/// Side of the sphere orthogonal to the right-handed `a`, `b`, `c`, `d` on which `e` lies.
///
/// `Positive` when the lifted `e` is strictly below the hyperplane of the lifted `a`, `b`, `c`,
/// `d`. Swapping two of the first four flips the sign. Exact for accepted coordinates and weights.
#[must_use]
pub fn power_sphere(
    a: WeightedPoint3,
    b: WeightedPoint3,
    c: WeightedPoint3,
    d: WeightedPoint3,
    e: WeightedPoint3,
) -> Sign {
    let corners = [a, b, c, d, e];
    let exponent = common_exponent(
        &corners.map(|p| p.point.to_array()).concat(),
        &corners.map(|p| p.weight),
    );
    let points = corners.map(|p| scaled(p.point.to_array(), exponent));
    let weights = scaled(corners.map(|p| p.weight), 2 * exponent);
    let rows: [[BigInt; 3]; 4] = std::array::from_fn(|i| minus(&points[i], &points[4]));
    let lifts: [BigInt; 4] =
        std::array::from_fn(|i| dot(&rows[i], &rows[i]) - (&weights[i] - &weights[4]));
    let volume = |i: usize, j: usize, k: usize| det3(&rows[i], &rows[j], &rows[k]);
    let below = &lifts[0] * volume(1, 2, 3) - &lifts[1] * volume(0, 2, 3)
        + &lifts[2] * volume(0, 1, 3)
        - &lifts[3] * volume(0, 1, 2);
    sign(&below)
}

/// Greatest exponent that divides all coordinates, and twice which divides all weights.
fn common_exponent(coordinates: &[f64], weights: &[f64]) -> i32 {
    least_exponent(coordinates).min(least_exponent(weights).div_euclid(2))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::in_ball::{in_circle, in_sphere};

    fn flat(x: f64, y: f64, weight: f64) -> WeightedPoint2 {
        WeightedPoint2 {
            point: DVec2::new(x, y),
            weight,
        }
    }

    fn solid(x: f64, y: f64, z: f64, weight: f64) -> WeightedPoint3 {
        WeightedPoint3 {
            point: DVec3::new(x, y, z),
            weight,
        }
    }

    #[test]
    fn a_weight_pulls_a_point_into_the_circle() {
        let [a, b, c] = [
            flat(0.0, 0.0, 0.0),
            flat(1.0, 0.0, 0.0),
            flat(0.0, 1.0, 0.0),
        ];
        assert_eq!(power_circle(a, b, c, flat(1.0, 1.0, 0.0)), Sign::Zero);
        assert_eq!(power_circle(a, b, c, flat(1.0, 1.0, 1e-30)), Sign::Positive);
        assert_eq!(
            power_circle(a, b, c, flat(1.0, 1.0, -1e-30)),
            Sign::Negative
        );
        assert_eq!(
            power_circle(b, a, c, flat(1.0, 1.0, -1e-30)),
            Sign::Positive
        );
    }

    #[test]
    fn a_weight_pulls_a_point_into_the_sphere() {
        let a = solid(0.0, 0.0, 0.0, 0.0);
        let b = solid(1.0, 0.0, 0.0, 0.0);
        let c = solid(0.0, 1.0, 0.0, 0.0);
        let d = solid(0.0, 0.0, 1.0, 0.0);
        assert_eq!(
            power_sphere(a, b, c, d, solid(1.0, 1.0, 1.0, 0.0)),
            Sign::Zero
        );
        assert_eq!(
            power_sphere(a, b, c, d, solid(1.0, 1.0, 1.0, 1e-30)),
            Sign::Positive
        );
        assert_eq!(
            power_sphere(a, b, c, d, solid(1.0, 1.0, 1.0, -1e-30)),
            Sign::Negative
        );
        assert_eq!(
            power_sphere(b, a, c, d, solid(1.0, 1.0, 1.0, -1e-30)),
            Sign::Positive
        );
    }

    #[test]
    fn equal_weights_do_not_matter() {
        let w = 0.3;
        let [a, b, c] = [flat(0.1, 0.0, w), flat(1.0, 0.2, w), flat(0.0, 1.0, w)];
        for d in [flat(0.5, 0.5, w), flat(1.1, 1.1, w), a, b] {
            let plain = in_circle(a.point, b.point, c.point, d.point);
            assert_eq!(power_circle(a, b, c, d), plain);
        }
        let [a, b] = [solid(0.1, 0.0, 0.0, w), solid(1.0, 0.0, 0.0, w)];
        let [c, d] = [solid(0.0, 1.0, 0.3, w), solid(0.2, 0.0, 1.0, w)];
        for e in [solid(0.5, 0.5, 0.5, w), solid(2.0, 1.1, 0.2, w), a, c] {
            let plain = in_sphere(a.point, b.point, c.point, d.point, e.point);
            assert_eq!(power_sphere(a, b, c, d, e), plain);
        }
    }
}
