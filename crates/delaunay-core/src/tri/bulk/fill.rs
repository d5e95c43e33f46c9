//! The star of a new vertex, face by face, as in `star.rs`.

use super::super::mesh::Face;
use super::arena::Arena;
use crate::ids::{FaceId, HalfEdgeId, VertexId};

/// The two faces that the insertion of `v` adds to a mesh; the first three vertices have four together.
pub(super) fn faces_of(v: VertexId) -> [FaceId; 2] {
    let first = 2 * v.slot() - 4;
    [first, first + 1].map(FaceId::new)
}

/// A star in the making: its faces follow each other counterclockwise.
pub(super) struct Star {
    vertex: VertexId,
    first: FaceId,
    before: FaceId,
    /// Where the next face goes.
    pub(super) here: FaceId,
}

impl Star {
    /// The star of `vertex`, without a face yet; its first face goes to `first`.
    #[inline(always)]
    pub(super) fn new(vertex: VertexId, first: FaceId) -> Self {
        Self {
            vertex,
            first,
            before: first,
            here: first,
        }
    }

    /// Writes the face on the edge from `start` to `end` of the rim, which has `outer` on its other side. The face that
    /// follows goes to `after`; the last face may have anything there.
    ///
    /// # Safety
    /// No other thread uses the face at this place, nor the twin of `outer`.
    #[inline(always)]
    pub(super) unsafe fn add(
        &mut self,
        arena: &Arena<'_>,
        [start, end]: [VertexId; 2],
        outer: HalfEdgeId,
        after: FaceId,
    ) {
        let Self {
            vertex,
            before,
            here,
            ..
        } = *self;
        let face = Face {
            origin: [vertex, start, end],
            twin: [before.half_edge(2), outer, after.half_edge(0)],
        };
        // SAFETY: the caller's promise.
        unsafe {
            arena.set_twin(outer, here.half_edge(1));
            arena.put(here, face);
        }
        (self.before, self.here) = (here, after);
    }

    /// Joins the last face to the first.
    ///
    /// # Safety
    /// All faces have been added, and no other thread uses them.
    #[inline(always)]
    pub(super) unsafe fn close(&self, arena: &Arena<'_>) {
        let [last, first] = [self.before.half_edge(2), self.first.half_edge(0)];
        // SAFETY: the caller's promise.
        unsafe {
            arena.set_twin(last, first);
            arena.set_twin(first, last);
        }
    }
}
