//! Where a walk without a hint starts: at a vertex of a sparse sample that is near the point.
//!
//! One in sixteen vertices is a leaf of a balanced tree, each inner node of which cuts the box of its leaves across
//! the longest side at the median (Bentley 1975, *Multidimensional binary search trees*). A search
//! goes straight down without looking back: the leaf that it ends at is seldom the nearest one but always
//! a near one, and the walk, which is exact, does the rest in a few steps. Unlike a sample that is looked
//! through from end to end it follows clusters of any density.
//!
//! The tree is made when it is first asked for. Changes of the triangulation leave it as it is, since a start
//! that is a little off costs a few steps, until there have been so many that it is made anew.

use crate::ids::VertexId;
use crate::order::{Spatial, scramble};
use std::sync::OnceLock;

/// Vertices for each leaf: a small tree stays in the cache, a large one makes short walks.
const VERTICES_PER_LEAF: usize = 16;

/// A tree of starts, and what has happened since it was made.
#[derive(Clone, Debug, Default)]
pub(crate) struct Guide {
    tree: OnceLock<Tree>,
    changes: usize,
}

impl Guide {
    /// Takes note that a vertex has come, gone or moved.
    pub(crate) fn note_change(&mut self) {
        match self.tree.get() {
            Some(tree) if self.changes < tree.lifetime() => self.changes += 1,
            _ => *self = Self::default(),
        }
    }

    /// A vertex near `p` for which `lives` holds, if one is found.
    ///
    /// `points` are the places of all vertices by slot, the ghost in front. Takes log n time, unless all leaves near
    /// `p` are gone and few others are left, but for the first call and the first one after many
    /// changes, which take n log n.
    pub(crate) fn near<P: Spatial>(
        &self,
        p: P,
        points: &[P],
        lives: impl Fn(VertexId) -> bool,
    ) -> Option<VertexId> {
        let tree = self.tree.get_or_init(|| Tree::over(points, &lives));
        tree.leaves_round(tree.leaf_of(p)).find(|&v| lives(v))
    }
}

/// A balanced tree in which the node of the leaves `low..high` is the middle of that range.
#[derive(Clone, Debug)]
struct Tree {
    /// Vertex slots when it was made.
    slots: usize,
    leaves: Vec<VertexId>,
    /// By its middle, where the node of a range cuts. The first one is not used.
    cuts: Vec<Cut>,
}

#[derive(Clone, Copy, Debug)]
struct Cut {
    /// Leaves on the lower side are not above this coordinate, those on the upper side not below.
    at: f64,
    axis: usize,
}

impl Tree {
    fn over<P: Spatial>(points: &[P], lives: impl Fn(VertexId) -> bool) -> Self {
        // Drawn by lot, so that no pattern in the numbering shows in the sample.
        let drawn = |slot: &usize| scramble(*slot as u64).is_multiple_of(VERTICES_PER_LEAF as u64);
        let vertices = (1..points.len()).filter(drawn).map(VertexId::from_slot);
        let sample = vertices.filter(|&v| lives(v));
        let mut leaves: Vec<VertexId> = sample.collect();
        let mut cuts = vec![Cut { at: 0.0, axis: 0 }; leaves.len()];
        cut(&mut leaves, &mut cuts, points);
        Self {
            slots: points.len(),
            leaves,
            cuts,
        }
    }

    /// After how many changes the tree is too old: as many as pay for looking at all slots again.
    fn lifetime(&self) -> usize {
        self.slots / VERTICES_PER_LEAF + VERTICES_PER_LEAF
    }

    /// The leaf whose box contains `p`.
    fn leaf_of<P: Spatial>(&self, p: P) -> usize {
        let (mut low, mut high) = (0, self.leaves.len());
        while high - low > 1 {
            let middle = low.midpoint(high);
            let Cut { at, axis } = self.cuts[middle];
            let below = p[axis] < at;
            (low, high) = if below { (low, middle) } else { (middle, high) };
        }
        low
    }

