//! What can be wrong with a file, and where.

use std::error::Error;
use std::fmt;
use std::io;
use std::path::{Path, PathBuf};

use crate::blocks::BlocksDefect;
use crate::mesh::{Axis, MeshDefect};
use crate::piecewise_complex::{ComplexDefect, NoTriangle};
use crate::points::OffPlane;
use crate::svg_outline::DrawingDefect;

/// Why a file could not be read. Prints as `file:line: problem`, on one line.
#[derive(Debug)]
pub struct ReadError {
    /// The file, where it is known.
    pub path: Option<PathBuf>,
    /// Where in it.
    pub place: Place,
    /// What is wrong there.
    pub problem: ReadProblem,
}

/// A place in a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    /// The file as a whole.
    File,
    /// A line, from 1.
    Line(usize),
    /// A byte, from 0.
    Byte(usize),
}

/// What is wrong in a file.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ReadProblem {
    /// The operating system refused.
    #[error("{0}")]
    Io(#[from] io::Error),
    /// Something else stands where a part of the format is due.
    #[error("expected {expected}, found {found}")]
    Expected {
        /// What is due, element and index included.
        expected: String,
        /// What stands there.
        found: String,
    },
    /// The file ends early.
    #[error("the file ends where {expected} should follow")]
    Truncated {
        /// What is due, element and index included.
        expected: String,
    },
    /// A coordinate is infinite or NaN.
    #[error("{element} {index}: {axis} is {value}, which is not a finite number")]
    NotFinite {
        /// What has the coordinate: point, hole, region.
        element: &'static str,
        /// Index of the element, from 0.
        index: usize,
        /// Which coordinate.
        axis: Axis,
        /// The offending value.
        value: f64,
    },
    /// The weight of a point is infinite or NaN.
    #[error("point {index}: the weight is {value}, which is not a finite number")]
    WeightNotFinite {
        /// Index of the point, from 0.
        index: usize,
        /// The offending value.
        value: f64,
    },
    /// An element names another that does not exist.
    #[error("{element} {index}: there is no {names} {found}")]
    NoSuch {
        /// What names something.
        element: &'static str,
        /// Its index, from 0.
        index: usize,
        /// What is named.
        names: &'static str,
        /// The number that names it, as the file counts.
        found: i64,
    },
    /// Two numbers that should agree do not.
    #[error("{what}: {claimed} announced, {found} found")]
    Count {
        /// What is counted.
        what: String,
        /// The number announced.
        claimed: u64,
        /// The number found.
        found: u64,
    },
    /// The last of the raw numbers make no whole point.
    #[error("{bytes} bytes are no whole number of points of {each} bytes each")]
    PartOfPoint {
        /// Bytes in the file.
        bytes: usize,
        /// Bytes per point.
        each: usize,
    },
    /// Raw numbers under a name that does not tell the dimension, and nobody else did.
    #[error(
        "how many coordinates a point has must be told, or the file called NAME.2d.f64 or NAME.3d.f64"
    )]
    NoDimension,
    /// There are no weights, but the caller wants some.
    #[error("the points have no weights: {expected} is missing")]
    NoWeights {
        /// What would hold them.
        expected: &'static str,
    },
    /// The file asks for more memory than one of its size may have.
    #[error("the arrays unpack to more than {limit} bytes, the most for a file of this size")]
    TooLarge {
        /// Bytes that all arrays together may have.
        limit: u64,
    },
    /// A device or a pipe does not end.
    #[error("a device or pipe that gives more than {limit} bytes")]
    TooLong {
        /// Bytes that are read at most from what is not a file.
        limit: u64,
    },
    /// The file is sound but uses a part of the format that is not read.
    #[error("{0} is not supported")]
    Unsupported(String),
    /// The path names no format.
    #[error(
        "no known format has this name; known are {}",
        crate::Format::EXTENSIONS
    )]
    UnknownFormat,
    /// The bytes are not text.
    #[error("not text in UTF-8")]
    NotText,
    /// Another library refused the syntax.
    #[error("{0}")]
    Syntax(String),
    /// The mesh contradicts itself.
    #[error(transparent)]
    Mesh(#[from] MeshDefect),
    /// The blocks contradict each other.
    #[error(transparent)]
    Blocks(#[from] BlocksDefect),
    /// The drawing makes no outlines.
    #[error(transparent)]
    Drawing(#[from] DrawingDefect),
    /// A point of space where points of the plane are needed.
    #[error(transparent)]
    OffPlane(#[from] OffPlane),
    /// A facet of a piecewise linear complex where triangles are needed.
    #[error(transparent)]
    NoTriangle(#[from] NoTriangle),
}

/// Why a file could not be written; a file of that name is then as it was before. Prints as `file: problem`, on one line.
#[derive(Debug)]
pub struct WriteError {
    /// The file, where it is known.
    pub path: Option<PathBuf>,
    /// What is wrong.
    pub problem: WriteProblem,
}

/// What prevents writing.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum WriteProblem {
    /// The operating system refused.
    #[error("{0}")]
    Io(#[from] io::Error),
    /// The format has no place for it.
    #[error("{format} cannot hold {what}")]
    Unsupported {
        /// Which format.
        format: crate::Format,
        /// What it cannot hold.
        what: String,
    },
    /// The path names no format.
    #[error(
        "no known format has this name; known are {}",
        crate::Format::EXTENSIONS
    )]
    UnknownFormat,
    /// A number is infinite or NaN.
    #[error("{element} {index}: {axis} is {value}, which is not a finite number")]
    NotFinite {
        /// What has the coordinate: point, hole, region.
        element: &'static str,
        /// Index of the element, from 0.
        index: usize,
        /// Which coordinate.
        axis: Axis,
        /// The offending value.
        value: f64,
    },
    /// An element names a point that does not exist.
    #[error("{element} {index}: there is no point {found}")]
    NoSuchPoint {
        /// What names a point.
        element: &'static str,
        /// Its index, from 0.
        index: usize,
        /// The index found.
        found: u32,
    },
    /// The mesh contradicts itself.
    #[error(transparent)]
    Mesh(#[from] MeshDefect),
    /// The blocks contradict each other.
    #[error(transparent)]
    Blocks(#[from] BlocksDefect),
    /// The complex contradicts itself.
    #[error(transparent)]
    Complex(#[from] ComplexDefect),
}

impl ReadError {
    /// A problem at a line, counted from 1.
    pub fn at_line(line: usize, problem: impl Into<ReadProblem>) -> Self {
        Self {
            path: None,
            place: Place::Line(line),
            problem: problem.into(),
        }
    }

    /// A problem at a byte, counted from 0.
    pub fn at_byte(byte: usize, problem: impl Into<ReadProblem>) -> Self {
        Self {
            path: None,
            place: Place::Byte(byte),
            problem: problem.into(),
        }
    }

    /// The same, naming the file.
    #[must_use]
    pub fn in_file(self, path: &Path) -> Self {
        Self {
            path: Some(self.path.unwrap_or_else(|| path.to_owned())),
            ..self
        }
    }
}

impl WriteError {
    /// The same, naming the file.
    #[must_use]
    pub fn in_file(self, path: &Path) -> Self {
        Self {
            path: Some(self.path.unwrap_or_else(|| path.to_owned())),
            ..self
        }
    }
}

impl<P: Into<ReadProblem>> From<P> for ReadError {
    fn from(problem: P) -> Self {
        Self {
            path: None,
            place: Place::File,
            problem: problem.into(),
        }
    }
}

impl<P: Into<WriteProblem>> From<P> for WriteError {
    fn from(problem: P) -> Self {
        Self {
            path: None,
            problem: problem.into(),
        }
    }
}

impl fmt::Display for ReadError {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match (&self.path, self.place) {
            (Some(path), Place::File) => write!(out, "{}: ", path.display())?,
            (Some(path), Place::Line(line)) => write!(out, "{}:{line}: ", path.display())?,
            (Some(path), Place::Byte(byte)) => write!(out, "{}: byte {byte}: ", path.display())?,
            (None, Place::File) => {}
            (None, Place::Line(line)) => write!(out, "line {line}: ")?,
            (None, Place::Byte(byte)) => write!(out, "byte {byte}: ")?,
        }
        write!(out, "{}", self.problem)
    }
}

impl fmt::Display for WriteError {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(path) = &self.path {
            write!(out, "{}: ", path.display())?;
        }
        write!(out, "{}", self.problem)
    }
}

impl Error for ReadError {
    fn source(&self) -> Option<&(dyn Error + 'static)> {
        self.problem.source()
    }
}

impl Error for WriteError {
    fn source(&self) -> Option<&(dyn Error + 'static)> {
        self.problem.source()
    }
}
