//! One mesh in one file, in a given format.

use std::io::Write;
use std::path::Path;

use crate::cell::Cell;
use crate::error::{WriteError, WriteProblem};
use crate::format::Format;
use crate::mesh::Mesh;
use crate::numbers::Encoding;
use crate::planar_graph::PlanarGraph;
use crate::{medit, msh, obj, off, ply, stl, triangle, vtk, vtu, xy};

/// Writes one file of a mesh.
pub(crate) fn write_as(
    out: &mut impl Write,
    format: Format,
    mesh: &Mesh,
) -> Result<(), WriteError> {
    match format {
        Format::Xy | Format::Xyz => xy::write(out, format, mesh),
        Format::Off => off::write(out, mesh),
        Format::Msh => msh::write(out, mesh, &[], Encoding::Ascii),
        Format::Medit => medit::write(out, mesh),
        Format::TrianglePoly => triangle::write_poly(out, &graph_of(mesh)?),
        Format::Vtu => vtu::write(out, mesh),
        Format::Vtk => vtk::write(out, mesh),
        Format::Ply => ply::write(out, mesh, Encoding::Binary),
        Format::Stl => stl::write(out, mesh, Encoding::Binary),
        Format::Obj => obj::write(out, mesh),
        _ => Err(unsupported(format, "a mesh")),
    }
}

/// The graph of a planar mesh that has only segments.
fn graph_of(mesh: &Mesh) -> Result<PlanarGraph, WriteError> {
    mesh.check()?;
    let refuse = |what: &str| unsupported(Format::TrianglePoly, what);
    let points = mesh
        .points
        .iter()
        .enumerate()
        .map(|(index, &[x, y, z])| match z {
            0.0 => Ok([x, y]),
            _ => Err(refuse(&format!("z = {z} of point {index}"))),
        });
    let segments = mesh
        .cells
        .iter()
        .enumerate()
        .map(|(index, cell)| match cell {
            Cell::Segment(ends) => Ok(ends),
            _ => Err(refuse(&format!("cell {index}, a {}", cell.kind().name()))),
        });
    Ok(PlanarGraph {
        points: points.collect::<Result<_, _>>()?,
        point_markers: mesh.point_markers.clone(),
        point_data: mesh.point_data.clone(),
        segments: segments.collect::<Result<_, _>>()?,
        segment_markers: mesh.cell_markers.clone(),
        ..PlanarGraph::default()
    })
}

pub(crate) fn format_of(path: &Path) -> Result<Format, WriteError> {
    Format::from_path(path)
        .ok_or_else(|| WriteError::from(WriteProblem::UnknownFormat).in_file(path))
}

pub(crate) fn unsupported(format: Format, what: &str) -> WriteError {
    WriteProblem::Unsupported {
        format,
        what: what.to_owned(),
    }
    .into()
}
