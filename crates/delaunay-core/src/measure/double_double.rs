//! Numbers of twice the digits: sums of two doubles that do not overlap.
//!
//! Where a determinant of an element is small because its terms cancel, the terms must have more digits than
//! the result needs (Dekker 1971).

use glam::DVec3;
use std::ops::{Add, Mul, Sub};

/// A number of about 32 decimal digits.
#[derive(Clone, Copy, Debug)]
pub(super) struct DoubleDouble {
    high: f64,
    low: f64,
}

/// A vector of such numbers.
#[derive(Clone, Copy, Debug)]
pub(super) struct DoubleDVec3([DoubleDouble; 3]);

impl DoubleDouble {
    /// The nearest double.
    pub(super) fn rounded(self) -> f64 {
        self.high
    }
}

impl DoubleDVec3 {
    /// `(p - q) / unit` without rounding, for a power of two `unit`.
    pub(super) fn difference(p: DVec3, q: DVec3, unit: f64) -> Self {
        let component = |i: usize| {
            let (high, low) = sum(p[i], -q[i]);
            DoubleDouble {
                high: high / unit,
                low: low / unit,
            }
        };
        Self([0, 1, 2].map(component))
    }

    pub(super) fn dot(self, other: Self) -> DoubleDouble {
        let ([a, b, c], [p, q, r]) = (self.0, other.0);
        a * p + b * q + c * r
    }

    pub(super) fn cross(self, other: Self) -> Self {
        let ([a, b, c], [p, q, r]) = (self.0, other.0);
        Self([b * r - c * q, c * p - a * r, a * q - b * p])
    }

    pub(super) fn rounded(self) -> DVec3 {
        DVec3::from(self.0.map(DoubleDouble::rounded))
    }
}

impl Add for DoubleDouble {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        let (high, low) = sum(self.high, other.high);
        let (tail, rest) = sum(self.low, other.low);
        let (high, low) = sum(high, low + tail);
        let (high, low) = sum(high, low + rest);
        Self { high, low }
    }
}

impl Sub for DoubleDouble {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        let negative = Self {
            high: -other.high,
            low: -other.low,
        };
        self + negative
    }
}

impl Mul for DoubleDouble {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let (high, low) = product(self.high, other.high);
        let (high, low) = sum(high, low + (self.high * other.low + self.low * other.high));
        Self { high, low }
    }
}

impl Add for DoubleDVec3 {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self([0, 1, 2].map(|i| self.0[i] + other.0[i]))
    }
}

impl Mul<DoubleDVec3> for DoubleDouble {
    type Output = DoubleDVec3;

    fn mul(self, vector: DoubleDVec3) -> DoubleDVec3 {
        DoubleDVec3(vector.0.map(|component| self * component))
    }
}

/// A sum and what it loses by rounding (Knuth).
pub(super) fn sum(x: f64, y: f64) -> (f64, f64) {
    let sum = x + y;
    let y_virtual = sum - x;
    let x_virtual = sum - y_virtual;
    (sum, (x - x_virtual) + (y - y_virtual))
}

/// A product and what it loses by rounding (Dekker's splitting).
pub(super) fn product(x: f64, y: f64) -> (f64, f64) {
    let product = x * y;
    let ((x_high, x_low), (y_high, y_low)) = (split(x), split(y));
    let error = ((product - x_high * y_high) - x_low * y_high) - x_high * y_low;
    (product, x_low * y_low - error)
}

/// Two halves of 26 bits each.
fn split(x: f64) -> (f64, f64) {
    let scaled = 134_217_729.0 * x;
    let high = scaled - (scaled - x);
    (high, x - high)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_difference_of_products_keeps_what_doubles_lose() {
        let tiny = 2.0_f64.powi(-40);
        let vector = |x: f64| DoubleDVec3::difference(DVec3::new(x, 1.0, 0.0), DVec3::ZERO, 1.0);
        // (1 + t) (1 + t) - 1 · (1 + 2 t) = t²
        let [p, q] = [vector(1.0 + tiny), vector(1.0 + 2.0 * tiny)];
        let square = p.0[0] * p.0[0] - p.0[1] * q.0[0];
        assert_eq!(square.rounded(), tiny * tiny);
    }

    #[test]
    fn a_difference_keeps_the_smaller_number() {
        let far = DoubleDVec3::difference(DVec3::X, DVec3::splat(1e-30), 1.0);
        let near = DoubleDVec3::difference(DVec3::X, DVec3::ZERO, 1.0);
        assert_eq!((near.0[0] - far.0[0]).rounded(), 1e-30);
    }
}
