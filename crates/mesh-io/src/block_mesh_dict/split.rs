//! Blocks cut along whole rows or columns of cells, so that no two curves have the same ends.

use std::borrow::Cow;
use std::collections::BTreeMap;

use super::curves::ambiguous;
use super::unsupported::unsupported;
use super::vertices::Vertices;
use crate::blocks::{BlockSide, Connection, StructuredBlock, StructuredBlocks};
use crate::error::WriteError;

/// The blocks, cut where curves could not be told apart by their ends.
///
/// # Errors
/// A curve of a single cell that has the ends of another, and blocks that no plane has room for.
pub(super) fn with_distinct_curves(
    blocks: &StructuredBlocks,
) -> Result<Cow<'_, StructuredBlocks>, WriteError> {
    let mut blocks = Cow::Borrowed(blocks);
    loop {
        let vertices = Vertices::of(&blocks)?;
        let found = ambiguous(&blocks, &vertices);
        if found.is_empty() {
            check_corners(&vertices)?;
            return Ok(blocks);
        }
        let longest = |&&(block, side): &&(usize, BlockSide)| blocks.blocks[block].node_count(side);
        match found.iter().max_by_key(longest) {
            Some(&(block, side)) if blocks.blocks[block].node_count(side) < 3 => {
                let what = format!(
                    "block {block}, whose side {side} of one cell ends where another curve does"
                );
                return Err(unsupported(what));
            }
            _ => blocks = Cow::Owned(Cuts::across(&blocks, found).apply(&blocks)),
        }
    }
}

/// Refuses what no plane has room for: a block that touches itself at opposite corners, and two blocks between the same corners.
fn check_corners(vertices: &Vertices) -> Result<(), WriteError> {
    let mut by_corners = BTreeMap::new();
    for (block, &corners) in vertices.corners.iter().enumerate() {
        let [v00, v10, v11, v01] = corners;
        if v00 == v11 || v10 == v01 {
            return Err(unsupported(format!(
                "block {block}, two opposite corners of which are one vertex"
            )));
        }
        let mut sorted = corners;
        sorted.sort_unstable();
        if let Some(other) = by_corners.insert(sorted, block) {
            return Err(unsupported(format!(
                "block {block}, whose corners are those of block {other}"
            )));
        }
    }
    Ok(())
}

/// Where `i` and `j` of every block are cut, as the indices of the nodes at which pieces start and end.
struct Cuts(Vec<[Vec<usize>; 2]>);

/// The index that runs along a side: 0 for `i`, 1 for `j`.
const fn index_along(side: BlockSide) -> usize {
    match side {
        BlockSide::JMin | BlockSide::JMax => 0,
        BlockSide::IMin | BlockSide::IMax => 1,
    }
}

impl Cuts {
    /// Cuts through these sides, and on through the blocks on the far sides.
    fn across(blocks: &StructuredBlocks, mut sides: Vec<(usize, BlockSide)>) -> Self {
        let mut cut = vec![[false; 2]; blocks.blocks.len()];
        while let Some((block, side)) = sides.pop() {
            let along = index_along(side);
            if std::mem::replace(&mut cut[block][along], true) {
                continue;
            }
            for side in BlockSide::ALL
                .into_iter()
                .filter(|&side| index_along(side) == along)
            {
                if let Connection::Block { block, side, .. } =
                    *blocks.blocks[block].connection(side)
                {
                    sides.push((block, side));
                }
            }
        }
        let of_block = |(block, cut): (&StructuredBlock, [bool; 2])| {
            [
                symmetric_cuts(block.ni, cut[0]),
                symmetric_cuts(block.nj, cut[1]),
            ]
        };
        Self(blocks.blocks.iter().zip(cut).map(of_block).collect())
    }

    /// Pieces of a block along an index.
    fn pieces(&self, block: usize, index: usize) -> usize {
        self.0[block][index].len() - 1
    }

