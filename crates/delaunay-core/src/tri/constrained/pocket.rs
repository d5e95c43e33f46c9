//! One side of a corridor: a polygon between the way, which becomes an edge, and a wall.
//!
//! ```text
//!     a ---------------------> b        corners 0, 1, ..., n counterclockwise; wall edge i runs from corner i to
//!     0 \      base         / n         i + 1, and the base from corner n back to 0
//!        \   /\            /
//!         \ /  \___ . ____/             a vertex is two corners when an edge sticks into the polygon
//! ```
//!
//! Every corner sees a part of the base, because it is the end of an edge that crossed it. Of the corners, the one
//! whose circle through the ends of the base holds no other is therefore seen from the whole base and makes the Delaunay
//! triangle on it (Anglada 1997); what is left on both sides of the triangle is again of the same kind. That
//! takes n log n expected time where corners lie as if at random, and n² in the worst case, so long walls are left to
//! [`large`](super::large).

use super::super::sight::precedes;
use crate::ids::{HalfEdgeId, VertexId};
use geo_predicates::{Sign, in_circle_perturbed, orient2d};
use glam::DVec2;

/// A polygon between a base and a wall.
#[derive(Clone, Debug, Default)]
pub(super) struct Pocket {
    pub(super) corners: Vec<VertexId>,
    pub(super) walls: Vec<Wall>,
    pub(super) has_spikes: bool,
}

/// An edge of a wall: what is beyond it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Wall {
    /// The half-edge on the other side.
    pub(super) outer: HalfEdgeId,
    /// The segment that the edge lies on.
    pub(super) segment: u32,
    /// The wall edge on the other side, when this edge sticks into the polygon.
    pub(super) spike: Option<usize>,
}

impl Pocket {
    pub(super) fn clear(&mut self) {
        self.corners.clear();
        self.walls.clear();
        self.has_spikes = false;
    }

    /// The corner between two others that makes the Delaunay triangle with them; there is one at least.
    pub(super) fn apex(&self, coords: &[DVec2], [low, high]: [usize; 2]) -> usize {
        let place = |corner: usize| coords[self.corners[corner].slot()];
        let (a, b) = (place(low), place(high));
        let mut apex = low + 1;
        for corner in low + 2..high {
            let is_new = [low, high, apex].map(|known| self.corners[known] != self.corners[corner]);
            if is_new == [true; 3] && in_circle_perturbed(a, place(apex), b, place(corner)) {
                apex = corner;
            }
        }
        if !self.has_spikes {
            return apex;
        }
        let mut same = (low + 1..high).filter(|&corner| self.corners[corner] == self.corners[apex]);
        same.find(|&corner| self.opens_to(coords, corner, a))
            .unwrap_or(apex)
    }

    /// Whether the angle of the polygon at a corner, from the wall after it counterclockwise to the wall before, contains
    /// the direction to `target`; that of the wall before belongs to it. Of the corners at one vertex only one does, as
    /// their angles lie side by side.
    fn opens_to(&self, coords: &[DVec2], corner: usize, target: DVec2) -> bool {
        let place = |corner: usize| coords[self.corners[corner].slot()];
        let [before, here, after] = [corner - 1, corner, corner + 1].map(place);
        if before == after {
            return true;
        }
        let turn = |from: DVec2, to: DVec2| orient2d(here, from, to);
        let from_after = turn(after, target);
        match turn(after, before) {
            Sign::Positive => {
                from_after == Sign::Positive && turn(target, before) != Sign::Negative
            }
            Sign::Negative => {
                turn(before, target) != Sign::Positive || from_after == Sign::Positive
            }
            Sign::Zero if from_after == Sign::Zero => {
                precedes(here, target) == precedes(here, before)
            }
            Sign::Zero => from_after == Sign::Positive,
        }
    }
}
