//! Corners of blocks as vertices, merged where sides are connected.

use std::collections::BTreeMap;

use super::unsupported::unsupported;
use crate::blocks::{BlockSide, StructuredBlock, StructuredBlocks};
use crate::error::WriteError;

/// The vertices of the plane and which of them are the corners of every block.
pub(super) struct Vertices {
    pub(super) points: Vec<[f64; 3]>,
    /// Vertices at nodes `(0, 0)`, `(ni - 1, 0)`, `(ni - 1, nj - 1)` and `(0, nj - 1)`.
    pub(super) corners: Vec<[usize; 4]>,
}

impl Vertices {
    pub(super) fn of(blocks: &StructuredBlocks) -> Result<Self, WriteError> {
        let mesh = blocks.to_mesh()?;
        let mut vertex_of_point = BTreeMap::new();
        let mut vertices = Self {
            points: Vec::new(),
            corners: Vec::new(),
        };
        let mut quads = mesh.cells.corners().as_chunks::<4>().0;
        for StructuredBlock { ni, nj, .. } in &blocks.blocks {
            // Quads run with `i` fastest, their corners counterclockwise from the smallest `i` and `j`.
            let (across, count) = (ni - 1, (ni - 1) * (nj - 1));
            let at_corners = [0, across - 1, count - 1, count - across];
            let points = std::array::from_fn(|corner| quads[at_corners[corner]][corner]);
            vertices.corners.push(points.map(|point: u32| {
                *vertex_of_point.entry(point).or_insert_with(|| {
                    vertices.points.push(mesh.points[point as usize]);
                    vertices.points.len() - 1
                })
            }));
            quads = &quads[count..];
        }
        Ok(vertices)
    }

    /// The vertices at the ends of a side, in the direction of growing `i` or `j`.
    pub(super) fn ends(&self, block: usize, side: BlockSide) -> [usize; 2] {
        let [v00, v10, v11, v01] = self.corners[block];
        match side {
            BlockSide::IMin => [v00, v01],
            BlockSide::IMax => [v10, v11],
            BlockSide::JMin => [v00, v10],
            BlockSide::JMax => [v01, v11],
        }
    }
}

/// How `i` and `j` of a block turn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Turn {
    Counterclockwise,
    Clockwise,
}

/// How `i` and `j` of a block turn, and the area of its outline.
///
/// # Errors
/// An outline whose area is zero or not finite.
pub(super) fn turn_and_area(
    index: usize,
    block: &StructuredBlock,
) -> Result<(Turn, f64), WriteError> {
    let twice = twice_signed_area(&outline(block));
    if twice == 0.0 || !twice.is_finite() {
        return Err(unsupported(format!(
            "block {index}, whose outline has the area {}",
            twice / 2.0
        )));
    }
    let turn = if twice > 0.0 {
        Turn::Counterclockwise
    } else {
        Turn::Clockwise
    };
    Ok((turn, twice.abs() / 2.0))
}

/// The nodes round a block: out along `j_min` and `i_max`, back along `j_max` and `i_min`.
fn outline(block: &StructuredBlock) -> Vec<[f64; 3]> {
    let along = |side| block.nodes_along(side).map(|node| block.points[node]);
    let mut outline: Vec<_> = along(BlockSide::JMin)
        .chain(along(BlockSide::IMax))
        .collect();
    outline.extend(along(BlockSide::JMax).collect::<Vec<_>>().into_iter().rev());
    outline.extend(along(BlockSide::IMin).collect::<Vec<_>>().into_iter().rev());
    outline
}

fn twice_signed_area(outline: &[[f64; 3]]) -> f64 {
    let Some(&[x0, y0, _]) = outline.first() else {
        return 0.0;
    };
    let pairs = outline.iter().zip(outline.iter().skip(1));
    pairs
        .map(|(a, b)| (a[0] - x0) * (b[1] - y0) - (b[0] - x0) * (a[1] - y0))
        .sum()
}
