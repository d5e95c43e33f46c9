//! What can be wrong with the input, by the node that is wrong.

use delaunay_core::BuildError;
use delaunay_core::geo_predicates::CoordinateError;
use thiserror::Error;

/// Why nodes are no closed boundary.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum BoundaryError {
    /// A coordinate is not accepted; the index in the error is that of the node.
    #[error(transparent)]
    Coordinate(#[from] CoordinateError),
    /// There are fewer than three nodes.
    #[error("{count} nodes do not make a closed boundary")]
    TooFewNodes {
        /// Nodes given.
        count: usize,
    },
    /// A node and the one that follows it are in one place, so their edge gives no size.
    #[error("boundary node {node} and the next one are in the same place")]
    RepeatedNode {
        /// Index of the node.
        node: usize,
    },
}

/// Why nodes do not bound a region that can be meshed.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum DomainError {
    /// They are no closed boundary.
    #[error(transparent)]
    Boundary(#[from] BoundaryError),
    /// They have no triangulation.
    #[error(transparent)]
    Build(#[from] BuildError),
    /// The boundary through them is not convex.
    #[error("the boundary is not convex at node {node}, or crosses itself there")]
    NotConvex {
        /// Index of the first node that is not on the convex hull, or not where the boundary has it.
        node: usize,
    },
}
