//! Why a mesh is not refined.

use delaunay_core::progress::Cancelled;
use thiserror::Error;

/// Why a mesh is not refined.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum RefineError {
    /// Below 1 no minimum separation holds and refinement might not end (§4.4).
    #[error("the ratio {ratio} is not a number from 1 on, below which refinement might not end")]
    Ratio {
        /// As given.
        ratio: f64,
    },
    /// The angle of [`Boundary::Split`](crate::Boundary::Split) is none.
    #[error("the crease angle {crease} is not a number of degrees from 0 to 180")]
    Crease {
        /// As given.
        crease: f64,
    },
    /// A region limit is no length.
    #[error("the size {size} of region {region} is not a number above zero")]
    RegionSize {
        /// Which of the limits, counted from 0.
        region: usize,
        /// As given.
        size: f64,
    },
    /// The seed of a region is in no element, or its coordinates are none that a point of a mesh may have.
    #[error("the point of region {region} is outside of the mesh")]
    RegionOutside {
        /// Which of the limits, counted from 0.
        region: usize,
    },
    /// The report closure stopped the work before it began.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
}
