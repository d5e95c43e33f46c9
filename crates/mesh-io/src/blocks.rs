//! Multiblock structured grids of the plane: blocks of nodes and what lies behind each of their sides.

use crate::mesh::{Axis, first_not_finite};

/// Blocks of quads and how they meet.
///
/// The fields are plain; [`StructuredBlocks::check`] names the first that contradicts another.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct StructuredBlocks {
    /// The blocks; connections name them by position.
    pub blocks: Vec<StructuredBlock>,
}

/// A grid of `ni` by `nj` nodes.
///
/// ```text
///        j_max
///   +-----+-----+
///   |     |     |        node (i, j) is points[j * ni + i]
/// i_min   |     i_max
///   |     |     |        sides i_min and i_max run along j,
///   +-----+-----+        sides j_min and j_max along i
///        j_min
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct StructuredBlock {
    /// Name for people and for formats that have one.
    pub name: String,
    /// Nodes along `i`, at least 2.
    pub ni: usize,
    /// Nodes along `j`, at least 2.
    pub nj: usize,
    /// The `ni * nj` nodes, `i` running fastest.
    pub points: Vec<[f64; 3]>,
    /// What lies behind `i_min`, `i_max`, `j_min`, `j_max`.
    pub sides: [Connection; 4],
}

/// A side of a block.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[expect(missing_docs, reason = "the drawing at `StructuredBlock` shows them")]
pub enum BlockSide {
    IMin,
    IMax,
    JMin,
    JMax,
}

impl BlockSide {
    /// The sides in the order of [`StructuredBlock::sides`].
    pub const ALL: [Self; 4] = [Self::IMin, Self::IMax, Self::JMin, Self::JMax];

    /// Position in [`StructuredBlock::sides`].
    #[must_use]
    pub const fn index(self) -> usize {
        match self {
            Self::IMin => 0,
            Self::IMax => 1,
            Self::JMin => 2,
            Self::JMax => 3,
        }
    }

    /// `i_min`, `i_max`, `j_min` or `j_max`.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::IMin => "i_min",
            Self::IMax => "i_max",
            Self::JMin => "j_min",
            Self::JMax => "j_max",
        }
    }
}

impl std::fmt::Display for BlockSide {
    fn fmt(&self, out: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        out.write_str(self.name())
    }
}

/// What lies behind a side of a block.
#[derive(Clone, Debug, PartialEq)]
pub enum Connection {
    /// A whole side of a block, perhaps of the same one.
    Block {
        /// Position of the other block.
        block: usize,
        /// Which of its sides.
        side: BlockSide,
        /// Whether the two sides run in opposite directions: node `k` of this one meets node `n - 1 - k` of the other.
        reversed: bool,
        /// What to add to this side's nodes to reach the other's: zero, or a period.
        shift: [f64; 3],
    },
    /// The boundary of the domain, by name.
    Patch(String),
}

/// The first contradiction in [`StructuredBlocks`].
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum BlocksDefect {
    /// A block is too thin to have a cell.
    #[error("block {block}: {ni} by {nj} nodes, but a block needs at least 2 each way")]
    TooThin {
        /// Position of the block.
        block: usize,
        /// Its nodes along `i`.
        ni: usize,
        /// Its nodes along `j`.
        nj: usize,
    },
    /// A block has another number of points than `ni * nj`.
    #[error("block {block}: {found} points for {ni} by {nj} nodes")]
    PointCount {
        /// Position of the block.
        block: usize,
        /// Its nodes along `i`.
        ni: usize,
        /// Its nodes along `j`.
        nj: usize,
        /// Number of points found.
        found: usize,
    },
    /// A coordinate or a shift is infinite or NaN.
    #[error("block {block}, {place}: {axis} is {value}, which is not a finite number")]
    NotFinite {
        /// Position of the block.
        block: usize,
        /// Which point, or the shift of which side.
        place: String,
        /// Which coordinate.
        axis: Axis,
        /// The offending value.
        value: f64,
    },
    /// A side leads to a block that does not exist.
    #[error("block {block}, side {side}: leads to block {other}, but there are {blocks} blocks")]
    NoSuchBlock {
        /// Position of the block.
        block: usize,
        /// Which of its sides.
        side: BlockSide,
        /// The position it leads to.
        other: usize,
        /// Number of blocks.
        blocks: usize,
    },
    /// Two sides that should be one curve have different node counts.
    #[error(
        "block {block}, side {side}: {count} nodes meet {other_count} nodes of block {other}, side {other_side}"
    )]
    NodeCount {
        /// Position of the block.
        block: usize,
        /// Which of its sides.
        side: BlockSide,
        /// Nodes along it.
        count: usize,
        /// Position of the other block.
        other: usize,
        /// Which of its sides.
        other_side: BlockSide,
        /// Nodes along that.
        other_count: usize,
    },
    /// A side leads to one that does not lead back in the same way.
    #[error(
        "block {block}, side {side}: leads to block {other}, side {other_side}, which does not lead back"
    )]
    NotReciprocal {
        /// Position of the block.
        block: usize,
        /// Which of its sides.
        side: BlockSide,
        /// Position of the other block.
        other: usize,
        /// Which of its sides.
        other_side: BlockSide,
    },
    /// There are more nodes than 32-bit indices.
    #[error("{0} nodes are more than 32-bit indices can name")]
    TooManyNodes(usize),
}

