//! Which corners of a polyhedron a half-space removes, and the rim round them.
//!
//! Each corner is judged once, by the sign of its rounded height over the plane; a corner in the plane stays, and so does
//! one so near that rounding may have lifted it out.
//!
//! ```text
//!          removed                     On the way round the rim the removed corners are on the
//!        *----*     *                  left: from a rim edge to the next along the face between
//!   -----|----|-----|----- plane       them. Where rounding makes the signs those of no convex
//!        *    *-----*                  body, there are several rims; then corners too few to
//!           kept                       matter change sides until there is one (mend).
//! ```
//!
//! When there are many corners, most of them are not looked at: from one above the plane, found by
//! [climbing](super::climb), all others above are reached along edges.

use super::climb::Summit;
use super::half_space::HalfSpace;
use super::polyhedron::{ConvexPolyhedron, Corner, End};

/// Room for clipping, kept from one time to the next.
#[derive(Clone, Debug, Default)]
pub struct Clipper {
    /// By corner: positive for those to be removed, 0 for those not looked at.
    pub(super) heights: Vec<f64>,
    /// Corners looked at, unless all were.
    judged: Vec<u32>,
    all_judged: bool,
    /// The least height met.
    lowest: f64,
    /// Ascending.
    pub(super) removed: Vec<u32>,
    /// The ends, at removed corners, of the edges to corners that stay, in order round the new face.
    pub(super) rim: Vec<End>,
    /// Corners round the new face, in the same order.
    pub(super) fresh: Vec<Corner>,
    reached: Vec<bool>,
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
    pub(super) fn judge(&mut self, polyhedron: &ConvexPolyhedron, plane: &HalfSpace) -> Verdict {
        if polyhedron.corners.len() < Self::MANY {
            self.judge_all(polyhedron, plane);
        } else {
            self.judge_near_summit(polyhedron, plane);
        }
        match self.removed.is_empty() {
            true => Verdict::KeepAll,
            false if self.lowest >= 0.0 => Verdict::RemoveAll,
            false => Verdict::Divide,
        }
    }

    fn judge_all(&mut self, polyhedron: &ConvexPolyhedron, plane: &HalfSpace) {
        let corners = polyhedron.corners.iter();
        self.heights.clear();
        self.heights
            .extend(corners.map(|corner| plane.rise(corner.place)));
        self.all_judged = true;
        self.lowest = self.heights.iter().copied().fold(f64::INFINITY, f64::min);
        self.list_removed();
    }

    pub(super) fn list_removed(&mut self) {
        self.removed.clear();
        let above = self
            .heights
            .iter()
            .enumerate()
            .filter(|&(_, &height)| height > 0.0);
        self.removed.extend(above.map(|(slot, _)| slot as u32));
    }

    /// Judges the corners above the plane and their neighbours only.
    fn judge_near_summit(&mut self, polyhedron: &ConvexPolyhedron, plane: &HalfSpace) {
        self.forget_heights(polyhedron.corners.len());
        match Summit::climb(polyhedron, plane) {
            Summit::Below => {}
            Summit::Above(slot) => self.descend(polyhedron, plane, slot),
            Summit::Unclear => self.judge_all(polyhedron, plane),
        }
        if !self.removed.is_empty() && self.lowest >= 0.0 {
            self.judge_all(polyhedron, plane);
        }
    }

    /// Empties all lists and makes all heights 0.
    fn forget_heights(&mut self, count: usize) {
        if self.all_judged {
            self.heights.clear();
            self.all_judged = false;
        }
        for &slot in &self.judged {
            if let Some(height) = self.heights.get_mut(slot as usize) {
                *height = 0.0;
            }
        }
        self.heights.resize(count, 0.0);
        self.judged.clear();
        self.removed.clear();
        self.lowest = f64::INFINITY;
    }

    /// Goes down from a corner above the plane to all others that are above.
    ///
    /// Where corners crowd at an apex of the polyhedron, rounding puts some of them below the plane that others
    /// above are behind. So the way goes on over corners in the plane up to rounding.
    fn descend(&mut self, polyhedron: &ConvexPolyhedron, plane: &HalfSpace, summit: usize) {
        self.judge_one(polyhedron, plane, summit);
        while let Some(slot) = self.pending.pop() {
            for twin in polyhedron.corners[slot].twins {
                self.judge_one(polyhedron, plane, twin.corner());
            }
        }
        self.removed.sort_unstable();
    }

