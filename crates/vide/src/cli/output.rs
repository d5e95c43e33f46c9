//! Output files: looked at before the work begins, so that a wrong name costs no time and leaves nothing half done.

use std::path::{Path, PathBuf};

use vide::mesh_io::{Format, WriteError, WriteProblem};

use super::failure::Failure;

/// Checks that every path names a format among `formats`, lies in a folder that exists, and is named once.
pub(crate) fn check_outputs(
    paths: &[PathBuf],
    formats: &[Format],
    what: &str,
) -> Result<(), Failure> {
    for (index, path) in paths.iter().enumerate() {
        let unknown = || WriteError::from(WriteProblem::UnknownFormat).in_file(path);
        let format = Format::from_path(path).ok_or_else(unknown)?;
        if !formats.contains(&format) {
            let problem = WriteProblem::Unsupported {
                format,
                what: what.to_owned(),
            };
            return Err(WriteError::from(problem).in_file(path).into());
        }
        if paths[..index].contains(path) {
            return Err(Failure::Output {
                path: path.clone(),
                problem: "named twice as an output",
            });
        }
        check_folder(path)?;
    }
    Ok(())
}

/// Checks that a file can lie where `path` says.
pub(crate) fn check_folder(path: &Path) -> Result<(), Failure> {
    let folder = match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    };
    let problem = if !folder.is_dir() {
        "the folder does not exist"
    } else if path.is_dir() {
        "is a folder"
    } else {
        return Ok(());
    };
    Err(Failure::Output {
        path: path.to_owned(),
        problem,
    })
}
