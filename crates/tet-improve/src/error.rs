//! Why a mesh is not improved.

use delaunay_core::progress::Cancelled;
use thiserror::Error;

/// Why a mesh is not improved.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum ImproveError {
    /// No tetrahedron has all dihedral angles between this and 180° less this, or all have.
    #[error("{angle} degrees are not an angle to ask for, above 0 and at most 70")]
    Angle {
        /// As given, degrees.
        angle: f64,
    },
    /// The report closure stopped the work before it began.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
}
