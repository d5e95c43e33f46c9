//! Everything that ends the program with exit code 1, as one line that names file, line and
//! element.

use std::fmt::Display;
use std::path::{Path, PathBuf};

use vide::medial_blocking::{Defect, DomainError, WallName};
use vide::mesh_io::{CirclesDomain, ReadError, WriteError};

/// Why nothing was made.
#[derive(Debug, thiserror::Error)]
pub(crate) enum Failure {
    #[error(transparent)]
    Read(#[from] ReadError),
    #[error(transparent)]
    Write(#[from] WriteError),
    /// The contents of a file make no sense to a method.
    #[error("{}: {problem}", .path.display())]
    Input { path: PathBuf, problem: String },
    /// The same at a line of the file.
    #[error("{}:{line}: {problem}", .path.display())]
    InputLine {
        path: PathBuf,
        line: usize,
        problem: String,
    },
    #[error("cannot start threads: {0}")]
    Threads(#[from] rayon::ThreadPoolBuildError),
    #[error("{}: {problem}", .path.display())]
    Output {
        path: PathBuf,
        problem: &'static str,
    },
}

impl Failure {
    /// A method refused what `path` holds.
    pub(crate) fn input(path: &Path, problem: impl Display) -> Self {
        Self::Input {
            path: path.to_owned(),
            problem: problem.to_string(),
        }
    }

    /// Circles that make no domain, at the line of the first one to blame.
    pub(crate) fn domain(path: &Path, circles: &CirclesDomain, error: &DomainError) -> Self {
        let blamed = error.defects().first().and_then(blamed_hole);
        let line = blamed.and_then(|hole| circles.holes.get(hole)?.line);
        match line {
            Some(line) => Self::InputLine {
                path: path.to_owned(),
                line,
                problem: error.to_string(),
            },
            None => Self::input(path, error),
        }
    }
}

/// The hole that a defect is about; of two the later one, which is the one that did not fit.
fn blamed_hole(defect: &Defect) -> Option<usize> {
    let wall = match *defect {
        Defect::Center { wall, .. } | Defect::Radius { wall, .. } | Defect::Tiny { wall, .. } => {
            wall
        }
        Defect::Duplicate { second, .. } | Defect::Gap { second, .. } => second,
        Defect::Outside { hole, .. } => hole,
        Defect::NoHoles | Defect::Period { .. } => return None,
    };
    match wall {
        WallName::Hole(index) => Some(index),
        WallName::Bounding => None,
    }
}
