//! The dictionary, section by section.

use std::io::{self, Write};

use super::curves::{curves, inner_nodes};
use super::patches::{FRONT_AND_BACK, Patch, PatchKind, patches};
use super::split::with_distinct_curves;
use super::unsupported::unsupported;
use super::vertices::{Turn, Vertices, turn_and_area};
use crate::blocks::StructuredBlocks;
use crate::error::WriteError;

/// How thick the one layer of cells is.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Thickness {
    /// The square root of the mean area of cells.
    #[default]
    MeanCellSize,
    /// A length, positive and finite, in the unit of the coordinates.
    Length(f64),
}

/// Writes a `blockMeshDict` for blocks in the plane `z = 0`. O(nodes log blocks).
///
/// # Errors
/// Blocks that contradict each other, lie outside the plane or have no area, curves that `blockMesh` cannot tell apart (see the module), a
/// thickness that is none, and what `out` refuses.
pub fn write(
    out: &mut impl Write,
    blocks: &StructuredBlocks,
    thickness: Thickness,
) -> Result<(), WriteError> {
    blocks.check()?;
    check_plane(blocks)?;
    let blocks = with_distinct_curves(blocks)?;
    let vertices = Vertices::of(&blocks)?;
    let turned = blocks
        .blocks
        .iter()
        .enumerate()
        .map(|(index, block)| turn_and_area(index, block));
    let (turns, areas): (Vec<Turn>, Vec<f64>) =
        turned.collect::<Result<Vec<_>, _>>()?.into_iter().unzip();
    let thickness = length(thickness, &blocks, areas.iter().sum())?;
    let patches = patches(&blocks, &vertices, &turns)?;
    write_head(out)?;
    write_vertices(out, &vertices, thickness)?;
    write_blocks(out, &blocks, &vertices, &turns)?;
    write_edges(out, &blocks, &vertices, thickness)?;
    write_boundary(out, &vertices, &turns, &patches)?;
    Ok(writeln!(out, "mergePatchPairs\n(\n);")?)
}

fn check_plane(blocks: &StructuredBlocks) -> Result<(), WriteError> {
    for (index, block) in blocks.blocks.iter().enumerate() {
        if let Some(node) = block.points.iter().position(|point| point[2] != 0.0) {
            return Err(unsupported(format!(
                "block {index}, whose point {node} is outside the plane z = 0"
            )));
        }
    }
    Ok(())
}

fn length(thickness: Thickness, blocks: &StructuredBlocks, area: f64) -> Result<f64, WriteError> {
    let cells: usize = blocks
        .blocks
        .iter()
        .map(|block| (block.ni - 1) * (block.nj - 1))
        .sum();
    let length = match thickness {
        Thickness::Length(length) => length,
        Thickness::MeanCellSize if cells == 0 => 1.0,
        Thickness::MeanCellSize => (area / cells as f64).sqrt(),
    };
    if length > 0.0 && length.is_finite() {
        return Ok(length);
    }
    Err(unsupported(format!("cells of thickness {length}")))
}

fn write_head(out: &mut impl Write) -> io::Result<()> {
    writeln!(
        out,
        "FoamFile\n{{\n    version     2.0;\n    format      ascii;"
    )?;
    writeln!(
        out,
        "    class       dictionary;\n    object      blockMeshDict;\n}}\n"
    )?;
    writeln!(out, "convertToMeters 1;\n")
}

/// Vertices at the back, then those in front in the same order.
fn write_vertices(out: &mut impl Write, vertices: &Vertices, thickness: f64) -> io::Result<()> {
    writeln!(out, "vertices\n(")?;
    for z in [0.0, thickness] {
        for &[x, y, _] in &vertices.points {
            writeln!(out, "    ({x:?} {y:?} {z:?})")?;
        }
    }
    writeln!(out, ");\n")
}

