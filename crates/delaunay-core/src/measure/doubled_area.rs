//! Twice the area of a triangle in the plane, the one quantity in which a thin triangle loses its digits.
//!
//! It is taken at the corner with the largest angle, where the two edges are shortest, and summed with the
//! rounding errors of the differences and of the products.

use super::double_double::{product, sum};
use glam::DVec2;

/// The corners in the same cyclic order, starting opposite the longest edge.
pub(super) fn largest_angle_first([a, b, c]: [DVec2; 3]) -> [DVec2; 3] {
    let [ab, bc, ca] = [a - b, b - c, c - a].map(DVec2::length_squared);
    if bc >= ab && bc >= ca {
        [a, b, c]
    } else if ca >= ab {
        [b, c, a]
    } else {
        [c, a, b]
    }
}

/// Twice the signed area in units of `unit` squared, positive for counterclockwise corners: `(b - a) × (c - a)`
/// with first-order corrections for what rounds off.
///
/// The corners come as [`largest_angle_first`] gives them, the unit is a power of two.
pub(super) fn doubled_area([a, b, c]: [DVec2; 3], unit: f64) -> f64 {
    let (ab, ab_tail) = ((b - a) / unit, difference_tail(b, a) / unit);
    let (ac, ac_tail) = ((c - a) / unit, difference_tail(c, a) / unit);
    let (left, left_tail) = product(ab.x, ac.y);
    let (right, right_tail) = product(ab.y, ac.x);
    let tails = ab.perp_dot(ac_tail) + ab_tail.perp_dot(ac);
    let correction = (left_tail - right_tail) + tails;
    // Beside the largest numbers a tail overflows on the way, and there is nothing to correct with.
    let correction = if correction.is_finite() {
        correction
    } else {
        0.0
    };
    (left - right) + correction
}

/// What `p - q` loses by rounding, per coordinate.
fn difference_tail(p: DVec2, q: DVec2) -> DVec2 {
    DVec2::new(sum(p.x, -q.x).1, sum(p.y, -q.y).1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_corner_has_the_largest_angle() {
        let [a, b, c] = [[0.0, 0.0], [9.0, 0.0], [4.0, 1.0]].map(DVec2::from);
        for corners in [[a, b, c], [b, c, a], [c, a, b]] {
            assert_eq!(largest_angle_first(corners), [c, a, b]);
        }
    }

    #[test]
    fn a_thin_triangle_far_from_the_origin_keeps_its_digits() {
        let height = 2.0_f64.powi(-30);
        let corners = [[0.0, height], [-1.0, 0.0], [1.0, 0.0]]
            .map(|corner| DVec2::from(corner) + DVec2::new(1e6, -3e6));
        assert_eq!(doubled_area(corners, 1.0), 2.0 * height);
    }

    #[test]
    fn the_area_is_a_number_beside_the_largest_numbers() {
        let [x, y] = [f64::MAX, 8.403_057_791_051_773e307];
        let corners = [[0.076, 1e-5], [x, 3.8e258], [y, 0.556]].map(DVec2::from);
        for [a, b, c] in [[0, 1, 2], [1, 2, 0], [2, 0, 1]].map(|order| order.map(|i| corners[i])) {
            assert!(doubled_area([a, b, c], 2f64.powi(1023)).is_finite());
        }
    }

    #[test]
    fn differences_that_round_are_corrected() {
        // The first corner is beside the line through the others by less than a difference can hold.
        let aside = 2.0_f64.powi(-54);
        let corners = [[1.0, 1.0], [3.0, 3.0], [aside, 0.0]].map(DVec2::from);
        assert_eq!(doubled_area(corners, 1.0), -2.0 * aside);
    }
}