    /// A leaf and others on both sides, first near ones, then at distances that double, then all.
    fn leaves_round(&self, leaf: usize) -> impl Iterator<Item = VertexId> {
        let distances = (0..usize::BITS).map(|power| 1 << power);
        let both = distances.flat_map(move |d| [leaf.checked_add(d), leaf.checked_sub(d)]);
        let round = [leaf].into_iter().chain(both.flatten());
        let round = round.filter_map(|i| self.leaves.get(i).copied());
        round.chain(self.leaves.iter().copied())
    }
}

/// Sorts leaves into a tree.
fn cut<P: Spatial>(leaves: &mut [VertexId], cuts: &mut [Cut], points: &[P]) {
    if leaves.len() < 2 {
        return;
    }
    let place = |v: &VertexId| points[v.slot()];
    let boxes = leaves.iter().map(|v| [place(v), place(v)]);
    let axis = P::longest_axis(boxes.fold(P::NOWHERE, P::hull));
    let middle = leaves.len() / 2;
    let (_, median, _) = leaves.select_nth_unstable_by(middle, |v, w| {
        let [a, b] = [v, w].map(|v| place(v)[axis]);
        a.total_cmp(&b).then(v.cmp(w))
    });
    let at = place(median)[axis];
    cuts[middle] = Cut { at, axis };
    let (lower, upper) = leaves.split_at_mut(middle);
    let (lower_cuts, upper_cuts) = cuts.split_at_mut(middle);
    cut(lower, lower_cuts, points);
    cut(upper, upper_cuts, points);
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec2;

    /// A ghost and points on a spiral, half of them in a small cluster.
    fn places(count: usize) -> Vec<DVec2> {
        let place = |i: usize| {
            let scale = if i.is_multiple_of(2) { 1.0 } else { 1e-6 };
            DVec2::from_angle(i as f64 * 2.4) * scale * (i as f64 / count as f64).sqrt()
        };
        [DVec2::NAN]
            .into_iter()
            .chain((0..count).map(place))
            .collect()
    }

    fn nearest(points: &[DVec2], p: DVec2) -> f64 {
        let distances = points[1..].iter().map(|q| q.distance(p));
        distances.fold(f64::INFINITY, f64::min)
    }

    #[test]
    fn starts_are_near_in_sparse_and_in_dense_places() {
        let points = places(20_000);
        let guide = Guide::default();
        for (p, reach) in [(DVec2::new(0.3, 0.4), 1.0), (DVec2::new(2e-7, -3e-7), 1e-6)] {
            let start = guide.near(p, &points, |_| true).unwrap();
            // There are 625 leaves in each disk.
            assert!(points[start.slot()].distance(p) < 0.2 * reach + nearest(&points, p));
        }
    }

    #[test]
    fn what_is_gone_is_no_start_and_little_changes_nothing() {
        let points = places(1000);
        let mut guide = Guide::default();
        let first = guide.near(DVec2::ZERO, &points, |_| true).unwrap();
        let second = guide.near(DVec2::ZERO, &points, |v| v != first).unwrap();
        assert_ne!(first, second);
        assert_eq!(guide.near(DVec2::ZERO, &points, |_| false), None);
        guide.note_change();
        assert_eq!(guide.near(DVec2::ZERO, &points, |_| true), Some(first));
    }

    #[test]
    fn a_lone_leaf_is_found_wherever_it_is() {
        let points = places(3000);
        let guide = Guide::default();
        let all = guide
            .tree
            .get_or_init(|| Tree::over(&points, |_| true))
            .leaves
            .clone();
        for last in [0, 1, all.len() / 2, all.len() - 1] {
            let start = guide.near(DVec2::ZERO, &points, |v| v == all[last]);
            assert_eq!(start, Some(all[last]));
        }
    }

    #[test]
    fn many_changes_make_a_new_tree() {
        let few = places(50);
        let mut guide = Guide::default();
        assert!(guide.near(DVec2::ZERO, &few, |_| true).is_some());
        let many = places(5000);
        for _ in 50..5000 {
            guide.note_change();
        }
        let far = DVec2::new(0.9, 0.1);
        let start = guide.near(far, &many, |_| true).unwrap();
        assert!(many[start.slot()].distance(far) < 0.3 && start.slot() > 50);
    }

    #[test]
    fn without_points_there_is_no_start() {
        let guide = Guide::default();
        assert_eq!(guide.near(DVec2::ZERO, &[DVec2::NAN], |_| true), None);
    }
}
