//! Whether two triangles intersect: whether they have more in common than the corners and the edge that they share.
//!
//! ```text
//!   two corners shared          one corner shared              none shared
//!
//!       b                           ·───·   ·
//!      /│\     a wrong fold:        │    \ /│   wrong when       wrong when an edge of
//!     c │ d    c and d on one       │     v │   the edge         one meets the other
//!      \│/     side of ab in        │    / \│   opposite v
//!       a      one plane            ·───·   ·   meets the other
//! ```
//!
//! Only edges without a shared corner need a look: two convex sets that have `v` and some other point in common have the
//! segment between in common, and it can be prolonged from `v` until it leaves one of them, through the edge opposite.
//! All signs are exact.

use super::projection::View;
use crate::ids::VertexId;
use geo_predicates::{Sign, orient2d, orient3d};
use glam::DVec3;

/// Whether two triangles have a point in common that is on no corner and no edge that they share. Exact.
///
/// `place` tells where a vertex is, an accepted point. Both triangles must have area, and different vertices be at
/// different places.
pub fn triangles_intersect(
    place: impl Fn(VertexId) -> DVec3,
    first: [VertexId; 3],
    second: [VertexId; 3],
) -> bool {
    pierces(&place, first, second)
        || pierces(&place, second, first)
        || folds_over(&place, first, second)
}

/// Whether an edge of `first` without a corner of `second` meets `second`.
fn pierces(
    place: &impl Fn(VertexId) -> DVec3,
    first: [VertexId; 3],
    second: [VertexId; 3],
) -> bool {
    let [a, b, c] = first;
    let free = |edge: &[VertexId; 2]| edge.iter().all(|v| !second.contains(v));
    let mut edges = [[a, b], [b, c], [c, a]].into_iter().filter(free);
    edges.any(|edge| segment_meets(edge.map(place), second.map(place)))
}

/// Whether the triangles share an edge and lie in one plane on the same side of it.
fn folds_over(
    place: &impl Fn(VertexId) -> DVec3,
    first: [VertexId; 3],
    second: [VertexId; 3],
) -> bool {
    let mut shared = first.into_iter().filter(|v| second.contains(v));
    let (Some(a), Some(b)) = (shared.next(), shared.next()) else {
        return false;
    };
    let apex = |of: [VertexId; 3]| of.into_iter().find(|&v| v != a && v != b);
    let (Some(c), Some(d)) = (apex(first), apex(second)) else {
        return false;
    };
    let [a, b, c, d] = [a, b, c, d].map(place);
    orient3d(a, b, c, d) == Sign::Zero
        && View::of_area([a, b, c]).is_some_and(|view| {
            let [a, b, c, d] = [a, b, c, d].map(|p| view.of(p));
            orient2d(a, b, c) == orient2d(a, b, d)
        })
}

/// Whether the segment, ends included, meets the triangle, rim included.
fn segment_meets([p, q]: [DVec3; 2], [a, b, c]: [DVec3; 3]) -> bool {
    let [side_of_p, side_of_q] = [p, q].map(|end| orient3d(a, b, c, end));
    if side_of_p == Sign::Zero && side_of_q == Sign::Zero {
        return segment_meets_in_plane([p, q], [a, b, c]);
    }
    if side_of_p == side_of_q {
        return false;
    }
    // The line through p and q meets the plane in one point, of the segment; it is in the triangle
    // when the edges turn round it in one sense.
    let turns = [[a, b], [b, c], [c, a]].map(|[from, to]| orient3d(p, q, from, to));
    !(turns.contains(&Sign::Positive) && turns.contains(&Sign::Negative))
}

