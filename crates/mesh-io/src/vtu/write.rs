//! Writes a VTU.

use std::io::Write;

use super::MARKER;
use super::array::{Array, Values, Width};
use crate::error::{WriteError, WriteProblem};
use crate::format::Format;
use crate::mesh::{DataArray, Mesh};

/// Writes a mesh with its markers and data, so that reading gives the same bits. O(mesh), copying nothing but the corners of wedges.
///
/// # Errors
/// A mesh that contradicts itself ([`Mesh::check`]), a name with a control character, which XML has no place for, and what the
/// stream answers.
pub fn write(out: &mut impl Write, mesh: &Mesh) -> Result<(), WriteError> {
    mesh.check()?;
    check_names(mesh.point_data.iter().chain(&mesh.cell_data))?;
    let counts = (mesh.points.len(), mesh.cells.len());
    write_sections(out, counts, sections(mesh))
}

/// The elements of one piece, each with its arrays.
pub(super) type Sections<'a> = [(&'static str, Vec<Array<'a>>); 4];

/// Writes a file of one piece, of so many points and cells.
pub(super) fn write_sections(
    out: &mut impl Write,
    (points, cells): (usize, usize),
    sections: Sections<'_>,
) -> Result<(), WriteError> {
    out.write_all(
        b"<?xml version=\"1.0\"?>\n\
          <VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n\
          <UnstructuredGrid>\n",
    )?;
    writeln!(
        out,
        "<Piece NumberOfPoints=\"{points}\" NumberOfCells=\"{cells}\">"
    )?;
    for (element, arrays) in sections {
        writeln!(out, "<{element}>")?;
        arrays.iter().try_for_each(|array| array.write(out))?;
        writeln!(out, "</{element}>")?;
    }
    out.write_all(b"</Piece>\n</UnstructuredGrid>\n</VTKFile>\n")?;
    Ok(())
}

/// The arrays of the file, by the elements that hold them.
fn sections(mesh: &Mesh) -> Sections<'_> {
    let width = Width::for_numbers_to(mesh.cells.corners().len().max(mesh.points.len()));
    let array = |name, components, values| Array {
        name,
        components,
        values,
    };
    let cells = vec![
        array("connectivity", 1, Values::Corners(&mesh.cells, width)),
        array("offsets", 1, Values::Ends(&mesh.cells, width)),
        array("types", 1, Values::Types(&mesh.cells)),
    ];
    [
        (
            "PointData",
            data(&mesh.point_data, mesh.point_markers.as_deref()),
        ),
        (
            "CellData",
            data(&mesh.cell_data, mesh.cell_markers.as_deref()),
        ),
        (
            "Points",
            vec![array("Points", 3, Values::Points(&mesh.points))],
        ),
        ("Cells", cells),
    ]
}

pub(super) fn data<'a>(fields: &'a [DataArray], markers: Option<&'a [i32]>) -> Vec<Array<'a>> {
    let fields = fields.iter().map(|field| Array {
        name: &field.name,
        components: field.components,
        values: Values::Doubles(&field.values),
    });
    let markers = markers.map(|markers| Array {
        name: MARKER,
        components: 1,
        values: Values::Markers(markers),
    });
    fields.chain(markers).collect()
}

pub(super) fn check_names<'a>(
    fields: impl IntoIterator<Item = &'a DataArray>,
) -> Result<(), WriteError> {
    let mut names = fields.into_iter().map(|field| &field.name);
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
