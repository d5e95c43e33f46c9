//! What can be wrong with the input, by the element that is wrong.

use delaunay_core::{ConstrainError, RegionError, VertexId};
use thiserror::Error;

/// Why an outline bounds no region that can be meshed.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum DomainError {
    /// It comes with points inside, which no boundary edge gives a size.
    #[error("{vertex} is the end of no segment, so nothing says how large its bubble is")]
    InteriorPoint {
        /// The first such point.
        vertex: VertexId,
    },
    /// It bounds no region.
    #[error(transparent)]
    Region(#[from] RegionError),
}

/// Why a mesh is not optimized.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum OptimizeError {
    /// Radii can not be amplified so.
    #[error("the amplification {amplification} is not a number above 0 and up to 100")]
    Amplification {
        /// As given.
        amplification: f64,
    },
    /// Forces can not move nodes so.
    #[error("the step {step} is not a number from 0 to 1")]
    Step {
        /// As given.
        step: f64,
    },
    /// The moved nodes have no triangulation: the report closure stopped it. Nodes are moved so that nothing else happens.
    #[error("the moved nodes have no triangulation: {0}")]
    Triangulation(#[from] ConstrainError),
}
