//! Triangles in the plane: corners `[a, b, c]` in either orientation; only [`signed_area`] tells them apart.

use glam::DVec2;

use super::doubled_area::{doubled_area, largest_angle_first};
use super::scale::scale;
use super::shape::Shape;

/// Area, positive when `a`, `b`, `c` turn counterclockwise; square of the unit of length.
///
/// Rounded: use `orient2d` for the sign.
#[must_use]
pub fn signed_area(corners: [DVec2; 3]) -> f64 {
    unit(corners).map_or(0.0, |unit| {
        0.5 * doubled_area(largest_angle_first(corners), unit) * unit * unit
    })
}

/// Area, not negative; square of the unit of length.
#[must_use]
pub fn area(corners: [DVec2; 3]) -> f64 {
    shape(corners).area()
}

/// Angles at `a`, `b`, `c` in degrees, in [0, 180].
///
/// Three corners on a line give 0, 0 and 180; a corner that coincides with another has angle 0.
#[must_use]
pub fn angles(corners: [DVec2; 3]) -> [f64; 3] {
    shape(corners).angles()
}

/// The point at equal distance from the corners; [`DVec2::INFINITY`] when the area is zero.
///
/// Relative to the circumradius the error is of the order of 1e-15 as long as the height of the triangle is
/// more than about 1e-16 of its longest edge times the distance of its corners from the origin; beyond that
/// the center of a still thinner triangle may be anywhere along its axis, even at infinity.
#[must_use]
pub fn circumcenter(corners: [DVec2; 3]) -> DVec2 {
    let Some(unit) = unit(corners) else {
        return DVec2::INFINITY;
    };
    let [a, b, c] = largest_angle_first(corners);
    let (ab, ac) = ((b - a) / unit, (c - a) / unit);
    let offset = ab.length_squared() * ac.perp() - ac.length_squared() * ab.perp();
    // `perp` turns by a right angle to the left, hence the sign.
    let center = a - unit * (offset / (2.0 * doubled_area([a, b, c], unit)));
    if center.is_finite() {
        center
    } else {
        DVec2::INFINITY
    }
}

/// Radius of the circle through the corners, unit of length; infinite when the area is zero.
#[must_use]
pub fn circumradius(corners: [DVec2; 3]) -> f64 {
    shape(corners).circumradius()
}

/// Radius of the inscribed circle, unit of length; 0 when the area is zero.
#[must_use]
pub fn inradius(corners: [DVec2; 3]) -> f64 {
    shape(corners).inradius()
}

/// Length of the shortest edge.
#[must_use]
pub fn shortest_edge(corners: [DVec2; 3]) -> f64 {
    shape(corners).shortest_edge()
}

/// Length of the longest edge.
#[must_use]
pub fn longest_edge(corners: [DVec2; 3]) -> f64 {
    shape(corners).longest_edge()
}

/// Circumradius over shortest edge, r/l: dimensionless, at least 1/√3 (equilateral), infinite when the area
/// is zero.
///
/// The smallest angle is arcsin(1 / (2 r/l)). Source: blocking paper §4.1; sink paper §4.3.
#[must_use]
pub fn radius_edge_ratio(corners: [DVec2; 3]) -> f64 {
    shape(corners).radius_edge_ratio()
}

/// Twice the inradius over the circumradius: dimensionless, in [0, 1], 1 for the equilateral triangle, 0 when
/// the area is zero.
///
/// Source: bubble paper, eq. 10.
#[must_use]
pub fn radius_ratio(corners: [DVec2; 3]) -> f64 {
    shape(corners).radius_ratio()
}

fn shape([a, b, c]: [DVec2; 3]) -> Shape {
    let Some(unit) = unit([a, b, c]) else {
        return Shape::default();
    };
    let [ab, bc, ca] = [b - a, c - b, a - c].map(|edge| edge / unit);
    Shape {
        unit,
        edges: [bc, ca, ab].map(DVec2::length),
        dots: [-ab.dot(ca), -bc.dot(ab), -ca.dot(bc)],
        cross: doubled_area(largest_angle_first([a, b, c]), unit).abs(),
    }
}

