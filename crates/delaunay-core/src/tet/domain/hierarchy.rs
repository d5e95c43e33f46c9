//! A tree of boxes: which of many boxes a box meets, without a look at most of them.
//!
//! ```text
//!    +---------------+     Boxes are parted into two halves by their middles, along the axis on which those are spread most,
//!    | +--+  +-----+ |     and so on until few are left. Nodes stand in one array, each in front of all that is below it,
//!    | |  |  | +-+ | |     and know where that ends: a walk goes to the next node or past the end, and
//!    | +--+  +-+-+-+ |     needs no stack.
//!    +---------------+
//! ```

use crate::tet::bounds::Bounds;
use std::ops::Range;

/// Most boxes at a leaf.
const LEAF: usize = 4;

/// A tree of numbered boxes.
pub(super) struct Hierarchy {
    nodes: Vec<Node>,
    /// The boxes with their numbers, leaf by leaf.
    boxes: Vec<(Bounds, u32)>,
}

struct Node {
    bounds: Bounds,
    /// The first node that is not below this one.
    end: u32,
    /// The boxes of a leaf; none at other nodes.
    first: u32,
    last: u32,
}

impl Hierarchy {
    /// A tree of these boxes, whose corners are finite, in time n log n. The same for the same boxes in the same order.
    pub(super) fn of(boxes: Vec<(Bounds, u32)>) -> Self {
        let mut tree = Self {
            nodes: Vec::with_capacity(boxes.len()),
            boxes,
        };
        if !tree.boxes.is_empty() {
            tree.grow(0..tree.boxes.len());
        }
        tree
    }

    /// Adds the node of some of the boxes, and all below it. Ranges are halved, so the depth is logarithmic.
    fn grow(&mut self, range: Range<usize>) {
        let boxes = &mut self.boxes[range.clone()];
        let bounds = boxes.iter().fold(Bounds::NOTHING, |all, b| all.with(b.0));
        let index = self.nodes.len();
        let is_leaf = boxes.len() <= LEAF;
        self.nodes.push(Node {
            bounds,
            end: 0,
            first: range.start as u32,
            last: if is_leaf { range.end } else { range.start } as u32,
        });
        if !is_leaf {
            let middles = Bounds::of(boxes.iter().map(|(bounds, _)| bounds.middle()));
            let axis = middles.size().max_position();
            let half = boxes.len() / 2;
            boxes.select_nth_unstable_by(half, |(a, i), (b, j)| {
                let [a, b] = [a, b].map(|bounds| bounds.middle()[axis]);
                // Many boxes can have the same middle; their numbers differ.
                a.total_cmp(&b).then(i.cmp(j))
            });
            let middle = range.start + half;
            self.grow(range.start..middle);
            self.grow(middle..range.end);
        }
        self.nodes[index].end = self.nodes.len() as u32;
    }

    /// Tells `found` the number of every box that meets `bounds`, in no particular order, each once.
    pub(super) fn meeting(&self, bounds: Bounds, mut found: impl FnMut(usize)) {
        let mut next = 0;
        while let Some(node) = self.nodes.get(next) {
            if !node.bounds.meets(bounds) {
                next = node.end as usize;
                continue;
            }
            let here = &self.boxes[node.first as usize..node.last as usize];
            for (other, number) in here {
                if other.meets(bounds) {
                    found(*number as usize);
                }
            }
            next += 1;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn a_walk_finds_the_boxes_that_meet(
            boxes in prop::collection::vec((prop::array::uniform3(0_u8..9), prop::array::uniform3(0_u8..4)), 0..60),
        ) {
            let bounds = |(low, size): &([u8; 3], [u8; 3])| {
                let low = DVec3::from(low.map(f64::from));
                Bounds::of([low, low + DVec3::from(size.map(f64::from))])
            };
            let boxes: Vec<Bounds> = boxes.iter().map(bounds).collect();
            let tree = Hierarchy::of(boxes.iter().copied().zip(0..).collect());
            for &one in &boxes {
                let mut found = Vec::new();
                tree.meeting(one, |number| found.push(number));
                found.sort_unstable();
                let all = 0..boxes.len();
                let expected: Vec<usize> = all.filter(|&i| boxes[i].meets(one)).collect();
                prop_assert_eq!(found, expected);
            }
        }
    }
}