fn write_blocks(
    out: &mut impl Write,
    blocks: &StructuredBlocks,
    vertices: &Vertices,
    turns: &[Turn],
) -> io::Result<()> {
    let front = vertices.points.len();
    writeln!(out, "blocks\n(")?;
    for ((block, &corners), &turn) in blocks.blocks.iter().zip(&vertices.corners).zip(turns) {
        let (cells_i, cells_j) = (block.ni - 1, block.nj - 1);
        let [a, b, c, d] = counterclockwise(corners, turn);
        let (across, up) = match turn {
            Turn::Counterclockwise => (cells_i, cells_j),
            Turn::Clockwise => (cells_j, cells_i),
        };
        write!(
            out,
            "    hex ({a} {b} {c} {d} {} {} {} {})",
            a + front,
            b + front,
            c + front,
            d + front
        )?;
        writeln!(out, " ({across} {up} 1) simpleGrading (1 1 1)")?;
    }
    writeln!(out, ");\n")
}

/// The corners of a block, counterclockwise from node `(0, 0)`.
const fn counterclockwise([v00, v10, v11, v01]: [usize; 4], turn: Turn) -> [usize; 4] {
    match turn {
        Turn::Counterclockwise => [v00, v10, v11, v01],
        Turn::Clockwise => [v00, v01, v11, v10],
    }
}

fn write_edges(
    out: &mut impl Write,
    blocks: &StructuredBlocks,
    vertices: &Vertices,
    thickness: f64,
) -> io::Result<()> {
    let front = vertices.points.len();
    writeln!(out, "edges\n(")?;
    for (block, side) in curves(blocks) {
        let nodes = inner_nodes(&blocks.blocks[block], side);
        if nodes.is_empty() {
            continue;
        }
        let [from, to] = vertices.ends(block, side);
        for (from, to, z) in [(from, to, 0.0), (from + front, to + front, thickness)] {
            writeln!(out, "    polyLine {from} {to}\n    (")?;
            for &[x, y, _] in &nodes {
                writeln!(out, "        ({x:?} {y:?} {z:?})")?;
            }
            writeln!(out, "    )")?;
        }
    }
    writeln!(out, ");\n")
}

fn write_boundary(
    out: &mut impl Write,
    vertices: &Vertices,
    turns: &[Turn],
    patches: &[Patch],
) -> io::Result<()> {
    let front = vertices.points.len();
    writeln!(out, "boundary\n(")?;
    for Patch { name, kind, faces } in patches {
        writeln!(out, "    {name}\n    {{")?;
        match kind {
            PatchKind::Wall => writeln!(out, "        type wall;")?,
            PatchKind::Cyclic {
                neighbour,
                shift: [x, y, z],
            } => {
                writeln!(
                    out,
                    "        type cyclic;\n        neighbourPatch {neighbour};"
                )?;
                writeln!(
                    out,
                    "        transform translational;\n        separationVector ({x:?} {y:?} {z:?});"
                )?;
            }
        }
        let around = faces
            .iter()
            .map(|&[from, to]| [from, to, to + front, from + front]);
        write_faces(out, around)?;
    }
    writeln!(out, "    {FRONT_AND_BACK}\n    {{\n        type empty;")?;
    let corners = vertices
        .corners
        .iter()
        .zip(turns)
        .map(|(&corners, &turn)| counterclockwise(corners, turn));
    write_faces(
        out,
        corners.flat_map(|[a, b, c, d]| [[a, d, c, b], [a, b, c, d].map(|vertex| vertex + front)]),
    )?;
    writeln!(out, ");\n")
}

/// The faces of a patch, seen from outside, and the end of the patch.
fn write_faces(out: &mut impl Write, faces: impl Iterator<Item = [usize; 4]>) -> io::Result<()> {
    writeln!(out, "        faces\n        (")?;
    for [a, b, c, d] in faces {
        writeln!(out, "            ({a} {b} {c} {d})")?;
    }
    writeln!(out, "        );\n    }}")
}
