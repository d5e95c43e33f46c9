//! A block: four curves round a quadrilateral piece of domain between a medial arc and a wall, and
//! its neighbours (§3).
//!
//! ```text
//!            ξ1: wall
//!        +--------------+
//!        |              |          ξ grows from the medial arc to the wall, η along the arc,
//!   η0 : |              | : η1     so that (ξ, η) is right-handed
//!        |              |
//!        +--------------+
//!            ξ0: medial arc
//! ```
//!
//! A block lies where its hole is at home, so the blocks round one hole meet along their η-curves
//! without a shift and only ξ0 can cross into another period.

use std::fmt;

use crate::medial_graph::{ArcEnd, ArcId, MedialArc};
use crate::wall::{Shift, WallId};

/// A block, numbered by its arc: blocks `2 a` and `2 a + 1` lie to the right and to the left of arc
/// `a`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct BlockId(pub(crate) u32);

impl BlockId {
    /// Position in [`crate::Blocking::blocks`].
    #[must_use]
    pub const fn index(self) -> usize {
        self.0 as usize
    }
}

impl ArcId {
    /// The block to the right of the arc, with C1 as its wall.
    #[must_use]
    pub const fn right_block(self) -> BlockId {
        BlockId(2 * self.0)
    }

    /// The block to the left of the arc, with C2 as its wall.
    #[must_use]
    pub const fn left_block(self) -> BlockId {
        BlockId(2 * self.0 + 1)
    }
}

impl fmt::Display for BlockId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "b{}", self.0)
    }
}

/// One of the four bounding curves of a block.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BlockSide {
    /// ξ = 0: the medial arc.
    Xi0,
    /// ξ = 1: the wall.
    Xi1,
    /// η = 0: the straight line from a medial vertex to its touching point.
    Eta0,
    /// η = 1: the same at the other end of the arc.
    Eta1,
}

/// On which side of its medial arc a block lies, travelling from the arc's start to its end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ArcSide {
    /// On the right, with the curve C1 as its wall; η runs with the arc.
    Right,
    /// On the left, with C2; η runs against the arc.
    Left,
}

/// A corner of a block at a medial vertex: the vertex, the periods that move it to the block, and
/// which of its touches is on the block's wall.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BlockCorner {
    /// The medial vertex.
    pub vertex: crate::MedialVertexId,
    /// The periods that move the vertex to the block.
    pub shift: Shift,
    /// Index into the vertex's touches.
    pub touch: u8,
}

impl BlockCorner {
    /// The vertex and touch alone: what two blocks round the same wall share.
    pub(crate) const fn ray(&self) -> (usize, u8) {
        (self.vertex.index(), self.touch)
    }
}

/// The three blocks with which a block exchanges values; ξ1 is wall.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Neighbours {
    /// Across the medial arc: the block and the periods that move this block's arc onto that
    /// block's.
    ///
    /// The shared curve runs in opposite directions of η.
    pub xi0: (BlockId, Shift),
    /// Across η0, round the same wall; it is that block's η1.
    pub eta0: BlockId,
    /// Across η1; it is that block's η0.
    pub eta1: BlockId,
}

/// A block of the blocking scheme.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Block {
    /// The medial arc at ξ0.
    pub arc: ArcId,
    /// On which side of the arc.
    pub side: ArcSide,
    /// The wall at ξ1, at home.
    pub wall: WallId,
    /// The corner at (ξ, η) = (0, 0).
    pub start: BlockCorner,
    /// The corner at (ξ, η) = (0, 1).
    pub end: BlockCorner,
    /// The periods that move the arc's frame to the block.
    pub arc_shift: Shift,
    /// The blocks across ξ0, η0 and η1.
    pub neighbours: Neighbours,
}

/// The blocks on both sides of every arc, with their neighbours.
pub(crate) fn blocks_of(arcs: &[MedialArc]) -> Vec<Block> {
    let mut blocks: Vec<Block> = arcs
        .iter()
        .enumerate()
        .flat_map(|(a, arc)| {
            [ArcSide::Right, ArcSide::Left].map(|side| lone_block(ArcId(a as u32), arc, side))
        })
        .collect();
    link_round_walls(&mut blocks);
    blocks
}

