//! Triangles that wait for a node, the one with the least bubble density first (§2.4, step c).
//!
//! A triangle that changes or goes is not looked for: its stamp changes, and what has an old stamp is dropped when it comes up.
//!
//! Only the triangles whose turn is near are in a heap, which is small enough for a cache; the far more others are in no order.
//! When the heap is empty, the next share of the others comes into it. Density grows slowly while the mesh
//! does, so most triangles are gone before their turn comes. The order is that of a single heap; each change
//! costs log n.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use delaunay_core::FaceId;
use glam::DVec2;

/// Of the triangles that are not near their turn, one in so many comes near, but at least so many.
const SHARE: usize = 32;
const LEAST: usize = 1024;

/// A priority queue of triangles.
#[derive(Clone, Debug)]
pub(super) struct Queue {
    /// Those with a density below the limit.
    near: BinaryHeap<Entry>,
    far: Vec<Entry>,
    limit: f64,
    /// By face; that of its entry, if it has one.
    stamps: Vec<u32>,
}

#[derive(Clone, Copy, Debug)]
struct Entry {
    density: f64,
    centroid: DVec2,
    face: FaceId,
    stamp: u32,
}

impl Queue {
    pub(super) fn new() -> Self {
        Self {
            near: BinaryHeap::new(),
            far: Vec::new(),
            limit: 0.0,
            stamps: Vec::new(),
        }
    }

    /// Takes up the triangle `f` as it is now.
    pub(super) fn push(&mut self, f: FaceId, density: f64, centroid: DVec2) {
        let entry = Entry {
            density,
            centroid,
            face: f,
            stamp: self.forget(f),
        };
        if density < self.limit {
            self.near.push(entry);
        } else {
            self.far.push(entry);
        }
    }

    /// Drops `f` as it was; gives its new stamp.
    pub(super) fn forget(&mut self, f: FaceId) -> u32 {
        if self.stamps.len() <= f.index() {
            self.stamps.resize(f.index() + 1, 0);
        }
        let stamp = &mut self.stamps[f.index()];
        // A face changes at most once with every node, and there are fewer nodes than stamps.
        *stamp = stamp.wrapping_add(1);
        *stamp
    }

    /// Takes out the triangle with the least density; of several, that with the smallest centroid.
    pub(super) fn pop(&mut self) -> Option<FaceId> {
        loop {
            let Some(entry) = self.near.pop() else {
                if self.far.is_empty() {
                    return None;
                }
                self.bring_near();
                continue;
            };
            if entry.stamp == self.stamps[entry.face.index()] {
                return Some(entry.face);
            }
        }
    }

    /// Fills the empty heap with the least dense of the other triangles, and drops those that are gone.
    fn bring_near(&mut self) {
        let Self {
            near,
            far,
            limit,
            stamps,
        } = self;
        far.retain(|entry| entry.stamp == stamps[entry.face.index()]);
        let share = (far.len() / SHARE).max(LEAST);
        if far.len() <= share {
            *limit = f64::INFINITY;
            near.extend(far.drain(..));
            return;
        }
        let by_density = |a: &Entry, b: &Entry| a.density.total_cmp(&b.density);
        let (_, last, _) = far.select_nth_unstable_by(share, by_density);
        // Equal densities stay together: more than a share may come, but never none.
        *limit = last.density.next_up();
        near.extend(far.extract_if(.., |entry| entry.density < *limit));
    }
}

impl Entry {
    /// Least first, by what does not depend on the numbers of faces as long as it can tell apart.
    fn rank(&self, other: &Self) -> Ordering {
        let [p, q] = [self, other].map(|entry| entry.centroid);
        let by_density = self.density.total_cmp(&other.density);
        by_density
            .then_with(|| p.x.total_cmp(&q.x))
            .then_with(|| p.y.total_cmp(&q.y))
            .then_with(|| self.face.cmp(&other.face))
            .then_with(|| self.stamp.cmp(&other.stamp))
    }
}

impl Ord for Entry {
    /// The greatest is on top of the heap.
    fn cmp(&self, other: &Self) -> Ordering {
        other.rank(self)
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

#[cfg(test)]
mod tests {
    use super::*;

    fn face(index: usize) -> FaceId {
        FaceId::new(index)
    }

    #[test]
    fn the_scarcest_comes_first_and_ties_go_by_place() {
        let mut queue = Queue::new();
        queue.push(face(0), 0.5, DVec2::new(2.0, 0.0));
        queue.push(face(1), 0.5, DVec2::new(1.0, 7.0));
        queue.push(face(2), 0.5, DVec2::new(1.0, 5.0));
        queue.push(face(3), 0.25, DVec2::new(9.0, 9.0));
        let order: Vec<FaceId> = std::iter::from_fn(|| queue.pop()).collect();
        assert_eq!(order, [3, 2, 1, 0].map(face));
    }

    #[test]
    fn a_triangle_counts_as_it_is_now() {
        let mut queue = Queue::new();
        queue.push(face(0), 0.1, DVec2::ZERO);
        queue.push(face(1), 0.2, DVec2::ZERO);
        queue.push(face(0), 0.3, DVec2::ZERO);
        queue.push(face(2), 0.0, DVec2::ZERO);
        queue.forget(face(2));
        let order: Vec<FaceId> = std::iter::from_fn(|| queue.pop()).collect();
        assert_eq!(order, [1, 0].map(face));
    }

    /// Against sorting, with many equal densities and changes on the way.
    #[test]
    fn the_order_is_that_of_one_heap() {
        let mut queue = Queue::new();
        let mut expected = Vec::new();
        let density = |k: usize| (k * 7919 % 1000) as f64;
        let place = |k: usize| DVec2::new((k * 31 % 17) as f64, k as f64);
        for k in 0..9000 {
            queue.push(face(k % 6000), density(k), place(k));
        }
        for k in 3000..9000 {
            expected.push(((density(k), place(k).x, place(k).y), k % 6000));
        }
        expected.sort_by(|a, b| a.0.partial_cmp(&b.0).unwrap());
        let mut order = Vec::new();
        while let Some(f) = queue.pop() {
            order.push(f.index());
        }
        let expected: Vec<usize> = expected.into_iter().map(|(_, f)| f).collect();
        assert_eq!(order, expected);
    }

    #[test]
    fn what_is_gone_does_not_pile_up() {
        let mut queue = Queue::new();
        for round in 0..100_000 {
            queue.push(face(round % 10), (round + 1) as f64, DVec2::ZERO);
            if round % 1000 == 999 {
                assert!(queue.pop().is_some());
                assert!(queue.near.len() + queue.far.len() <= 1000 + 10);
            }
        }
        assert_eq!(std::iter::from_fn(|| queue.pop()).count(), 9);
    }
}
