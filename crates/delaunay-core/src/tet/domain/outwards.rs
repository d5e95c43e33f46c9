//! Triangles of closed bodies turned so that their normals point out of the bodies, into voids too.
//!
//! ```text
//!        |  line, seen from the side            A line along an axis goes through a triangle of each patch. Where it ends
//!    ----+----  3                               is outside, so what it crosses above the triangle, an even or odd number,
//!        |                                      tells what is in front of the triangle.
//!    ----+----  2
//!        |           2 above: outside                 c         Seen along the line, it goes through the triangle abc next to a,
//!    ----+----  triangle                             / \        and far nearer to ab than to a: so it meets no other edge, and on
//!                                                   a·--b       which side of one it is, is told by a, else by b, else by c.
//! ```

use super::intersections::Boxed;
use super::patches::Patches;
use crate::progress::{Cancelled, Meter};
use crate::tet::bounds::Bounds;
use crate::tet::projection::View;
use geo_predicates::{Sign, orient2d, orient3d};
use glam::{DVec2, DVec3};

/// Turns the patches whose triangles, once they agree, have the inside in front. Exact.
///
/// No triangles may intersect, and every edge must have an even number of them. Takes time log n for each patch where lines meet
/// few boxes.
pub(super) fn turn_outwards(
    boxed: &Boxed<'_>,
    patches: &mut Patches,
    meter: &mut Meter<'_>,
) -> Result<(), Cancelled> {
    for patch in 0..patches.members.len() {
        meter.advance()?;
        let triangle = patches.members[patch][0];
        if front_is_inside(boxed, triangle) != patches.turned[triangle] {
            patches.turn_patch(patch);
        }
    }
    Ok(())
}

/// Whether there is inside where the normal of a triangle, as given, points.
fn front_is_inside(boxed: &Boxed<'_>, triangle: usize) -> bool {
    let places = |triangle: usize| boxed.corners[triangle].map(|v| boxed.place(v));
    let Some(line) = Line::through(places(triangle)) else {
        return false;
    };
    let mut inside_above = false;
    boxed.hierarchy.meeting(line.ray(), |other| {
        let corners = places(other);
        inside_above ^= other != triangle && line.crosses(corners) && line.is_below(corners);
    });
    inside_above == line.sees_front()
}

/// A line along an axis through a triangle, next to its first corner.
struct Line {
    view: View,
    own: [DVec3; 3],
}

impl Line {
    /// A line that the triangle does not run along; `None` when it has no area.
    fn through(own: [DVec3; 3]) -> Option<Self> {
        View::of_area(own).map(|view| Self { view, own })
    }

    /// What is on the line, or next to it, from the lowest corner of the triangle on.
    fn ray(&self) -> Bounds {
        let axis = self.view as usize;
        let mut ray = Bounds::of([self.own[0]]);
        ray.low[axis] = Bounds::of(self.own).low[axis];
        ray.high[axis] = f64::INFINITY;
        ray
    }

    /// Whether the normal of the triangle points up along the line.
    fn sees_front(&self) -> bool {
        let [a, b, c] = self.seen(self.own);
        orient2d(a, b, c).is_positive()
    }

    fn seen<const N: usize>(&self, places: [DVec3; N]) -> [DVec2; N] {
        places.map(|place| self.view.of(place))
    }

    /// Whether the line goes through a triangle.
    fn crosses(&self, corners: [DVec3; 3]) -> bool {
        let own = self.seen(self.own);
        let side = |[from, to]: [DVec2; 2]| {
            let mut sides = own.into_iter().map(|corner| orient2d(from, to, corner));
            sides.find(|side| !side.is_zero()).unwrap_or(Sign::Zero)
        };
        let [a, b, c] = self.seen(corners);
        // A triangle that runs along the line has area in no view of it.
        let turn = orient2d(a, b, c);
        let edges = [[a, b], [b, c], [c, a]];
        turn != Sign::Zero && edges.into_iter().all(|edge| side(edge) == turn)
    }

    /// Whether the triangle of the line is below one that the line crosses.
    ///
    /// Seen along the line the two overlap. They do not intersect, so the same one is below everywhere in the overlap, a polygon;
    /// they are not in one plane either, so it is strictly below at one of its corners: at a corner of one of them, or where
    /// two edges cross.
    fn is_below(&self, other: [DVec3; 3]) -> bool {
        let own = self.own;
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
        let [p, a, b, c] = self.seen([point, triangle[0], triangle[1], triangle[2]]);
        let turn = orient2d(a, b, c);
        let outside = |[from, to]: [DVec2; 2]| orient2d(from, to, p) == -turn;
        if [[a, b], [b, c], [c, a]].into_iter().any(outside) {
            return Sign::Zero;
        }
        let [a, b, c] = triangle;
        orient3d(a, b, c, point) * turn
    }

    /// `Positive` when `across` goes over `edge`, `Zero` when they meet or are not seen to cross.
    fn height_of_crossing(&self, edge: [DVec3; 2], across: [DVec3; 2]) -> Sign {
        let [[a, b], [c, d]] = [edge, across].map(|ends| self.seen(ends));
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
