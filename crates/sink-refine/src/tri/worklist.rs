//! Triangles of low quality, the most urgent first.

use super::records::{Records, Stamp};
use delaunay_core::FaceId;
use std::cmp::Ordering;
use std::collections::BinaryHeap;

/// Which triangle is the most urgent.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Urgency {
    /// The one with the largest ratio.
    #[default]
    WorstRatio,
    /// The one with the shortest edge.
    ShortestEdge,
}

/// A queue of triangles of low quality, some of which may be gone when their turn comes.
#[derive(Clone, Debug, Default)]
pub(crate) struct Worklist {
    urgency: Urgency,
    heap: BinaryHeap<Entry>,
    /// Triangles that nothing could be done for.
    parked: Vec<Entry>,
}

#[derive(Clone, Copy, Debug)]
struct Entry {
    key: f64,
    face: FaceId,
    stamp: Stamp,
}

impl Worklist {
    pub(crate) fn new(urgency: Urgency) -> Self {
        Self {
            urgency,
            ..Self::default()
        }
    }

    /// Takes those of `faces` that are of low quality.
    pub(crate) fn examine(&mut self, records: &Records, faces: impl IntoIterator<Item = FaceId>) {
        for face in faces {
            if records.is_low(face) {
                self.heap.push(self.entry(records, face));
            }
        }
    }

    /// The most urgent triangle that is still there.
    pub(crate) fn next(&mut self, records: &Records) -> Option<FaceId> {
        loop {
            let entry = self.heap.pop()?;
            if entry.is_there(records) {
                return Some(entry.face);
            }
        }
    }

    fn entry(&self, records: &Records, face: FaceId) -> Entry {
        let key = match self.urgency {
            Urgency::WorstRatio => records.squared_ratio(face),
            Urgency::ShortestEdge => -records.squared_shortest(face),
        };
        let stamp = records.stamp(face);
        Entry { key, face, stamp }
    }

    /// Puts a triangle aside until [`resume`](Self::resume).
    pub(crate) fn park(&mut self, records: &Records, face: FaceId) {
        self.parked.push(self.entry(records, face));
    }

    /// Takes the parked triangles up again that are still there.
    pub(crate) fn resume(&mut self, records: &Records) {
        let parked = self.parked.drain(..);
        self.heap
            .extend(parked.filter(|entry| entry.is_there(records)));
    }
}

impl Entry {
    fn is_there(&self, records: &Records) -> bool {
        records.stamp(self.face) == self.stamp
    }
}

/// By urgency, equal ones by id.
impl Ord for Entry {
    fn cmp(&self, other: &Self) -> Ordering {
        let keys = self.key.total_cmp(&other.key);
        keys.then(other.face.cmp(&self.face))
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