    fn apply(&self, blocks: &StructuredBlocks) -> StructuredBlocks {
        let counts = (0..self.0.len()).map(|block| self.pieces(block, 0) * self.pieces(block, 1));
        let first: Vec<usize> = counts
            .scan(0, |next, count| {
                Some(std::mem::replace(next, *next + count))
            })
            .collect();
        let mut pieces = Vec::new();
        for (index, block) in blocks.blocks.iter().enumerate() {
            for j in 0..self.pieces(index, 1) {
                for i in 0..self.pieces(index, 0) {
                    let sides = BlockSide::ALL
                        .map(|side| self.connection(&first, index, block, [i, j], side));
                    pieces.push(self.piece(index, block, [i, j], sides));
                }
            }
        }
        StructuredBlocks { blocks: pieces }
    }

    fn piece(
        &self,
        index: usize,
        block: &StructuredBlock,
        [i, j]: [usize; 2],
        sides: [Connection; 4],
    ) -> StructuredBlock {
        let [along_i, along_j] = &self.0[index];
        let (i, j) = (along_i[i]..=along_i[i + 1], along_j[j]..=along_j[j + 1]);
        let (ni, nj) = (i.clone().count(), j.clone().count());
        let row = |j: usize| i.clone().map(move |i| block.points[j * block.ni + i]);
        StructuredBlock {
            name: block.name.clone(),
            ni,
            nj,
            points: j.flat_map(row).collect(),
            sides,
        }
    }

    /// What lies behind a side of piece `(i, j)` of a block: the piece next to it, or a piece of what lies behind the block.
    fn connection(
        &self,
        first: &[usize],
        index: usize,
        block: &StructuredBlock,
        [i, j]: [usize; 2],
        side: BlockSide,
    ) -> Connection {
        let (across, up) = (self.pieces(index, 0), self.pieces(index, 1));
        let inside = |i: usize, j: usize, side| Connection::Block {
            block: first[index] + j * across + i,
            side,
            reversed: false,
            shift: [0.0; 3],
        };
        match side {
            BlockSide::IMin if i > 0 => inside(i - 1, j, BlockSide::IMax),
            BlockSide::IMax if i + 1 < across => inside(i + 1, j, BlockSide::IMin),
            BlockSide::JMin if j > 0 => inside(i, j - 1, BlockSide::JMax),
            BlockSide::JMax if j + 1 < up => inside(i, j + 1, BlockSide::JMin),
            _ => match block.connection(side).clone() {
                Connection::Block {
                    block: other,
                    side: there,
                    reversed,
                    shift,
                } => {
                    let k = [i, j][index_along(side)];
                    let block = first[other] + self.piece_behind(other, there, k, reversed);
                    Connection::Block {
                        block,
                        side: there,
                        reversed,
                        shift,
                    }
                }
                patch @ Connection::Patch(_) => patch,
            },
        }
    }

    /// Position, among the pieces of a block, of the one that has the `k`-th piece of a side, counted from either end.
    fn piece_behind(&self, block: usize, side: BlockSide, k: usize, reversed: bool) -> usize {
        let (across, up) = (self.pieces(block, 0), self.pieces(block, 1));
        let along = self.pieces(block, index_along(side));
        let k = if reversed { along - 1 - k } else { k };
        match side {
            BlockSide::IMin => k * across,
            BlockSide::IMax => k * across + across - 1,
            BlockSide::JMin => k,
            BlockSide::JMax => (up - 1) * across + k,
        }
    }
}

/// Cuts into two or three pieces that are the same from either end, so that sides fit whichever way they run.
fn symmetric_cuts(nodes: usize, cut: bool) -> Vec<usize> {
    let last = nodes - 1;
    match last {
        _ if !cut => vec![0, last],
        0 | 1 => vec![0, last],
        2 => vec![0, 1, 2],
        _ => vec![0, last / 3, last - last / 3, last],
    }
}
