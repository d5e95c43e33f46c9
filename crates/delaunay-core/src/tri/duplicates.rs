//! Input points that repeat another one: kept as ids, mapped to the vertex that stands for them.

use crate::ids::VertexId;

/// Which input points have the coordinates of an earlier one, and of which.
#[derive(Clone, Debug, Default)]
pub struct Duplicates {
    /// (duplicate, representative), by duplicate; the ghost stands for representatives that are gone.
    pairs: Vec<(VertexId, VertexId)>,
    /// (representative, duplicate), by representative, those that are gone included.
    groups: Vec<(VertexId, VertexId)>,
    len: usize,
}

impl Duplicates {
    pub(crate) fn from_pairs(mut pairs: Vec<(VertexId, VertexId)>) -> Self {
        pairs.sort_unstable();
        let mut groups: Vec<_> = pairs.iter().map(|&(v, of)| (of, v)).collect();
        groups.sort_unstable();
        let len = pairs.len();
        Self { pairs, groups, len }
    }

    /// The vertex that stands for the duplicate `v`: the smallest id at its place.
    ///
    /// `None` when `v` is no duplicate. Takes log n time.
    #[must_use]
    pub fn representative(&self, v: VertexId) -> Option<VertexId> {
        let vertex = self.pairs[self.place(v)?].1;
        (!vertex.is_ghost()).then_some(vertex)
    }

    /// Pairs (duplicate, representative), by duplicate.
    pub fn iter(&self) -> impl Iterator<Item = (VertexId, VertexId)> + Clone + '_ {
        self.pairs
            .iter()
            .copied()
            .filter(|(_, vertex)| !vertex.is_ghost())
    }

    /// The number of duplicates; representatives do not count.
    #[must_use]
    pub fn len(&self) -> usize {
        self.len
    }

    /// Whether all points are distinct.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len == 0
    }

    /// Forgets the duplicates of `vertex`, in time log n for each.
    pub(crate) fn forget(&mut self, vertex: VertexId) {
        let first = self.groups.partition_point(|&(of, _)| of < vertex);
        for group in first..self.groups.len() {
            let (of, duplicate) = self.groups[group];
            // A vertex that took the id of a removed one has no duplicates: the pairs are gone.
            match self.place(duplicate) {
                Some(place) if of == vertex && self.pairs[place].1 == vertex => {
                    self.pairs[place].1 = VertexId::GHOST;
                    self.len -= 1;
                }
                _ => return,
            }
        }
    }

    /// Where the pair of the duplicate `v` is.
    fn place(&self, v: VertexId) -> Option<usize> {
        self.pairs
            .binary_search_by_key(&v, |&(duplicate, _)| duplicate)
            .ok()
    }
}

impl PartialEq for Duplicates {
    fn eq(&self, other: &Self) -> bool {
        self.iter().eq(other.iter())
    }
}

impl Eq for Duplicates {}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_vertex_is_forgotten_with_its_own_duplicates_only() {
        let [a, b, c, d, e] = [0, 1, 2, 3, 4].map(VertexId::new);
        let mut duplicates = Duplicates::from_pairs(vec![(e, a), (c, b), (d, a)]);
        duplicates.forget(a);
        duplicates.forget(a);
        duplicates.forget(c);
        assert_eq!(
            [c, d, e].map(|v| duplicates.representative(v)),
            [Some(b), None, None]
        );
        assert_eq!((duplicates.len(), duplicates.is_empty()), (1, false));
        assert_eq!(duplicates, Duplicates::from_pairs(vec![(c, b)]));
    }
}
