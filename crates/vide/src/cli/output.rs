//! Output files: looked at before the work begins, so that a wrong name costs no time and leaves
//! nothing half done.

use std::path::{Path, PathBuf};

use vide::mesh_io::{Format, WriteError, WriteProblem};

use super::failure::Failure;

/// Checks that every path names a format among `formats`.
pub(crate) fn check_formats(
    paths: &[PathBuf],
    formats: &[Format],
    what: &str,
) -> Result<(), Failure> {
    for path in paths {
        let unknown = || WriteError::from(WriteProblem::UnknownFormat).in_file(path);
        let format = Format::from_path(path).ok_or_else(unknown)?;
        if !formats.contains(&format) {
            let problem = WriteProblem::Unsupported {
                format,
                what: what.to_owned(),
            };
            return Err(WriteError::from(problem).in_file(path).into());
        }
    }
    Ok(())
}

/// Checks that every output lies in a folder that exists, is named once, and is not the input.
pub(crate) fn check_places<'a>(
    input: &Path,
    outputs: impl IntoIterator<Item = &'a PathBuf>,
) -> Result<(), Failure> {
    let mut taken = vec![place(input)];
    for path in outputs {
        let failed = |problem| Failure::Output {
            path: path.clone(),
            problem,
        };
        check_folder(path).map_err(failed)?;
        let own = place(path);
        match taken.iter().position(|other| *other == own) {
            Some(0) => return Err(failed("is the input")),
            Some(_) => return Err(failed("named twice as an output")),
            None => taken.push(own),
        }
    }
    Ok(())
}

/// Where a file lies, however its folder is written.
fn place(path: &Path) -> PathBuf {
    let folder = folder(path);
    let folder = folder.canonicalize().unwrap_or_else(|_| folder.to_owned());
    path.file_name()
        .map_or(folder.clone(), |name| folder.join(name))
}

fn folder(path: &Path) -> &Path {
    match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    }
}

/// Checks that a file can lie where `path` says.
fn check_folder(path: &Path) -> Result<(), &'static str> {
    if !folder(path).is_dir() {
        Err("the folder does not exist")
    } else if path.is_dir() {
        Err("is a folder")
    } else {
        Ok(())
    }
}
