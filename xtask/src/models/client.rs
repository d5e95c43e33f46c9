//! A package comes through its ordinary client.

use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use super::packages::{Client, Package};

/// The archive of a package, in the folder, which must have been empty.
///
/// # Errors
/// No such client on this machine, or no such package.
pub(super) fn fetch(package: &Package, folder: &Path) -> Result<PathBuf, Box<dyn Error>> {
    let name = package.name;
    let (program, arguments): (&str, Vec<&str>) = match package.client {
        Client::Pip => (
            "pip",
            vec!["download", "--no-deps", "--only-binary", name, name],
        ),
        Client::PipSource => (
            "pip",
            vec!["download", "--no-deps", "--no-binary", name, name],
        ),
        Client::Npm => ("npm", vec!["pack", name]),
        Client::Apt => ("apt-get", vec!["download", name]),
    };
    run(Command::new(program).args(arguments).current_dir(folder))?;
    let mut entries = fs::read_dir(folder)?;
    let entry = entries.next().ok_or("nothing came")??;
    Ok(entry.path())
}

/// Runs a program without a word.
///
/// # Errors
/// The program is not there, or fails.
pub(super) fn run(command: &mut Command) -> Result<(), Box<dyn Error>> {
    let program = command.get_program().to_string_lossy().into_owned();
    let quiet = command
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(Stdio::null());
    let status = quiet
        .status()
        .map_err(|error| format!("{program}: {error}"))?;
    if status.success() {
        Ok(())
    } else {
        Err(format!("{program} failed").into())
    }
}
