//! One thread's part of a bulk build: walk, dig, fill, for one point after the other.

use super::arena::Arena;
use super::circumsphere::Circumsphere;
use super::pile::Pile;
use super::star::{MAX_FACETS, Star};
use super::walk::Walk;
use crate::ids::{FacetId, TetId, VertexId};
use crate::progress::{Cancelled, Meter};
use crate::tet::mesh::Tet;
use geo_predicates::filter::{Filter3, StaticFilter3};
use glam::DVec3;
use std::ops::Range;

/// What came of a point.
pub(super) enum Outcome {
    /// It is a vertex now.
    Inserted,
    /// There is a vertex in its place.
    Duplicate(VertexId),
    /// Its cavity is not in this part alone, and nothing was changed.
    Late,
    /// There are too few slots, and nothing was changed.
    Full,
}

/// Inserts points whose cavities lie in one part. `SHARED` when other threads work on other parts.
pub(super) struct Inserter<const SHARED: bool> {
    pub(super) arena: Arena,
    pub(super) filter: Filter3,
    pub(super) box_filter: StaticFilter3,
    pub(super) part: u16,
    /// Whether the processor has the instructions for [`super::wide`].
    pub(super) is_wide: bool,
    /// Slots that were never used.
    pub(super) fresh: Range<usize>,
    /// Slots of tetrahedra that are gone.
    pub(super) free: Vec<TetId>,
    /// Twice the number of the last insertion.
    pub(super) stamp: u32,
    /// Whether [`last`](Self::last) is a tetrahedron with two corners of this part or more.
    pub(super) has_start: bool,
    /// Where the next walk starts.
    pub(super) last: TetId,
    /// The cavity; then the slots of the star.
    pub(super) dug: Pile<TetId>,
    /// The boundary of the cavity, by its outer and its inner side.
    pub(super) outer: Pile<FacetId>,
    pub(super) inner: Pile<FacetId>,
    pub(super) star: Box<Star>,
    /// The tetrahedron of the star nearest to the next point.
    pub(super) aim: usize,
}

impl<const SHARED: bool> Inserter<SHARED> {
    /// Inserts `v`, which is at `p`; `next` is the point that comes after it.
    #[inline(always)]
    pub(super) fn insert(&mut self, v: VertexId, p: DVec3, next: DVec3) -> Outcome {
        let seed = match self.walk(p, self.last) {
            Walk::Conflict(t) => t,
            Walk::Vertex(w) => return Outcome::Duplicate(w),
            Walk::Border => return Outcome::Late,
        };
        if !self.dig_best(p, seed) {
            return Outcome::Late;
        }
        let freed = self.free.len();
        if !self.take_slots() {
            return Outcome::Full;
        }
        if self.outer.len() > MAX_FACETS {
            self.fill_large(v, p);
        } else {
            self.fill_best(v, p, next);
        }
        for &t in self.free.get(freed..).unwrap_or_default() {
            self.arena.put(t, Tet::VACANT, Circumsphere::UNKNOWN);
        }
        Outcome::Inserted
    }

    /// Inserts points one after the other until slots run out; answers how many are done. Pairs
    /// (duplicate, its vertex) are added to `duplicates`.
    pub(super) fn insert_while_room(
        &mut self,
        points: &[VertexId],
        meter: &mut Meter<'_>,
        duplicates: &mut Vec<(VertexId, VertexId)>,
    ) -> Result<usize, Cancelled> {
        for (done, &v) in points.iter().enumerate() {
            let next = points.get(done + 1).copied().unwrap_or(v);
            let [p, next] = [v, next].map(|v| self.arena.place(v));
            match self.insert(v, p, next) {
                Outcome::Inserted => {}
                Outcome::Duplicate(vertex) => duplicates.push((v, vertex)),
                Outcome::Full | Outcome::Late => return Ok(done),
            }
            meter.advance()?;
        }
        Ok(points.len())
    }

    /// The real tetrahedron that has taken the slot of `t`, or that is beside the ghost that has.
    pub(super) fn real_at(&self, t: TetId) -> Option<TetId> {
        let tet = self.arena.tet(t);
        let is_vacant = tet.vertex[0].is_ghost();
        let real = if tet.vertex[3].is_ghost() {
            tet.twin[3].tet()
        } else {
            t
        };
        (!is_vacant).then_some(real)
    }

    /// [`fill`](Self::fill), by the wide loops where the processor can.
    #[inline(always)]
    fn fill_best(&mut self, v: VertexId, p: DVec3, next: DVec3) {
        #[cfg(target_arch = "x86_64")]
        if self.is_wide {
            // SAFETY: the processor was asked.
            return unsafe { self.fill_wide(v, p, next) };
        }
        self.fill(v, p, next);
    }

    /// [`dig`](Self::dig), four neighbours at a time where the processor can.
    #[inline(always)]
    fn dig_best(&mut self, p: DVec3, seed: TetId) -> bool {
        #[cfg(target_arch = "x86_64")]
        if self.is_wide {
            // SAFETY: the processor was asked.
            return unsafe { self.dig_wide(p, seed) };
        }
        self.dig(p, seed)
    }
}

#[cfg(test)]
thread_local! {
    static NARROW: std::cell::Cell<bool> = const { std::cell::Cell::new(false) };
}

/// Makes builds of this thread use the portable loops, or not.
#[cfg(test)]
pub(super) fn force_narrow(narrow: bool) {
    NARROW.set(narrow);
}

/// Whether this processor runs the wide loops.
pub(super) fn is_wide() -> bool {
    #[cfg(test)]
    if NARROW.get() {
        return false;
    }
    #[cfg(target_arch = "x86_64")]
    return super::wide::is_supported();
    #[cfg(not(target_arch = "x86_64"))]
    return false;
}
