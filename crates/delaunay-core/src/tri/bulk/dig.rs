//! The cavity of a point, as in `cavity.rs`, within one part.

use super::super::cavity::{PendingEdge, RimEdge};
use super::super::sight::{Seen, Sight};
use super::part::Part;
use super::worker::Worker;
use crate::ids::{FaceId, HalfEdgeId, VertexId};
use geo_predicates::filter::Relative2;
use glam::DVec2;

/// Faces that a cavity may have before its buffers grow. Nearly all have fewer than twenty.
const FIRST_ROOM: usize = 64;

/// The cavity of the last point, and the edges still to be looked at while it is dug.
///
/// All buffers are filled with anything up to their length; a cavity of m faces uses the first m of `faces`,
/// m + 2 of `rim` and at most m + 1 of `pending`. Two more faces and one more edge are room to close the star.
pub(super) struct Diggings {
    pub(super) faces: Vec<FaceId>,
    pub(super) rim: Vec<RimEdge>,
    pending: Vec<PendingEdge>,
}

/// How digging ended.
pub(super) enum Dug {
    /// The cavity has this many edges; the star face on edge `aimed` seems to face the next point.
    Rim { edges: usize, aimed: usize },
    /// The cavity has faces that are not of the part.
    Abroad,
    /// The buffers are full.
    TooLarge,
}

impl Diggings {
    pub(super) fn new() -> Self {
        let mut diggings = Self {
            faces: Vec::new(),
            rim: Vec::new(),
            pending: Vec::new(),
        };
        diggings.make_room(FIRST_ROOM);
        diggings
    }

    /// Makes room for twice as many faces.
    #[cold]
    pub(super) fn grow(&mut self) {
        self.make_room(2 * self.room());
    }

    fn make_room(&mut self, faces: usize) {
        let first = HalfEdgeId::new(0);
        let rim = RimEdge {
            origin: VertexId::GHOST,
            outer: first,
        };
        self.faces.resize(faces + 2, first.face());
        self.rim.resize(faces + 3, rim);
        let nothing = Seen {
            vertex: VertexId::GHOST,
            arm: Relative2::new(DVec2::ZERO, DVec2::ZERO),
        };
        let pending = PendingEdge::new(&nothing, nothing, first);
        self.pending.resize(faces + 1, pending);
    }

    /// The most faces that a cavity may have.
    fn room(&self) -> usize {
        self.faces.len() - 2
    }
}

impl<P: Part> Worker<'_, P> {
    /// Digs the cavity of the point of `sight` from a face `seed` known to be in it, and aims at `next`.
    ///
    /// Writes nothing but the diggings, so giving up costs nothing.
    ///
    /// # Safety
    /// As [`insert`](Self::insert), and the real corners of `seed` are in the part.
    #[inline(always)]
    pub(super) unsafe fn dig(&mut self, sight: &Sight<'_>, seed: FaceId, next: DVec2) -> Dug {
        let room = self.diggings.room();
        let towards = Relative2::new(next, sight.from());
        let faces = self.diggings.faces.as_mut_ptr();
        let rim = self.diggings.rim.as_mut_ptr();
        let pending = self.diggings.pending.as_mut_ptr();
        // SAFETY: twins are read only of faces found to be of the part, corners only of those and of faces
        // across their edges, which share a vertex with them. `dug` is at most `room`; every face dug
        // turns one edge into two, so edges on the rim and pending are `dug + 2` together, and
        // all buffers have that much room.
        unsafe {
            let [ab, bc, ca] = seed.half_edges();
            let [mut start, b, c] = [ab, bc, ca].map(|h| self.see(sight, self.arena.origin(h)));
            pending.write(PendingEdge::new(&c, start, self.arena.twin(ca)));
            pending
                .add(1)
                .write(PendingEdge::new(&b, c, self.arena.twin(bc)));
            let mut edge = PendingEdge::new(&start, b, self.arena.twin(ab));
            faces.write(seed);
            let (mut dug, mut edges, mut waiting) = (1, 0, 2);
            let (mut aimed, mut left_before) = (0, true);
            loop {
                let (left, right) = (edge.outer.prev(), edge.outer.next());
                let apex = self.see(sight, self.arena.origin(left));
                if sight.in_conflict([&edge.end, &start, &apex], edge.backwards) {
                    if !apex.vertex.is_ghost() && !self.part.holds(apex.vertex) {
                        return Dug::Abroad;
                    }
                    if dug == room {
                        return Dug::TooLarge;
                    }
                    faces.add(dug).write(edge.outer.face());
                    dug += 1;
                    let below = PendingEdge::new(&apex, edge.end, self.arena.twin(left));
                    pending.add(waiting).write(below);
                    waiting += 1;
                    edge = PendingEdge::new(&start, apex, self.arena.twin(right));
                } else {
                    let origin = start.vertex;
                    rim.add(edges).write(RimEdge {
                        origin,
                        outer: edge.outer,
                    });
                    // Rounding does no harm to the aim, the walk is exact.
                    let left = towards.cross(&edge.end.arm).seems_left();
                    aimed = if left && !left_before { edges } else { aimed };
                    left_before = left;
                    edges += 1;
                    start = edge.end;
                    if waiting == 0 {
                        debug_assert_eq!(edges, dug + 2);
                        return Dug::Rim { edges, aimed };
                    }
                    waiting -= 1;
                    edge = pending.add(waiting).read();
                }
            }
        }
    }
}
