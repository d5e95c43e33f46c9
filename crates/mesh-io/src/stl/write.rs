//! Writes triangles.

use std::io::Write;

use super::HEADER;
use super::normal::normal;
use crate::cell::Cell;
use crate::error::WriteError;
use crate::format::Format;
use crate::mesh::{Axis, Mesh};
use crate::numbers::Encoding;
use crate::write_as::unsupported;

/// Writes the triangles of a mesh as one solid: as text, or as binary with floats of 4 bytes. Points without a triangle, markers and
/// data are left out. O(mesh).
///
/// # Errors
/// [`WriteProblem::Unsupported`](crate::WriteProblem::Unsupported) when there are other cells than triangles; in binary also when a
/// coordinate is beyond the floats, or there are more triangles than 32 bits count.
pub fn write(out: &mut impl Write, mesh: &Mesh, encoding: Encoding) -> Result<(), WriteError> {
    mesh.check()?;
    match encoding {
        Encoding::Ascii => text(out, mesh),
        Encoding::Binary => binary(out, mesh),
    }
}

fn text(out: &mut impl Write, mesh: &Mesh) -> Result<(), WriteError> {
    writeln!(out, "solid mesh")?;
    for corners in triangles(mesh) {
        let corners = places(mesh, corners?);
        let [x, y, z] = normal(corners);
        writeln!(out, "facet normal {x:?} {y:?} {z:?}\n outer loop")?;
        for [x, y, z] in corners {
            writeln!(out, "  vertex {x:?} {y:?} {z:?}")?;
        }
        writeln!(out, " endloop\nendfacet")?;
    }
    Ok(writeln!(out, "endsolid mesh")?)
}

fn binary(out: &mut impl Write, mesh: &Mesh) -> Result<(), WriteError> {
    let count = mesh.cells.len();
    let count = u32::try_from(count)
        .map_err(|_| unsupported(Format::Stl, &format!("{count} triangles in binary")))?;
    // A file that begins with the word solid is text.
    out.write_all(format!("{:<HEADER$}", "binary STL").as_bytes())?;
    out.write_all(&count.to_le_bytes())?;
    for corners in triangles(mesh) {
        let corners = corners?;
        let normal = normal(places(mesh, corners)).map(|coordinate| coordinate as f32);
        write_floats(out, normal)?;
        for corner in corners {
            write_floats(out, floats(mesh, corner)?)?;
        }
        out.write_all(&[0; 2])?;
    }
    Ok(())
}

/// The corners of every cell, each of which should be a triangle.
fn triangles(mesh: &Mesh) -> impl Iterator<Item = Result<[u32; 3], WriteError>> + '_ {
    let cells = mesh.cells.iter().enumerate();
    cells.map(|(index, cell)| match cell {
        Cell::Triangle(corners) => Ok(corners),
        _ => {
            let what = format!("cell {index}, a {}", cell.kind().name());
            Err(unsupported(Format::Stl, &what))
        }
    })
}

fn places(mesh: &Mesh, corners: [u32; 3]) -> [[f64; 3]; 3] {
    corners.map(|corner| place(mesh, corner))
}

/// The place of a corner, which [`Mesh::check`] has seen to exist.
fn place(mesh: &Mesh, corner: u32) -> [f64; 3] {
    let place = mesh.points.get(corner as usize);
    place.copied().unwrap_or_default()
}

/// The nearest floats, none of which may be infinite.
fn floats(mesh: &Mesh, corner: u32) -> Result<[f32; 3], WriteError> {
    let place = place(mesh, corner);
    let floats = place.map(|coordinate| coordinate as f32);
    let mut named = Axis::ALL.into_iter().zip(place).zip(floats);
    match named.find(|(_, float)| !float.is_finite()) {
        None => Ok(floats),
        Some(((axis, value), _)) => {
            let what = format!("{axis} = {value:?} of point {corner} in binary");
            Err(unsupported(Format::Stl, &what))
        }
    }
}

fn write_floats(out: &mut impl Write, floats: [f32; 3]) -> std::io::Result<()> {
    let mut floats = floats.into_iter();
    floats.try_for_each(|float| out.write_all(&float.to_le_bytes()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cell::Cells;

    #[test]
    fn a_text_has_the_words_that_readers_look_for() {
        let points = vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1e-300, 0.0]];
        let mesh = Mesh::new(points, Cells::of_triangles(vec![[0, 1, 2]]));
        let mut file = Vec::new();
        write(&mut file, &mesh, Encoding::Ascii).unwrap();
        insta::assert_snapshot!(String::from_utf8(file).unwrap(), @r"
        solid mesh
        facet normal 0.0 0.0 1.0
         outer loop
          vertex 0.0 0.0 0.0
          vertex 1.0 0.0 0.0
          vertex 0.0 1e-300 0.0
         endloop
        endfacet
        endsolid mesh
        ");
    }

    #[test]
    fn what_triangles_or_floats_cannot_hold_is_refused() {
        let error = |cell| {
            let points = vec![[0.0, -1e300, 0.0]; 4];
            let mesh = Mesh::new(points, Cells::from_iter([cell]));
            write(&mut Vec::new(), &mesh, Encoding::Binary).unwrap_err()
        };
        insta::assert_snapshot!(error(Cell::Quad([0, 1, 2, 3])), @"STL cannot hold cell 0, a quad");
        insta::assert_snapshot!(error(Cell::Triangle([0, 1, 2])), @"STL cannot hold y = -1e300 of point 0 in binary");
    }
}
