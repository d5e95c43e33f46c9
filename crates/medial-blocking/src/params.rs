//! How many cells, and how nodes are matched across a block.

use std::f64::consts::FRAC_PI_2;

use crate::blocking::Blocking;
use crate::error::BlockingError;
use crate::medial_graph::ArcId;
use crate::wall::{WallId, WallName};

/// Most cells of a mesh: their nodes take 4 GiB.
pub const MAX_CELLS: u64 = 1 << 28;

/// How many cells each block has.
///
/// Counts along an arc are shared by the two blocks on its sides, counts across by all blocks round
/// one wall, so shared curves always have the same nodes.
#[derive(Clone, Debug, PartialEq)]
pub enum CellCounts {
    /// The same number of cells along and across in every block.
    PerBlock(u32),
    /// As many cells as keep every edge of a bounding curve at most this long, in units of the
    /// domain.
    Size(f64),
    /// Chosen by the caller for every arc and every wall.
    Each {
        /// Cells along each arc, in the order of [`Blocking::arcs`].
        along_arc: Vec<u32>,
        /// Cells between each wall and the medial axis, in the order of [`crate::Domain::walls`].
        across_wall: Vec<u32>,
    },
}

/// Which node of the wall belongs to which node of the medial arc.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum NodeMatching {
    /// Equal spacing along arc and wall, matched by number (§3, §5).
    ///
    /// Where that would fold a strip of cells, the nodes of that one arc lean towards the touching
    /// points, just far enough: a departure from the paper, which claims that folding cannot
    /// happen. [`crate::BlockMesh::leaning_arcs`] lists them.
    #[default]
    EqualSpacing,
    /// Equal spacing along the arc, each node matched with the point where its empty circle touches
    /// the wall (§6).
    EmptyCircle,
}

/// Settings of the mesh.
#[derive(Clone, Debug, PartialEq)]
pub struct Params {
    /// Numbers of cells; 16 per block unless said otherwise.
    pub cells: CellCounts,
    /// Matching of nodes; the paper's equal spacing unless said otherwise.
    pub matching: NodeMatching,
}

impl Default for Params {
    fn default() -> Self {
        Self {
            cells: CellCounts::PerBlock(16),
            matching: NodeMatching::EqualSpacing,
        }
    }
}

/// Checked numbers of cells of a blocking.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Counts {
    pub(crate) along_arc: Vec<u32>,
    pub(crate) across_wall: Vec<u32>,
}

impl Counts {
    pub(crate) fn of(blocking: &Blocking, cells: &CellCounts) -> Result<Self, BlockingError> {
        let (arcs, walls) = (blocking.arcs().len(), blocking.domain().walls().len());
        let counts = match cells {
            CellCounts::PerBlock(n) => Self {
                along_arc: vec![*n; arcs],
                across_wall: vec![*n; walls],
            },
            CellCounts::Size(size) => Self::by_size(blocking, *size)?,
            CellCounts::Each {
                along_arc,
                across_wall,
            } => {
                expect_length("arcs", along_arc.len(), arcs)?;
                expect_length("walls", across_wall.len(), walls)?;
                Self {
                    along_arc: along_arc.clone(),
                    across_wall: across_wall.clone(),
                }
            }
        };
        counts.validated(blocking)
    }

    fn by_size(blocking: &Blocking, size: f64) -> Result<Self, BlockingError> {
        if !(size.is_finite() && size > 0.0) {
            return Err(BlockingError::CellSize { size });
        }
        let count = |length: f64| (length / size).ceil().clamp(1.0, f64::from(u32::MAX)) as u32;
        let mut counts = Self {
            along_arc: vec![1; blocking.arcs().len()],
            across_wall: vec![1; blocking.domain().walls().len()],
        };
        for (arc, along) in blocking.arc_ids().zip(&mut counts.along_arc) {
            *along = count(blocking.longest_curve_along(arc)).max(count_of_turn(blocking, arc));
        }
        for block in blocking.blocks() {
            let across = &mut counts.across_wall[block.wall.index()];
            for corner in [block.start, block.end] {
                *across = (*across).max(count(blocking.vertex(corner.vertex).clearance));
            }
        }
        Ok(counts)
    }

