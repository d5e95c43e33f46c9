//! Tetrahedra of low records, the worst first.

use super::records::{Records, Stamp};
use delaunay_core::TetId;
use std::cmp::Ordering;
use std::collections::BinaryHeap;

/// A queue of tetrahedra of low records, some of which may be gone when their turn comes.
#[derive(Clone, Debug, Default)]
pub(crate) struct Worklist {
    heap: BinaryHeap<Entry>,
    /// Tetrahedra that nothing could be done for.
    parked: Vec<Entry>,
}

#[derive(Clone, Copy, Debug)]
struct Entry {
    squared_ratio: f64,
    tet: TetId,
    stamp: Stamp,
}

impl Worklist {
    /// Takes those of `tets` that are of low records.
    pub(crate) fn examine(&mut self, records: &Records, tets: impl IntoIterator<Item = TetId>) {
        for tet in tets {
            if records.is_low(tet) {
                self.heap.push(Entry::of(records, tet));
            }
        }
    }

    /// The worst tetrahedron that is still there.
    pub(crate) fn next(&mut self, records: &Records) -> Option<TetId> {
        loop {
            let entry = self.heap.pop()?;
            if entry.is_there(records) {
                return Some(entry.tet);
            }
        }
    }

    /// Puts a tetrahedron aside until [`resume`](Self::resume).
    pub(crate) fn park(&mut self, records: &Records, tet: TetId) {
        self.parked.push(Entry::of(records, tet));
    }

    /// Takes the parked tetrahedra up again that are still there.
    pub(crate) fn resume(&mut self, records: &Records) {
        let parked = self.parked.drain(..);
        self.heap
            .extend(parked.filter(|entry| entry.is_there(records)));
    }
}

impl Entry {
    fn of(records: &Records, tet: TetId) -> Self {
        Self {
            squared_ratio: records.squared_ratio(tet),
            tet,
            stamp: records.stamp(tet),
        }
    }

    fn is_there(&self, records: &Records) -> bool {
        records.stamp(self.tet) == self.stamp
    }
}

/// By ratio, equal ones by id.
impl Ord for Entry {
    fn cmp(&self, other: &Self) -> Ordering {
        let ratios = self.squared_ratio.total_cmp(&other.squared_ratio);
        ratios
            .then(other.tet.cmp(&self.tet))
            .then(self.stamp.cmp(&other.stamp))
    }
}

impl PartialOrd for Entry {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Entry {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Entry {}
