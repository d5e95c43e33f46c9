//! Writing a file as a whole or not at all.

use std::fs::File;
use std::io::{BufWriter, Write};
use std::path::Path;

use tempfile::NamedTempFile;

use crate::error::WriteError;

/// Lets `write` fill a file and puts it at `path` when all went well; otherwise `path` is left as it was.
///
/// The bytes go to a temporary file in the same folder, which is renamed at the end.
///
/// # Errors
/// What `write` answers and what the operating system refuses, naming `path`.
pub fn write_atomically(
    path: &Path,
    write: impl FnOnce(&mut BufWriter<File>) -> Result<(), WriteError>,
) -> Result<(), WriteError> {
    Staged::fill(path, write)?.publish()
}

/// A file that is written but not yet at its place.
pub(crate) struct Staged<'p> {
    file: NamedTempFile,
    path: &'p Path,
}

impl<'p> Staged<'p> {
    pub(crate) fn fill(
        path: &'p Path,
        write: impl FnOnce(&mut BufWriter<File>) -> Result<(), WriteError>,
    ) -> Result<Self, WriteError> {
        let fill = || {
            let folder = path
                .parent()
                .filter(|folder| !folder.as_os_str().is_empty());
            let file = new_file(folder.unwrap_or(Path::new(".")))?;
            let mut buffer = BufWriter::new(file.as_file().try_clone()?);
            write(&mut buffer)?;
            buffer.flush()?;
            Ok(file)
        };
        let file = fill().map_err(|error: WriteError| error.in_file(path))?;
        Ok(Self { file, path })
    }

    pub(crate) fn publish(self) -> Result<(), WriteError> {
        self.file
            .persist(self.path)
            .map_err(|error| WriteError::from(error.error).in_file(self.path))?;
        Ok(())
    }
}

#[cfg(unix)]
fn new_file(folder: &Path) -> std::io::Result<NamedTempFile> {
    use std::os::unix::fs::PermissionsExt;
    // Private by default; a mesh is as public as any other file its owner makes.
    tempfile::Builder::new()
        .permissions(std::fs::Permissions::from_mode(0o666))
        .tempfile_in(folder)
}

#[cfg(not(unix))]
fn new_file(folder: &Path) -> std::io::Result<NamedTempFile> {
    NamedTempFile::new_in(folder)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::error::WriteProblem;

    #[test]
    fn a_failed_write_leaves_the_old_file_and_nothing_else() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("mesh.off");
        write_atomically(&path, |out| Ok(out.write_all(b"old")?)).unwrap();
        let failed = write_atomically(&path, |out| {
            out.write_all(b"half of the new")?;
            Err(WriteProblem::UnknownFormat.into())
        });
        assert!(
            failed
                .unwrap_err()
                .to_string()
                .contains("mesh.off: no known format")
        );
        assert_eq!(std::fs::read(&path).unwrap(), b"old");
        assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1);
    }

    #[test]
    fn a_folder_that_does_not_exist_is_named() {
        let error =
            write_atomically(Path::new("/no/such/folder/mesh.off"), |_| Ok(())).unwrap_err();
        assert!(
            error.to_string().starts_with("/no/such/folder/mesh.off: "),
            "{error}"
        );
    }
}