/// The block on one side of an arc; its neighbours along η are still itself.
fn lone_block(id: ArcId, arc: &MedialArc, side: ArcSide) -> Block {
    let (own, mate, image, across) = match side {
        ArcSide::Right => (id.right_block(), id.left_block(), arc.right, arc.left),
        ArcSide::Left => (id.left_block(), id.right_block(), arc.left, arc.right),
    };
    let arc_shift = -image.shift;
    let corner = |end: &ArcEnd| BlockCorner {
        vertex: end.vertex,
        shift: end.shift + arc_shift,
        touch: if side == ArcSide::Right {
            end.right
        } else {
            end.left
        },
    };
    let (start, end) = match side {
        ArcSide::Right => (corner(&arc.start), corner(&arc.end)),
        ArcSide::Left => (corner(&arc.end), corner(&arc.start)),
    };
    let neighbours = Neighbours {
        xi0: (mate, image.shift - across.shift),
        eta0: own,
        eta1: own,
    };
    Block {
        arc: id,
        side,
        wall: image.wall,
        start,
        end,
        arc_shift,
        neighbours,
    }
}

/// Glues blocks along their η-curves: one block ends and one starts on every ray from a medial
/// vertex to a wall.
fn link_round_walls(blocks: &mut [Block]) {
    let mut ends: Vec<((usize, u8), usize)> = blocks
        .iter()
        .enumerate()
        .map(|(b, block)| (block.end.ray(), b))
        .collect();
    let mut starts: Vec<((usize, u8), usize)> = blocks
        .iter()
        .enumerate()
        .map(|(b, block)| (block.start.ray(), b))
        .collect();
    ends.sort_unstable();
    starts.sort_unstable();
    for (&(_, before), &(_, after)) in ends.iter().zip(&starts) {
        blocks[before].neighbours.eta1 = BlockId(after as u32);
        blocks[after].neighbours.eta0 = BlockId(before as u32);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Blocking;
    use crate::example_domains::{one_hole, three_holes, two_periodic_holes};

    #[test]
    fn following_eta1_round_a_wall_visits_all_its_blocks_and_comes_back() {
        for domain in [one_hole(), three_holes(), two_periodic_holes()] {
            let blocking = Blocking::of(&domain).unwrap();
            for first in blocking.block_ids() {
                let wall = blocking.block(first).wall;
                let blocks = blocking.blocks().iter();
                let count = blocks.filter(|block| block.wall == wall).count();
                let mut at = first;
                for step in 0..count {
                    assert!(step == 0 || at != first, "{wall:?} has two rings of blocks");
                    at = blocking.block(at).neighbours.eta1;
                }
                assert_eq!(at, first);
            }
        }
    }

    #[test]
    fn neighbours_share_the_whole_of_their_curves() {
        for domain in [one_hole(), three_holes(), two_periodic_holes()] {
            let blocking = Blocking::of(&domain).unwrap();
            for block in blocking.blocks() {
                let (mate, shift) = block.neighbours.xi0;
                let mate = blocking.block(mate);
                let at = |corner: BlockCorner| (corner.vertex, corner.shift);
                let moved = |corner: BlockCorner| (corner.vertex, corner.shift + shift);
                assert_eq!(moved(block.start), at(mate.end));
                assert_eq!(moved(block.end), at(mate.start));
                let next = blocking.block(block.neighbours.eta1);
                assert_eq!(block.end.ray(), next.start.ray());
            }
        }
    }

    #[test]
    fn blocks_are_numbered_by_their_arcs() {
        let blocking = Blocking::of(&three_holes()).unwrap();
        for arc in blocking.arc_ids() {
            let (right, left) = (arc.right_block(), arc.left_block());
            assert_eq!(
                (right.index(), left.index()),
                (2 * arc.index(), 2 * arc.index() + 1)
            );
            assert_eq!(blocking.block(right).side, ArcSide::Right);
            assert_eq!(blocking.block(left).side, ArcSide::Left);
        }
        assert_eq!(ArcId(3).left_block().to_string(), "b7");
    }
}
