//! The walk to a point, as in `locate.rs`, within one part.

use super::super::sight::{Seen, Sight};
use super::dig::Seed;
use super::part::Part;
use super::worker::{Seat, Worker};
use crate::ids::{HalfEdgeId, VertexId};
use geo_predicates::Sign;
use geo_predicates::filter::Relative2;

impl<P: Part> Worker<'_, P> {
    /// Walks from the start to the point of `sight`.
    ///
    /// # Safety
    /// As [`insert`](Self::insert).
    #[inline(always)]
    pub(super) unsafe fn walk(&self, sight: &Sight<'_>) -> Seat {
        // SAFETY: the walk reads twins only of faces that it has found to be of its part, and corners only of
        // those and of faces across their edges, which share a vertex with them.
        unsafe {
            let mut entry = self.start;
            let mut from = self.see(sight, self.arena.apex(entry.next()));
            let mut to = self.see(sight, self.arena.apex(entry.prev()));
            if sight.side(&from, &to) == Sign::Negative {
                entry = self.arena.twin(entry);
                std::mem::swap(&mut from, &mut to);
            }
            loop {
                let apex = self.see(sight, self.arena.apex(entry));
                if apex.vertex.is_ghost() {
                    let corners = [from, to, apex];
                    let base = entry;
                    return Seat::Face(Seed { base, corners });
                }
                if !self.part.holds(apex.vertex) {
                    return Seat::Lost;
                }
                let ahead = sight.side(&to, &apex);
                if ahead == Sign::Negative {
                    entry = self.arena.twin(entry.next());
                    from = apex;
                    continue;
                }
                let behind = sight.side(&apex, &from);
                if behind == Sign::Negative {
                    entry = self.arena.twin(entry.prev());
                    to = apex;
                    continue;
                }
                let at_corner = ahead == Sign::Zero || behind == Sign::Zero;
                let corners = [from, to, apex];
                if at_corner
                    && let Some(corner) = corners.iter().find(|corner| corner.arm.is_zero())
                {
                    return Seat::Vertex(corner.vertex);
                }
                let base = entry;
                return Seat::Face(Seed { base, corners });
            }
        }
    }

    /// What the point of `sight` sees of `v`.
    ///
    /// # Safety
    /// `v` is a vertex of the arena.
    #[inline(always)]
    pub(super) unsafe fn see(&self, sight: &Sight<'_>, vertex: VertexId) -> Seen {
        // SAFETY: the caller's promise.
        let place = unsafe { self.arena.point(vertex) };
        Seen {
            vertex,
            arm: Relative2::new(place, sight.from()),
        }
    }

    /// `h`, or a half-edge of a triangle beside it when `h` bounds a ghost face.
    ///
    /// # Safety
    /// The face of `h` is of the part.
    #[inline(always)]
    pub(super) unsafe fn real_side(&self, h: HalfEdgeId) -> HalfEdgeId {
        // SAFETY: the caller's promise.
        unsafe {
            for base in [h, h.next(), h.prev()] {
                if self.arena.apex(base).is_ghost() {
                    return self.arena.twin(base);
                }
            }
        }
        h
    }
}
