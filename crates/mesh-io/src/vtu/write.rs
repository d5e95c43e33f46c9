//! Writes a VTU.

use std::io::{self, Write};

use base64::engine::general_purpose::STANDARD;
use base64::write::EncoderWriter;
use quick_xml::escape::escape;

use super::{MARKER, turn_wedge, vtk_type};
use crate::cell::CellKind;
use crate::error::{WriteError, WriteProblem};
use crate::format::Format;
use crate::mesh::{DataArray, Mesh};

/// Writes a mesh with its markers and data, so that reading gives the same bits. O(mesh), copying nothing.
///
/// # Errors
/// A mesh that contradicts itself ([`Mesh::check`]), a name with a control character, which XML has no place for, and what the
/// stream answers.
pub fn write(out: &mut impl Write, mesh: &Mesh) -> Result<(), WriteError> {
    mesh.check()?;
    check_names(mesh)?;
    out.write_all(
        b"<?xml version=\"1.0\"?>\n\
          <VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n\
          <UnstructuredGrid>\n",
    )?;
    let (points, cells) = (mesh.points.len(), mesh.cells.len());
    writeln!(
        out,
        "<Piece NumberOfPoints=\"{points}\" NumberOfCells=\"{cells}\">"
    )?;
    write_data(
        out,
        "PointData",
        &mesh.point_data,
        mesh.point_markers.as_deref(),
    )?;
    write_data(
        out,
        "CellData",
        &mesh.cell_data,
        mesh.cell_markers.as_deref(),
    )?;
    out.write_all(b"<Points>\n")?;
    write_doubles(
        out,
        "Points",
        3,
        points * 3,
        mesh.points.iter().flatten().copied(),
    )?;
    out.write_all(b"</Points>\n<Cells>\n")?;
    write_array(
        out,
        "Int64",
        "connectivity",
        1,
        mesh.cells.corners().len() * 8,
        connectivity(mesh).map(|corner| i64::from(corner).to_le_bytes()),
    )?;
    write_array(
        out,
        "Int64",
        "offsets",
        1,
        cells * 8,
        ends(mesh).map(i64::to_le_bytes),
    )?;
    write_array(
        out,
        "UInt8",
        "types",
        1,
        cells,
        mesh.cells.kinds().iter().map(|&kind| [vtk_type(kind)]),
    )?;
    out.write_all(b"</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n")?;
    Ok(())
}

fn check_names(mesh: &Mesh) -> Result<(), WriteError> {
    let mut names = mesh
        .point_data
        .iter()
        .chain(&mesh.cell_data)
        .map(|data| &data.name);
    names
        .find(|name| name.contains(char::is_control))
        .map_or(Ok(()), |name| {
            let what = format!("the name {name:?}");
            Err(WriteProblem::Unsupported {
                format: Format::Vtu,
                what,
            }
            .into())
        })
}

/// The corners of all cells in VTK's order.
fn connectivity(mesh: &Mesh) -> impl Iterator<Item = u32> {
    mesh.cells.iter().flat_map(|cell| {
        let count = cell.corners().len();
        let mut corners = [0; 8];
        corners[..count].copy_from_slice(cell.corners());
        if cell.kind() == CellKind::Wedge {
            turn_wedge(&mut corners);
        }
        corners.into_iter().take(count)
    })
}

/// Where the corners of each cell end in the list of all corners.
fn ends(mesh: &Mesh) -> impl Iterator<Item = i64> {
    mesh.cells.kinds().iter().scan(0, |end, kind| {
        *end += kind.corner_count() as i64;
        Some(*end)
    })
}

fn write_data(
    out: &mut impl Write,
    element: &str,
    fields: &[DataArray],
    markers: Option<&[i32]>,
) -> io::Result<()> {
    writeln!(out, "<{element}>")?;
    for field in fields {
        write_doubles(
            out,
            &field.name,
            field.components,
            field.values.len(),
            field.values.iter().copied(),
        )?;
    }
    if let Some(markers) = markers {
        write_array(
            out,
            "Int32",
            MARKER,
            1,
            markers.len() * 4,
            markers.iter().map(|marker| marker.to_le_bytes()),
        )?;
    }
    writeln!(out, "</{element}>")
}

fn write_doubles(
    out: &mut impl Write,
    name: &str,
    components: usize,
    count: usize,
    values: impl Iterator<Item = f64>,
) -> io::Result<()> {
    write_array(
        out,
        "Float64",
        name,
        components,
        count * 8,
        values.map(f64::to_le_bytes),
    )
}

/// One `DataArray`: `size` bytes behind a header that says so, all in one run of base64.
fn write_array<const N: usize>(
    out: &mut impl Write,
    number: &str,
    name: &str,
    components: usize,
    size: usize,
    values: impl Iterator<Item = [u8; N]>,
) -> io::Result<()> {
    let name = escape(name);
    write!(out, "<DataArray type=\"{number}\" Name=\"{name}\"")?;
    if components != 1 {
        // Where it is written, some readers make a column of a scalar.
        write!(out, " NumberOfComponents=\"{components}\"")?;
    }
    out.write_all(b" format=\"binary\">\n")?;
    // Without the buffer the encoder would be asked for eight bytes at a time.
    let mut encoder =
        io::BufWriter::with_capacity(3 << 12, EncoderWriter::new(&mut *out, &STANDARD));
    encoder.write_all(&(size as u64).to_le_bytes())?;
    for value in values {
        encoder.write_all(&value)?;
    }
    encoder
        .into_inner()
        .map_err(io::IntoInnerError::into_error)?
        .finish()?;
    out.write_all(b"\n</DataArray>\n")
}
