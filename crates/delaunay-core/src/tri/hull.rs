//! The convex hull: the edges on which the ghosts stand.

use super::mesh::TriMesh;
use crate::ids::{HalfEdgeId, VertexId};
use crate::tri::Delaunay2;

impl Delaunay2 {
    /// The half-edges of the convex hull, counterclockwise, each with a triangle on its left and a
    /// ghost on the other side.
    ///
    /// Vertices on the border of the hull are ends of hull edges even where they are no corners.
    #[must_use]
    pub fn hull(&self) -> Hull<'_> {
        let start = self
            .mesh
            .outgoing(VertexId::GHOST)
            .and_then(|h| self.mesh.ghost_base(h.face()))
            .map(|base| self.mesh.twin(base));
        Hull {
            mesh: &self.mesh,
            start,
            here: start,
        }
    }

    /// The vertices on the border of the convex hull, counterclockwise.
    pub fn hull_vertices(&self) -> impl Iterator<Item = VertexId> + Clone + '_ {
        self.hull().map(|h| self.mesh.origin(h))
    }
}

/// Iterator over the half-edges of the convex hull, see [`Delaunay2::hull`].
#[derive(Clone, Debug)]
pub struct Hull<'a> {
    mesh: &'a TriMesh,
    start: Option<HalfEdgeId>,
    here: Option<HalfEdgeId>,
}

impl Iterator for Hull<'_> {
    type Item = HalfEdgeId;

    fn next(&mut self) -> Option<HalfEdgeId> {
        let here = self.here?;
        let after = following(self.mesh, here);
        self.here = Some(after).filter(|_| Some(after) != self.start);
        Some(here)
    }
}

/// The hull half-edge that starts where the hull half-edge `h` ends: across two ghosts.
fn following(mesh: &TriMesh, h: HalfEdgeId) -> HalfEdgeId {
    let ghost = mesh.twin(h);
    let next_ghost = mesh.twin(ghost.prev());
    mesh.twin(next_ghost.prev())
}
