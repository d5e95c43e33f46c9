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
    for (element, arrays) in sections(mesh) {
        writeln!(out, "<{element}>")?;
        arrays.iter().try_for_each(|array| array.write(out))?;
        writeln!(out, "</{element}>")?;
    }
    out.write_all(b"</Piece>\n</UnstructuredGrid>\n</VTKFile>\n")?;
    Ok(())
}

/// The arrays of the file, by the elements that hold them.
fn sections(mesh: &Mesh) -> [(&'static str, Vec<Array<'_>>); 4] {
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

fn data<'a>(fields: &'a [DataArray], markers: Option<&'a [i32]>) -> Vec<Array<'a>> {
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
