//! What can be wrong, each error naming the circle, the pair or the count that is at fault.

use std::fmt;

use delaunay_core::progress::Cancelled;
use thiserror::Error;

use crate::wall::WallName;

/// Most pairs of overlapping circles that an error lists: input of many equal circles has a
/// quadratic number of them.
pub const MAX_LISTED_DEFECTS: usize = 10_000;

/// One thing that is wrong with a domain.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum Defect {
    /// There is no hole: the medial axis of a disk is a point, of an empty rectangle nothing.
    #[error("there is no hole")]
    NoHoles,
    /// A centre is not finite, or larger than 2^201.
    #[error("{wall}: {axis} of the centre is {value:?}, not a usable number")]
    Center {
        /// The circle.
        wall: WallName,
        /// `x` or `y`.
        axis: char,
        /// The value given.
        value: f64,
    },
    /// A radius is not between 2^-142 and 2^201.
    #[error("{wall}: radius {radius:?} is not a usable positive number")]
    Radius {
        /// The circle.
        wall: WallName,
        /// The value given.
        radius: f64,
    },
    /// A radius is below 2^-36 of the largest coordinate: doubles do not tell points of the circle
    /// apart well enough.
    #[error("{wall}: radius {radius:?} is too small beside the coordinates to be resolved")]
    Tiny {
        /// The circle.
        wall: WallName,
        /// The value given.
        radius: f64,
    },
    /// A period is not between 2^-142 and 2^201.
    #[error("period {axis} is {value:?}, not a usable positive number")]
    Period {
        /// `x` or `y`.
        axis: char,
        /// The value given.
        value: f64,
    },
    /// Two holes are the same circle.
    #[error("{first} and {second} are the same circle")]
    Duplicate {
        /// The hole with the smaller index.
        first: WallName,
        /// The other hole.
        second: WallName,
    },
    /// Two holes overlap or touch: `gap` is negative or too small to be resolved.
    #[error("{first} and {second}{} overlap or touch (gap {gap:.3e})", Image(*shift))]
    Gap {
        /// The hole with the smaller index.
        first: WallName,
        /// The other hole.
        second: WallName,
        /// The periods by which the second hole is moved.
        shift: [i32; 2],
        /// Distance between the circles, negative when they overlap.
        gap: f64,
    },
    /// A hole is not inside the bounding circle, or touches it.
    #[error("{hole} is not inside the bounding circle (gap {gap:.3e})")]
    Outside {
        /// The hole.
        hole: WallName,
        /// Distance between the hole and the bounding circle, negative when the hole sticks out.
        gap: f64,
    },
}

/// Prints the image of a periodic pair, nothing for the hole itself.
struct Image([i32; 2]);

impl fmt::Display for Image {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0 {
            [0, 0] => Ok(()),
            [x, y] => write!(f, " (moved by {x}, {y} periods)"),
        }
    }
}

/// Why circles do not make a domain: all defects, in the order of the circles.
///
/// At most [`MAX_LISTED_DEFECTS`] are listed; the text shows the first five.
#[derive(Clone, Debug, PartialEq)]
pub struct DomainError {
    defects: Vec<Defect>,
}

impl DomainError {
    pub(crate) fn new(mut defects: Vec<Defect>) -> Self {
        defects.truncate(MAX_LISTED_DEFECTS);
        Self { defects }
    }

    /// Everything that is wrong, never empty.
    #[must_use]
    pub fn defects(&self) -> &[Defect] {
        &self.defects
    }
}

impl fmt::Display for DomainError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        const SHOWN: usize = 5;
        for (i, defect) in self.defects.iter().take(SHOWN).enumerate() {
            write!(f, "{}{defect}", if i > 0 { "; " } else { "" })?;
        }
        match self.defects.len() {
            more if more >= MAX_LISTED_DEFECTS => write!(f, "; and at least {} more", more - SHOWN),
            more if more > SHOWN => write!(f, "; and {} more", more - SHOWN),
            _ => Ok(()),
        }
    }
}

impl std::error::Error for DomainError {}

/// Why a domain could not be blocked or a blocking not meshed.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum BlockingError {
    /// The circles do not make a domain.
    #[error(transparent)]
    Domain(#[from] DomainError),
    /// Sampling did not come to an end: circles so close, or so unequal, that doubles do not tell
    /// their samples apart.
    #[error("the samples of the walls do not resolve the domain: circles too close or too unequal")]
    Unresolved,
    /// Tiny gaps, or a period very long beside its holes, ask for more samples and images of samples
    /// than the triangulation can number.
    #[error("the domain asks for more than {limit} boundary samples and images of samples")]
    TooManySamples {
        /// The largest number of samples.
        limit: usize,
    },
    /// A number of cells is zero.
    #[error("{what}: 0 cells asked for, at least 1 is needed")]
    NoCells {
        /// Where.
        what: String,
    },
    /// The target cell size is not a positive finite number.
    #[error("cell size {size:?} is not a positive finite number")]
    CellSize {
        /// The value given.
        size: f64,
    },
    /// The mesh would be larger than [`crate::MAX_CELLS`].
    #[error("the mesh would have {cells:.3e} cells, more than {limit}")]
    TooManyCells {
        /// The number asked for, rounded.
        cells: f64,
        /// The largest number allowed.
        limit: u64,
    },
    /// So few cells along an arc that one of them would span half a turn of a wall and fold.
    #[error("{cells} cells along arc {arc} are too few: a cell would fold round {wall}")]
    TooFewCells {
        /// The arc.
        arc: usize,
        /// Cells along it.
        cells: u32,
        /// The wall round which a cell folds.
        wall: WallName,
    },
    /// Cell counts were given for another number of arcs or walls.
    #[error("cell counts for {given} {what}, the blocking has {expected}")]
    CountsLength {
        /// `arcs` or `walls`.
        what: &'static str,
        /// Number of counts given.
        given: usize,
        /// Number of counts needed.
        expected: usize,
    },
    /// The progress callback asked to stop.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
}
