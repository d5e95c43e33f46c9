//! Doubles as 62-bit integers, for the exact stage.
//!
//! When the coordinates of a query lie in a window of 61 bits (all are multiples of 2^-61 times the
//! greatest, rounded up to a power of two), they are integers on one grid, and determinants are
//! plain integer arithmetic: faster than floating-point expansions, and exact without further
//! thought. That is the common case: doubles in `[0.01, 1]`, for instance, always fit.

use crate::coordinate::power_of_two;

/// Coordinates of magnitude below 2^61, so that differences fit 63 bits, and the scale.
pub(crate) struct Grid<const N: usize> {
    /// The coordinates times the scale.
    pub(crate) integers: [i64; N],
    scale: f64,
}

impl<const N: usize> Grid<N> {
    /// The coordinates on a grid, if they fit in one window.
    #[inline]
    pub(crate) fn of(coordinates: [f64; N]) -> Option<Self> {
        Self::with_least_top(coordinates, 0)
    }

    /// The coordinates on a grid, with weights that are multiples of the square of its step and
    /// below 2^123 of those squares.
    #[inline]
    pub(crate) fn with_weights<const M: usize>(
        coordinates: [f64; N],
        weights: [f64; M],
    ) -> Option<(Self, [i128; M])> {
        let heaviest = (exponent(weights) - 1024).div_euclid(2) + 1023;
        let grid = Self::with_least_top(coordinates, heaviest)?;
        let scaled = weights.map(|weight| weight * (grid.scale * grid.scale));
        let integers = scaled.map(|weight| weight as i128);
        let fits = |(&integer, &weight): (&i128, &f64)| {
            integer as f64 == weight && weight.abs() < power_of_two(123)
        };
        integers
            .iter()
            .zip(&scaled)
            .all(fits)
            .then_some((grid, integers))
    }

    #[inline]
    fn with_least_top(coordinates: [f64; N], least: i64) -> Option<Self> {
        let top = exponent(coordinates).max(least).max(1023 - 142);
        if top > 1023 + 202 {
            return None;
        }
        let scale = power_of_two(1023 + 60 - top);
        let scaled = coordinates.map(|coordinate| coordinate * scale);
        let integers = scaled.map(|coordinate| coordinate as i64);
        let exact = integers.iter().zip(&scaled).all(|(&i, &x)| i as f64 == x);
        exact.then_some(Self { integers, scale })
    }
}

/// Greatest biased exponent of the values: 1023 for `[1, 2)`, 0 for zero, 2047 for NaN.
#[inline]
fn exponent<const N: usize>(values: [f64; N]) -> i64 {
    let bits = values.map(|value| value.to_bits() & (u64::MAX >> 1));
    (bits.into_iter().fold(0, u64::max) >> 52) as i64
}

/// Coordinate differences `a - b`.
#[inline]
pub(crate) fn minus<const N: usize>(a: [i64; N], b: [i64; N]) -> [i64; N] {
    std::array::from_fn(|i| a[i] - b[i])
}

/// Inner product.
#[inline]
pub(crate) fn dot<const N: usize>(a: [i64; N], b: [i64; N]) -> i128 {
    let mut sum = 0;
    for i in 0..N {
        sum += i128::from(a[i]) * i128::from(b[i]);
    }
    sum
}

/// `a x - b y` of the first two coordinates.
#[inline]
pub(crate) fn cross<const N: usize>(a: [i64; N], b: [i64; N]) -> i128 {
    i128::from(a[0]) * i128::from(b[1]) - i128::from(a[1]) * i128::from(b[0])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_within_sixty_one_bits_of_each_other_fit() {
        let grid = Grid::of([1.0, -0.0, -power_of_two(-60)]).unwrap();
        assert_eq!(grid.integers, [1 << 60, 0, -1]);
        assert!(Grid::of([1.0, power_of_two(-61)]).is_none());
        assert_eq!(Grid::of([0.0]).unwrap().integers, [0]);
        let most = 2.0f64.next_down();
        assert_eq!(Grid::of([most]).unwrap().integers, [(1 << 61) - (1 << 8)]);
    }

    #[test]
    fn numbers_that_are_not_finite_do_not_fit() {
        for value in [f64::NAN, f64::INFINITY, -f64::INFINITY, f64::MAX] {
            assert!(Grid::of([1.0, value]).is_none());
            assert!(Grid::with_weights([1.0], [value]).is_none());
        }
        assert!(Grid::of([f64::MIN_POSITIVE]).is_none());
    }

    #[test]
    fn weights_share_the_grid() {
        let (grid, weights) = Grid::with_weights([1.0], [-0.5, 0.0, 3.0]).unwrap();
        assert_eq!(grid.integers, [1 << 60]);
        assert_eq!(weights, [-1 << 119, 0, 3 << 120]);
        let (_, weights) = Grid::with_weights([0.0], [16.0f64.next_down()]).unwrap();
        assert!((1 << 121..1 << 123).contains(&weights[0]));
        assert!(Grid::with_weights([1.0], [power_of_two(-130)]).is_none());
    }
}
