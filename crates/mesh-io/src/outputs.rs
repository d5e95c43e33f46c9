//! The files of one run, which appear together or not at all.

use std::path::{Path, PathBuf};

use crate::atomic::{Staged, StagedWriter};
use crate::block_mesh_dict::{self, Thickness};
use crate::blocks::StructuredBlocks;
use crate::error::WriteError;
use crate::format::Format;
use crate::mesh::Mesh;
use crate::numbers::Encoding;
use crate::write_as::{format_of, unsupported, write_as};
use crate::{connectivity_map, plot3d, triangle};

/// Files that are written beside their places, and put there when all are whole.
///
/// Dropped without [`Outputs::publish`], it leaves nothing behind. Once publishing has begun only the operating system can refuse a
/// renaming; the files renamed before it then stay.
///
/// ```
/// use mesh_io::{Mesh, Outputs};
///
/// let folder = tempfile::tempdir()?;
/// let mut bytes = 0;
/// let mut report = |written| bytes = written;
/// let mut outputs = Outputs::new(&mut report);
/// outputs.mesh(&folder.path().join("a.vtu"), &Mesh::default())?;
/// let failed = outputs.mesh(&folder.path().join("b.svg"), &Mesh::default());
/// assert!(failed.is_err());
/// drop(outputs);
/// assert_eq!(std::fs::read_dir(folder.path())?.count(), 0);
/// assert!(bytes > 0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct Outputs<'r> {
    staged: Vec<Staged>,
    bytes: u64,
    report: &'r mut dyn FnMut(u64),
}

impl<'r> Outputs<'r> {
    /// No files yet; `report` hears how many bytes are written in all, every quarter of a mebibyte.
    pub fn new(report: &'r mut dyn FnMut(u64)) -> Self {
        Self {
            staged: Vec::new(),
            bytes: 0,
            report,
        }
    }

    /// Writes a mesh in the format that its path names; cells are never left out, markers and data are where a format has no place
    /// for them.
    ///
    /// An `.ele` or a `.node` of a mesh with triangles is a pair of files: the other one is written beside it.
    ///
    /// # Errors
    /// A [`WriteError`] that names the file: the path names no format, the format cannot hold the cells, the mesh contradicts itself,
    /// the operating system refuses. O(mesh).
    pub fn mesh(&mut self, path: &Path, mesh: &Mesh) -> Result<(), WriteError> {
        let format = format_of(path)?;
        if !matches!(format, Format::TriangleNode | Format::TriangleEle) {
            return self.file(path, |out| write_as(out, format, mesh));
        }
        let (node, ele) = (path.with_extension("node"), path.with_extension("ele"));
        self.file(&node, |out| triangle::write_node(out, mesh))?;
        if format == Format::TriangleNode && mesh.cells.is_empty() {
            return Ok(());
        }
        self.file(&ele, |out| triangle::write_ele(out, mesh))
    }

    /// Writes structured blocks in a format that [`Format::holds_blocks`].
    ///
    /// Plot3D comes with a [`connectivity_map`] beside it.
    ///
    /// # Errors
    /// Like [`Outputs::mesh`]. O(nodes).
    pub fn blocks(&mut self, path: &Path, blocks: &StructuredBlocks) -> Result<(), WriteError> {
        let encoding = match format_of(path)? {
            Format::BlockMeshDict => {
                let write = |out: &mut StagedWriter<'_>| {
                    block_mesh_dict::write(out, blocks, Thickness::default())
                };
                return self.file(path, write);
            }
            Format::Plot3dAscii => Encoding::Ascii,
            Format::Plot3dBinary => Encoding::Binary,
            format => {
                return Err(unsupported(format, "structured blocks").in_file(path));
            }
        };
        let map = connectivity_map::path_beside(path);
        self.file(path, |out| plot3d::write(out, blocks, encoding))?;
        self.file(&map, |out| connectivity_map::write(out, blocks))
    }

    /// Lets `write` fill a file of any kind.
    ///
    /// # Errors
    /// What `write` answers and what the operating system refuses, naming `path`.
    pub fn file(
        &mut self,
        path: &Path,
        write: impl FnOnce(&mut StagedWriter<'_>) -> Result<(), WriteError>,
    ) -> Result<(), WriteError> {
        let (bytes, report) = (&mut self.bytes, &mut *self.report);
        let mut count = |more: usize| {
            *bytes += more as u64;
            report(*bytes);
        };
        self.staged.push(Staged::fill(path, &mut count, write)?);
        Ok(())
    }

    /// Puts all files at their places: into devices and pipes first, where writing can still fail, then by renaming.
    ///
    /// # Errors
    /// The first of them that the operating system refuses, naming the file.
    pub fn publish(self) -> Result<(), WriteError> {
        let (streams, files): (Vec<_>, Vec<_>) =
            self.staged.into_iter().partition(Staged::is_for_stream);
        let mut all = streams.into_iter().chain(files);
        all.try_for_each(Staged::publish)
    }
}

/// The file that [`Outputs`] writes beside `path`: elements beside points, points beside elements, a map beside Plot3D.
#[must_use]
pub fn companion(path: &Path) -> Option<PathBuf> {
    match Format::from_path(path)? {
        Format::TriangleNode => Some(path.with_extension("ele")),
        Format::TriangleEle => Some(path.with_extension("node")),
        Format::Plot3dAscii | Format::Plot3dBinary => Some(connectivity_map::path_beside(path)),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::io::Write as _;

    #[test]
    fn files_appear_together_and_not_before() {
        let folder = tempfile::tempdir().unwrap();
        let [a, b] = ["a.off", "b.xyz"].map(|name| folder.path().join(name));
        std::fs::write(&a, "old").unwrap();
        let mut silent = |_| ();
        let mut outputs = Outputs::new(&mut silent);
        outputs.mesh(&a, &Mesh::default()).unwrap();
        outputs
            .file(&b, |out| Ok(out.write_all(b"0 0 0\n")?))
            .unwrap();
        assert_eq!(std::fs::read(&a).unwrap(), b"old");
        assert!(!b.exists());
        outputs.publish().unwrap();
        assert_eq!(std::fs::read(&a).unwrap(), b"OFF\n0 0 0\n");
        assert!(b.exists());
        assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 2);
    }

    #[test]
    fn bytes_are_counted_over_all_files() {
        let folder = tempfile::tempdir().unwrap();
        let mut seen = Vec::new();
        let mut report = |bytes| seen.push(bytes);
        let mut outputs = Outputs::new(&mut report);
        for name in ["a", "b"] {
            outputs
                .file(
                    &folder.path().join(name),
                    |out| Ok(out.write_all(&[0; 10])?),
                )
                .unwrap();
        }
        outputs.publish().unwrap();
        assert_eq!(seen, [10, 20]);
    }
}
