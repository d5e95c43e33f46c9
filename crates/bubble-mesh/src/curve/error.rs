//! What can be wrong with curves and with what is asked of them.

use delaunay_core::geo_predicates::CoordinateError;
use thiserror::Error;

/// Why something is no curve.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum CurveError {
    /// A coordinate is not accepted; points are counted as they are given.
    #[error(transparent)]
    Coordinate(#[from] CoordinateError),
    /// A radius is not accepted.
    #[error("the radius {radius:e} is not a number of 2^-142 to 2^201 (about 1.8e-43 to 3.2e60)")]
    Radius {
        /// As given.
        radius: f64,
    },
    /// An angle is not finite, or an arc goes round more than once.
    #[error("the angle {angle} is not finite, or more than a full turn")]
    Angle {
        /// As given, in radians.
        angle: f64,
    },
    /// A piece has no length.
    #[error("the piece has no length")]
    NoLength,
    /// The three points of an arc are on a line.
    #[error("no circle goes through three points on a line")]
    Straight,
    /// There are too few points.
    #[error("{count} points are given, at least {least} are needed")]
    TooFewPoints {
        /// Points given.
        count: usize,
        /// Points needed.
        least: usize,
    },
    /// Two consecutive points are at one place.
    #[error("point {index} is at the place of the point before it")]
    RepeatedPoint {
        /// The second of them; 0 when it is the last point that is at the place of the first.
        index: usize,
    },
    /// There are no pieces.
    #[error("the curve has no pieces")]
    Empty,
    /// A piece does not begin where the one before it ends.
    #[error("piece {piece} begins at a distance of {gap:e} from the end of the piece before it")]
    Apart {
        /// The second of them; 0 when it is the last piece that does not end where the first begins.
        piece: usize,
        /// How far apart they are.
        gap: f64,
    },
}

/// Why curves are not sampled.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum SamplingError {
    /// The longest edge is no length.
    #[error("the size {size} is not a finite number above 0")]
    Size {
        /// As given.
        size: f64,
    },
    /// The tolerance is no length.
    #[error("the distance {chord} between curve and chord is not a number above 0")]
    Chord {
        /// As given.
        chord: f64,
    },
    /// The gradation is none.
    #[error("the gradation {grade} is not a finite number above 0")]
    Grade {
        /// As given.
        grade: f64,
    },
    /// More nodes are needed than are allowed.
    #[error("more than {at_most} nodes are needed")]
    TooManyNodes {
        /// As given.
        at_most: usize,
    },
}
