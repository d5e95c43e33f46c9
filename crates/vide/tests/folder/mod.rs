//! A folder in which the program runs.
#![allow(dead_code, reason = "every test uses some of it")]

use std::path::PathBuf;
use std::process::{Command, Output};

use tempfile::TempDir;

/// A folder with some files in it, in which the program runs.
pub(crate) struct Folder(TempDir);

impl Folder {
    /// A folder with these files.
    pub(crate) fn with<C: AsRef<[u8]>>(files: &[(&str, C)]) -> Self {
        let folder = Self(tempfile::tempdir().expect("a temporary folder can be made"));
        for (name, contents) in files {
            std::fs::write(folder.path(name), contents).expect("a file can be written");
        }
        folder
    }

    pub(crate) fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    pub(crate) fn vide(&self, arguments: &[&str]) -> Output {
        let program = Command::new(env!("CARGO_BIN_EXE_vide"))
            .current_dir(self.0.path())
            .args(arguments)
            .output();
        program.expect("the program can be started")
    }

    /// The error line of a run that must fail with exit code 1 and leave no new file behind.
    pub(crate) fn error(&self, arguments: &[&str]) -> String {
        let before = self.names();
        let output = self.vide(arguments);
        let error = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(1), "{arguments:?}: {error}");
        assert_eq!(error.lines().count(), 1, "{error}");
        assert_eq!(before, self.names(), "{arguments:?} left files behind");
        assert!(output.stdout.is_empty());
        error
    }

    pub(crate) fn names(&self) -> Vec<std::ffi::OsString> {
        let entries = std::fs::read_dir(self.0.path()).expect("the folder exists");
        let mut names: Vec<_> = entries.flatten().map(|entry| entry.file_name()).collect();
        names.sort();
        names
    }
}

/// What a program says.
pub(crate) fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}
