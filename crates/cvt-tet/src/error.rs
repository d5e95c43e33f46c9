//! What can go wrong, by the point it goes wrong with.

use delaunay_core::BuildError;
use glam::DVec2;
use thiserror::Error;

/// Why there is no tessellation of a region by the given points.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum GeneratorError {
    /// The region is an empty polygon.
    #[error("the region is empty")]
    EmptyRegion,
    /// A point lies outside the region.
    #[error("point {point} lies outside the region")]
    Outside {
        /// Index of the point.
        point: usize,
    },
    /// Two points are in the same place and would have to share a cell.
    #[error("points {first} and {second} are in the same place")]
    Repeated {
        /// Index of the first.
        first: usize,
        /// Index of the second.
        second: usize,
    },
    /// Put on the boundary, all points would lie on one line.
    #[error("on the boundary all points would lie on one line")]
    OnOneLine,
    /// The points have no Delaunay triangulation: a coordinate is not accepted, there are too many or they
    /// all lie on one line.
    #[error(transparent)]
    Build(#[from] BuildError),
}

/// A density that is not finite or not positive somewhere.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[error("the density at ({}, {}) is {value}, not a positive number", .at.x, .at.y)]
pub struct DensityError {
    /// Where the density was asked for.
    pub at: DVec2,
    /// What it answered.
    pub value: f64,
}
