//! Tetrahedra that are to be improved, the worst first.

use crate::records::{Moment, Records};
use delaunay_core::{Complex3, TetId};
use std::cmp::{Ordering, Reverse};
use std::collections::BinaryHeap;

/// A queue of tetrahedra, some of which may be gone when their turn comes.
#[derive(Clone, Debug, Default)]
pub(crate) struct Worklist {
    heap: BinaryHeap<Reverse<Entry>>,
    /// Tetrahedra that nothing could be done for.
    parked: Vec<Entry>,
}

/// A tetrahedron that waits, worst and then smallest id first.
#[derive(Clone, Copy, Debug)]
struct Entry {
    quality: f64,
    tet: TetId,
    made: Moment,
    /// When nothing could be done for it last.
    since: Moment,
}

impl Worklist {
    /// Lists a tetrahedron.
    pub(crate) fn push(&mut self, records: &Records, tet: TetId) {
        self.heap.push(Reverse(Entry {
            quality: records.quality(tet),
            tet,
            made: records.made(tet),
            since: Moment::NEVER,
        }));
    }

    /// The worst tetrahedron that is still as it was listed, and when nothing could be done for it last.
    pub(crate) fn next(&mut self, records: &Records) -> Option<(TetId, Moment)> {
        loop {
            let Reverse(Entry {
                tet, made, since, ..
            }) = self.heap.pop()?;
            if records.made(tet) == made {
                return Some((tet, since));
            }
        }
    }

    /// Puts a tetrahedron aside that nothing could be done for.
    pub(crate) fn park(&mut self, records: &Records, tet: TetId) {
        let (quality, made) = (records.quality(tet), records.made(tet));
        let since = records.now();
        self.parked.push(Entry {
            quality,
            tet,
            made,
            since,
        });
    }

    /// Lists the tetrahedra again that were put aside, as far as they are still there and something has changed round them
    /// since; tells whether there are any.
    pub(crate) fn resume(&mut self, complex: &Complex3, records: &Records) -> bool {
        self.parked
            .retain(|entry| records.made(entry.tet) == entry.made);
        let news = |entry: &mut Entry| {
            let corners = complex.mesh().tet_vertices(entry.tet);
            corners.into_iter().any(|v| records.is_news(v, entry.since))
        };
        let resumed = self.parked.extract_if(.., news);
        self.heap.extend(resumed.map(Reverse));
        !self.heap.is_empty()
    }

    /// The tetrahedra put aside, worst first, with the moments when they were made: some may be gone.
    pub(crate) fn parked(&self) -> Vec<(TetId, Moment)> {
        let mut parked = self.parked.clone();
        parked.sort_unstable();
        let parked = parked.into_iter();
        parked.map(|entry| (entry.tet, entry.made)).collect()
    }
}

impl Ord for Entry {
    fn cmp(&self, other: &Self) -> Ordering {
        let qualities = self.quality.total_cmp(&other.quality);
        qualities
            .then(self.tet.cmp(&other.tet))
            .then(self.made.cmp(&other.made))
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
    use crate::sample::cube;

    #[test]
    fn the_worst_comes_first_and_what_was_put_aside_comes_again_after_news() {
        let complex = cube(3, 1);
        let mut records = Records::of(&complex);
        let mut worklist = Worklist::default();
        let tets: Vec<TetId> = complex.tets().collect();
        for &t in &tets {
            worklist.push(&records, t);
        }
        let mut qualities = Vec::new();
        while let Some((t, since)) = worklist.next(&records) {
            assert_eq!(since, Moment::NEVER);
            qualities.push(records.quality(t));
            worklist.park(&records, t);
        }
        assert!(qualities.len() == tets.len() && qualities.is_sorted());
        assert!(!worklist.resume(&complex, &records));
        let parked = worklist.parked();
        assert!(
            parked
                .iter()
                .map(|&(t, _)| records.quality(t))
                .eq(qualities)
        );

        // Its neighbours at corners hear of a tetrahedron that changes; as it was it does not come again.
        let (changed, then) = (tets[0], records.now());
        records.note_change(&complex, &[], &[changed]);
        assert!(worklist.resume(&complex, &records));
        let corners = complex.mesh().tet_vertices(changed);
        let mut resumed = 0;
        while let Some((t, since)) = worklist.next(&records) {
            assert!(since == then && t != changed);
            assert!(
                complex
                    .mesh()
                    .tet_vertices(t)
                    .iter()
                    .any(|v| corners.contains(v))
            );
            resumed += 1;
        }
        assert!(resumed > 10, "{resumed}");
    }
}