    fn validated(self, blocking: &Blocking) -> Result<Self, BlockingError> {
        if let Some(arc) = self.along_arc.iter().position(|&n| n == 0) {
            return Err(BlockingError::NoCells {
                what: format!("along arc {arc}"),
            });
        }
        if let Some(wall) = self.across_wall.iter().position(|&n| n == 0) {
            return Err(BlockingError::NoCells {
                what: format!("between {} and the medial axis", name(blocking, wall)),
            });
        }
        let cells: f64 = blocking
            .blocks()
            .iter()
            .map(|block| {
                f64::from(self.along_arc[block.arc.index()])
                    * f64::from(self.across_wall[block.wall.index()])
            })
            .sum();
        if cells > MAX_CELLS as f64 {
            return Err(BlockingError::TooManyCells {
                cells,
                limit: MAX_CELLS,
            });
        }
        Ok(self)
    }
}

/// Cells along an arc that keep each below a quarter turn of the walls on its sides.
fn count_of_turn(blocking: &Blocking, arc: ArcId) -> u32 {
    let turn = blocking
        .wall_sweep(arc.right_block())
        .abs()
        .max(blocking.wall_sweep(arc.left_block()).abs());
    (turn / FRAC_PI_2).ceil() as u32
}

fn name(blocking: &Blocking, wall: usize) -> WallName {
    blocking.domain().name(WallId(wall as u32))
}

fn expect_length(what: &'static str, given: usize, expected: usize) -> Result<(), BlockingError> {
    if given == expected {
        Ok(())
    } else {
        Err(BlockingError::CountsLength {
            what,
            given,
            expected,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::BlockSide;
    use crate::example_domains::{one_hole, three_holes, two_periodic_holes};

    #[test]
    fn by_size_every_edge_along_the_curves_is_at_most_that_long() {
        for domain in [one_hole(), three_holes(), two_periodic_holes()] {
            for size in [0.03, 0.1, 0.5] {
                let params = Params {
                    cells: CellCounts::Size(size),
                    ..Params::default()
                };
                let mesh = crate::mesh(&domain, &params).unwrap();
                for grid in mesh.grids() {
                    let (across, along) = (grid.cells_across(), grid.cells_along());
                    for j in 0..along {
                        let edge = grid.node(0, j).distance(grid.node(0, j + 1));
                        assert!(edge <= size * (1.0 + 1e-9), "{edge} {size}");
                    }
                    for (i, j) in (0..across).flat_map(|i| [(i, 0), (i, along)]) {
                        assert!(
                            grid.node(i, j).distance(grid.node(i + 1, j)) <= size * (1.0 + 1e-9)
                        );
                    }
                }
            }
        }
    }

    #[test]
    fn by_size_no_cell_spans_more_than_a_quarter_turn() {
        let blocking = Blocking::of(&one_hole()).unwrap();
        let counts = Counts::of(&blocking, &CellCounts::Size(1e6)).unwrap();
        for block in blocking.block_ids() {
            let along = counts.along_arc[blocking.block(block).arc.index()];
            assert!(
                blocking.wall_sweep(block).abs() <= FRAC_PI_2 * f64::from(along) * (1.0 + 1e-12)
            );
            assert!(blocking.curve(block, BlockSide::Xi1, 0.5).is_finite());
        }
    }

    #[test]
    fn counts_must_fit_the_blocking() {
        let blocking = Blocking::of(&three_holes()).unwrap();
        let each = |arcs: usize, walls: usize| CellCounts::Each {
            along_arc: vec![4; arcs],
            across_wall: vec![4; walls],
        };
        assert!(Counts::of(&blocking, &each(6, 4)).is_ok());
        for (arcs, walls) in [(5, 4), (7, 4), (6, 3), (6, 5), (0, 0)] {
            assert!(Counts::of(&blocking, &each(arcs, walls)).is_err());
        }
    }
}