    fn judge_one(&mut self, polyhedron: &ConvexPolyhedron, plane: &HalfSpace, slot: usize) {
        if self.heights[slot] != 0.0 {
            return;
        }
        let place = polyhedron.corners[slot].place;
        let height = plane.rise(place);
        self.lowest = self.lowest.min(height);
        // Height 0 says that a corner was not looked at.
        self.heights[slot] = if height == 0.0 {
            -f64::MIN_POSITIVE
        } else {
            height
        };
        self.judged.push(slot as u32);
        if height > 0.0 {
            self.removed.push(slot as u32);
        }
        if plane.may_reach(place) {
            self.pending.push(slot);
        }
    }

    /// Finds the rim, and changes the verdict on corners where there would be several.
    pub(super) fn find_rim(&mut self, polyhedron: &ConvexPolyhedron, plane: &HalfSpace) {
        if !self.trace_rim(polyhedron) {
            self.judge_all(polyhedron, plane);
            self.mend(polyhedron);
            self.trace_rim(polyhedron);
        }
    }

    #[inline]
    fn is_removed(&self, slot: usize) -> bool {
        self.heights[slot] > 0.0
    }

    /// Lists the rim of a removed corner; tells whether it is the only one.
    pub(super) fn trace_rim(&mut self, polyhedron: &ConvexPolyhedron) -> bool {
        let slots = self.removed.iter();
        let ends = slots.flat_map(|&slot| [0, 1, 2].map(|edge| End::new(slot as usize, edge)));
        let mut rim_ends = ends.filter(|&end| !self.is_removed(polyhedron.twin(end).corner()));
        let start = rim_ends.next();
        let count = rim_ends.count() + 1;
        self.rim.clear();
        let mut here = start;
        while let Some(end) = here {
            self.rim.push(end);
            let next = self.next_on_rim(polyhedron, end);
            here = Some(next).filter(|_| Some(next) != start);
        }
        self.rim.len() == count
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

    /// Makes the removed corners and the kept ones connected, each kind with itself: then there is one
    /// rim. Corners that rounding has put on the wrong side count as in the plane, or hardly above it.
    #[cold]
    pub(super) fn mend(&mut self, polyhedron: &ConvexPolyhedron) {
        let highest = extreme(&self.heights, 1.0);
        self.keep_connected(polyhedron, highest, |height| height > 0.0, 0.0);
        let lowest = extreme(&self.heights, -1.0);
        self.keep_connected(
            polyhedron,
            lowest,
            |height| height <= 0.0,
            f64::MIN_POSITIVE,
        );
        self.list_removed();
    }

    /// Gives the height `otherwise` to corners of a kind that are not connected with `seed`.
    fn keep_connected(
        &mut self,
        polyhedron: &ConvexPolyhedron,
        seed: usize,
        is_of_kind: impl Fn(f64) -> bool,
        otherwise: f64,
    ) {
        self.reached.clear();
        self.reached.resize(self.heights.len(), false);
        self.reached[seed] = true;
        self.pending.clear();
        self.pending.push(seed);
        while let Some(slot) = self.pending.pop() {
            for twin in polyhedron.corners[slot].twins {
                let other = twin.corner();
                if is_of_kind(self.heights[other]) && !self.reached[other] {
                    self.reached[other] = true;
                    self.pending.push(other);
                }
            }
        }
        for (height, &reached) in self.heights.iter_mut().zip(&self.reached) {
            if is_of_kind(*height) && !reached {
                *height = otherwise;
            }
        }
    }
}

/// The corner farthest up (`sign` 1) or down (-1).
fn extreme(heights: &[f64], sign: f64) -> usize {
    let farthest =
        (0..heights.len()).max_by(|&i, &j| (heights[i] * sign).total_cmp(&(heights[j] * sign)));
    farthest.unwrap_or(0)
}
