//! A change of the mesh that is planned: what goes, what comes, and how good it is.

use delaunay_core::{TetId, VertexId};
use glam::DVec3;

/// Tetrahedra to be replaced by others between the same vertices.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Exchange {
    pub(crate) gone: Vec<TetId>,
    /// Corners, right-handed.
    pub(crate) made: Vec<[VertexId; 4]>,
    /// The quality of the worst tetrahedron made.
    pub(crate) quality: f64,
}

/// A vertex to be inserted in the place of some tetrahedra.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Insertion {
    pub(crate) gone: Vec<TetId>,
    pub(crate) place: DVec3,
    pub(crate) quality: f64,
}

/// A vertex to be moved.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Move {
    pub(crate) vertex: VertexId,
    pub(crate) place: DVec3,
    pub(crate) quality: f64,
}
