//! Triangles of space seen along a coordinate axis, where two dimensions tell what happens in their plane.

use geo_predicates::{Sign, orient2d};
use glam::{DVec2, DVec3};

/// A coordinate axis to look along.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum View {
    X,
    Y,
    Z,
}

impl View {
    /// A view in which the triangle has area: its whole plane is seen one to one. `None` when its corners are
    /// on one line. Exact.
    pub(super) fn of_area(triangle: [DVec3; 3]) -> Option<Self> {
        let views = [Self::X, Self::Y, Self::Z];
        views.into_iter().find(|view| {
            let [a, b, c] = triangle.map(|corner| view.of(corner));
            orient2d(a, b, c) != Sign::Zero
        })
    }

    /// The point as it is seen: two of its coordinates, unrounded.
    pub(super) fn of(self, p: DVec3) -> DVec2 {
        match self {
            Self::X => DVec2::new(p.y, p.z),
            Self::Y => DVec2::new(p.z, p.x),
            Self::Z => DVec2::new(p.x, p.y),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn three_points_on_a_line_have_no_area_in_any_view() {
        let on_line = [0.0, 1.0, 3.0].map(|t| DVec3::new(0.1, 0.2, 0.3) * t);
        assert_eq!(View::of_area([DVec3::ZERO; 3]), None);
        // 3 (0.1, 0.2, 0.3) is rounded, and so just off the line.
        assert!(View::of_area(on_line).is_some());
        assert_eq!(View::of_area(on_line.map(|p| DVec3::splat(p.x))), None);
    }

    #[test]
    fn a_triangle_in_a_coordinate_plane_is_seen_along_its_axis() {
        let [x, y, z] = DVec3::AXES;
        assert_eq!(View::of_area([DVec3::ZERO, y, z]), Some(View::X));
        assert_eq!(View::of_area([DVec3::ZERO, z, x]), Some(View::Y));
        assert_eq!(View::of_area([DVec3::ZERO, x, y]), Some(View::Z));
    }
}
