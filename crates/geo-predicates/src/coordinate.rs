//! Which coordinates and weights are accepted, and the errors that name the others.
//!
//! A point is judged once, at the door of a crate; behind the door no loop looks again. A
//! coordinate may be zero (`-0.0` counts as `0.0` in every comparison) or of magnitude
//! [`MIN_MAGNITUDE`] to [`MAX_MAGNITUDE`]: then it is a multiple of 2^-194, every product of five
//! differences is a multiple of 2^-970 and below 2^1017, and nothing in an in-sphere determinant
//! underflows or overflows. A weight is compared with squared lengths, so its range is the square
//! of that of the coordinates.

use glam::{DVec2, DVec3};
use std::fmt;
use thiserror::Error;

/// Least magnitude of a coordinate that is not zero: 2^-142, about 1.8e-43.
pub const MIN_MAGNITUDE: f64 = power_of_two(-142);
/// Greatest magnitude of a coordinate: 2^201, about 3.2e60.
pub const MAX_MAGNITUDE: f64 = power_of_two(201);
/// Least magnitude of a weight that is not zero: 2^-284.
pub const MIN_WEIGHT: f64 = power_of_two(-284);
/// Greatest magnitude of a weight: 2^402.
pub const MAX_WEIGHT: f64 = power_of_two(402);

/// 2 to the power `exponent`, for exponents of normal numbers (-1022 to 1023).
pub(crate) const fn power_of_two(exponent: i64) -> f64 {
    f64::from_bits(((1023 + exponent) as u64) << 52)
}

/// Name of a coordinate.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Axis {
    /// First coordinate.
    X,
    /// Second coordinate.
    Y,
    /// Third coordinate.
    Z,
}

impl fmt::Display for Axis {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::X => "x",
            Self::Y => "y",
            Self::Z => "z",
        })
    }
}

/// A coordinate outside the accepted range.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[error(
    "point {index} has {axis} = {value:e}, which is neither zero nor of magnitude 2^-142 to 2^201 (about 1.8e-43 to 3.2e60)"
)]
pub struct CoordinateError {
    /// Index of the point in the checked slice, or the one given with a single point.
    pub index: usize,
    /// Which coordinate.
    pub axis: Axis,
    /// What was found there; NaN and infinities included.
    pub value: f64,
}

/// A weight outside the accepted range.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[error(
    "point {index} has weight {value:e}, which is neither zero nor of magnitude 2^-284 to 2^402 (about 3.2e-86 to 1.0e121)"
)]
pub struct WeightError {
    /// Index of the weight in the checked slice.
    pub index: usize,
    /// What was found there; NaN and infinities included.
    pub value: f64,
}

/// Accepts a slice of points of the plane. Linear in its length.
///
/// # Errors
/// The first coordinate outside the accepted range, by index of the point, then axis.
pub fn check_points2(points: &[DVec2]) -> Result<(), CoordinateError> {
    points
        .iter()
        .enumerate()
        .try_for_each(|(index, &point)| check_point2(index, point))
}

/// Accepts a slice of points of space. Linear in its length.
///
/// # Errors
/// The first coordinate outside the accepted range, by index of the point, then axis.
pub fn check_points3(points: &[DVec3]) -> Result<(), CoordinateError> {
    points
        .iter()
        .enumerate()
        .try_for_each(|(index, &point)| check_point3(index, point))
}

/// Accepts one point of the plane; `index` is only reported.
///
/// # Errors
/// The first coordinate outside the accepted range.
#[inline]
pub fn check_point2(index: usize, point: DVec2) -> Result<(), CoordinateError> {
    check_coordinate(index, Axis::X, point.x)?;
    check_coordinate(index, Axis::Y, point.y)
}