impl StructuredBlock {
    /// What lies behind a side.
    #[must_use]
    pub const fn connection(&self, side: BlockSide) -> &Connection {
        let [i_min, i_max, j_min, j_max] = &self.sides;
        match side {
            BlockSide::IMin => i_min,
            BlockSide::IMax => i_max,
            BlockSide::JMin => j_min,
            BlockSide::JMax => j_max,
        }
    }

    /// Number of nodes along a side.
    #[must_use]
    pub const fn node_count(&self, side: BlockSide) -> usize {
        match side {
            BlockSide::IMin | BlockSide::IMax => self.nj,
            BlockSide::JMin | BlockSide::JMax => self.ni,
        }
    }

    /// Positions in `points` of the nodes along a side, in the direction of growing `j` or `i`.
    #[must_use]
    pub fn nodes_along(&self, side: BlockSide) -> impl ExactSizeIterator<Item = usize> + use<> {
        let (ni, nj) = (self.ni, self.nj);
        let (first, step) = match side {
            BlockSide::IMin => (0, ni),
            BlockSide::IMax => (ni.saturating_sub(1), ni),
            BlockSide::JMin => (0, 1),
            BlockSide::JMax => (ni * nj.saturating_sub(1), 1),
        };
        (0..self.node_count(side)).map(move |k| first + k * step)
    }
}

impl StructuredBlocks {
    /// Whether lengths, indices and connections agree. O(nodes).
    ///
    /// A connection agrees when it leads to a side of the same number of nodes whose own connection leads back, reversed alike and
    /// by the opposite shift. Where the nodes lie is not looked at.
    ///
    /// # Errors
    /// The first contradiction.
    pub fn check(&self) -> Result<(), BlocksDefect> {
        for (index, block) in self.blocks.iter().enumerate() {
            check_nodes(index, block)?;
        }
        let nodes = self.blocks.iter().map(|block| block.points.len()).sum();
        if u32::try_from(nodes).is_err() {
            return Err(BlocksDefect::TooManyNodes(nodes));
        }
        for (index, block) in self.blocks.iter().enumerate() {
            for side in BlockSide::ALL {
                self.check_connection(index, block, side)?;
            }
        }
        Ok(())
    }

    fn check_connection(
        &self,
        index: usize,
        block: &StructuredBlock,
        side: BlockSide,
    ) -> Result<(), BlocksDefect> {
        let &Connection::Block {
            block: other,
            side: other_side,
            reversed,
            shift,
        } = block.connection(side)
        else {
            return Ok(());
        };
        if let Some((axis, value)) = first_not_finite(&shift) {
            let place = format!("shift of side {side}");
            return Err(BlocksDefect::NotFinite {
                block: index,
                place,
                axis,
                value,
            });
        }
        let Some(neighbour) = self.blocks.get(other) else {
            return Err(BlocksDefect::NoSuchBlock {
                block: index,
                side,
                other,
                blocks: self.blocks.len(),
            });
        };
        let (count, other_count) = (block.node_count(side), neighbour.node_count(other_side));
        if count != other_count {
            return Err(BlocksDefect::NodeCount {
                block: index,
                side,
                count,
                other,
                other_side,
                other_count,
            });
        }
        let back = Connection::Block {
            block: index,
            side,
            reversed,
            shift: shift.map(|period| -period),
        };
        if *neighbour.connection(other_side) != back || (other, other_side) == (index, side) {
            return Err(BlocksDefect::NotReciprocal {
                block: index,
                side,
                other,
                other_side,
            });
        }
        Ok(())
    }
}

fn check_nodes(index: usize, block: &StructuredBlock) -> Result<(), BlocksDefect> {
    let &StructuredBlock {
        ni, nj, ref points, ..
    } = block;
    if ni < 2 || nj < 2 {
        return Err(BlocksDefect::TooThin {
            block: index,
            ni,
            nj,
        });
    }
    if ni.checked_mul(nj) != Some(points.len()) {
        return Err(BlocksDefect::PointCount {
            block: index,
            ni,
            nj,
            found: points.len(),
        });
    }
    for (point, coordinates) in points.iter().enumerate() {
        if let Some((axis, value)) = first_not_finite(coordinates) {
            return Err(BlocksDefect::NotFinite {
                block: index,
                place: format!("point {point}"),
                axis,
                value,
            });
        }
    }
    Ok(())
}
