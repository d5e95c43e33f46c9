//! A quick way to see that two triangles do not intersect: along an axis, an edge of one has the other beyond it, or in space the
//! plane of one has the other on one side.
//!
//! ```text
//!          ·-----·         All that the line has of the first triangle is its edge, and all that it has of the second
//!           \ 1 / \        are corners that both share. Where the first has area, so it is in space.
//!            \ /   \
//!       - - - ·-----· - -  Neighbours in one plane, for which the signs of volumes are zero and slow to be exact, are parted
//!              \ 2 /       by areas, which are fast.
//!               \ /
//!                ·
//! ```

use crate::ids::VertexId;
use crate::tet::projection::View;
use geo_predicates::{Sign, orient2d, orient3d};
use glam::{DVec2, DVec3};

/// A triangle as it is seen along an axis.
pub(super) struct Seen {
    corners: [VertexId; 3],
    places: [DVec3; 3],
    seen: [DVec2; 3],
    turn: Sign,
}

impl Seen {
    pub(super) fn of(view: View, corners: [VertexId; 3], places: [DVec3; 3]) -> Self {
        let seen = places.map(|place| view.of(place));
        let [a, b, c] = seen;
        Self {
            corners,
            places,
            seen,
            turn: orient2d(a, b, c),
        }
    }

    /// Whether an edge or the plane of one of the triangles parts them, so that they have nothing in common but corners and an edge that they
    /// share. Exact when true; when false, they may be parted all the same.
    pub(super) fn parted(&self, other: &Self) -> bool {
        self.has_beyond_an_edge(other)
            || other.has_beyond_an_edge(self)
            || self.has_on_one_side(other)
            || other.has_on_one_side(self)
    }

    /// Whether the other triangle, but for shared corners, is strictly beyond an edge of this one.
    fn has_beyond_an_edge(&self, other: &Self) -> bool {
        let beyond = |[from, to]: [usize; 2]| {
            let ends = [self.corners[from], self.corners[to]];
            let [p, q] = [self.seen[from], self.seen[to]];
            let mut corners = other.corners.iter().zip(other.seen);
            corners.all(|(v, place)| ends.contains(v) || orient2d(p, q, place) == -self.turn)
        };
        self.turn != Sign::Zero && [[0, 1], [1, 2], [2, 0]].into_iter().any(beyond)
    }

    /// Whether the other triangle, but for shared corners, is strictly on one side of the plane of this one.
    fn has_on_one_side(&self, other: &Self) -> bool {
        let [a, b, c] = self.places;
        let corners = other.corners.iter().zip(other.places);
        let mut sides = corners
            .filter(|(v, _)| !self.corners.contains(v))
            .map(|(_, place)| orient3d(a, b, c, place));
        let first = sides.next().unwrap_or(Sign::Zero);
        first != Sign::Zero && sides.all(|side| side == first)
    }
}

/// The axis along which a triangle looks largest. Rounded: another axis only shows less.
pub(super) fn best_view([a, b, c]: [DVec3; 3]) -> View {
    let normal = (b - a).cross(c - a).abs();
    [View::X, View::Y, View::Z][normal.max_position()]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tet::intersection::triangles_intersect;
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(2048))]

        /// Corners on a small lattice, of which some are shared.
        #[test]
        fn parted_triangles_do_not_intersect(
            corners in prop::array::uniform6(prop::array::uniform3(0_i32..4)),
            shared in 0_usize..3,
        ) {
            let points = corners.map(|p| DVec3::from(p.map(f64::from)));
            let [first, mut second] = [[0, 1, 2], [3, 4, 5]];
            second[..shared].copy_from_slice(&first[..shared]);
            let mut different: Vec<_> = first.iter().chain(&second[shared..]).map(|&i| corners[i]).collect();
            different.sort_unstable();
            prop_assume!(different.windows(2).all(|pair| pair[0] != pair[1]));
            let places = |triangle: [usize; 3]| triangle.map(|i| points[i]);
            prop_assume!([first, second].into_iter().all(|t| View::of_area(places(t)).is_some()));
            let ids = |triangle: [usize; 3]| triangle.map(VertexId::new);
            let intersect = triangles_intersect(|v| points[v.index()], ids(first), ids(second));
            for view in [best_view(places(first)), View::X, View::Y, View::Z] {
                let [one, two] = [first, second].map(|t| Seen::of(view, ids(t), places(t)));
                prop_assert!(!(intersect && one.parted(&two)));
            }
        }
    }
}
