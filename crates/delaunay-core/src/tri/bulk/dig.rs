//! The cavity of a point, as in `cavity.rs`, within one part; the star that replaces it is made on the way.
//!
//! Edges of the rim are met in their order round the point, each when it is known that its inside is in the cavity and
//! its outside is not. There is always a place for the face on it: the vertex brings two faces, and
//! an edge on the rim or waiting is one more for each face dug. So the star need not wait for the end of
//! the cavity, and a second loop whose number of rounds no processor can foretell is saved.

use super::super::sight::{Seen, Sight};
use super::diggings::{Beyond, Pending};
use super::fill::{Star, faces_of};
use super::part::Part;
use super::worker::Worker;
use crate::ids::{HalfEdgeId, VertexId};
use geo_predicates::filter::Relative2;
use glam::DVec2;

/// A face whose circumdisk contains a point, as the walk to the point has met it.
pub(super) struct Seed {
    pub(super) base: HalfEdgeId,
    /// The ends of the base and the apex.
    pub(super) corners: [Seen; 3],
}

impl<P: Part> Worker<'_, P> {
    /// Replaces the cavity of the vertex `v`, the point of `sight`, by its star, and starts the next walk at a face
    /// of it that seems to face `next`; or leaves everything as it was and is false, when the cavity leaves the part.
    ///
    /// # Safety
    /// As [`insert`](Self::insert), and the real corners of `seed` are in the part.
    #[inline(always)]
    pub(super) unsafe fn dig(
        &mut self,
        v: VertexId,
        sight: &Sight<'_>,
        seed: &Seed,
        next: DVec2,
    ) -> bool {
        let towards = Relative2::new(next, sight.from());
        let mut room = self.diggings.room();
        let mut places = self.diggings.places.as_mut_ptr();
        let mut pending = self.diggings.pending.as_mut_ptr();
        // SAFETY: twins are read only of faces found to be of the part, corners only of those and of faces across their
        // edges, which share a vertex with them. `dug` is at most `room`; every face dug turns one edge into two,
        // so edges on the rim and pending are `dug + 2` together; there are `room + 3` places and room for
        // `room + 1` pending edges besides the one looked at.
        // Faces are written in place of faces dug and of those of `v`, and twins on edges of faces
        // dug: nobody else touches either. What is read of a face beyond an edge stays true until the
        // edge has its turn, because no face is met twice.
        unsafe {
            let [mut start, b, c] = seed.corners;
            let [ab, bc, ca] = [seed.base, seed.base.next(), seed.base.prev()];
            self.diggings.saved.clear();
            self.save(ab.face());
            pending.write(self.pending(&c, start, self.arena.twin(ca)));
            pending
                .add(1)
                .write(self.pending(&b, c, self.arena.twin(bc)));
            let Pending {
                mut end,
                mut outer,
                mut forwards,
                mut beyond,
            } = self.pending(&start, b, self.arena.twin(ab));
            let [first, second] = faces_of(v);
            places.write(first);
            places.add(1).write(second);
            places.add(2).write(ab.face());
            let mut star = Star::new(v, first);
            let (mut dug, mut edges, mut waiting) = (1, 0, 2);
            let (mut aimed, mut left_before) = (first, true);
            loop {
                let apex = Seen {
                    vertex: beyond.apex,
                    arm: Relative2::new(beyond.place, sight.from()),
                };
                let (near, far) = (start.arm.cross(&apex.arm), apex.arm.cross(&end.arm));
                let crosses = [near, far, -forwards];
                if sight.in_conflict_crossed([&end, &start, &apex], crosses) {
                    if !apex.vertex.is_ghost() && !self.part.holds(apex.vertex) {
                        self.restore();
                        return false;
                    }
                    if dug == room {
                        self.diggings.grow();
                        room = self.diggings.room();
                        places = self.diggings.places.as_mut_ptr();
                        pending = self.diggings.pending.as_mut_ptr();
                    }
                    self.save(outer.face());
                    places.add(dug + 2).write(outer.face());
                    dug += 1;
                    // Field by field: the compiler moves whole records by way of the stack, 4 % more instructions.
                    let below = pending.add(waiting);
                    let left = self.arena.twin(outer.prev());
                    (&raw mut (*below).end).write(end);
                    (&raw mut (*below).outer).write(left);
                    (&raw mut (*below).forwards).write(far);
                    (&raw mut (*below).beyond).write(self.beyond(left));
                    waiting += 1;
                    end = apex;
                    outer = self.arena.twin(outer.next());
                    forwards = near;
                    beyond = self.beyond(outer);
                } else {
                    // Rounding does no harm to the aim, the walk is exact.
                    let left = towards.cross(&end.arm).seems_left();
                    aimed = if left && !left_before {
                        star.here
                    } else {
                        aimed
                    };
                    left_before = left;
                    edges += 1;
                    debug_assert!(edges < self.diggings.places.len());
                    let after = places.add(edges).read();
                    let ends = [start.vertex, end.vertex];
                    star.add(self.arena, ends, outer, after);
                    if waiting == 0 {
                        debug_assert_eq!(edges, dug + 2);
                        star.close(self.arena);
                        self.start = self.real_side(aimed.half_edge(1));
                        return true;
                    }
                    start = end;
                    waiting -= 1;
                    let above = pending.add(waiting);
                    end = (&raw const (*above).end).read();
                    outer = (&raw const (*above).outer).read();
                    forwards = (&raw const (*above).forwards).read();
                    beyond = (&raw const (*above).beyond).read();
                }
            }
        }
    }

    /// The edge from `start` to `end` with `outer` on its other side.
    ///
    /// # Safety
    /// As for [`beyond`](Self::beyond).
    #[inline(always)]
    unsafe fn pending(&self, start: &Seen, end: Seen, outer: HalfEdgeId) -> Pending {
        Pending {
            end,
            outer,
            forwards: start.arm.cross(&end.arm),
            // SAFETY: the caller's promise.
            beyond: unsafe { self.beyond(outer) },
        }
    }

    /// The apex of the face of `outer`.
    ///
    /// # Safety
    /// The other side of `outer` is of the part.
    #[inline(always)]
    unsafe fn beyond(&self, outer: HalfEdgeId) -> Beyond {
        // SAFETY: the face has a corner in the part, so no other thread writes its corners; they are vertices.
        unsafe {
            let apex = self.arena.apex(outer);
            let place = self.arena.point(apex);
            Beyond { apex, place }
        }
    }
}
