//! Writes an unstructured grid.

use std::io::{self, Write};

use super::name::encoded;
use crate::cell::{Cell, Cells};
use crate::error::WriteError;
use crate::format::Format;
use crate::mesh::{DataArray, Mesh};
use crate::vtu::{MARKER, turn_wedge, vtk_type};
use crate::write_as::unsupported;

/// Writes a mesh with its markers and data as version 3.0 in ASCII, so that reading gives the same bits. O(mesh).
///
/// # Errors
/// A mesh that contradicts itself, [`WriteProblem::Unsupported`](crate::WriteProblem::Unsupported) when data have no name or there are
/// more points than 31 bits number.
pub fn write(out: &mut impl Write, mesh: &Mesh) -> Result<(), WriteError> {
    mesh.check()?;
    let count = mesh.points.len();
    if i32::try_from(count).is_err() {
        return Err(unsupported(Format::Vtk, &format!("{count} points")));
    }
    let mut data = mesh.point_data.iter().chain(&mesh.cell_data);
    if data.any(|array| array.name.is_empty()) {
        return Err(unsupported(Format::Vtk, "data without a name"));
    }
    write!(
        out,
        "# vtk DataFile Version 3.0\nmesh\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS {count} double\n"
    )?;
    for [x, y, z] in &mesh.points {
        writeln!(out, "{x:?} {y:?} {z:?}")?;
    }
    write_cells(out, &mesh.cells)?;
    let markers = mesh.point_markers.as_deref();
    write_data(out, "POINT_DATA", count, &mesh.point_data, markers)?;
    let markers = mesh.cell_markers.as_deref();
    write_data(out, "CELL_DATA", mesh.cells.len(), &mesh.cell_data, markers)?;
    Ok(())
}

fn write_cells(out: &mut impl Write, cells: &Cells) -> io::Result<()> {
    let size = cells.len() + cells.corners().len();
    writeln!(out, "CELLS {} {size}", cells.len())?;
    for mut cell in cells.iter() {
        if let Cell::Wedge(corners) = &mut cell {
            turn_wedge(corners);
        }
        write!(out, "{}", cell.corners().len())?;
        for corner in cell.corners() {
            write!(out, " {corner}")?;
        }
        writeln!(out)?;
    }
    writeln!(out, "CELL_TYPES {}", cells.len())?;
    let mut kinds = cells.kinds().iter();
    kinds.try_for_each(|&kind| writeln!(out, "{}", vtk_type(kind)))
}

/// Writes markers and data as the arrays of one field, where there are some.
fn write_data(
    out: &mut impl Write,
    about: &str,
    rows: usize,
    arrays: &[DataArray],
    markers: Option<&[i32]>,
) -> io::Result<()> {
    let count = arrays.len() + markers.iter().len();
    if count == 0 {
        return Ok(());
    }
    writeln!(out, "{about} {rows}\nFIELD FieldData {count}")?;
    for array in arrays {
        let (name, components) = (encoded(&array.name), array.components);
        writeln!(out, "{name} {components} {rows} double")?;
        for row in array.values.chunks(components) {
            write_row(out, row)?;
        }
    }
    if let Some(markers) = markers {
        writeln!(out, "{MARKER} 1 {rows} int")?;
        let mut markers = markers.iter();
        markers.try_for_each(|marker| writeln!(out, "{marker}"))?;
    }
    Ok(())
}

fn write_row(out: &mut impl Write, row: &[f64]) -> io::Result<()> {
    for (index, value) in row.iter().enumerate() {
        let blank = if index == 0 { "" } else { " " };
        write!(out, "{blank}{value:?}")?;
    }
    writeln!(out)
}
