//! The last resort: places as integers of any length.

use std::cmp::Ordering;

use num_bigint::BigInt;

use super::point::ExactPoint3;
use crate::unbounded::{least_exponent, scaled};

/// Places in units of a common power of two that makes all of them whole.
pub(super) fn whole<const N: usize>(points: [ExactPoint3<'_>; N]) -> [[BigInt; 3]; N] {
    // The unit is that of the ends of all segments times that of the shares.
    let mut places = Vec::with_capacity(6 * N);
    let mut shares = Vec::with_capacity(N);
    for point in &points {
        match point {
            ExactPoint3::Given(place) => places.extend(place.to_array()),
            ExactPoint3::OnSegment(point) => {
                let [from, to] = point.ends();
                places.extend(from.to_array());
                places.extend(to.to_array());
                shares.push(point.share());
            }
        }
    }
    let unit = least_exponent(&places);
    let share_unit = least_exponent(&shares).min(0);
    let shift = share_unit.unsigned_abs() as usize;
    points.map(|point| match point {
        ExactPoint3::Given(place) => place
            .to_array()
            .map(|coordinate| scaled(coordinate, unit) << shift),
        ExactPoint3::OnSegment(point) => {
            let [from, to] = point.ends().map(|end| end.to_array());
            let share = scaled(point.share(), share_unit);
            std::array::from_fn(|axis| {
                let [from, to] = [from, to].map(|end| scaled(end[axis], unit));
                let length = to - &from;
                (from << shift) + &share * length
            })
        }
    })
}

/// Which of two places comes first along an axis.
#[cold]
pub(super) fn compare_exactly(a: &ExactPoint3<'_>, b: &ExactPoint3<'_>, axis: usize) -> Ordering {
    let [a, b] = whole([*a, *b]);
    a[axis].cmp(&b[axis])
}
