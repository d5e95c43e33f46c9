//! Every invariant of a constrained triangulation, as a typed violation.

use super::triangulation::Constrained2;
use crate::ids::{FaceId, HalfEdgeId, VertexId};
use crate::tri::check::Violation;
use geo_predicates::{Sign, orient2d};
use thiserror::Error;

/// The first invariant found broken.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum ConstrainedViolation {
    /// The mesh is no mesh, or a triangle does not turn counterclockwise.
    #[error(transparent)]
    Mesh(#[from] Violation),
    /// The two sides of an edge have different segments.
    #[error("{half_edge} and its twin have different segments")]
    SegmentsDiffer {
        /// The half-edge.
        half_edge: HalfEdgeId,
    },
    /// The vertex across an edge without a segment is inside the circumcircle, ties broken.
    #[error(
        "{vertex} is inside the circumcircle of the face of {half_edge}, which no segment hides"
    )]
    NotDelaunay {
        /// The half-edge of the triangle.
        half_edge: HalfEdgeId,
        /// The vertex across it.
        vertex: VertexId,
    },
}

impl Constrained2 {
    /// Checks every invariant: those of the [mesh](crate::TriMesh::check), counterclockwise triangles, the same segment on both
    /// sides of an edge, and empty circumcircles across edges without segments.
    ///
    /// Together with the segments being edges they say that this is *the* constrained Delaunay triangulation. Takes linear
    /// time.
    ///
    /// # Errors
    /// The first [`ConstrainedViolation`], in the order above, then by id.
    pub fn check(&self) -> Result<(), ConstrainedViolation> {
        self.mesh.check()?;
        self.faces().try_for_each(|f| self.check_orientation(f))?;
        let mut half_edges = self.mesh.half_edges();
        half_edges.try_for_each(|half_edge| self.check_edge(half_edge))
    }

    fn check_orientation(&self, face: FaceId) -> Result<(), ConstrainedViolation> {
        let [a, b, c] = self.triangle(face);
        match orient2d(a, b, c) {
            Sign::Positive => Ok(()),
            _ => Err(Violation::Orientation { face }.into()),
        }
    }

    fn check_edge(&self, half_edge: HalfEdgeId) -> Result<(), ConstrainedViolation> {
        let twin = self.mesh.twin(half_edge);
        if self.labels[half_edge.index()] != self.labels[twin.index()] {
            return Err(ConstrainedViolation::SegmentsDiffer { half_edge });
        }
        let vertex = self.mesh.apex(twin);
        match !self.is_constrained(half_edge) && self.is_in_circle(half_edge) {
            true => Err(ConstrainedViolation::NotDelaunay { half_edge, vertex }),
            false => Ok(()),
        }
    }
}
