//! Elements of low quality, the most urgent first.
//!
//! Most that wait are gone when their turn comes: an insertion takes a crowd of them away. So they are not kept in order all
//! together, which in large meshes would be a walk through memory for each of them, but in classes of like urgency. When the turn
//! of a class comes, those that are gone are left out in passing, and only the others are put in order.

use crate::stamp::Stamp;
use std::cmp::Ordering;
use std::collections::{BTreeMap, BinaryHeap};

/// A queue of elements with ids of type `I`, some of which may be gone when their turn comes.
#[derive(Clone, Debug)]
pub(crate) struct Worklist<I> {
    /// Those of the class `first` and of more urgent ones.
    heap: BinaryHeap<Entry<I>>,
    first: Class,
    /// The others, in no order.
    classes: BTreeMap<Class, Vec<Entry<I>>>,
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

/// Urgencies that differ by some percent at most; greater for greater ones.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Class(u64);

impl Class {
    const MOST_URGENT: Self = Self(u64::MAX);

    /// That of an urgency, by the order of [`f64::total_cmp`]: its sign, its exponent and four binary digits.
    fn of(urgency: f64) -> Self {
        const REST: u32 = f64::MANTISSA_DIGITS - 1 - 4;
        let bits = urgency.to_bits();
        let ordered = match urgency.is_sign_negative() {
            true => !bits,
            false => bits | 1 << 63,
        };
        Self(ordered >> REST)
    }
}

impl<I: Copy + Ord> Worklist<I> {
    pub(crate) const fn new() -> Self {
        Self {
            heap: BinaryHeap::new(),
            first: Class::MOST_URGENT,
            classes: BTreeMap::new(),
            parked: Vec::new(),
        }
    }

    pub(crate) fn push(&mut self, entry: Entry<I>) {
        let class = Class::of(entry.urgency);
        if class >= self.first {
            self.heap.push(entry);
        } else {
            self.classes.entry(class).or_default().push(entry);
        }
    }

    /// The most urgent element that is still there; `stamp` gives the stamps of now.
    pub(crate) fn next(&mut self, stamp: impl Fn(I) -> Stamp) -> Option<I> {
        let is_there = |entry: &Entry<I>| stamp(entry.id) == entry.stamp;
        loop {
            while let Some(entry) = self.heap.pop() {
                if is_there(&entry) {
                    return Some(entry.id);
                }
            }
            let (class, mut entries) = self.classes.pop_last()?;
            entries.retain(is_there);
            self.heap = entries.into();
            self.first = class;
        }
    }

    /// Puts an element aside until [`resume`](Self::resume).
    pub(crate) fn park(&mut self, entry: Entry<I>) {
        self.parked.push(entry);
    }

    /// Takes the parked elements up again that are still there.
    pub(crate) fn resume(&mut self, stamp: impl Fn(I) -> Stamp) {
        for entry in std::mem::take(&mut self.parked) {
            if stamp(entry.id) == entry.stamp {
                self.push(entry);
            }
        }
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

#[cfg(test)]
mod tests {
    use super::*;
    use delaunay_core::FaceId;
    use proptest::prelude::*;

    fn urgency() -> impl Strategy<Value = f64> {
        prop_oneof![
            0.9..1.2,
            -1e3..1e3,
            Just(0.0),
            Just(-0.0),
            Just(f64::INFINITY),
            any::<f64>()
        ]
    }

    proptest! {
        #[test]
        fn classes_are_in_the_order_of_urgencies(a in urgency(), b in urgency()) {
            let order = a.total_cmp(&b);
            prop_assert!(Class::of(a).cmp(&Class::of(b)) == order || Class::of(a) == Class::of(b));
        }

        #[test]
        fn elements_come_by_urgency_with_pushes_in_between(
            batches in prop::collection::vec(prop::collection::vec(urgency(), 0..9), 0..9),
        ) {
            let mut stamp = Stamp::NONE;
            let stamp = stamp.advance();
            let mut list = Worklist::new();
            let mut sorted = Vec::new();
            for batch in batches {
                for urgency in batch {
                    let id = FaceId::new(sorted.len() % 7);
                    let entry = Entry { urgency, id, stamp };
                    list.push(entry);
                    sorted.push(entry);
                }
                sorted.sort_unstable();
                for _ in 0..3 {
                    prop_assert_eq!(list.next(|_| stamp), sorted.pop().map(|entry| entry.id));
                }
            }
        }

        #[test]
        fn elements_that_are_gone_or_parked_do_not_come(urgencies in prop::collection::vec(urgency(), 1..40)) {
            let mut last = Stamp::NONE;
            let [old, new] = [last.advance(), last.advance()];
            let mut list = Worklist::new();
            for (k, &urgency) in urgencies.iter().enumerate() {
                let stamp = if k % 2 == 0 { new } else { old };
                list.push(Entry { urgency, id: FaceId::new(k), stamp });
                list.park(Entry { urgency, id: FaceId::new(k), stamp });
            }
            for _ in 0..2 {
                let mut came: Vec<usize> = std::iter::from_fn(|| list.next(|_| new)).map(FaceId::index).collect();
                came.sort_unstable();
                prop_assert!(came.iter().copied().eq((0..urgencies.len()).step_by(2)));
                list.resume(|_| new);
            }
        }
    }
}