/// Accepts one point of space; `index` is only reported.
///
/// # Errors
/// The first coordinate outside the accepted range.
#[inline]
pub fn check_point3(index: usize, point: DVec3) -> Result<(), CoordinateError> {
    check_coordinate(index, Axis::X, point.x)?;
    check_coordinate(index, Axis::Y, point.y)?;
    check_coordinate(index, Axis::Z, point.z)
}

/// Accepts a slice of weights. Linear in its length.
///
/// # Errors
/// The first weight outside the accepted range.
pub fn check_weights(weights: &[f64]) -> Result<(), WeightError> {
    match weights
        .iter()
        .position(|&weight| !accepts(weight, MIN_WEIGHT, MAX_WEIGHT))
    {
        Some(index) => Err(WeightError {
            index,
            value: weights[index],
        }),
        None => Ok(()),
    }
}

#[inline]
fn check_coordinate(index: usize, axis: Axis, value: f64) -> Result<(), CoordinateError> {
    if accepts(value, MIN_MAGNITUDE, MAX_MAGNITUDE) {
        Ok(())
    } else {
        Err(CoordinateError { index, axis, value })
    }
}

/// Whether all of these coordinates are accepted.
pub(crate) fn are_accepted(coordinates: &[f64]) -> bool {
    let mut coordinates = coordinates.iter();
    coordinates.all(|&value| accepts(value, MIN_MAGNITUDE, MAX_MAGNITUDE))
}

#[inline]
fn accepts(value: f64, least: f64, greatest: f64) -> bool {
    value == 0.0 || (least..=greatest).contains(&value.abs())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_zeros_and_both_ends_of_the_range_are_accepted() {
        for value in [
            0.0,
            -0.0,
            1.0,
            MIN_MAGNITUDE,
            -MIN_MAGNITUDE,
            MAX_MAGNITUDE,
            -MAX_MAGNITUDE,
        ] {
            assert_eq!(check_points2(&[DVec2::splat(value)]), Ok(()));
            assert_eq!(check_points3(&[DVec3::splat(value)]), Ok(()));
        }
        assert_eq!(check_weights(&[0.0, -0.0, MIN_WEIGHT, -MAX_WEIGHT]), Ok(()));
    }

    #[test]
    fn the_neighbours_of_the_ends_of_the_range_are_refused() {
        let outside = [
            MIN_MAGNITUDE.next_down(),
            -MIN_MAGNITUDE.next_down(),
            MAX_MAGNITUDE.next_up(),
            -MAX_MAGNITUDE.next_up(),
            f64::from_bits(1),
            f64::MAX,
            f64::INFINITY,
            f64::NEG_INFINITY,
        ];
        for value in outside {
            let error = CoordinateError {
                index: 1,
                axis: Axis::Y,
                value,
            };
            assert_eq!(
                check_points2(&[DVec2::ONE, DVec2::new(1.0, value)]),
                Err(error)
            );
            let error = CoordinateError {
                index: 0,
                axis: Axis::Z,
                value,
            };
            assert_eq!(check_points3(&[DVec3::new(1.0, 0.0, value)]), Err(error));
        }
        for value in [MIN_WEIGHT.next_down(), MAX_WEIGHT.next_up(), f64::INFINITY] {
            assert_eq!(
                check_weights(&[0.0, value]),
                Err(WeightError { index: 1, value })
            );
        }
        assert!(check_weights(&[f64::NAN]).is_err());
    }

    #[test]
    fn errors_name_point_axis_and_value() {
        let error = check_points3(&[DVec3::ZERO, DVec3::new(0.0, f64::NAN, 0.0)]).unwrap_err();
        assert_eq!(
            error.to_string(),
            "point 1 has y = NaN, which is neither zero nor of magnitude 2^-142 to 2^201 (about 1.8e-43 to 3.2e60)"
        );
        let error = check_weights(&[-1e300]).unwrap_err();
        assert_eq!(
            error.to_string(),
            "point 0 has weight -1e300, which is neither zero nor of magnitude 2^-284 to 2^402 (about 3.2e-86 to 1.0e121)"
        );
    }
}
