//! The vertices whose faces one thread may replace.

use crate::ids::VertexId;
use crate::order::Order;

/// A set of vertices, the ghost aside.
pub(super) trait Part: Copy + Send {
    /// Whether there are vertices that are not in the set, so that cavities may leave it.
    const HAS_BORDER: bool;

    /// Whether the real vertex `v` is in the set.
    ///
    /// # Safety
    /// `v` is a vertex of the points that the part was made for.
    unsafe fn holds(&self, v: VertexId) -> bool;
}

/// All vertices: the part of a thread that is alone.
#[derive(Clone, Copy)]
pub(super) struct Whole;

impl Part for Whole {
    const HAS_BORDER: bool = false;

    #[inline(always)]
    unsafe fn holds(&self, _v: VertexId) -> bool {
        true
    }
}

/// The vertices on consecutive stretches of the curve, the first of which may follow the last.
#[derive(Clone, Copy)]
pub(super) struct Stretches<'a> {
    /// The stretch that a vertex is on, by vertex slot.
    pub(super) stretch_of: &'a [u8],
    pub(super) first: u8,
    /// How many stretches, less one.
    pub(super) others: u8,
}

impl Part for Stretches<'_> {
    const HAS_BORDER: bool = true;

    #[inline(always)]
    unsafe fn holds(&self, v: VertexId) -> bool {
        debug_assert!(v.slot() < self.stretch_of.len());
        // SAFETY: there is a stretch for each vertex slot.
        let stretch = unsafe { *self.stretch_of.get_unchecked(v.slot()) };
        stretch.wrapping_sub(self.first) <= self.others
    }
}

/// The stretch of the curve that each vertex is on, by slot.
pub(super) fn stretch_of_slots(order: &Order, slots: usize) -> Vec<u8> {
    let mut stretch_of = vec![0; slots];
    for (round, starts) in order.rounds.iter().zip(&order.stretches) {
        let ends = starts
            .iter()
            .skip(1)
            .map(|&end| end as usize)
            .chain([round.end]);
        for (stretch, (&start, end)) in starts.iter().zip(ends).enumerate() {
            stretch_of[start as usize + 1..=end].fill(stretch as u8);
        }
    }
    stretch_of
}
