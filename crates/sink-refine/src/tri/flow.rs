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
use delaunay_core::{Delaunay2, FaceId, HalfEdgeId, Subcomplex2, TriMesh, VertexId};
use glam::DVec2;

/// Triangles that a flow runs through: a whole triangulation of the plane, or part of one.
pub trait Triangles {
    /// How they are glued, ghosts included.
    fn mesh(&self) -> &TriMesh;

    /// The place of a real vertex.
    fn point(&self, v: VertexId) -> DVec2;
}

impl Triangles for Delaunay2 {
    fn mesh(&self) -> &TriMesh {
        self.mesh()
    }

    fn point(&self, v: VertexId) -> DVec2 {
        self.point(v)
    }
}

impl Triangles for Subcomplex2 {
    fn mesh(&self) -> &TriMesh {
        self.mesh()
    }

    fn point(&self, v: VertexId) -> DVec2 {
        self.point(v)
    }
}

/// Where the flow goes from a triangle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Successor {
    /// Nowhere: the triangle contains its circumcenter, it is a sink triangle.
    None,
    /// Into the neighbor on whose side of the common edge the circumcenter lies.
    Triangle(FaceId),
    /// Across a hull edge or boundary edge, to the dummy element ω that stands for all outside.
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
pub fn successor(triangles: &impl Triangles, f: FaceId) -> Successor {
    successor_through(triangles.mesh(), exit(triangles, f))
}

/// The half-edge through which the flow leaves the triangle `f`.
pub(crate) fn exit(triangles: &impl Triangles, f: FaceId) -> Option<HalfEdgeId> {
    let mut half_edges = f.half_edges().into_iter();
    half_edges.find(|&h| flows_through(triangles, h))
}

/// The successor of a triangle that the flow leaves through `exit`.
fn successor_through(mesh: &TriMesh, exit: Option<HalfEdgeId>) -> Successor {
    match exit.map(|h| mesh.twin(h).face()) {
        None => Successor::None,
        Some(beyond) if mesh.is_ghost_face(beyond) => Successor::Outside,
        Some(beyond) => Successor::Triangle(beyond),
    }
}

/// The sink triangle in which the flow from `f` ends, by exits known already; `None` when it leaves.
pub(crate) fn sink_triangle(
    mesh: &TriMesh,
    mut f: FaceId,
    exit: impl Fn(FaceId) -> Option<HalfEdgeId>,
) -> Option<FaceId> {
    loop {
        match successor_through(mesh, exit(f)) {
            Successor::None => return Some(f),
            Successor::Outside => return None,
            Successor::Triangle(next) => f = next,
        }
    }
}

/// Whether the circumcenter of the triangle on the left of `h` lies strictly on the right of `h`.
///
/// # Panics
/// When there is no half-edge `h` or its face is a ghost.
#[must_use]
pub fn flows_through(triangles: &impl Triangles, h: HalfEdgeId) -> bool {
    let mesh = triangles.mesh();
    let [a, b, apex] = [mesh.origin(h), mesh.target(h), mesh.apex(h)].map(|v| triangles.point(v));
    in_diametral_circle(a, b, apex) == Sign::Positive
}

/// The triangle `f` and those that the flow passes from there, up to the last one inside.
///
/// # Panics
/// When there is no face `f` or it is a ghost.
pub fn path(triangles: &impl Triangles, f: FaceId) -> impl Iterator<Item = FaceId> + '_ {
    std::iter::successors(Some(f), |&f| match successor(triangles, f) {
        Successor::Triangle(next) => Some(next),
        Successor::None | Successor::Outside => None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

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
