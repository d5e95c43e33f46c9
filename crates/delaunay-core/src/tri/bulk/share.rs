//! One thread's share of a round.

use super::arena::Arena;
use super::fill::faces_of;
use super::part::{Part, Stretches};
use super::worker::Worker;
use crate::ids::{HalfEdgeId, VertexId};
use crate::order::Order;
use crate::progress::Cancelled;
use crate::threads;
use geo_predicates::filter::Filter2;
use std::iter::Peekable;

/// Points that a thread inserts between two reports.
const LEG: usize = 1 << 18;

/// Vertices for which one start of a walk is kept.
const STEP: usize = 64;

/// Faces of the round before that are tried as a start.
const TRIALS: usize = 16;

/// Vertices of one part and the thread that inserts them.
///
/// Shares lie side by side and change with every point; in cache lines of their own, no thread waits for the other
/// (a sixth of the time of two threads otherwise).
#[repr(align(128))]
pub(super) struct Share<'a, I: Iterator<Item = VertexId>> {
    worker: Worker<'a, Stretches<'a>>,
    vertices: Peekable<I>,
    starts: Starts,
}

impl<'a, I: ExactSizeIterator<Item = VertexId> + Send> Share<'a, I> {
    /// A share of `round`; none of its work has begun, and no thread writes to the arena.
    pub(super) fn new(
        arena: &'a Arena<'a>,
        filter: Filter2,
        part: Stretches<'a>,
        vertices: I,
        order: &Order,
        round: usize,
    ) -> Self {
        let starts = Starts::find(arena, part, order, round);
        let first = HalfEdgeId::new(0);
        let mut share = Self {
            worker: Worker::new(arena, part, filter, first),
            vertices: vertices.peekable(),
            starts,
        };
        match (share.vertices.peek(), share.starts.faces.is_empty()) {
            (Some(&v), false) => share.worker.start = share.starts.near(v),
            // No face to start from: all comes later.
            _ => share.worker.postponed.extend(share.vertices.by_ref()),
        }
        share
    }
}

/// What several threads have done.
pub(super) struct Settled {
    /// In the order of the shares.
    pub(super) postponed: Vec<VertexId>,
    pub(super) duplicates: Vec<(VertexId, VertexId)>,
}

/// Works on all shares at the same time, and reports now and then how many points are settled.
///
/// # Safety
/// The parts of the shares are disjoint, their vertices are in the parts, and nobody else uses the arena.
pub(super) unsafe fn work_on<'a, I: ExactSizeIterator<Item = VertexId> + Send>(
    mut shares: Vec<Share<'a, I>>,
    mut report: impl FnMut(usize) -> Result<(), Cancelled>,
) -> Result<Settled, Cancelled> {
    let open = |share: &Share<'a, I>| share.vertices.len() + share.worker.postponed.len();
    let given: usize = shares.iter().map(open).sum();
    while shares.iter().any(|share| share.vertices.len() > 0) {
        threads::for_each(shares.iter_mut().collect(), |share| {
            let Share {
                worker,
                vertices,
                starts,
            } = share;
            // SAFETY: the caller's promise, and what the module says of disjoint parts; `starts` are faces of
            // the part, in which a slot once of the part stays so.
            unsafe { worker.insert_some(vertices, LEG, |v| starts.near(v)) };
        });
        report(given - shares.iter().map(open).sum::<usize>())?;
    }
    let mut settled = Settled {
        postponed: Vec::new(),
        duplicates: Vec::new(),
    };
    for share in shares {
        settled.postponed.extend(share.worker.postponed);
        settled.duplicates.extend(share.worker.duplicates);
    }
    Ok(settled)
}

/// Faces of a part from which walks to the vertices of a round can start.
struct Starts {
    /// The slot of the first vertex of the round.
    first: usize,
    /// One for every `STEP` vertices of the round, or none at all.
    faces: Vec<HalfEdgeId>,
}

impl Starts {
    /// Finds starts near the vertices of the part, in places of faces that the round before has made.
    fn find(arena: &Arena<'_>, part: Stretches<'_>, order: &Order, round: usize) -> Self {
        let ranks = &order.rounds[round];
        let mut faces = Vec::with_capacity(ranks.len() / STEP + 1);
        let mut missing = 0;
        for rank in ranks.clone().step_by(STEP) {
            let v = VertexId::from_slot(rank + 1);
            // SAFETY: `v` is one of the points.
            let mine = unsafe { part.holds(v) };
            let near = order.rank_before(round, rank, part.stretch_of[v.slot()].into());
            let found = mine
                .then(|| face_of_part(arena, part, near..ranks.start))
                .flatten();
            match found.or(faces.last().copied()) {
                Some(start) => faces.push(start),
                None => missing += 1,
            }
        }
        if let Some(&start) = faces.first() {
            faces.splice(..0, std::iter::repeat_n(start, missing));
        }
        Self {
            first: ranks.start + 1,
            faces,
        }
    }

    fn near(&self, v: VertexId) -> HalfEdgeId {
        self.faces[(v.slot() - self.first) / STEP]
    }
}

/// A half-edge of a real face of `part`, among those that the vertices of the first few ranks have brought.
fn face_of_part(
    arena: &Arena<'_>,
    part: Stretches<'_>,
    ranks: std::ops::Range<usize>,
) -> Option<HalfEdgeId> {
    let slots = (ranks.start + 1).max(4)..ranks.end + 1;
    let faces = slots
        .take(TRIALS / 2)
        .flat_map(|slot| faces_of(VertexId::from_slot(slot)));
    let mut outer = faces.map(|f| f.half_edge(1));
    outer.find(|&h| {
        // SAFETY: all vertices before the round have brought their faces, and no thread writes now.
        let corners = [h, h.next(), h.prev()].map(|h| unsafe { arena.apex(h) });
        // SAFETY: corners are vertices of the arena.
        corners
            .iter()
            .all(|&v| !v.is_ghost() && unsafe { part.holds(v) })
    })
}