/// A power of two near the longest edge; `None` when the corners coincide.
fn unit([a, b, c]: [DVec2; 3]) -> Option<f64> {
    scale([b - a, c - b, a - c].map(|edge| edge.abs().max_element()))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn corners(points: [[f64; 2]; 3]) -> [DVec2; 3] {
        points.map(DVec2::from)
    }

    #[test]
    fn the_right_triangle_3_4_5_has_its_school_values() {
        let t = corners([[0.0, 0.0], [4.0, 0.0], [0.0, 3.0]]);
        assert_eq!((signed_area(t), area(t)), (6.0, 6.0));
        assert_eq!(signed_area([t[1], t[0], t[2]]), -6.0);
        assert_eq!(circumcenter(t), DVec2::new(2.0, 1.5));
        assert_eq!((circumradius(t), inradius(t)), (2.5, 1.0));
        assert_eq!((shortest_edge(t), longest_edge(t)), (3.0, 5.0));
        assert_eq!(angles(t)[0], 90.0);
        assert_eq!(radius_edge_ratio(t), 2.5 / 3.0);
        assert_eq!(radius_ratio(t), 0.8);
    }

    #[test]
    fn the_equilateral_triangle_is_best() {
        let t = corners([[0.0, 0.0], [2.0, 0.0], [1.0, 3f64.sqrt()]]);
        assert!((radius_ratio(t) - 1.0).abs() < 1e-15);
        assert!((radius_edge_ratio(t) - 1.0 / 3f64.sqrt()).abs() < 1e-15);
        assert!(angles(t).iter().all(|angle| (angle - 60.0).abs() < 1e-13));
    }

    #[test]
    fn three_corners_on_a_line_have_the_worst_values() {
        let t = corners([[0.0, 0.0], [1.0, 1.0], [3.0, 3.0]]);
        assert_eq!(angles(t), [0.0, 180.0, 0.0]);
        assert_eq!((radius_ratio(t), inradius(t)), (0.0, 0.0));
        assert_eq!([radius_edge_ratio(t), circumradius(t)], [f64::INFINITY; 2]);
        assert_eq!(circumcenter(t), DVec2::INFINITY);
    }

    #[test]
    fn coincident_corners_have_the_worst_values() {
        for t in [[[1.0, 2.0]; 3], [[0.0, 0.0], [0.0, 0.0], [1.0, 0.0]]].map(corners) {
            assert_eq!(angles(t), [0.0; 3]);
            assert_eq!((area(t), signed_area(t), shortest_edge(t)), (0.0, 0.0, 0.0));
            assert_eq!(
                (radius_ratio(t), radius_edge_ratio(t)),
                (0.0, f64::INFINITY)
            );
            assert_eq!(circumcenter(t), DVec2::INFINITY);
        }
    }

    #[test]
    fn size_has_no_influence_up_to_the_ends_of_the_accepted_range() {
        let unit = corners([[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]);
        for size in [2f64.powi(-142), 2f64.powi(201)] {
            let scaled = unit.map(|p| p * size);
            assert_eq!(circumcenter(scaled), size * circumcenter(unit));
            assert_eq!(circumradius(scaled), size * circumradius(unit));
            assert_eq!(radius_edge_ratio(scaled), radius_edge_ratio(unit));
            assert_eq!(radius_ratio(scaled), radius_ratio(unit));
        }
    }

    #[test]
    fn a_needle_keeps_an_accurate_smallest_angle() {
        let [_, _, angle] = angles(corners([[0.0, 0.0], [1e-9, 0.0], [0.0, 1.0]]));
        assert!((angle.to_radians() - 1e-9).abs() < 1e-24);
    }

    #[test]
    fn a_flat_triangle_far_from_the_origin_keeps_its_center() {
        // Height h over a base of length 2: circumradius (1 + h^2) / (2 h) below the apex.
        let h = 2.0_f64.powi(-30);
        let corner = |x, y| DVec2::new(1e6, -3e6) + DVec2::new(x, y);
        let t = [corner(-1.0, 0.0), corner(1.0, 0.0), corner(0.0, h)];
        let exact = corner(0.0, h - (1.0 + h * h) / (2.0 * h));
        assert!(circumcenter(t).distance(exact) < 1e-14 * circumradius(t));
        assert!((circumradius(t) - 0.5 / h).abs() < 1e-14 / h);
    }
}
