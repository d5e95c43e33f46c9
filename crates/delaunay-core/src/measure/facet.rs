//! Triangles in space: corners `[a, b, c]` in either orientation, measured as [`triangle`](super::triangle)
//! does in the plane.

use glam::DVec3;

use super::double_double::DoubleDVec3;
use super::scale::{scale, scaled};
use super::shape::Shape;

/// Area, not negative; square of the unit of length.
#[must_use]
pub fn area(corners: [DVec3; 3]) -> f64 {
    shape(corners).area()
}

/// Angles at `a`, `b`, `c` in degrees, in [0, 180].
///
/// Three corners on a line give 0, 0 and 180; a corner that coincides with another has angle 0.
#[must_use]
pub fn angles(corners: [DVec3; 3]) -> [f64; 3] {
    shape(corners).angles()
}

/// Radius of the circle through the corners, unit of length; infinite when the area is zero.
#[must_use]
pub fn circumradius(corners: [DVec3; 3]) -> f64 {
    shape(corners).circumradius()
}

/// Radius of the inscribed circle, unit of length; 0 when the area is zero.
#[must_use]
pub fn inradius(corners: [DVec3; 3]) -> f64 {
    shape(corners).inradius()
}

/// Length of the shortest edge.
#[must_use]
pub fn shortest_edge(corners: [DVec3; 3]) -> f64 {
    shape(corners).shortest_edge()
}

/// Length of the longest edge.
#[must_use]
pub fn longest_edge(corners: [DVec3; 3]) -> f64 {
    shape(corners).longest_edge()
}

/// Circumradius over shortest edge, r/l: dimensionless, at least 1/√3 (equilateral), infinite when the area
/// is zero. Source: sink paper §4.3.
#[must_use]
pub fn radius_edge_ratio(corners: [DVec3; 3]) -> f64 {
    shape(corners).radius_edge_ratio()
}

/// The center of the circle through the corners, in their plane; [`DVec3::INFINITY`] when they are on a line.
///
/// Relative to the circumradius the error is of the order of 1e-15, unless the height of the triangle is below about
/// 1e-30 of its longest edge.
#[must_use]
pub fn circumcenter([a, b, c]: [DVec3; 3]) -> DVec3 {
    let Some(unit) = scale([b - a, c - a].map(|edge| edge.abs().max_element())) else {
        return DVec3::INFINITY;
    };
    let [u, v] = [b, c].map(|corner| DoubleDVec3::difference(corner, a, unit));
    let normal = u.cross(v);
    let offset = u.dot(u) * v.cross(normal) + v.dot(v) * normal.cross(u);
    let center = a + unit * (offset.rounded() / (2.0 * normal.dot(normal).rounded()));
    if center.is_finite() {
        center
    } else {
        DVec3::INFINITY
    }
}

/// Twice the inradius over the circumradius: dimensionless, in [0, 1], 1 for the equilateral triangle, 0 when
/// the area is zero. Source: bubble paper, eq. 10.
#[must_use]
pub fn radius_ratio(corners: [DVec3; 3]) -> f64 {
    shape(corners).radius_ratio()
}

/// The normal of unit length from which the corners turn counterclockwise; zero for three corners on a line.
///
/// The error is of the order of 1e-16 unless the height is below about 1e-30 of the longest edge; then the
/// normal may be anything, even zero.
#[must_use]
pub fn normal([a, b, c]: [DVec3; 3]) -> DVec3 {
    let Some(unit) = scale([b - a, c - a].map(|edge| edge.abs().max_element())) else {
        return DVec3::ZERO;
    };
    let [ab, ac] = [b, c].map(|corner| DoubleDVec3::difference(corner, a, unit));
    let (_, cross) = scaled(ab.cross(ac).rounded());
    cross.normalize_or_zero()
}

fn shape([a, b, c]: [DVec3; 3]) -> Shape {
    let edges = [b - a, c - b, a - c];
    let Some(unit) = scale(edges.map(|edge| edge.abs().max_element())) else {
        return Shape::default();
    };
    let [ab, bc, ca] = edges.map(|edge| edge / unit);
    Shape {
        unit,
        edges: [bc, ca, ab].map(DVec3::length),
        dots: [-ab.dot(ca), -bc.dot(ab), -ca.dot(bc)],
        cross: shortest_cross([ab, bc, ca]).length(),
    }
}

/// The product of the two shortest edges loses the least to cancellation.
fn shortest_cross([ab, bc, ca]: [DVec3; 3]) -> DVec3 {
    let [squared_ab, squared_bc, squared_ca] = [ab, bc, ca].map(DVec3::length_squared);
    if squared_bc >= squared_ab && squared_bc >= squared_ca {
        ca.cross(ab)
    } else if squared_ca >= squared_ab {
        ab.cross(bc)
    } else {
        bc.cross(ca)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_circumcenter_is_at_equal_distance_in_the_plane() {
        let corners = [[1.0, 2.0, 3.0], [4.0, -1.0, 3.5], [1.0 + 1e-7, 2.0, 3.0]].map(DVec3::from);
        let center = circumcenter(corners);
        let radius = circumradius(corners);
        for corner in corners {
            assert!((center.distance(corner) / radius - 1.0).abs() < 1e-14);
        }
        let height = (center - corners[0]).dot(normal(corners));
        assert!(height.abs() < 1e-14 * radius);
        assert_eq!(
            circumcenter([DVec3::ZERO, DVec3::X, 2.0 * DVec3::X]),
            DVec3::INFINITY
        );
    }

    #[test]
    fn a_right_triangle_in_space_has_its_school_values() {
        let t = [[1.0, 1.0, 1.0], [1.0, 5.0, 1.0], [1.0, 1.0, 4.0]].map(DVec3::from);
        assert_eq!((area(t), circumradius(t), inradius(t)), (6.0, 2.5, 1.0));
        assert_eq!((shortest_edge(t), longest_edge(t)), (3.0, 5.0));
        assert_eq!((angles(t)[0], radius_ratio(t)), (90.0, 0.8));
    }

    #[test]
    fn the_normal_of_a_thin_facet_keeps_its_digits() {
        let thin = [
            [1e6, 2e6, 3e6],
            [1e6 + 1.0, 2e6 + 1.0, 3e6],
            [1e6 + 2.0, 2e6 + 2.0, 3e6 + 1e-9],
        ];
        let normal = normal(thin.map(DVec3::from));
        let exact = DVec3::new(1.0, -1.0, 0.0).normalize();
        assert!(normal.distance(exact) < 1e-15, "{normal}");
        assert_eq!(super::normal([DVec3::X, DVec3::Y, DVec3::Y]), DVec3::ZERO);
        assert_eq!(
            super::normal([DVec3::ZERO, DVec3::X * 1e50, DVec3::Y * 1e-40]),
            DVec3::Z
        );
    }

    #[test]
    fn a_collapsed_facet_has_the_worst_values() {
        let point = [DVec3::ONE; 3];
        assert_eq!(
            (area(point), inradius(point), radius_ratio(point)),
            (0.0, 0.0, 0.0)
        );
        assert_eq!(
            [circumradius(point), radius_edge_ratio(point)],
            [f64::INFINITY; 2]
        );
        assert_eq!(angles(point), [0.0; 3]);
    }
}
