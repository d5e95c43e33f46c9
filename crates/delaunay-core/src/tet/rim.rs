//! Which corners of a polyhedron a half-space removes, and the rim round them.
//!
//! Each corner is judged once, exactly; a corner in the plane stays.
//!
//! ```text
//!          removed                     On the way round the rim the removed corners are on the
//!        *----*     *                  left: from a rim edge to the next along the face between
//!   -----|----|-----|----- plane       them. The corners strictly above a plane are connected, and
//!        *    *-----*                  so are the others, on every convex polyhedron: there is one
//!           kept                       rim.
//! ```
//!
//! When there are many corners, most of them are not looked at: from one above the plane, found by
//! [climbing](super::climb), all others above are reached along edges.

use super::climb::Summit;
use super::face_plane::FacePlane;
use super::polyhedron::{ConvexPolyhedron, Corner, End};
use geo_predicates::Sign;

/// Room for clipping, kept from one time to the next.
#[derive(Clone, Debug, Default)]
pub struct Clipper {
    /// By corner: the side of the plane it is on, `Positive` for those to be removed; `None` for those not looked at.
    sides: Vec<Option<Sign>>,
    /// Corners looked at, unless all were.
    judged: Vec<u32>,
    all_judged: bool,
    some_below: bool,
    /// Ascending.
    pub(super) removed: Vec<u32>,
    /// The ends, at removed corners, of the edges to corners that stay, in order round the new face.
    pub(super) rim: Vec<End>,
    /// Corners round the new face, in the same order.
    pub(super) fresh: Vec<Corner>,
    pending: Vec<usize>,
}

/// What becomes of a polyhedron.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Verdict {
    KeepAll,
    RemoveAll,
    Divide,
}

impl Clipper {
    /// Number of corners from which on climbing is faster than looking at all.
    const MANY: usize = 400;

    /// Finds the corners above the plane.
    pub(super) fn judge(&mut self, polyhedron: &ConvexPolyhedron, plane: &FacePlane) -> Verdict {
        if polyhedron.corners.len() < Self::MANY {
            self.judge_all(polyhedron, plane);
        } else {
            self.judge_near_summit(polyhedron, plane);
        }
        match self.removed.is_empty() {
            true => Verdict::KeepAll,
            false if !self.some_below => Verdict::RemoveAll,
            false => Verdict::Divide,
        }
    }

    fn judge_all(&mut self, polyhedron: &ConvexPolyhedron, plane: &FacePlane) {
        self.sides.clear();
        self.removed.clear();
        self.all_judged = true;
        self.some_below = false;
        for (slot, corner) in polyhedron.corners.iter().enumerate() {
            let side = polyhedron.side_of_corner(corner, plane);
            self.take_note(slot, side);
            self.sides.push(Some(side));
        }
    }

    fn take_note(&mut self, slot: usize, side: Sign) {
        match side {
            Sign::Positive => self.removed.push(slot as u32),
            Sign::Negative => self.some_below = true,
            Sign::Zero => {}
        }
    }

    /// Judges the corners above the plane and their neighbours only.
    fn judge_near_summit(&mut self, polyhedron: &ConvexPolyhedron, plane: &FacePlane) {
        self.forget_sides(polyhedron.corners.len());
        match Summit::climb(polyhedron, plane) {
            Summit::NotAbove => {}
            Summit::Above(slot) => self.descend(polyhedron, plane, slot),
        }
        if !self.removed.is_empty() && !self.some_below {
            self.judge_all(polyhedron, plane);
        }
    }

    /// Empties all lists.
    fn forget_sides(&mut self, count: usize) {
        if self.all_judged {
            self.sides.clear();
            self.all_judged = false;
        }
        for &slot in &self.judged {
            if let Some(side) = self.sides.get_mut(slot as usize) {
                *side = None;
            }
        }
        self.sides.resize(count, None);
        self.judged.clear();
        self.removed.clear();
        self.some_below = false;
    }

    /// Goes down from a corner above the plane to all others that are above.
    fn descend(&mut self, polyhedron: &ConvexPolyhedron, plane: &FacePlane, summit: usize) {
        self.judge_one(polyhedron, plane, summit);
        while let Some(slot) = self.pending.pop() {
            for twin in polyhedron.corners[slot].twins {
                self.judge_one(polyhedron, plane, twin.corner());
            }
        }
        self.removed.sort_unstable();
    }

    fn judge_one(&mut self, polyhedron: &ConvexPolyhedron, plane: &FacePlane, slot: usize) {
        if self.sides[slot].is_some() {
            return;
        }
        let side = polyhedron.side_of_corner(&polyhedron.corners[slot], plane);
        self.sides[slot] = Some(side);
        self.judged.push(slot as u32);
        self.take_note(slot, side);
        if side == Sign::Positive {
            self.pending.push(slot);
        }
    }

    #[inline]
    fn is_removed(&self, slot: usize) -> bool {
        self.sides[slot] == Some(Sign::Positive)
    }

    /// Lists the rim.
    pub(super) fn trace_rim(&mut self, polyhedron: &ConvexPolyhedron) {
        let slots = self.removed.iter();
        let ends = slots.flat_map(|&slot| [0, 1, 2].map(|edge| End::new(slot as usize, edge)));
        let mut rim_ends = ends.filter(|&end| !self.is_removed(polyhedron.twin(end).corner()));
        let start = rim_ends.next();
        let count = rim_ends.count() + usize::from(start.is_some());
        self.rim.clear();
        let mut here = start;
        while let Some(end) = here {
            self.rim.push(end);
            let next = self.next_on_rim(polyhedron, end);
            here = Some(next).filter(|_| Some(next) != start);
        }
        debug_assert_eq!(self.rim.len(), count, "there are several rims");
    }

    /// The rim end after `end`, round the face between: over its removed corners to the first that stays.
    #[inline]
    fn next_on_rim(&self, polyhedron: &ConvexPolyhedron, end: End) -> End {
        let mut next = end.next();
        loop {
            let twin = polyhedron.twin(next);
            if !self.is_removed(twin.corner()) {
                return next;
            }
            next = twin.next();
        }
    }
}

impl ConvexPolyhedron {
    /// The side of a plane on which one of the corners lies, exactly.
    #[inline]
    pub(super) fn side_of_corner(&self, corner: &Corner, plane: &FacePlane) -> Sign {
        plane.side_of(
            corner,
            corner.faces.map(|face| &self.faces[face as usize].plane),
        )
    }
}
