//! Writing a file in the format that its path names.

use std::path::Path;

use crate::atomic::write_atomically;
use crate::blocks::StructuredBlocks;
use crate::circles::CirclesDomain;
use crate::error::WriteError;
use crate::format::Format;
use crate::mesh::Mesh;
use crate::outputs::Outputs;
use crate::piecewise_complex::PiecewiseComplex;
use crate::planar_graph::PlanarGraph;
use crate::write_as::{format_of, unsupported};
use crate::{circles_toml, tetgen, triangle};

/// Writes a mesh, as a whole or not at all. Cells are never left out; markers and data are where a format has no place for them.
///
/// An `.ele` or a `.node` of a mesh with triangles is a pair of files: the other one is written beside it.
///
/// # Errors
/// A [`WriteError`] that names the file: the path names no format, the format cannot hold the cells, the mesh contradicts itself,
/// the operating system refuses. O(mesh).
pub fn write_mesh(path: &Path, mesh: &Mesh) -> Result<(), WriteError> {
    published(|outputs| outputs.mesh(path, mesh))
}

/// Writes structured blocks, as a whole or not at all: as blocks where the format has them, as a mesh of quads elsewhere.
///
/// Plot3D comes with a [`connectivity_map`](crate::connectivity_map) beside it.
///
/// # Errors
/// Like [`write_mesh`]. O(nodes).
pub fn write_blocks(path: &Path, blocks: &StructuredBlocks) -> Result<(), WriteError> {
    if format_of(path)?.holds_blocks() {
        return published(|outputs| outputs.blocks(path, blocks));
    }
    let mesh = blocks
        .to_mesh()
        .map_err(|defect| WriteError::from(defect).in_file(path))?;
    write_mesh(path, &mesh)
}

/// Writes circles as a `DOMAIN.toml`, as a whole or not at all.
///
/// # Errors
/// A [`WriteError`] that names the file, when the operating system refuses.
pub fn write_circles(path: &Path, domain: &CirclesDomain) -> Result<(), WriteError> {
    write_atomically(path, |out| circles_toml::write(out, domain))
}

/// Writes a planar straight-line graph as a `.poly`, as a whole or not at all.
///
/// # Errors
/// A [`WriteError`] that names the file: the path names another format, the graph contradicts itself, the operating system refuses.
pub fn write_planar_graph(path: &Path, graph: &PlanarGraph) -> Result<(), WriteError> {
    match format_of(path)? {
        Format::TrianglePoly => write_atomically(path, |out| triangle::write_poly(out, graph)),
        format => Err(unsupported(format, "a planar graph").in_file(path)),
    }
}

/// Writes a piecewise linear complex as a `.poly` of space, as a whole or not at all.
///
/// # Errors
/// A [`WriteError`] that names the file: the path names another format, the complex contradicts itself, the operating system refuses.
pub fn write_piecewise_complex(path: &Path, complex: &PiecewiseComplex) -> Result<(), WriteError> {
    match format_of(path)? {
        Format::TrianglePoly => write_atomically(path, |out| tetgen::write_poly(out, complex)),
        format => Err(unsupported(format, "a piecewise linear complex").in_file(path)),
    }
}

fn published(
    write: impl FnOnce(&mut Outputs<'_>) -> Result<(), WriteError>,
) -> Result<(), WriteError> {
    let mut silent = |_| ();
    let mut outputs = Outputs::new(&mut silent);
    write(&mut outputs)?;
    outputs.publish()
}
