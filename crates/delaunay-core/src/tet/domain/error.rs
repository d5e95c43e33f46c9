//! Why triangles are no domain.

use super::defects::DomainDefects;
use crate::progress::Cancelled;
use thiserror::Error;

/// Why triangles are no domain.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum DomainError {
    /// There are no triangles.
    #[error("the surface has no triangles")]
    Empty,
    /// There are more points than a triangulation can hold.
    #[error("{count} points are more than the {limit} that a triangulation can hold")]
    TooManyPoints {
        /// Points given.
        count: usize,
        /// Points possible.
        limit: usize,
    },
    /// There are more triangles than 32 bits can number.
    #[error("{count} triangles are more than the {limit} that can be told apart")]
    TooManyTriangles {
        /// Triangles given.
        count: usize,
        /// Triangles possible.
        limit: usize,
    },
    /// Something is wrong with points, triangles or edges; all of it is listed.
    #[error(transparent)]
    Defects(Box<DomainDefects>),
    /// The report closure stopped the work.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
}

impl DomainError {
    /// What is wrong with points, triangles and edges, if that is why.
    #[must_use]
    pub fn defects(&self) -> Option<&DomainDefects> {
        match self {
            Self::Defects(defects) => Some(defects),
            _ => None,
        }
    }
}

/// There are not as many markers as triangles.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[error("{markers} markers for {triangles} triangles")]
pub struct MarkerCount {
    /// Markers given.
    pub markers: usize,
    /// Triangles there are.
    pub triangles: usize,
}
