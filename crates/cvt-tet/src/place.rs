//! Where a generator may go: the set P of a constrained tessellation (§3.1, definition 3.2).

use delaunay_core::ConvexPolygon;
use glam::DVec2;

/// The part of the region to which a generator is bound.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Place {
    /// It is free.
    Inside,
    /// It slides along the edge of the region that starts at this corner.
    Edge(usize),
    /// It stays at this corner of the region.
    Corner(usize),
}

impl Place {
    /// The point of this place that is nearest to `center`.
    ///
    /// For a fixed cell the cost is the mass times the squared distance from the mass centroid, plus what no
    /// generator can change: so the nearest point to the centroid is the cheapest (§3.2 step 2).
    pub(crate) fn nearest(self, region: &ConvexPolygon, center: DVec2) -> DVec2 {
        let corner = |i: usize| {
            region
                .corners()
                .iter()
                .cycle()
                .nth(i)
                .copied()
                .unwrap_or(center)
        };
        match self {
            Self::Inside => center,
            Self::Edge(edge) => nearest_on_segment([corner(edge), corner(edge + 1)], center),
            Self::Corner(i) => corner(i),
        }
    }

    /// Whether the edge of the region that starts at corner `edge` of `corners` contains this place.
    pub(crate) fn is_on(self, edge: usize, corners: usize) -> bool {
        match self {
            Self::Inside => false,
            Self::Edge(own) => own == edge,
            Self::Corner(corner) => corner == edge || corner == (edge + 1) % corners,
        }
    }
}

fn nearest_on_segment([a, b]: [DVec2; 2], p: DVec2) -> DVec2 {
    let along = ((p - a).dot(b - a) / (b - a).length_squared()).clamp(0.0, 1.0);
    // Not a blend of a and b: this one keeps to horizontal and vertical edges without rounding.
    a + along * (b - a)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_nearest_point_of_an_edge_is_at_a_right_angle_or_an_end() {
        let square = ConvexPolygon::rectangle(DVec2::ZERO, DVec2::ONE).unwrap();
        let nearest = |place: Place, x, y| place.nearest(&square, DVec2::new(x, y)).to_array();
        assert_eq!(nearest(Place::Inside, 0.3, 0.4), [0.3, 0.4]);
        assert_eq!(nearest(Place::Edge(0), 0.3, 0.4), [0.3, 0.0]);
        assert_eq!(nearest(Place::Edge(3), 0.3, 0.4), [0.0, 0.4]);
        assert_eq!(nearest(Place::Edge(1), 0.5, 7.0), [1.0, 1.0]);
        assert_eq!(nearest(Place::Corner(2), 0.3, 0.4), [1.0, 1.0]);
    }

    #[test]
    fn a_corner_is_on_its_two_edges() {
        let edges = |place: Place| {
            (0..4)
                .filter(|&edge| place.is_on(edge, 4))
                .collect::<Vec<_>>()
        };
        assert_eq!(edges(Place::Corner(0)), [0, 3]);
        assert_eq!(edges(Place::Corner(3)), [2, 3]);
        assert_eq!(edges(Place::Edge(1)), [1]);
        assert!(edges(Place::Inside).is_empty());
    }
}
