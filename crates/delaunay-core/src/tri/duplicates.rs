//! Input points that repeat another one: kept as ids, mapped to the vertex that stands for them.

use crate::ids::VertexId;

/// Which input points have the coordinates of an earlier one, and of which.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Duplicates {
    /// (duplicate, representative), by duplicate.
    pairs: Vec<(VertexId, VertexId)>,
}

impl Duplicates {
    pub(super) fn from_pairs(mut pairs: Vec<(VertexId, VertexId)>) -> Self {
        pairs.sort_unstable();
        Self { pairs }
    }

    /// The vertex that stands for the duplicate `v`: the smallest id at its place.
    ///
    /// `None` when `v` is no duplicate. Takes log n time.
    #[must_use]
    pub fn representative(&self, v: VertexId) -> Option<VertexId> {
        let found = self
            .pairs
            .binary_search_by_key(&v, |&(duplicate, _)| duplicate);
        found.ok().map(|place| self.pairs[place].1)
    }

    /// Pairs (duplicate, representative), by duplicate.
    #[must_use]
    pub fn iter(&self) -> impl ExactSizeIterator<Item = (VertexId, VertexId)> + Clone + '_ {
        self.pairs.iter().copied()
    }

    /// The number of duplicates; representatives do not count.
    #[must_use]
    pub fn len(&self) -> usize {
        self.pairs.len()
    }

    /// Whether all points are distinct.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.pairs.is_empty()
    }

    pub(super) fn forget(&mut self, representative: VertexId) {
        self.pairs.retain(|&(_, vertex)| vertex != representative);
    }
}
