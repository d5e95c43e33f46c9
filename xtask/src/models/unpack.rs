//! Archives in archives are unpacked, and surfaces found in what was in them.

use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use super::client::run;

/// Archives in archives in archives, and no deeper.
const DEEPEST: usize = 3;

/// How an archive is unpacked, by its name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Archive {
    Zip,
    Tar,
    Deb,
    /// One compressed file.
    Single,
}

impl Archive {
    fn of(path: &Path) -> Option<Self> {
        let name = path.file_name()?.to_str()?.to_ascii_lowercase();
        let ends = |extensions: &[&str]| extensions.iter().any(|end| name.ends_with(end));
        if ends(&[".zip", ".whl"]) {
            Some(Self::Zip)
        } else if ends(&[".tar", ".tar.gz", ".tgz", ".tar.xz", ".tar.bz2"]) {
            Some(Self::Tar)
        } else if ends(&[".deb"]) {
            Some(Self::Deb)
        } else if ends(&[".stl.gz", ".off.gz", ".obj.gz", ".ply.gz"]) {
            Some(Self::Single)
        } else {
            None
        }
    }
}

/// Unpacks an archive into a new folder, and the archives in it beside themselves.
///
/// # Errors
/// It is no archive, or cannot be unpacked; of those in it nothing is expected.
pub(super) fn unpack(archive: &Path, folder: &Path) -> Result<(), Box<dyn Error>> {
    unpack_one(archive, folder)?;
    let mut done: Vec<PathBuf> = Vec::new();
    for _ in 1..DEEPEST {
        let inner = files(folder)?
            .into_iter()
            .filter(|path| Archive::of(path).is_some());
        let new: Vec<PathBuf> = inner.filter(|path| !done.contains(path)).collect();
        for path in new {
            // A broken one, made for tests of readers, is passed over.
            let _ = unpack_one(&path, &path.with_extension("unpacked"));
            done.push(path);
        }
    }
    Ok(())
}

fn unpack_one(archive: &Path, folder: &Path) -> Result<(), Box<dyn Error>> {
    let kind = Archive::of(archive).ok_or("the package is no archive")?;
    match kind {
        Archive::Single => return run(Command::new("gzip").args(["-d", "-k", "-f"]).arg(archive)),
        _ => fs::create_dir_all(folder)?,
    }
    match kind {
        Archive::Zip => run(Command::new("python3")
            .args(["-m", "zipfile", "-e"])
            .args([archive, folder])),
        Archive::Deb => run(Command::new("dpkg-deb").arg("-x").args([archive, folder])),
        _ => run(Command::new("tar")
            .arg("xf")
            .arg(archive)
            .arg("-C")
            .arg(folder)),
    }
}

/// All surfaces in a folder that are not larger than so many bytes, by path.
///
/// # Errors
/// A folder that cannot be read.
pub(super) fn surfaces(folder: &Path, largest: u64) -> Result<Vec<PathBuf>, Box<dyn Error>> {
    let is_surface = |path: &PathBuf| {
        let extension = path.extension().and_then(|extension| extension.to_str());
        let extension = extension.map(str::to_ascii_lowercase);
        let is_named =
            extension.is_some_and(|end| ["stl", "off", "obj", "ply"].contains(&end.as_str()));
        is_named && fs::metadata(path).is_ok_and(|data| (1..=largest).contains(&data.len()))
    };
    Ok(files(folder)?.into_iter().filter(is_surface).collect())
}

/// All files in a folder and those in it, by path; links are not followed.
fn files(folder: &Path) -> Result<Vec<PathBuf>, Box<dyn Error>> {
    let mut files = Vec::new();
    let mut left = vec![folder.to_owned()];
    while let Some(folder) = left.pop() {
        for entry in fs::read_dir(folder)? {
            let entry = entry?;
            let kind = entry.file_type()?;
            if kind.is_dir() {
                left.push(entry.path());
            } else if kind.is_file() {
                files.push(entry.path());
            }
        }
    }
    files.sort();
    Ok(files)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn archives_are_known_by_their_names() {
        let kind = |name: &str| Archive::of(Path::new(name));
        assert_eq!(kind("a/numpy-1.0-py3-none-any.whl"), Some(Archive::Zip));
        assert_eq!(kind("a/demo.TAR.GZ"), Some(Archive::Tar));
        assert_eq!(kind("a/dragon.ply.gz"), Some(Archive::Single));
        assert_eq!(kind("a/b_1.0_all.deb"), Some(Archive::Deb));
        assert_eq!(kind("a/changelog.gz"), None);
    }

    #[test]
    fn surfaces_are_found_in_archives_in_archives() {
        let folder = tempfile::tempdir().unwrap();
        let inner = folder.path().join("inner");
        fs::create_dir_all(&inner).unwrap();
        fs::write(inner.join("cube.OFF"), "OFF\n0 0 0\n").unwrap();
        fs::write(inner.join("large.stl"), vec![b' '; 100]).unwrap();
        fs::write(inner.join("notes.txt"), "no surface").unwrap();
        let tar = |archive: &str, what: &str| {
            run(Command::new("tar")
                .current_dir(folder.path())
                .args(["czf", archive, what]))
            .unwrap();
        };
        tar("inner.tgz", "inner");
        tar("outer.tgz", "inner.tgz");
        let unpacked = folder.path().join("unpacked");
        unpack(&folder.path().join("outer.tgz"), &unpacked).unwrap();
        let found = surfaces(&unpacked, 50).unwrap();
        assert_eq!(found.len(), 1);
        assert!(found[0].ends_with("inner/cube.OFF"));
    }
}
