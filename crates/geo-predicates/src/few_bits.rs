//! Coordinates with so few bits that determinants in doubles are exact.

use crate::coordinate::power_of_two;

/// Extent of a set of points in units of the lowest bit that any of their coordinates has: when
/// it is `e`, differences of points are integers of magnitude at most `e` in those units.
///
/// Infinite as soon as it exceeds `limit`, or when a coordinate is not an accepted one. At most
/// linear in the number of points.
pub(crate) fn extent<const N: usize>(points: impl Iterator<Item = [f64; N]>, limit: f64) -> f64 {
    let mut range = [(f64::INFINITY, f64::NEG_INFINITY); N];
    let mut lowest = i64::MAX;
    let mut extent = 0.0;
    for point in points {
        for (range, x) in range.iter_mut().zip(point) {
            let Some(bit) = lowest_bit(x) else {
                return f64::INFINITY;
            };
            lowest = lowest.min(bit);
            *range = (range.0.min(x), range.1.max(x));
        }
        let widest = range
            .iter()
            .map(|(least, most)| most - least)
            .fold(0.0, f64::max);
        extent = if widest == 0.0 {
            0.0
        } else {
            widest / power_of_two(lowest)
        };
        if extent > limit {
            return f64::INFINITY;
        }
    }
    extent
}

/// Exponent of the lowest bit of an accepted coordinate; the greatest exponent for zero.
fn lowest_bit(x: f64) -> Option<i64> {
    let bits = x.to_bits();
    let biased = ((bits >> 52) & 0x7ff) as i64;
    match biased {
        _ if x == 0.0 => Some(1023),
        0 | 0x7ff => None,
        _ => Some((biased - 1075 + i64::from((bits | 1 << 52).trailing_zeros())).max(-1022)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_extent_is_counted_in_units_of_the_lowest_bit() {
        let of = |points: &[[f64; 2]]| extent(points.iter().copied(), 1e9);
        assert_eq!(of(&[[0.0, 3.0], [1.0, -4.0]]), 7.0);
        assert_eq!(of(&[[0.25, 3.0], [1.0, -4.0]]), 28.0);
        assert_eq!(of(&[[1024.0, 0.0], [3072.0, 1024.0]]), 2.0);
        assert_eq!(of(&[[1e6, 1e6], [1e6 + 1.0, 1e6 + 3.0]]), 3.0);
        assert_eq!(of(&[[5.0, 5.0], [5.0, 5.0]]), 0.0);
        assert_eq!(of(&[]), 0.0);
    }

    #[test]
    fn many_bits_and_refused_coordinates_have_no_extent() {
        let of = |x: f64| extent([[0.0], [x]].into_iter(), 1e6);
        for x in [
            0.1,
            f64::NAN,
            f64::INFINITY,
            f64::MIN_POSITIVE / 2.0,
            1e6 + 1.0,
        ] {
            assert_eq!(of(x), f64::INFINITY);
        }
        assert_eq!(of(1e6), 1e6 / 64.0);
    }
}
