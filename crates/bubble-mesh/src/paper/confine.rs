//! Nodes stay in the region.
//!
//! The paper does not say what becomes of a node that forces push across the boundary. Departs from Luo §3.2: such a step is not
//! made, and the node tries again the next time; all others are as in the paper.
//!
//! ```text
//!      ·-------·         In the mesh that was generated the triangles round a node fill a disk, and they are in
//!     / \ ___ / \        the region: in the disk no step is judged. Beyond it the triangle that contains
//!    · (  · → )  ·       the node is found by a walk from the last one, with exact signs. That mesh does not
//!     \ / ‾‾‾ \ /        change while nodes move.
//!      ·-------·
//! ```

use delaunay_core::geo_predicates::{Sign, check_point2, orient2d};
use delaunay_core::{FaceId, HalfEdgeId, Subcomplex2, VertexId};
use glam::DVec2;

/// What the radius of the disk is of the distance to the nearest side round the star: it is rounded.
const SURE: f64 = 0.999;

/// Keeps an interior node in the region.
#[derive(Clone, Copy, Debug)]
pub(super) struct Tether {
    /// Where the node was generated.
    start: DVec2,
    /// The square of the radius of a disk round `start` in the region.
    free: f64,
    /// A triangle in or near which the node was last found.
    home: FaceId,
    /// How many steps were not made.
    refused: u32,
}

impl Tether {
    /// For a vertex that is not on the boundary. Takes time proportional to its degree.
    pub(super) fn of(region: &Subcomplex2, node: VertexId) -> Self {
        let mesh = region.mesh();
        let start = region.point(node);
        let sides = mesh.link(node).map(|h| region.segment(h));
        let distances = sides.map(|side| squared_distance(start, side));
        let home = mesh.outgoing(node).map_or(FaceId::new(0), HalfEdgeId::face);
        Self {
            start,
            free: SURE * distances.fold(f64::INFINITY, f64::min),
            home,
            refused: 0,
        }
    }

    /// Whether a step was not made.
    pub(super) fn has_refused(&self) -> bool {
        self.refused > 0
    }

    /// The place that a node at `here` gets that forces move to `there`: that place, or where it is.
    #[inline]
    pub(super) fn held(&mut self, region: &Subcomplex2, here: DVec2, there: DVec2) -> DVec2 {
        let is_free = there.distance_squared(self.start) < self.free;
        if check_point2(0, there).is_ok() && (is_free || self.finds(region, there)) {
            there
        } else {
            self.refused = self.refused.saturating_add(1);
            here
        }
    }

    /// Whether a walk from the last triangle finds the place in the region.
    fn finds(&mut self, region: &Subcomplex2, place: DVec2) -> bool {
        let found = walk(region, self.home, place);
        self.home = found.unwrap_or(self.home);
        found.is_some()
    }
}

/// The triangle that contains `place`, from `start` on across edges beyond which it lies; `None` when it is a vertex or the walk
/// comes to the boundary.
///
/// The walk ends: on its way the power of the place with respect to the circumcircles falls, and no triangle comes twice.
fn walk(region: &Subcomplex2, start: FaceId, place: DVec2) -> Option<FaceId> {
    let mesh = region.mesh();
    let mut here = start;
    for _ in 0..mesh.face_count() {
        let sides = here.half_edges().map(|h| {
            let [a, b] = region.segment(h);
            (h, orient2d(a, b, place))
        });
        let mut beyond = sides.iter().filter(|(_, side)| *side == Sign::Negative);
        if let Some((h, _)) = beyond.clone().find(|(h, _)| !region.is_boundary(*h)) {
            here = mesh.twin(*h).face();
            continue;
        }
        let on = || sides.iter().filter(|(_, side)| *side == Sign::Zero);
        let is_on_boundary = on().any(|(h, _)| region.is_boundary(*h));
        let is_inside = beyond.next().is_none() && !is_on_boundary && on().count() < 2;
        return is_inside.then_some(here);
    }
    None
}

/// Square of the distance between a point and a segment.
fn squared_distance(p: DVec2, [a, b]: [DVec2; 2]) -> f64 {
    let (ab, ap) = (b - a, p - a);
    let along = (ap.dot(ab) / ab.length_squared()).clamp(0.0, 1.0);
    ap.distance_squared(along * ab)
}

#[cfg(test)]
mod tests {
    use super::*;
    use delaunay_core::Delaunay2;

    /// A square with a node in the middle.
    fn square() -> (Subcomplex2, VertexId) {
        let points = [
            [-1.0, -1.0],
            [1.0, -1.0],
            [1.0, 1.0],
            [-1.0, 1.0],
            [0.0, 0.0],
        ];
        let delaunay = Delaunay2::build(&points.map(DVec2::from)).unwrap();
        (Subcomplex2::of(&delaunay, |_| true), VertexId::new(4))
    }

    #[test]
    fn steps_inside_are_made_and_steps_outside_are_not() {
        let (region, middle) = square();
        let mut tether = Tether::of(&region, middle);
        for inside in [[0.5, 0.5], [0.999, -0.999], [-0.9, 0.95], [0.0, 0.0]] {
            let there = DVec2::from(inside);
            assert_eq!(tether.held(&region, DVec2::ZERO, there), there);
        }
        assert!(!tether.has_refused());
        let here = DVec2::new(0.5, 0.5);
        for outside in [
            [1.0, 0.0],
            [1.0, 1.0],
            [3.0, 0.1],
            [f64::NAN, 0.0],
            [1e-60, 0.995],
        ] {
            assert_eq!(tether.held(&region, here, DVec2::from(outside)), here);
        }
        assert!(tether.has_refused());
    }

    #[test]
    fn a_step_into_a_hole_is_not_made() {
        let ring = |s: f64| [[-s, -s], [s, -s], [s, s], [-s, s]].map(DVec2::from);
        let points = [&ring(3.0)[..], &ring(1.0), &[DVec2::new(2.0, 0.0)]].concat();
        let delaunay = Delaunay2::build(&points).unwrap();
        let is_hole = |f: FaceId| {
            delaunay
                .triangle(f)
                .iter()
                .all(|p| p.abs().max_element() == 1.0)
        };
        let region = Subcomplex2::of(&delaunay, |f| !is_hole(f));
        let mut tether = Tether::of(&region, VertexId::new(8));
        let here = DVec2::new(2.0, 0.0);
        for there in [[0.9, 0.0], [0.0, 0.0], [1.0, 0.0], [-1.0, 0.5]] {
            assert_eq!(tether.held(&region, here, DVec2::from(there)), here);
        }
        let round_the_corner = [[2.0, 1.9], [0.5, 2.0], [-2.0, 2.0], [-2.0, 0.0]];
        for there in round_the_corner.map(DVec2::from) {
            assert_eq!(tether.held(&region, here, there), there);
        }
    }
}
