//! Sides as curves between vertices: one curve for two sides that meet without a shift, one for every other side.

use std::collections::BTreeMap;

use super::vertices::Vertices;
use crate::blocks::{BlockSide, Connection, StructuredBlock, StructuredBlocks};

/// How far, in lengths of the curve, a node may be from where an even division puts it.
const EVEN: f64 = 1e-12;

/// The curves as sides of blocks, each by the first side that runs along it.
pub(super) fn curves(blocks: &StructuredBlocks) -> impl Iterator<Item = (usize, BlockSide)> + '_ {
    let sides = (0..blocks.blocks.len()).flat_map(|block| BlockSide::ALL.map(|side| (block, side)));
    sides.filter(
        |&(block, side)| match *blocks.blocks[block].connection(side) {
            Connection::Block {
                block: other,
                side: other_side,
                shift: [0.0, 0.0, 0.0],
                ..
            } => (block, side) < (other, other_side),
            _ => true,
        },
    )
}

/// Curves that end where they start, or where another curve between the same vertices is.
pub(super) fn ambiguous(blocks: &StructuredBlocks, vertices: &Vertices) -> Vec<(usize, BlockSide)> {
    let mut by_ends = BTreeMap::<[usize; 2], Vec<(usize, BlockSide)>>::new();
    for (block, side) in curves(blocks) {
        let mut ends = vertices.ends(block, side);
        ends.sort_unstable();
        by_ends.entry(ends).or_default().push((block, side));
    }
    let ambiguous = by_ends
        .into_iter()
        .filter(|([from, to], curves)| from == to || curves.len() > 1);
    ambiguous.flat_map(|(_, curves)| curves).collect()
}

/// The nodes between the ends of a curve; none when they divide a straight line evenly, which needs no description.
pub(super) fn inner_nodes(block: &StructuredBlock, side: BlockSide) -> Vec<[f64; 3]> {
    let nodes: Vec<[f64; 3]> = block
        .nodes_along(side)
        .map(|node| block.points[node])
        .collect();
    let [from, inner @ .., to] = nodes.as_slice() else {
        return Vec::new();
    };
    let steps = (inner.len() + 1) as f64;
    let length = (to[0] - from[0]).hypot(to[1] - from[1]);
    let evenly = (1..).zip(inner).all(|(k, node): (u32, _)| {
        let along = f64::from(k) / steps;
        let even = [0, 1].map(|axis| from[axis] + (to[axis] - from[axis]) * along);
        (node[0] - even[0]).hypot(node[1] - even[1]) <= EVEN * length
    });
    if evenly { Vec::new() } else { inner.to_vec() }
}
