//! Quadrilaterals in the plane: corners `[a, b, c, d]` in order round the boundary, counterclockwise.

use glam::DVec2;

use super::angle::degrees;
use super::scale::scale;

/// Area, positive when `a`, `b`, `c`, `d` turn counterclockwise; square of the unit of length.
///
/// For a self-crossing (bow-tie) quadrilateral, the area of one loop minus that of the other.
#[must_use]
pub fn signed_area(corners: [DVec2; 4]) -> f64 {
    let (unit, [ab, bc, cd, _]) = edges(corners);
    // Half the cross product of the diagonals.
    0.5 * (ab + bc).perp_dot(bc + cd) * unit * unit
}

/// Interior angles at `a`, `b`, `c`, `d` in degrees, in [0, 360).
///
/// An angle above 180° is a reflex corner: the cell is not convex there, or turns clockwise. The four of a
/// simple counterclockwise quadrilateral add up to 360°. A corner on a collapsed edge has angle 0.
#[must_use]
pub fn corner_angles(corners: [DVec2; 4]) -> [f64; 4] {
    edges_at_corners(corners).map(|(next, previous)| {
        let angle = degrees(next.perp_dot(previous), next.dot(previous));
        // A tiny negative angle would round to a full turn.
        if angle < 0.0 {
            (angle + 360.0).min(360f64.next_down())
        } else {
            angle
        }
    })
}

/// Least over the corners of the sine of the interior angle: dimensionless, in [-1, 1], 1 for a rectangle.
///
/// Not positive when a corner is flat, reflex or clockwise; 0 at best when an edge has collapsed. The value
/// is the Jacobian of the bilinear map at the corner over the lengths of the two edges there.
#[must_use]
pub fn scaled_jacobian(corners: [DVec2; 4]) -> f64 {
    edges_at_corners(corners)
        .map(|(next, previous)| sine(next, previous))
        .into_iter()
        .fold(f64::INFINITY, f64::min)
}

fn sine(u: DVec2, v: DVec2) -> f64 {
    let lengths = u.length() * v.length();
    if lengths == 0.0 {
        0.0
    } else {
        (u.perp_dot(v) / lengths).clamp(-1.0, 1.0)
    }
}

/// At each corner, the edges to the next and to the previous corner, in units of [`edges`].
fn edges_at_corners(corners: [DVec2; 4]) -> [(DVec2, DVec2); 4] {
    let (_, [ab, bc, cd, da]) = edges(corners);
    [(ab, -da), (bc, -ab), (cd, -bc), (da, -cd)]
}

/// The edges `ab`, `bc`, `cd`, `da` in units of a power of two, and that unit; all zero for a point.
fn edges([a, b, c, d]: [DVec2; 4]) -> (f64, [DVec2; 4]) {
    let edges = [b - a, c - b, d - c, a - d];
    match scale(edges.map(|edge| edge.abs().max_element())) {
        Some(unit) => (unit, edges.map(|edge| edge / unit)),
        None => (0.0, [DVec2::ZERO; 4]),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn corners(points: [[f64; 2]; 4]) -> [DVec2; 4] {
        points.map(DVec2::from)
    }

    const RECTANGLE: [[f64; 2]; 4] = [[0.0, 0.0], [3.0, 0.0], [3.0, 2.0], [0.0, 2.0]];

    #[test]
    fn a_rectangle_is_best() {
        let q = corners(RECTANGLE);
        assert_eq!((signed_area(q), scaled_jacobian(q)), (6.0, 1.0));
        assert_eq!(corner_angles(q), [90.0; 4]);
    }

    #[test]
    fn a_clockwise_rectangle_is_worst() {
        let [a, b, c, d] = corners(RECTANGLE);
        let q = [a, d, c, b];
        assert_eq!((signed_area(q), scaled_jacobian(q)), (-6.0, -1.0));
        assert_eq!(corner_angles(q), [270.0; 4]);
    }

    #[test]
    fn a_dart_has_one_reflex_corner() {
        let q = corners([[0.0, 0.0], [2.0, -2.0], [1.0, 0.0], [2.0, 2.0]]);
        let angles = corner_angles(q);
        assert!((angles.iter().sum::<f64>() - 360.0).abs() < 1e-12);
        assert_eq!(angles.iter().filter(|&&angle| angle > 180.0).count(), 1);
        assert!(angles[2] > 180.0 && scaled_jacobian(q) < 0.0);
        assert_eq!(signed_area(q), 2.0);
    }

    #[test]
    fn a_flat_corner_has_180_degrees() {
        let q = corners([[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [0.0, 1.0]]);
        assert_eq!((corner_angles(q)[1], scaled_jacobian(q)), (180.0, 0.0));
    }

    #[test]
    fn a_corner_that_just_folds_over_stays_below_a_full_turn() {
        let q = corners([[0.0, 0.0], [1.0, 0.0], [2.0, 5.0], [1.0, -1e-20]]);
        assert!((359.0..360.0).contains(&corner_angles(q)[0]));
    }

    #[test]
    fn collapsed_edges_have_the_worst_values() {
        let q = corners([[0.0, 0.0], [0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]);
        assert_eq!(scaled_jacobian(q), 0.0);
        assert_eq!(corner_angles(q)[..2], [0.0, 0.0]);
        let point = [DVec2::new(-1.0, 5.0); 4];
        assert_eq!((signed_area(point), scaled_jacobian(point)), (0.0, 0.0));
        assert_eq!(corner_angles(point), [0.0; 4]);
    }

    #[test]
    fn size_has_no_influence_up_to_the_ends_of_the_accepted_range() {
        let unit = corners([[0.0, 0.0], [3.0, 1.0], [3.0, 2.0], [0.0, 2.0]]);
        for size in [2f64.powi(-142), 2f64.powi(201)] {
            let scaled = unit.map(|p| p * size);
            assert_eq!(corner_angles(scaled), corner_angles(unit));
            assert_eq!(scaled_jacobian(scaled), scaled_jacobian(unit));
            assert_eq!(signed_area(scaled), signed_area(unit) * size * size);
        }
    }
}
