//! The circumcenter of a triangle, as well as it can be rounded.
//!
//! Everything is relative to the corner with the largest angle, where the two edges are shortest. The
//! one quantity that can lose all its digits, the doubled area of a thin triangle, is summed with the
//! rounding errors of the differences and of the products.

use glam::DVec2;

/// The point at equal distance from `a`, `b`, `c`, corners in either order.
///
/// Relative to the circumradius the error is of the order of 1e-15 as long as the height of the triangle is
/// more than about 1e-16 of its longest edge times the distance of its corners from the origin; beyond that the
/// center of a still thinner triangle may be anywhere along its axis, even at infinity.
pub(super) fn circumcenter(a: DVec2, b: DVec2, c: DVec2) -> DVec2 {
    let [a, b, c] = largest_angle_first(a, b, c);
    let (ab, ac) = (b - a, c - a);
    let offset = ab.length_squared() * ac.perp() - ac.length_squared() * ab.perp();
    // `perp` turns by a right angle to the left, hence the sign.
    a - offset / (2.0 * doubled_area(a, b, c))
}

/// The corners in the same cyclic order, starting opposite the longest edge.
fn largest_angle_first(a: DVec2, b: DVec2, c: DVec2) -> [DVec2; 3] {
    let [ab, bc, ca] = [a - b, b - c, c - a].map(DVec2::length_squared);
    if bc >= ab && bc >= ca {
        [a, b, c]
    } else if ca >= ab {
        [b, c, a]
    } else {
        [c, a, b]
    }
}

/// Twice the signed area: `(b - a) × (c - a)` with first-order corrections for what rounds off.
fn doubled_area(a: DVec2, b: DVec2, c: DVec2) -> f64 {
    let (ab, ab_tail) = (b - a, difference_tail(b, a));
    let (ac, ac_tail) = (c - a, difference_tail(c, a));
    let (left, left_tail) = product(ab.x, ac.y);
    let (right, right_tail) = product(ab.y, ac.x);
    let tails = ab.perp_dot(ac_tail) + ab_tail.perp_dot(ac);
    (left - right) + ((left_tail - right_tail) + tails)
}

/// What `p - q` loses by rounding (Knuth's exact sum, per coordinate).
fn difference_tail(p: DVec2, q: DVec2) -> DVec2 {
    let difference = p - q;
    let q_virtual = p - difference;
    let p_virtual = difference + q_virtual;
    (p - p_virtual) + (q_virtual - q)
}

/// A product and what it loses by rounding (Dekker's splitting).
fn product(x: f64, y: f64) -> (f64, f64) {
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
    fn the_right_triangle_has_its_center_on_the_hypotenuse() {
        let center = circumcenter(DVec2::ZERO, DVec2::new(4.0, 0.0), DVec2::new(0.0, 2.0));
        assert_eq!(center, DVec2::new(2.0, 1.0));
    }

    #[test]
    fn a_flat_triangle_far_from_the_origin_keeps_its_digits() {
        // Height h over a base of length 2: circumradius (1 + h^2) / (2 h) below the apex.
        let h = 2.0_f64.powi(-30);
        let o = DVec2::new(1e6, -3e6);
        let corner = |x, y| o + DVec2::new(x, y);
        let center = circumcenter(corner(-1.0, 0.0), corner(1.0, 0.0), corner(0.0, h));
        let exact = corner(0.0, h - (1.0 + h * h) / (2.0 * h));
        let radius = 0.5 / h;
        assert!(center.distance(exact) < 1e-14 * radius, "{center} {exact}");
    }

    #[test]
    fn the_order_of_corners_does_not_matter() {
        let [a, b, c] = [[0.1, 0.7], [3.3, -0.2], [1.9, 2.4]].map(DVec2::from);
        let center = circumcenter(a, b, c);
        for other in [circumcenter(b, c, a), circumcenter(c, b, a)] {
            assert!(center.distance(other) < 1e-15 * 4.0);
        }
    }
}
