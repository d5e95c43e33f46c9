//! One thread of a build: it inserts points one after the other.

use super::super::mesh::Face;
use super::super::sight::Sight;
use super::arena::Arena;
use super::dig::Seed;
use super::diggings::Diggings;
use super::fill::faces_of;
use super::part::Part;
use crate::ids::{HalfEdgeId, VertexId};
use geo_predicates::filter::Filter2;
use std::iter::Peekable;

/// Inserts points into the faces of its part.
pub(super) struct Worker<'a, P> {
    pub(super) arena: &'a Arena<'a>,
    pub(super) part: P,
    pub(super) filter: Filter2,
    /// Where the next walk starts: a half-edge of a real face, between vertices of the part.
    pub(super) start: HalfEdgeId,
    pub(super) diggings: Diggings,
    /// Pairs (duplicate, the vertex in its place).
    pub(super) duplicates: Vec<(VertexId, VertexId)>,
    /// Points whose insertion would touch faces of another part.
    pub(super) postponed: Vec<VertexId>,
}

/// What became of a point.
enum Outcome {
    Inserted,
    /// This vertex is in its place.
    Duplicate(VertexId),
    /// The walk to it left the part.
    Lost,
    /// Its cavity leaves the part.
    Abroad,
}

/// Where a point is, as far as an insertion asks.
pub(super) enum Seat {
    /// In a face whose circumdisk contains it.
    Face(Seed),
    Vertex(VertexId),
    /// The walk left the part.
    Lost,
}

impl<'a, P: Part> Worker<'a, P> {
    pub(super) fn new(arena: &'a Arena<'a>, part: P, filter: Filter2, start: HalfEdgeId) -> Self {
        Self {
            arena,
            part,
            filter,
            start,
            diggings: Diggings::new(),
            duplicates: Vec::new(),
            postponed: Vec::new(),
        }
    }

    /// Inserts the next `limit` of `vertices`, or all that are left; after a walk that left the part, once more
    /// from where `restart` says.
    ///
    /// # Safety
    /// The rules of the [module](super): only this thread writes faces that have a vertex of the part, apart from
    /// twins on edges without one; no other inserts `vertices`, which are of the part; `start` is as
    /// it says, and `restart` answers with half-edges of faces of the part.
    pub(super) unsafe fn insert_some(
        &mut self,
        vertices: &mut Peekable<impl Iterator<Item = VertexId>>,
        limit: usize,
        restart: impl Fn(VertexId) -> HalfEdgeId,
    ) {
        for _ in 0..limit {
            let Some(v) = vertices.next() else {
                return;
            };
            let next = vertices.peek().copied().unwrap_or(v);
            let mut lost_before = false;
            loop {
                // SAFETY: the caller's promise.
                match unsafe { self.insert(v, next) } {
                    Outcome::Inserted => {}
                    Outcome::Lost if !lost_before => {
                        lost_before = true;
                        // SAFETY: the face is of the part; since the start was chosen, its slot may have
                        // been filled with a ghost.
                        self.start = unsafe { self.real_side(restart(v)) };
                        continue;
                    }
                    Outcome::Lost | Outcome::Abroad => self.postponed.push(v),
                    Outcome::Duplicate(vertex) => {
                        self.duplicates.push((v, vertex));
                        for f in faces_of(v) {
                            // SAFETY: no other thread inserts `v`, so its faces are not in use.
                            unsafe { self.arena.put(f, Face::VACANT) };
                        }
                    }
                }
                break;
            }
        }
    }

    /// Makes `v` a vertex, unless it is one already or its cavity leaves the part; `next` is the vertex that
    /// comes after it.
    ///
    /// # Safety
    /// As [`insert_some`](Self::insert_some).
    #[inline(always)]
    unsafe fn insert(&mut self, v: VertexId, next: VertexId) -> Outcome {
        // SAFETY: the caller's promise; the seed is a face of the part, and the cavity dug is that of `v`.
        unsafe {
            let (p, next) = (self.arena.point(v), self.arena.point(next));
            let sight = Sight::new(self.arena.coords(), self.filter, p);
            let seed = match self.walk(&sight) {
                Seat::Face(seed) => seed,
                Seat::Vertex(vertex) => return Outcome::Duplicate(vertex),
                Seat::Lost => return Outcome::Lost,
            };
            match self.dig(v, &sight, &seed, next) {
                true => Outcome::Inserted,
                false => Outcome::Abroad,
            }
        }
    }
}
