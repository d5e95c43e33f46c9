//! The multiblock structured mesh: a grid of nodes in every block.

use std::ops::ControlFlow;

use delaunay_core::progress::{Meter, Progress, silent};
use glam::DVec2;
use rayon::prelude::*;

use crate::block::{Block, BlockId};
use crate::blocking::Blocking;
use crate::error::BlockingError;
use crate::medial_graph::ArcId;
use crate::nodes::SideNodes;
use crate::params::{Counts, NodeMatching, Params};
use crate::transfinite::{BoundaryNodes, transfinite_grid};

/// Arcs whose nodes are placed side by side between two reports of progress.
const BATCH: usize = 1024;

/// The structured grid of one block.
#[derive(Clone, Debug, PartialEq)]
pub struct BlockGrid {
    across: usize,
    along: usize,
    nodes: Vec<DVec2>,
}

impl BlockGrid {
    /// Number of cells in the direction of ξ, from the medial arc to the wall.
    #[must_use]
    pub const fn cells_across(&self) -> usize {
        self.across
    }

    /// Number of cells in the direction of η, along the medial arc.
    #[must_use]
    pub const fn cells_along(&self) -> usize {
        self.along
    }

    /// All nodes, ξ fastest: node (i, j) is entry `j (cells_across + 1) + i`.
    #[must_use]
    pub fn nodes(&self) -> &[DVec2] {
        &self.nodes
    }

    /// Node (i, j), `i` counting with ξ from the medial arc, `j` with η.
    ///
    /// # Panics
    /// If `i > cells_across` or `j > cells_along`.
    #[must_use]
    pub fn node(&self, i: usize, j: usize) -> DVec2 {
        self.nodes[j * (self.across + 1) + i]
    }

    /// The corners of every cell, counterclockwise from the one with the smallest ξ and η; ξ
    /// fastest.
    pub fn cells(&self) -> impl Iterator<Item = [DVec2; 4]> + '_ {
        let row = self.across + 1;
        (0..self.along).flat_map(move |j| {
            (0..self.across).map(move |i| {
                let k = j * row + i;
                [
                    self.nodes[k],
                    self.nodes[k + 1],
                    self.nodes[k + row + 1],
                    self.nodes[k + row],
                ]
            })
        })
    }
}

/// A blocking with a grid in every block.
///
/// Blocks that share a curve have the same nodes on it, bit for bit, up to the shift of a periodic
/// side.
#[derive(Clone, Debug)]
pub struct BlockMesh {
    blocking: Blocking,
    grids: Vec<BlockGrid>,
    leaning: Vec<ArcId>,
}

impl BlockMesh {
    /// Places the nodes of every block.
    ///
    /// # Errors
    /// Counts that are zero, too small for a cell not to fold, too large together, or of the wrong
    /// length; a cell size that is not positive.
    ///
    /// O(cells), on all threads of the current rayon pool; the result does not depend on their
    /// number. Source: Guoy & Erickson §3 and §5, equal spacing and transfinite interpolation.
    pub fn of(blocking: Blocking, params: &Params) -> Result<Self, BlockingError> {
        Self::of_with(blocking, params, &mut silent)
    }

    /// The same as [`BlockMesh::of`], reporting progress to `report`, which may stop the work.
    ///
    /// # Errors
    /// As [`BlockMesh::of`], and [`BlockingError::Cancelled`].
    pub fn of_with(
        blocking: Blocking,
        params: &Params,
        report: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<Self, BlockingError> {
        let counts = Counts::of(&blocking, &params.cells)?;
        let arcs: Vec<ArcId> = blocking.arc_ids().collect();
        let mut grids = Vec::with_capacity(blocking.blocks().len());
        let mut leaning = Vec::new();
        let mut meter = Meter::start(report, "place nodes", arcs.len())?;
        for batch in arcs.chunks(BATCH) {
            let pairs = batch
                .par_iter()
                .map(|&arc| PairOfGrids::of(&blocking, arc, &counts, params.matching));
            // Of several errors the one of the first arc, whichever thread was faster.
            for (pair, &arc) in pairs.collect::<Vec<_>>().into_iter().zip(batch) {
                let pair = pair?;
                grids.extend(pair.grids);
                leaning.extend(pair.leans.then_some(arc));
                meter.advance()?;
            }
        }
        Ok(Self {
            blocking,
            grids,
            leaning,
        })
    }

    /// The arcs whose nodes, or whose walls' nodes, are not spaced as asked for, because a cell
    /// would have folded.
    #[must_use]
    pub fn leaning_arcs(&self) -> &[ArcId] {
        &self.leaning
    }

    /// The blocks behind the grids.
    #[must_use]
    pub const fn blocking(&self) -> &Blocking {
        &self.blocking
    }

    /// One grid per block, in the order of [`Blocking::blocks`].
    #[must_use]
    pub fn grids(&self) -> &[BlockGrid] {
        &self.grids
    }

    /// The grid of a block.
    #[must_use]
    pub fn grid(&self, id: BlockId) -> &BlockGrid {
        &self.grids[id.index()]
    }

    /// Every block with its grid.
    pub fn blocks(&self) -> impl Iterator<Item = (&Block, &BlockGrid)> {
        self.blocking.blocks().iter().zip(&self.grids)
    }

    /// Number of cells of all blocks.
    #[must_use]
    pub fn cell_count(&self) -> usize {
        self.grids.iter().map(|grid| grid.across * grid.along).sum()
    }

    /// The corners of every cell, block after block.
    pub fn cells(&self) -> impl Iterator<Item = [DVec2; 4]> + '_ {
        self.grids.iter().flat_map(BlockGrid::cells)
    }
}

