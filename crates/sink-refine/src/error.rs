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
    /// The report closure stopped the work before it began.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
}
