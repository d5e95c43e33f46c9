//! Writing a file as a whole or not at all.

use std::fs::File;
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use tempfile::NamedTempFile;

use crate::error::WriteError;

/// Bytes that are gathered before the operating system is asked to take them.
const BUFFER: usize = 1 << 18;

/// Lets `write` fill a file and puts it at `path` when all went well; otherwise `path` is left as it was.
///
/// The bytes go to a temporary file in the same folder, which is renamed at the end. A symbolic link stays, and what it leads to is
/// replaced. Into a device or a pipe the bytes are poured at the end.
///
/// # Errors
/// What `write` answers and what the operating system refuses, naming `path`.
pub fn write_atomically(
    path: &Path,
    write: impl FnOnce(&mut StagedWriter<'_>) -> Result<(), WriteError>,
) -> Result<(), WriteError> {
    Staged::fill(path, &mut |_| (), write)?.publish()
}

/// What a file is written through before it comes to its place.
pub type StagedWriter<'r> = BufWriter<Counted<'r>>;

/// A file that tells how many bytes each write adds.
pub struct Counted<'r> {
    file: File,
    report: &'r mut dyn FnMut(usize),
}

impl Write for Counted<'_> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let count = self.file.write(bytes)?;
        (self.report)(count);
        Ok(count)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.file.flush()
    }
}

/// A file that is written but not yet at its place.
pub(crate) struct Staged {
    file: NamedTempFile,
    target: Target,
    /// As the caller calls it.
    path: PathBuf,
}

/// How a file comes to its place.
enum Target {
    /// By renaming.
    File(PathBuf),
    /// Byte by byte: renaming would put a file in place of the device.
    Stream(PathBuf),
}

impl Target {
    fn of(path: &Path) -> Self {
        // What does not exist yet has no canonical path, and is no link.
        let path = path.canonicalize().unwrap_or_else(|_| path.to_owned());
        match path.metadata() {
            Ok(metadata) if !metadata.is_file() && !metadata.is_dir() => Self::Stream(path),
            _ => Self::File(path),
        }
    }

    fn new_file(&self) -> io::Result<NamedTempFile> {
        let Self::File(path) = self else {
            return NamedTempFile::new();
        };
        let folder = path
            .parent()
            .filter(|folder| !folder.as_os_str().is_empty());
        new_file(folder.unwrap_or(Path::new(".")))
    }
}

impl Staged {
    pub(crate) fn fill(
        path: &Path,
        report: &mut dyn FnMut(usize),
        write: impl FnOnce(&mut StagedWriter<'_>) -> Result<(), WriteError>,
    ) -> Result<Self, WriteError> {
        let target = Target::of(path);
        let fill = || {
            let file = target.new_file()?;
            let counted = Counted {
                file: file.as_file().try_clone()?,
                report,
            };
            let mut buffer = BufWriter::with_capacity(BUFFER, counted);
            write(&mut buffer)?;
            buffer.flush()?;
            Ok(file)
        };
        let file = fill().map_err(|error: WriteError| error.in_file(path))?;
        Ok(Self {
            file,
            target,
            path: path.to_owned(),
        })
    }

    /// Whether it will be poured into a device or a pipe, where that can still fail half way.
    pub(crate) const fn is_for_stream(&self) -> bool {
        matches!(self.target, Target::Stream(_))
    }

    pub(crate) fn publish(self) -> Result<(), WriteError> {
        let published = match &self.target {
            Target::File(target) => self
                .file
                .persist(target)
                .map(drop)
                .map_err(|error| error.error),
            Target::Stream(target) => pour(&self.file, target),
        };
        published.map_err(|error| WriteError::from(error).in_file(&self.path))
    }
}

fn pour(file: &NamedTempFile, target: &Path) -> io::Result<()> {
    let mut stream = File::options().write(true).open(target)?;
    io::copy(&mut file.reopen()?, &mut stream)?;
    Ok(())
}

#[cfg(unix)]
fn new_file(folder: &Path) -> io::Result<NamedTempFile> {
    use std::os::unix::fs::PermissionsExt;
    // Private by default; a mesh is as public as any other file its owner makes.
    tempfile::Builder::new()
        .permissions(std::fs::Permissions::from_mode(0o666))
        .tempfile_in(folder)
}

#[cfg(not(unix))]
fn new_file(folder: &Path) -> io::Result<NamedTempFile> {
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

    #[cfg(unix)]
    #[test]
    fn a_link_stays_and_its_target_is_replaced() {
        let folder = tempfile::tempdir().unwrap();
        let (file, link) = (
            folder.path().join("mesh.off"),
            folder.path().join("link.off"),
        );
        std::fs::write(&file, "old").unwrap();
        std::os::unix::fs::symlink(&file, &link).unwrap();
        write_atomically(&link, |out| Ok(out.write_all(b"new")?)).unwrap();
        assert!(std::fs::symlink_metadata(&link).unwrap().is_symlink());
        assert_eq!(std::fs::read(&file).unwrap(), b"new");
    }

    #[cfg(unix)]
    #[test]
    fn a_pipe_gets_the_bytes_and_stays_a_pipe() {
        use std::os::unix::fs::FileTypeExt;
        let folder = tempfile::tempdir().unwrap();
        let pipe = folder.path().join("pipe.off");
        assert!(
            std::process::Command::new("mkfifo")
                .arg(&pipe)
                .status()
                .unwrap()
                .success()
        );
        let reader = std::thread::spawn({
            let pipe = pipe.clone();
            move || std::fs::read(pipe)
        });
        write_atomically(&pipe, |out| Ok(out.write_all(b"OFF")?)).unwrap();
        assert!(std::fs::metadata(&pipe).unwrap().file_type().is_fifo());
        assert_eq!(reader.join().unwrap().unwrap(), b"OFF");
    }
}
