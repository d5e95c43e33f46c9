//! Writing a file in the format that its path names.

use std::path::Path;

use crate::atomic::write_atomically;
use crate::blocks::StructuredBlocks;
use crate::circles::CirclesDomain;
use crate::error::{WriteError, WriteProblem};
use crate::format::Format;
use crate::mesh::Mesh;
use crate::numbers::Encoding;
use crate::{circles_toml, msh, off, xy};

/// Writes a mesh, as a whole or not at all. Cells are never left out; markers and data are where a format has no place for them.
///
/// An `.ele` or a `.node` of a mesh with triangles is a pair of files: the other one is written beside it.
///
/// # Errors
/// A [`WriteError`] that names the file: the path names no format, the format cannot hold the cells, the mesh contradicts itself,
/// the operating system refuses. O(mesh).
pub fn write_mesh(path: &Path, mesh: &Mesh) -> Result<(), WriteError> {
    let format = format_of(path)?;
    write_atomically(path, |out| match format {
        Format::Xy | Format::Xyz => xy::write(out, format, mesh),
        Format::Off => off::write(out, mesh),
        Format::Msh => msh::write(out, mesh, &[], Encoding::Ascii),
        _ => Err(unsupported(format, "a mesh")),
    })
}

/// Writes structured blocks, as a whole or not at all: as blocks where the format has them, as a mesh of quads elsewhere.
///
/// # Errors
/// Like [`write_mesh`]. O(nodes).
pub fn write_blocks(path: &Path, blocks: &StructuredBlocks) -> Result<(), WriteError> {
    match format_of(path)? {
        format @ (Format::Plot3dAscii | Format::Plot3dBinary | Format::BlockMeshDict) => {
            Err(unsupported(format, "structured blocks").in_file(path))
        }
        _ => {
            let mesh = blocks
                .to_mesh()
                .map_err(|defect| WriteError::from(defect).in_file(path))?;
            write_mesh(path, &mesh)
        }
    }
}

/// Writes circles as a `DOMAIN.toml`, as a whole or not at all.
///
/// # Errors
/// A [`WriteError`] that names the file, when the operating system refuses.
pub fn write_circles(path: &Path, domain: &CirclesDomain) -> Result<(), WriteError> {
    write_atomically(path, |out| circles_toml::write(out, domain))
}

fn format_of(path: &Path) -> Result<Format, WriteError> {
    Format::from_path(path)
        .ok_or_else(|| WriteError::from(WriteProblem::UnknownFormat).in_file(path))
}

fn unsupported(format: Format, what: &str) -> WriteError {
    WriteProblem::Unsupported {
        format,
        what: what.to_owned(),
    }
    .into()
}
