//! Triangles of closed bodies turned so that their normals point out of the bodies, into voids too.
//!
//! ```text
//!        |  line, seen from the side            A line along an axis goes through a triangle of a patch. Where it comes out
//!    ----+----  3                               for good is outside, so what it crosses above the triangle,
//!        |                                      an even or odd number, tells what is in front.
//!    ----+----  2
//!        |           2 above: outside           The line is moved aside by less than any difference of coordinates, so it
//!    ----+----  triangle                        meets no edge and no triangle that it could run along.
//! ```

use super::intersections::Boxed;
use super::patches::Patches;
use crate::ids::VertexId;
use crate::progress::{Cancelled, Meter};
use crate::tet::bounds::Bounds;
use crate::tet::projection::View;
use geo_predicates::{Sign, orient2d, orient3d};
use glam::{DVec2, DVec3};

/// Turns the patches whose triangles, once they agree, have the inside in front. Exact.
///
/// No triangles may intersect, and every edge must have an even number of them. A patch of triangles all of which are so thin that
/// rounded centroids are beside them stays as it is. Takes time log n for each patch where lines meet few boxes.
pub(super) fn turn_outwards(
    boxed: &Boxed<'_>,
    patches: &mut Patches,
    meter: &mut Meter<'_>,
) -> Result<(), Cancelled> {
    for patch in 0..patches.members.len() {
        meter.advance()?;
        let mut members = patches.members[patch].iter();
        let probe =
            members.find_map(|&triangle| Some((triangle, Probe::through(boxed, triangle)?)));
        if let Some((triangle, probe)) = probe
            && probe.front_is_inside(boxed, triangle) != patches.turned[triangle]
        {
            patches.turn_patch(patch);
        }
    }
    Ok(())
}

/// A line along an axis through the inner part of a triangle.
struct Probe {
    view: View,
    /// Where the line is seen.
    at: DVec2,
    /// The box of the ray from the lowest corner of the triangle on.
    ray: Bounds,
    corners: [DVec3; 3],
}

impl Probe {
    /// The line through the rounded centroid, if that is within the triangle in a view along an axis.
    fn through(boxed: &Boxed<'_>, triangle: usize) -> Option<Self> {
        let corners = boxed.corners[triangle].map(|v| boxed.place(v));
        let center = corners.map(|corner| corner / 3.0).into_iter().sum();
        let views = [View::X, View::Y, View::Z].into_iter().enumerate();
        let mut seen = views.map(|(axis, view)| (axis, view, view.of(center)));
        let (axis, view, at) = seen.find(|(_, view, at)| {
            let [a, b, c] = corners.map(|corner| view.of(corner));
            let turns = [[a, b], [b, c], [c, a]].map(|[from, to]| orient2d(from, to, *at));
            turns[0] != Sign::Zero && turns == [turns[0]; 3]
        })?;
        let mut ray = Bounds {
            low: center,
            high: center,
        };
        ray.low[axis] = Bounds::of(corners).low[axis];
        ray.high[axis] = f64::INFINITY;
        Some(Self {
            view,
            at,
            ray,
            corners,
        })
    }

    /// Whether there is inside where the normal of the triangle, as given, points.
    fn front_is_inside(&self, boxed: &Boxed<'_>, triangle: usize) -> bool {
        let mut inside_above = false;
        boxed.hierarchy.meeting(self.ray, |other| {
            let corners = boxed.corners[other].map(|v: VertexId| boxed.place(v));
            inside_above ^= other != triangle && self.crosses(corners) && self.is_below(corners);
        });
        let [a, b, c] = self.corners.map(|corner| self.view.of(corner));
        inside_above == orient2d(a, b, c).is_positive()
    }

    /// Whether the line, moved aside by a little along the first coordinate of the view and by far less along the second, goes
    /// through a triangle.
    fn crosses(&self, corners: [DVec3; 3]) -> bool {
        let [a, b, c] = corners.map(|corner| self.view.of(corner));
        let side = |from: DVec2, to: DVec2| {
            let exact = orient2d(from, to, self.at);
            let moved_along_first = || Sign::of(from.y - to.y);
            let moved_along_second = || Sign::of(to.x - from.x);
            let tie =
                |sign: Sign, next: &dyn Fn() -> Sign| if sign.is_zero() { next() } else { sign };
            tie(tie(exact, &moved_along_first), &moved_along_second)
        };
        orient2d(a, b, c) != Sign::Zero && {
            let turns = [side(a, b), side(b, c), side(c, a)];
            turns == [turns[0]; 3]
        }
    }

    /// Whether the triangle of the line is below one that the line crosses.
    ///
    /// Seen along the line the two overlap. They do not intersect, so the same one is below everywhere in the overlap, a polygon;
    /// they are not in one plane either, so it is strictly below at one of its corners: at a corner of one of them, or where
    /// two edges cross.
    fn is_below(&self, other: [DVec3; 3]) -> bool {
        let own = self.corners;
        let above = other.into_iter().map(|corner| self.height(corner, own));
        let below = own.into_iter().map(|corner| -self.height(corner, other));
        let crossing = edges(own)
            .into_iter()
            .flat_map(|edge| edges(other).map(|across| self.height_of_crossing(edge, across)));
        let mut heights = above.chain(below).chain(crossing);
        heights.find(|height| !height.is_zero()) == Some(Sign::Positive)
    }

    /// `Positive` when a point is above a triangle, `Zero` when it is on its plane or above or below nothing of it.
    fn height(&self, point: DVec3, triangle: [DVec3; 3]) -> Sign {
        let [p, a, b, c] = [point, triangle[0], triangle[1], triangle[2]].map(|p| self.view.of(p));
        let turn = orient2d(a, b, c);
        let outside = |[from, to]: [DVec2; 2]| orient2d(from, to, p) == -turn;
        if [[a, b], [b, c], [c, a]].into_iter().any(outside) {
            return Sign::Zero;
        }
        let [a, b, c] = triangle;
        orient3d(a, b, c, point) * turn
    }

    /// `Positive` when `across` goes over `edge`, `Zero` when they meet or seem not to cross.
    fn height_of_crossing(&self, edge: [DVec3; 2], across: [DVec3; 2]) -> Sign {
        let [[a, b], [c, d]] = [edge, across].map(|ends| ends.map(|p| self.view.of(p)));
        let turn = orient2d(a, b, d);
        let parts = |sign: Sign, other: Sign| !sign.is_zero() && sign == -other;
        if parts(orient2d(a, b, c), turn) && parts(orient2d(c, d, a), orient2d(c, d, b)) {
            let [[a, b], [c, d]] = [edge, across];
            -orient3d(a, b, c, d) * turn
        } else {
            Sign::Zero
        }
    }
}

fn edges([a, b, c]: [DVec3; 3]) -> [[DVec3; 2]; 3] {
    [[a, b], [b, c], [c, a]]
}
