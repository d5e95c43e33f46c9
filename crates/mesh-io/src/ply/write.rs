//! Writes points, faces and edges.

use std::io::{self, Write};

use crate::cell::{Cell, CellKind};
use crate::error::WriteError;
use crate::format::Format;
use crate::mesh::Mesh;
use crate::numbers::Encoding;
use crate::write_as::unsupported;

/// Writes a mesh as text or as little-endian binary, coordinates as doubles so that reading gives the same bits: triangles and quads
/// as faces, and behind all of them segments as edges. Markers and data are left out. O(mesh).
///
/// # Errors
/// [`WriteProblem::Unsupported`](crate::WriteProblem::Unsupported) when there are other cells.
pub fn write(out: &mut impl Write, mesh: &Mesh, encoding: Encoding) -> Result<(), WriteError> {
    mesh.check()?;
    check_kinds(mesh.cells.kinds())?;
    let is_edge = |&&kind: &&CellKind| kind == CellKind::Segment;
    let edges = mesh.cells.kinds().iter().filter(is_edge).count();
    write_header(out, mesh, edges, encoding)?;
    for point in &mesh.points {
        write_point(out, point, encoding)?;
    }
    for cell in mesh.cells.iter() {
        if !matches!(cell, Cell::Segment(_)) {
            write_face(out, cell.corners(), encoding)?;
        }
    }
    for cell in mesh.cells.iter() {
        if let Cell::Segment(ends) = cell {
            write_edge(out, ends, encoding)?;
        }
    }
    Ok(())
}

fn check_kinds(kinds: &[CellKind]) -> Result<(), WriteError> {
    let fits = |kind| {
        matches!(
            kind,
            CellKind::Segment | CellKind::Triangle | CellKind::Quad
        )
    };
    let other = kinds.iter().enumerate().find(|&(_, &kind)| !fits(kind));
    other.map_or(Ok(()), |(index, kind)| {
        let what = format!("cell {index}, a {}", kind.name());
        Err(unsupported(Format::Ply, &what))
    })
}

fn write_header(
    out: &mut impl Write,
    mesh: &Mesh,
    edges: usize,
    encoding: Encoding,
) -> io::Result<()> {
    let format = match encoding {
        Encoding::Ascii => "ascii",
        Encoding::Binary => "binary_little_endian",
    };
    // Some readers know no unsigned indices.
    let index = match i32::try_from(mesh.points.len()) {
        Ok(_) => "int",
        Err(_) => "uint",
    };
    write!(
        out,
        "ply\nformat {format} 1.0\n\
         element vertex {}\nproperty double x\nproperty double y\nproperty double z\n\
         element face {}\nproperty list uchar {index} vertex_indices\n",
        mesh.points.len(),
        mesh.cells.len() - edges
    )?;
    if edges > 0 {
        write!(
            out,
            "element edge {edges}\nproperty {index} vertex1\nproperty {index} vertex2\n"
        )?;
    }
    writeln!(out, "end_header")
}

fn write_point(out: &mut impl Write, point: &[f64; 3], encoding: Encoding) -> io::Result<()> {
    match encoding {
        Encoding::Ascii => {
            let [x, y, z] = point;
            writeln!(out, "{x:?} {y:?} {z:?}")
        }
        Encoding::Binary => point
            .iter()
            .try_for_each(|coordinate| out.write_all(&coordinate.to_le_bytes())),
    }
}

fn write_face(out: &mut impl Write, corners: &[u32], encoding: Encoding) -> io::Result<()> {
    match encoding {
        Encoding::Ascii => {
            write!(out, "{}", corners.len())?;
            for corner in corners {
                write!(out, " {corner}")?;
            }
            writeln!(out)
        }
        Encoding::Binary => {
            out.write_all(&[corners.len() as u8])?;
            write_indices(out, corners)
        }
    }
}

fn write_edge(out: &mut impl Write, [a, b]: [u32; 2], encoding: Encoding) -> io::Result<()> {
    match encoding {
        Encoding::Ascii => writeln!(out, "{a} {b}"),
        Encoding::Binary => write_indices(out, &[a, b]),
    }
}

fn write_indices(out: &mut impl Write, indices: &[u32]) -> io::Result<()> {
    let mut indices = indices.iter();
    indices.try_for_each(|index| out.write_all(&index.to_le_bytes()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cell::Cells;

    #[test]
    fn faces_stand_before_edges_and_volumes_are_refused() {
        let cells = [Cell::Segment([2, 1]), Cell::Triangle([0, 1, 2])];
        let mut mesh = Mesh::new(vec![[0.5, -0.0, 1e300]; 3], Cells::from_iter(cells));
        let mut file = Vec::new();
        write(&mut file, &mesh, Encoding::Ascii).unwrap();
        insta::assert_snapshot!(String::from_utf8(file).unwrap(), @r"
        ply
        format ascii 1.0
        element vertex 3
        property double x
        property double y
        property double z
        element face 1
        property list uchar int vertex_indices
        element edge 1
        property int vertex1
        property int vertex2
        end_header
        0.5 -0.0 1e300
        0.5 -0.0 1e300
        0.5 -0.0 1e300
        3 0 1 2
        2 1
        ");
        mesh.cells.push(Cell::Tetrahedron([0; 4]));
        let written = write(&mut Vec::new(), &mesh, Encoding::Binary);
        insta::assert_snapshot!(written.unwrap_err(), @"PLY cannot hold cell 2, a tetrahedron");
    }
}
