//! Weighted in-circle and in-sphere tests, for power diagrams and regular triangulations.
//!
//! A point `p` of weight `w` is a circle (sphere) of squared radius `w` round `p`, lifted to the
//! height `|p|^2 - w`. With equal weights the tests are those of `in_circle` and `in_sphere`.

use crate::filter;
use crate::grid::{self, Grid};
use crate::in_ball::{below_hyperplane, below_plane};
use crate::sign::Sign;
use crate::statistics::{Predicate, Stage, record};
use crate::unbounded::{cross, det3, dot, integers_and_weights, minus, sign};
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
    let corners = [a, b, c].map(|corner| (corner.point - d.point, corner.weight - d.weight));
    filter::power_circle(corners).unwrap_or_else(|| exact_power_circle([a, b, c, d]))
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
    let corners = [a, b, c, d].map(|corner| (corner.point - e.point, corner.weight - e.weight));
    filter::power_sphere(corners).unwrap_or_else(|| exact_power_sphere([a, b, c, d, e]))
}

#[cold]
#[inline(never)]
fn exact_power_circle(corners: [WeightedPoint2; 4]) -> Sign {
    let points = corners.map(|corner| corner.point.to_array());
    let weights = corners.map(|corner| corner.weight);
    if let Some((points, weights)) = Grid::of_weighted_points(points, weights) {
        let (rows, lifts) = grid_rows::<2, 4, 3>(points, weights);
        record(Predicate::PowerCircle, Stage::Grid);
        return below_plane(rows, lifts);
    }
    record(Predicate::PowerCircle, Stage::Unbounded);
    let (points, weights) = integers_and_weights(points, weights);
    let (rows, lifts) = integer_rows::<2, 4, 3>(&points, &weights);
    let area = |i: usize, j: usize| cross(&rows[i], &rows[j]);
    sign(&(&lifts[0] * area(1, 2) + &lifts[1] * area(2, 0) + &lifts[2] * area(0, 1)))
}

#[cold]
#[inline(never)]
fn exact_power_sphere(corners: [WeightedPoint3; 5]) -> Sign {
    let points = corners.map(|corner| corner.point.to_array());
    let weights = corners.map(|corner| corner.weight);
    if let Some((points, weights)) = Grid::of_weighted_points(points, weights) {
        let (rows, lifts) = grid_rows::<3, 5, 4>(points, weights);
        record(Predicate::PowerSphere, Stage::Grid);
        return below_hyperplane(rows, lifts);
    }
    record(Predicate::PowerSphere, Stage::Unbounded);
    let (points, weights) = integers_and_weights(points, weights);
    let (rows, lifts) = integer_rows::<3, 5, 4>(&points, &weights);
    let volume = |i: usize, j: usize, k: usize| det3(&rows[i], &rows[j], &rows[k]);
    let below = &lifts[0] * volume(1, 2, 3) - &lifts[1] * volume(0, 2, 3)
        + &lifts[2] * volume(0, 1, 3)
        - &lifts[3] * volume(0, 1, 2);
    sign(&below)
}

/// Vectors from the last of `M` points to the `R = M - 1` others, and their weighted lifts.
fn grid_rows<const N: usize, const M: usize, const R: usize>(
    points: [[i64; N]; M],
    weights: [i128; M],
) -> ([[i64; N]; R], [i128; R]) {
    let rows: [[i64; N]; R] = std::array::from_fn(|i| grid::minus(points[i], points[R]));
    let lift = |i: usize| grid::dot(rows[i], rows[i]) - (weights[i] - weights[R]);
    (rows, std::array::from_fn(lift))
}

/// As [`grid_rows`], for integers of any length.
fn integer_rows<const N: usize, const M: usize, const R: usize>(
    points: &[[BigInt; N]; M],
    weights: &[BigInt; M],
) -> ([[BigInt; N]; R], [BigInt; R]) {
    let rows: [[BigInt; N]; R] = std::array::from_fn(|i| minus(&points[i], &points[R]));
    let lift = |i: usize| dot(&rows[i], &rows[i]) - (&weights[i] - &weights[R]);
    let lifts = std::array::from_fn(lift);
    (rows, lifts)
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
