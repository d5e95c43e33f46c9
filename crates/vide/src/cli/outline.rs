//! What is given to be meshed, from files of several kinds: an outline in the plane, or a mesh in space.

use std::path::Path;

use vide::mesh_io::{Format, Mesh, PlanarGraph, ReadError, read_mesh, read_planar_graph};

/// What a file holds.
pub(crate) enum Given {
    /// Something flat, as its outline.
    Outline(PlanarGraph),
    /// Something of space.
    Mesh(Mesh),
}

/// Reads an outline, or a mesh; one at z = 0 is an outline too.
pub(crate) fn read_given(input: &Path) -> Result<Given, ReadError> {
    let format = Format::from_path(input);
    if matches!(
        format,
        Some(Format::TrianglePoly | Format::Svg | Format::GeoJson)
    ) {
        return read_planar_graph(input).map(Given::Outline);
    }
    match read_mesh(input) {
        Ok(mesh) if is_flat(&mesh) => match PlanarGraph::outline_of(&mesh) {
            Ok(outline) => Ok(Given::Outline(outline)),
            // As many points as that are no file's.
            Err(_) => Ok(Given::Mesh(mesh)),
        },
        Ok(mesh) => Ok(Given::Mesh(mesh)),
        // Faces of any number of corners are no cells, but they have an outline.
        Err(error) if format == Some(Format::Off) => read_planar_graph(input)
            .map(Given::Outline)
            .map_err(|_| error),
        Err(error) => Err(error),
    }
}

/// Whether a mesh is of the plane: there is something in it, all of it at z = 0 and nothing with a volume.
fn is_flat(mesh: &Mesh) -> bool {
    let flat = mesh.points.iter().all(|&[_, _, z]| z == 0.0);
    let mut kinds = mesh.cells.kinds().iter();
    flat && !mesh.cells.is_empty() && kinds.all(|kind| kind.dimension() < 3)
}
