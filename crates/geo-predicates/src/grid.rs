//! Doubles as 62-bit integers, for the exact stage.
//!
//! When the coordinates of a query lie in a window of 61 bits (all are multiples of 2^-61 times the
//! greatest, rounded up to a power of two), they are integers on one grid, and determinants are
//! plain integer arithmetic: faster than floating-point expansions, and exact without further
//! thought. That is the common case: doubles in `[0.01, 1]`, for instance, always fit.

use crate::coordinate::power_of_two;

/// The conversion of a query's doubles to integers: a power of two, chosen for them all.
pub(crate) struct Grid {
    scale: f64,
}

impl Grid {
    /// The points in units of a common grid, if they fit in one window: coordinates of magnitude
    /// below 2^61, so that differences fit 63 bits.
    #[inline]
    pub(crate) fn of_points<const N: usize, const M: usize>(
        points: [[f64; N]; M],
    ) -> Option<[[i64; N]; M]> {
        Self::with_top(exponent(points.as_flattened()))?.points(points)
    }

    /// As [`Grid::of_points`], with weights in units of the square of the grid's, below 2^123.
    #[inline]
    pub(crate) fn of_weighted_points<const N: usize, const M: usize>(
        points: [[f64; N]; M],
        weights: [f64; M],
    ) -> Option<([[i64; N]; M], [i128; M])> {
        let heaviest = (exponent(&weights) - 1024).div_euclid(2) + 1023;
        let grid = Self::with_top(exponent(points.as_flattened()).max(heaviest))?;
        let scaled = weights.map(|weight| weight * (grid.scale * grid.scale));
        let integers = scaled.map(|weight| weight as i128);
        let fits = |(&integer, &weight): (&i128, &f64)| {
            integer as f64 == weight && weight.abs() < power_of_two(123)
        };
        let weights = integers.iter().zip(&scaled).all(fits).then_some(integers)?;
        Some((grid.points(points)?, weights))
    }

    /// The grid for doubles of biased exponent at most `top`, unless that is beyond the accepted
    /// range.
    #[inline]
    fn with_top(top: i64) -> Option<Self> {
        let top = (top - 1023).max(-142);
        (top <= 202).then(|| Self {
            scale: power_of_two(60 - top),
        })
    }

    #[inline]
    fn points<const N: usize, const M: usize>(
        &self,
        points: [[f64; N]; M],
    ) -> Option<[[i64; N]; M]> {
        let mut exact = true;
        let integers = points.map(|point| {
            point.map(|coordinate| {
                let scaled = coordinate * self.scale;
                let integer = scaled as i64;
                exact &= integer as f64 == scaled;
                integer
            })
        });
        exact.then_some(integers)
    }
}

/// Greatest biased exponent of the values: 1023 for `[1, 2)`, 0 for zero, 2047 for NaN.
#[inline]
fn exponent(values: &[f64]) -> i64 {
    let bits = values.iter().map(|value| value.to_bits() & (u64::MAX >> 1));
    (bits.fold(0, u64::max) >> 52) as i64
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
        let points = [[1.0, -0.0], [-power_of_two(-60), 1.0]];
        assert_eq!(Grid::of_points(points), Some([[1 << 60, 0], [-1, 1 << 60]]));
        assert_eq!(Grid::of_points([[1.0, power_of_two(-61)]]), None);
        assert_eq!(Grid::of_points([[0.0]]), Some([[0]]));
        let most = 2.0f64.next_down();
        assert_eq!(Grid::of_points([[most]]), Some([[(1 << 61) - (1 << 8)]]));
    }

    #[test]
    fn numbers_that_are_not_finite_do_not_fit() {
        for value in [
            f64::NAN,
            f64::INFINITY,
            -f64::INFINITY,
            f64::MAX,
            f64::MIN_POSITIVE,
        ] {
            assert_eq!(Grid::of_points([[0.0, value]]), None);
            assert_eq!(Grid::of_weighted_points([[1.0]], [value]), None);
        }
    }

    #[test]
    fn weights_share_the_grid() {
        let found = Grid::of_weighted_points([[1.0], [0.0], [0.0]], [-0.5, 0.0, 3.0]);
        assert_eq!(
            found,
            Some(([[1 << 60], [0], [0]], [-1 << 119, 0, 3 << 120]))
        );
        let (_, [weight]) = Grid::of_weighted_points([[0.0]], [16.0f64.next_down()]).unwrap();
        assert!((1 << 121..1 << 123).contains(&weight));
        assert_eq!(
            Grid::of_weighted_points([[1.0]], [power_of_two(-130)]),
            None
        );
    }
}
