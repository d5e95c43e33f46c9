//! The flow from triangle to triangle, toward larger circumcircles (§3.3).
//!
//! A triangle precedes its neighbor when its circumcenter lies strictly beyond their common edge:
//!
//! ```text
//!        apex
//!       /    \          The angle at the apex is obtuse, so the center is beyond the edge:
//!     a ------ b        the flow leaves the triangle through ab.
//!      \  ·   /
//!       \    /          The apex is strictly inside the circle with diameter ab: one exact sign,
//!         c             and no rounded center decides.
//! ```
//!
//! In the plane a triangle has at most one obtuse angle, hence at most one successor. With a right angle the
//! center lies on the edge itself; then there is none. Along the flow the circumradius grows; it stays the
//! same only between triangles of one circle, which have one center and are crossed toward it. So the flow
//! never runs in circles, in exact arithmetic.

use delaunay_core::geo_predicates::{Sign, in_diametral_circle};
use delaunay_core::{Delaunay2, FaceId, HalfEdgeId};

/// Where the flow goes from a triangle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Successor {
    /// Nowhere: the triangle contains its circumcenter, it is a sink triangle.
    None,
    /// Into the neighbor on whose side of the common edge the circumcenter lies.
    Triangle(FaceId),
    /// Across a hull edge, to the dummy element ω that stands for all outside the convex hull.
    Outside,
}

/// The successor of the triangle `f`. O(1); exact. Source: §3.3.
///
/// ```
/// use delaunay_core::{Delaunay2, FaceId};
/// use glam::DVec2;
/// use sink_refine::{Successor, successor};
///
/// let flat = Delaunay2::build(&[[0.0, 0.0], [4.0, 0.0], [2.0, 1.0]].map(DVec2::from))?;
/// let f = flat.faces().next().unwrap();
/// assert_eq!(successor(&flat, f), Successor::Outside);
/// # Ok::<(), delaunay_core::BuildError>(())
/// ```
///
/// # Panics
/// When there is no face `f` or it is a ghost.
#[must_use]
pub fn successor(delaunay: &Delaunay2, f: FaceId) -> Successor {
    let mesh = delaunay.mesh();
    match f
        .half_edges()
        .into_iter()
        .find(|&h| flows_through(delaunay, h))
    {
        None => Successor::None,
        Some(h) => match mesh.twin(h).face() {
            beyond if mesh.is_ghost_face(beyond) => Successor::Outside,
            beyond => Successor::Triangle(beyond),
        },
    }
}

/// Whether the circumcenter of the triangle on the left of `h` lies strictly on the right of `h`.
///
/// # Panics
/// When there is no half-edge `h` or its face is a ghost.
#[must_use]
pub fn flows_through(delaunay: &Delaunay2, h: HalfEdgeId) -> bool {
    let mesh = delaunay.mesh();
    let [a, b, apex] = [mesh.origin(h), mesh.target(h), mesh.apex(h)].map(|v| delaunay.point(v));
    in_diametral_circle(a, b, apex) == Sign::Positive
}

/// The triangle `f` and those that the flow passes from there, up to the last one inside the hull.
///
/// # Panics
/// When there is no face `f` or it is a ghost.
pub fn path(delaunay: &Delaunay2, f: FaceId) -> impl Iterator<Item = FaceId> + '_ {
    std::iter::successors(Some(f), |&f| match successor(delaunay, f) {
        Successor::Triangle(next) => Some(next),
        Successor::None | Successor::Outside => None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec2;

    fn built(points: &[[f64; 2]]) -> Delaunay2 {
        let points: Vec<DVec2> = points.iter().copied().map(DVec2::from).collect();
        Delaunay2::build(&points).unwrap()
    }

    fn successors(delaunay: &Delaunay2) -> Vec<Successor> {
        delaunay.faces().map(|f| successor(delaunay, f)).collect()
    }

    #[test]
    fn an_acute_triangle_has_no_successor() {
        let acute = built(&[[0.0, 0.0], [4.0, 0.0], [2.0, 3.0]]);
        assert_eq!(successors(&acute), [Successor::None]);
    }

    #[test]
    fn the_two_halves_of_a_square_are_both_sink_triangles() {
        let square = built(&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]);
        assert_eq!(successors(&square), [Successor::None; 2]);
    }

    #[test]
    fn an_angle_that_is_obtuse_by_the_last_bit_lets_the_flow_out() {
        let mut right = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
        assert_eq!(successors(&built(&right)), [Successor::None]);
        right[1][1] = -5e-40;
        assert_eq!(successors(&built(&right)), [Successor::Outside]);
    }

    #[test]
    fn an_obtuse_triangle_flows_into_its_acute_neighbor() {
        let two = built(&[[0.0, 0.0], [4.0, 0.0], [2.0, 1.0], [2.0, -8.0]]);
        let flat = two
            .faces()
            .find(|&f| two.triangle(f).contains(&DVec2::new(2.0, 1.0)))
            .unwrap();
        let passed: Vec<FaceId> = path(&two, flat).collect();
        assert_eq!(passed.len(), 2);
        assert_eq!(successor(&two, flat), Successor::Triangle(passed[1]));
        assert_eq!(successor(&two, passed[1]), Successor::None);
    }
}