/// The same where all is in one plane: there they meet unless an edge or the segment parts them.
fn segment_meets_in_plane(segment: [DVec3; 2], triangle: [DVec3; 3]) -> bool {
    let Some(view) = View::of_area(triangle) else {
        return false;
    };
    let [p, q] = segment.map(|end| view.of(end));
    let [a, b, c] = triangle.map(|corner| view.of(corner));
    let outside = -orient2d(a, b, c);
    let edge_parts = [[a, b], [b, c], [c, a]]
        .into_iter()
        .any(|[from, to]| [p, q].iter().all(|&end| orient2d(from, to, end) == outside));
    let sides = [a, b, c].map(|corner| orient2d(p, q, corner));
    let segment_parts = sides == [Sign::Positive; 3] || sides == [Sign::Negative; 3];
    !(edge_parts || segment_parts)
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::IVec3;
    use proptest::prelude::*;

    const FLAT: [[f64; 3]; 3] = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0]];

    /// The triangle [`FLAT`] against one whose corners are its corners, by index, or others.
    fn meets(corners: [usize; 3], others: &[[f64; 3]]) -> bool {
        let points = FLAT.iter().chain(others).copied().map(DVec3::from);
        let points: Vec<DVec3> = points.collect();
        let [first, second] = [[0, 1, 2], corners].map(|corners| corners.map(VertexId::new));
        let place = |v: VertexId| points[v.index()];
        let answer = triangles_intersect(place, first, second);
        assert_eq!(triangles_intersect(place, second, first), answer);
        answer
    }

    #[test]
    fn triangles_without_a_common_corner_intersect_when_they_touch() {
        let piercing = [[1.0, 1.0, -1.0], [1.0, 1.0, 1.0], [9.0, 9.0, 1.0]];
        assert!(meets([3, 4, 5], &piercing));
        let corner_on_face = [[1.0, 1.0, 0.0], [1.0, 1.0, 1.0], [9.0, 9.0, 1.0]];
        assert!(meets([3, 4, 5], &corner_on_face));
        let corner_on_edge = [[2.0, 2.0, 0.0], [1.0, 1.0, 1.0], [9.0, 9.0, 1.0]];
        assert!(meets([3, 4, 5], &corner_on_edge));
        let edges_cross = [[1.0, -1.0, -1.0], [1.0, 1.0, 1.0], [1.0, -9.0, 1.0]];
        assert!(meets([3, 4, 5], &edges_cross));
        let above = [[1.0, 1.0, 1.0], [2.0, 1.0, 1.0], [1.0, 2.0, 2.0]];
        assert!(!meets([3, 4, 5], &above));
        let crosses_plane_elsewhere = [[3.0, 3.0, -1.0], [3.0, 3.0, 1.0], [9.0, 9.0, 1.0]];
        assert!(!meets([3, 4, 5], &crosses_plane_elsewhere));
    }

    #[test]
    fn triangles_in_one_plane_intersect_when_they_overlap_or_touch() {
        let within = [[1.0, 1.0, 0.0], [2.0, 1.0, 0.0], [1.0, 2.0, 0.0]];
        assert!(meets([3, 4, 5], &within));
        let around = [[-9.0, -9.0, 0.0], [30.0, -9.0, 0.0], [-9.0, 30.0, 0.0]];
        assert!(meets([3, 4, 5], &around));
        let across = [[1.0, -1.0, 0.0], [2.0, -1.0, 0.0], [1.0, 9.0, 0.0]];
        assert!(meets([3, 4, 5], &across));
        let beside = [[3.0, 3.0, 0.0], [4.0, 3.0, 0.0], [3.0, 4.0, 0.0]];
        assert!(!meets([3, 4, 5], &beside));
        let corner_on_edge = [[2.0, 2.0, 0.0], [4.0, 3.0, 0.0], [3.0, 4.0, 0.0]];
        assert!(meets([3, 4, 5], &corner_on_edge));
    }

    #[test]
    fn a_common_corner_is_no_intersection_but_more_is() {
        assert!(!meets([0, 3, 4], &[[-1.0, 0.0, 0.0], [0.0, -1.0, 0.0]]));
        assert!(!meets([0, 3, 4], &[[1.0, 1.0, 1.0], [1.0, 2.0, 1.0]]));
        assert!(meets([0, 3, 4], &[[1.0, 1.0, 1.0], [1.0, 1.0, -1.0]]));
        assert!(meets([0, 3, 4], &[[1.0, 1.0, 0.0], [1.0, 1.0, 1.0]]));
        assert!(meets([0, 3, 4], &[[9.0, 9.0, 0.0], [9.0, 9.0, 1.0]]));
    }

    #[test]
    fn a_common_edge_is_an_intersection_only_when_one_folds_over_the_other() {
        assert!(!meets([0, 1, 3], &[[1.0, -1.0, 0.0]]));
        assert!(!meets([1, 3, 0], &[[1.0, 1.0, 1.0]]));
        assert!(meets([3, 0, 1], &[[1.0, 1.0, 0.0]]));
        assert!(meets([0, 3, 2], &[[9.0, 9.0, 0.0]]));
        assert!(meets([2, 1, 0], &[]));
    }

    fn spread(triangle: [IVec3; 3], axis: IVec3) -> (i32, i32) {
        let heights = triangle.map(|corner| corner.dot(axis));
        heights
            .into_iter()
            .fold((i32::MAX, i32::MIN), |(low, high), height| {
                (low.min(height), high.max(height))
            })
    }

    /// Disjoint convex sets have a direction in which one ends before the other begins; for triangles it is
    /// normal to one of them, to an edge of each, or to one of them and an edge of it.
    fn parted(first: [IVec3; 3], second: [IVec3; 3]) -> bool {
        let edges = |[a, b, c]: [IVec3; 3]| [b - a, c - b, a - c];
        let normals = [first, second].map(|[a, b, c]| (b - a).cross(c - a));
        let mut axes = normals.to_vec();
        for e in edges(first) {
            axes.push(e.cross(normals[0]));
            axes.extend(edges(second).map(|f| e.cross(f)));
        }
        axes.extend(edges(second).map(|f| f.cross(normals[1])));
        axes.into_iter().any(|axis| {
            let [(low, high), (other_low, other_high)] =
                [first, second].map(|triangle| spread(triangle, axis));
            high < other_low || other_high < low
        })
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(4096))]

        /// On so small a lattice every kind of touching occurs.
        #[test]
        fn separating_directions_say_the_same(corners in prop::array::uniform6(prop::array::uniform3(0_i32..4))) {
            let [a, b, c, d, e, f] = corners.map(IVec3::from_array);
            let points = [a, b, c, d, e, f].map(DVec3::from);
            let [first, second] = [[0, 1, 2], [3, 4, 5]];
            for triangle in [first, second] {
                prop_assume!(View::of_area(triangle.map(|i: usize| points[i])).is_some());
            }
            let place = |v: VertexId| points[v.index()];
            let [first, second] = [first, second].map(|corners| corners.map(VertexId::new));
            let answer = triangles_intersect(place, first, second);
            prop_assert_eq!(answer, !parted([a, b, c], [d, e, f]));
        }
    }
}
