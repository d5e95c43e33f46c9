//! Elements of low quality, the most urgent first.

use crate::stamp::Stamp;
use std::cmp::Ordering;
use std::collections::BinaryHeap;

/// A queue of elements with ids of type `I`, some of which may be gone when their turn comes.
#[derive(Clone, Debug)]
pub(crate) struct Worklist<I> {
    heap: BinaryHeap<Entry<I>>,
    /// Elements that nothing could be done for.
    parked: Vec<Entry<I>>,
}

/// An element that waits.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Entry<I> {
    /// The larger, the more urgent.
    pub(crate) urgency: f64,
    pub(crate) id: I,
    pub(crate) stamp: Stamp,
}

impl<I: Copy + Ord> Worklist<I> {
    pub(crate) const fn new() -> Self {
        Self {
            heap: BinaryHeap::new(),
            parked: Vec::new(),
        }
    }

    pub(crate) fn push(&mut self, entry: Entry<I>) {
        self.heap.push(entry);
    }

    /// The most urgent element that is still there; `stamp` gives the stamps of now.
    pub(crate) fn next(&mut self, stamp: impl Fn(I) -> Stamp) -> Option<I> {
        loop {
            let Entry {
                id, stamp: then, ..
            } = self.heap.pop()?;
            if stamp(id) == then {
                return Some(id);
            }
        }
    }

    /// Puts an element aside until [`resume`](Self::resume).
    pub(crate) fn park(&mut self, entry: Entry<I>) {
        self.parked.push(entry);
    }

    /// Takes the parked elements up again that are still there.
    pub(crate) fn resume(&mut self, stamp: impl Fn(I) -> Stamp) {
        let parked = self.parked.drain(..);
        self.heap
            .extend(parked.filter(|entry| stamp(entry.id) == entry.stamp));
    }
}

/// By urgency, equal ones by id.
impl<I: Ord> Ord for Entry<I> {
    fn cmp(&self, other: &Self) -> Ordering {
        let urgencies = self.urgency.total_cmp(&other.urgency);
        urgencies
            .then(other.id.cmp(&self.id))
            .then(self.stamp.cmp(&other.stamp))
    }
}

impl<I: Ord> PartialOrd for Entry<I> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl<I: Ord> PartialEq for Entry<I> {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl<I: Ord> Eq for Entry<I> {}
