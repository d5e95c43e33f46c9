//! A cut through a solid: what a plane has in common with its tetrahedra, coloured by their ratio r/l.

use delaunay_core::Subcomplex3;
use delaunay_core::measure::tetrahedron::radius_edge_ratio;
use glam::{DVec2, DVec3};
use mesh_io::svg::{Color, Panel, Stroke, Window};

use super::classes::{Class, Classes};

/// A plane on which one coordinate is fixed.
#[derive(Clone, Copy, Debug)]
pub(super) enum Plane {
    /// Seen along the y axis: x to the right, z up.
    Y(f64),
    /// Seen from above: x to the right, y up.
    Z(f64),
}

/// Good tetrahedra are blue, those of low quality yellow to red. Many meet the plane in specks: a line hardly to be seen round
/// each.
pub(super) const RATIOS: Classes = Classes {
    all: CLASSES,
    edge: Stroke {
        color: Color::INK,
        width: 0.2,
        dotted: false,
    },
};

const CLASSES: &[Class] = &[
    Class {
        bound: 1.0,
        color: Color::SKY,
        text: "r/l up to 1",
    },
    Class {
        bound: 2.0,
        color: Color([0x9d, 0xbc, 0xdf]),
        text: "1 to 2",
    },
    Class {
        bound: 4.0,
        color: Color([0xf6, 0xe6, 0xbd]),
        text: "of low quality: 2 to 4",
    },
    Class {
        bound: 8.0,
        color: Color([0xe3, 0xb5, 0x57]),
        text: "4 to 8",
    },
    Class {
        bound: f64::INFINITY,
        color: Color::RED,
        text: "above 8",
    },
];

/// The piece of the plane inside `solid`, one polygon for each tetrahedron it meets.
pub(super) fn panel(solid: &Subcomplex3, plane: Plane, caption: &str) -> Panel {
    let tetrahedra = solid.tets().map(|t| solid.tetrahedron(t));
    let pieces: Vec<(f64, Vec<DVec2>)> = tetrahedra
        .filter_map(|corners| Some((radius_edge_ratio(corners), plane.section(corners)?)))
        .collect();
    let corners = pieces
        .iter()
        .flat_map(|(_, corners)| corners.iter().copied());
    let mut panel = Panel::new(Window::around(corners).widened(0.01)).caption(caption);
    RATIOS.draw(&mut panel, &pieces);
    panel
}

impl Plane {
    /// What the plane has in common with a tetrahedron: a triangle, or a quadrilateral, its corners in order round it.
    ///
    /// A corner on the plane counts as above it.
    fn section(self, corners: [DVec3; 4]) -> Option<Vec<DVec2>> {
        let (below, above): (Vec<DVec3>, Vec<DVec3>) =
            corners.into_iter().partition(|&p| self.height(p) < 0.0);
        let crossings = match (below.as_slice(), above.as_slice()) {
            (&[apex], base) | (base, &[apex]) => base.iter().map(|&p| [apex, p]).collect(),
            // Neighbouring crossings share a corner.
            (&[a, b], &[c, d]) => vec![[a, c], [a, d], [b, d], [b, c]],
            _ => return None,
        };
        Some(
            crossings
                .into_iter()
                .map(|edge| self.crossing(edge))
                .collect(),
        )
    }

    /// Where an edge with an end on either side meets the plane.
    fn crossing(self, [a, b]: [DVec3; 2]) -> DVec2 {
        let [above, below] = [a, b].map(|p| self.height(p));
        self.seen(a.lerp(b, above / (above - below)))
    }

    /// Above the plane, negative below.
    fn height(self, p: DVec3) -> f64 {
        match self {
            Self::Y(at) => p.y - at,
            Self::Z(at) => p.z - at,
        }
    }

    /// A point of the plane as it is drawn.
    fn seen(self, p: DVec3) -> DVec2 {
        match self {
            Self::Y(_) => DVec2::new(p.x, p.z),
            Self::Z(_) => DVec2::new(p.x, p.y),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const CORNERS: [DVec3; 4] = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z];

    #[test]
    fn near_a_corner_the_section_is_a_triangle() {
        let section = Plane::Z(0.5).section(CORNERS).unwrap();
        let expected = [[0.0, 0.0], [0.5, 0.0], [0.0, 0.5]].map(DVec2::from);
        assert_eq!(section, expected);
    }

    #[test]
    fn between_two_edges_it_is_a_quadrilateral_with_corners_in_order() {
        let turned = [DVec3::ZERO, DVec3::X, DVec3::Z, DVec3::new(0.0, 1.0, 1.0)];
        let section = Plane::Z(0.5).section(turned).unwrap();
        let expected = [[0.0, 0.0], [0.0, 0.5], [0.5, 0.5], [0.5, 0.0]].map(DVec2::from);
        assert_eq!(section, expected);
    }

    #[test]
    fn a_plane_beside_the_tetrahedron_has_nothing_of_it() {
        assert_eq!(Plane::Y(1.5).section(CORNERS), None);
        assert_eq!(Plane::Y(-0.5).section(CORNERS), None);
    }
}
