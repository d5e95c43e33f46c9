//! Output files: looked at before the work begins, so that a wrong name costs no time and leaves
//! nothing half done; and written so that all of them appear or none.

use std::path::{Path, PathBuf};
use std::time::Instant;

use vide::mesh_io::{Format, Mesh, Outputs, WriteError, WriteProblem, companion};

use super::failure::Failure;
use super::progress::Watch;
use super::report::Report;

/// Checks that every path names a format among `formats`.
pub(crate) fn check_formats<'a>(
    paths: impl IntoIterator<Item = &'a PathBuf>,
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

/// Checks that every output lies in a folder that exists, is named once, and is not the input; and that
/// what is written beside `meshes` is neither the input nor one of `others`.
pub(crate) fn check_places<'a>(
    input: &Path,
    meshes: &'a [PathBuf],
    others: impl IntoIterator<Item = &'a PathBuf>,
) -> Result<(), Failure> {
    let mut taken = vec![place(input)];
    for path in others {
        take(path, &mut taken)?;
    }
    let not_meshes = taken.len();
    for path in meshes {
        take(path, &mut taken)?;
    }
    let mut beside = meshes.iter().filter_map(|path| companion(path));
    beside.try_for_each(|path| check_free(&path, &taken[..not_meshes]))
}

/// Checks that a file can lie where `path` says, and adds it to those that do.
fn take(path: &Path, taken: &mut Vec<PathBuf>) -> Result<(), Failure> {
    check_folder(path).map_err(|problem| failed(path, problem))?;
    check_free(path, taken)?;
    taken.push(place(path));
    Ok(())
}

/// Checks that a file is neither the input, which comes first, nor another output.
fn check_free(path: &Path, taken: &[PathBuf]) -> Result<(), Failure> {
    let own = place(path);
    match taken.iter().position(|other| *other == own) {
        Some(0) => Err(failed(path, "is the input")),
        Some(_) => Err(failed(path, "named twice as an output")),
        None => Ok(()),
    }
}

fn failed(path: &Path, problem: &'static str) -> Failure {
    Failure::Output {
        path: path.to_owned(),
        problem,
    }
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

/// Lets `write` make the output files, adds the report where one is asked for, and puts all of them at
/// their places.
pub(crate) fn write_together(
    mut watch: Watch,
    mut report: Report,
    report_path: Option<&Path>,
    write: impl FnOnce(&mut Outputs<'_>) -> Result<(), WriteError>,
) -> Result<(), Failure> {
    report.seconds = watch.seconds();
    let start = Instant::now();
    let mut written = |bytes| watch.written(bytes);
    let mut outputs = Outputs::new(&mut written);
    write(&mut outputs)?;
    let seconds = start.elapsed().as_secs_f64();
    report.seconds.insert("write".to_owned(), seconds);
    if let Some(path) = report_path {
        outputs.file(path, |out| report.write(out))?;
    }
    Ok(outputs.publish()?)
}

/// Writes a mesh, with the marked edges of its boundary where there are any and the format has a place for them.
pub(crate) fn write_marked(
    outputs: &mut Outputs<'_>,
    path: &Path,
    mesh: &Mesh,
    with_edges: Option<&Mesh>,
) -> Result<(), WriteError> {
    let has_place = matches!(
        Format::from_path(path),
        Some(Format::Vtu | Format::Vtk | Format::Msh | Format::Medit)
    );
    outputs.mesh(path, with_edges.filter(|_| has_place).unwrap_or(mesh))
}