/// The grids on both sides of an arc.
struct PairOfGrids {
    /// To the right of the arc and to the left.
    grids: [BlockGrid; 2],
    /// Whether nodes are not spaced as asked for.
    leans: bool,
}

impl PairOfGrids {
    fn of(
        blocking: &Blocking,
        arc: ArcId,
        counts: &Counts,
        matching: NodeMatching,
    ) -> Result<Self, BlockingError> {
        let along = blocking.nodes_along(arc, counts.along_arc[arc.index()], matching)?;
        let wall_leans = along.right.lean.max(along.left.lean) > 0.0;
        let leans = along.lean > 0.0 || (matching == NodeMatching::EqualSpacing && wall_leans);
        let sides = [
            (arc.right_block(), along.right),
            (arc.left_block(), along.left),
        ];
        let grids = sides.map(|(id, side)| block_grid(blocking, id, &side, counts));
        Ok(Self { grids, leans })
    }
}

fn block_grid(blocking: &Blocking, id: BlockId, side: &SideNodes, counts: &Counts) -> BlockGrid {
    let across = counts.across_wall[blocking.block(id).wall.index()];
    let [eta0, eta1] = blocking.eta_nodes(id, across);
    let nodes = transfinite_grid(&BoundaryNodes {
        xi0: &side.xi0,
        xi1: &side.xi1,
        eta0: &eta0,
        eta1: &eta1,
    });
    BlockGrid {
        across: across as usize,
        along: side.xi0.len() - 1,
        nodes,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::CellCounts;
    use crate::example_domains::three_holes;

    fn meshed(cells: CellCounts) -> BlockMesh {
        let params = Params {
            cells,
            ..Params::default()
        };
        crate::mesh(&three_holes(), &params).unwrap()
    }

    #[test]
    fn node_i_j_is_a_corner_of_the_cells_round_it() {
        let mesh = meshed(CellCounts::PerBlock(5));
        let grid = &mesh.grids()[0];
        assert_eq!(grid.nodes().len(), 36);
        let cells: Vec<_> = grid.cells().collect();
        assert_eq!(cells.len(), 25);
        for (i, j) in [(0, 0), (4, 0), (2, 3), (4, 4)] {
            let corners = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)];
            assert_eq!(cells[5 * j + i], corners.map(|(i, j)| grid.node(i, j)));
        }
    }

    #[test]
    fn lines_of_constant_eta_are_straight_and_equally_spaced() {
        let mesh = meshed(CellCounts::PerBlock(6));
        for grid in mesh.grids() {
            for j in 0..=6 {
                let (from, to) = (grid.node(0, j), grid.node(6, j));
                for i in 0..=6 {
                    let expected = from.lerp(to, i as f64 / 6.0);
                    assert!(grid.node(i, j).distance(expected) < 1e-14);
                }
            }
        }
    }

    #[test]
    fn the_cell_count_is_that_of_all_blocks() {
        let mesh = meshed(CellCounts::Each {
            along_arc: vec![4, 5, 6, 7, 8, 9],
            across_wall: vec![1, 2, 3, 4],
        });
        assert_eq!(mesh.cell_count(), mesh.cells().count());
        for (block, grid) in mesh.blocks() {
            assert_eq!(grid.cells_along(), 4 + block.arc.index());
            assert_eq!(grid.cells_across(), 1 + block.wall.index());
        }
    }
}
