//! Pairs of boxes that overlap, found in a tree of boxes.
//!
//! ```text
//!          whole               Halves by the middle along the longest side, down to a few boxes. Two nodes whose boxes are apart
//!         /     \              have no pair; of two that are not, the larger is taken apart.
//!      left     right
//!      /  \     /   \
//! ```

use glam::DVec3;
use std::ops::Range;

/// A box with sides along the axes; closed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extent {
    /// Least coordinates.
    pub low: DVec3,
    /// Greatest coordinates.
    pub high: DVec3,
}

/// Boxes that a leaf has at most.
const FEW: usize = 4;

struct Node {
    extent: Extent,
    /// Where its boxes are in the order of the tree.
    range: Range<usize>,
    halves: Option<[usize; 2]>,
}

struct Tree<'b> {
    boxes: &'b [Extent],
    order: Vec<usize>,
    nodes: Vec<Node>,
}

/// The first pair of different boxes that overlap and meet as asked, by index; always the same for the same boxes.
///
/// n log n, and the number of pairs that overlap.
pub fn find(
    boxes: &[Extent],
    mut is_meeting: impl FnMut([usize; 2]) -> bool,
) -> Option<[usize; 2]> {
    let mut tree = Tree {
        boxes,
        order: (0..boxes.len()).collect(),
        nodes: Vec::new(),
    };
    if boxes.is_empty() {
        return None;
    }
    let root = tree.grow(0..boxes.len());
    let mut left = vec![[root; 2]];
    while let Some(pair) = left.pop() {
        match tree.parts(pair) {
            Some(parts) => left.extend(parts),
            None => {
                if let Some(found) = tree.find_between(pair, &mut is_meeting) {
                    return Some(found);
                }
            }
        }
    }
    None
}

impl Extent {
    /// The least box round points.
    #[must_use]
    pub fn of(points: &[DVec3]) -> Self {
        let start = Self {
            low: DVec3::INFINITY,
            high: DVec3::NEG_INFINITY,
        };
        points.iter().fold(start, |extent, &p| Self {
            low: extent.low.min(p),
            high: extent.high.max(p),
        })
    }

    fn with(self, other: Self) -> Self {
        Self {
            low: self.low.min(other.low),
            high: self.high.max(other.high),
        }
    }

    /// Whether the two have a point in common.
    #[must_use]
    pub fn overlaps(&self, other: &Self) -> bool {
        self.low.cmple(other.high).all() && other.low.cmple(self.high).all()
    }
}

impl Tree<'_> {
    /// The node of a range; halves are halves of it, so that depth is the logarithm.
    fn grow(&mut self, range: Range<usize>) -> usize {
        let boxes = self.boxes;
        let members = &mut self.order[range.clone()];
        let extents = members.iter().map(|&index| boxes[index]);
        let extent = extents.reduce(Extent::with).unwrap_or(Extent::of(&[]));
        let mut halves = None;
        if range.len() > FEW {
            let middle = range.len() / 2;
            let axis = (extent.high - extent.low).max_position();
            let centre = |index: usize| boxes[index].low[axis] + boxes[index].high[axis];
            members.select_nth_unstable_by(middle, |&a, &b| {
                centre(a).total_cmp(&centre(b)).then(a.cmp(&b))
            });
            let cut = range.start + middle;
            halves = Some([range.start..cut, cut..range.end].map(|half| self.grow(half)));
        }
        self.nodes.push(Node {
            extent,
            range,
            halves,
        });
        self.nodes.len() - 1
    }

    /// The pairs of nodes that a pair is made of; `None` for two leaves.
    fn parts(&self, [a, b]: [usize; 2]) -> Option<Vec<[usize; 2]>> {
        let [first, second] = [&self.nodes[a], &self.nodes[b]];
        if !first.extent.overlaps(&second.extent) {
            return Some(Vec::new());
        }
        let is_first_larger = first.range.len() >= second.range.len();
        match (first.halves, second.halves) {
            (None, None) => None,
            (Some([left, right]), _) if a == b => Some(vec![[left; 2], [right; 2], [left, right]]),
            (None, Some(halves)) => Some(halves.map(|half| [a, half]).to_vec()),
            (Some(_), Some(halves)) if !is_first_larger => {
                Some(halves.map(|half| [a, half]).to_vec())
            }
            (Some(halves), _) => Some(halves.map(|half| [half, b]).to_vec()),
        }
    }

    fn find_between(
        &self,
        [a, b]: [usize; 2],
        is_meeting: &mut impl FnMut([usize; 2]) -> bool,
    ) -> Option<[usize; 2]> {
        for slot in self.nodes[a].range.clone() {
            for other in self.nodes[b].range.clone() {
                if a == b && other <= slot {
                    continue;
                }
                let pair = [self.order[slot], self.order[other]];
                let [first, second] = pair.map(|index| &self.boxes[index]);
                if first.overlaps(second) && is_meeting(pair) {
                    return Some(pair);
                }
            }
        }
        None
    }
}

#[cfg(test)]
mod tests {
    use super::super::random;
    use super::*;
    use rand::RngExt;

    #[test]
    fn every_pair_that_overlaps_is_met_once() {
        let mut random = random(1);
        let boxes: Vec<Extent> = (0..300)
            .map(|_| {
                let mut corner = || {
                    let mut draw = || f64::from(random.random_range(0..12_i32));
                    DVec3::new(draw(), draw(), draw() * 0.1)
                };
                let low = corner();
                Extent {
                    low,
                    high: low + corner() * 0.3,
                }
            })
            .collect();
        let mut met = Vec::new();
        assert_eq!(
            find(&boxes, |[a, b]| {
                met.push([a.min(b), a.max(b)]);
                false
            }),
            None
        );
        met.sort_unstable();
        let mut all = Vec::new();
        for a in 0..boxes.len() {
            let others = (a + 1..boxes.len()).filter(|&b| boxes[a].overlaps(&boxes[b]));
            all.extend(others.map(|b| [a, b]));
        }
        assert!(all.len() > 500);
        assert_eq!(met, all);
        assert!(find(&boxes, |_| true).is_some());
    }
}
