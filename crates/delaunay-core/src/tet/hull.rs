//! The convex hull: the facets on which the ghosts stand.

use super::delaunay::Delaunay3;
use crate::ids::{FacetId, VertexId};

impl Delaunay3 {
    /// The facets of the convex hull, each by the side that bounds a real tetrahedron, by id of the
    /// ghost beyond.
    ///
    /// Takes time linear in the size of the hull, once for all it gives.
    pub fn hull(&self) -> impl Iterator<Item = FacetId> + '_ {
        let mut facets: Vec<FacetId> = self.mesh.link(VertexId::GHOST).collect();
        facets.sort_unstable();
        facets.into_iter().map(|f| self.mesh.twin(f))
    }

    /// The vertices on the convex hull, by id; those inside its facets and edges included.
    #[must_use]
    pub fn hull_vertices(&self) -> Vec<VertexId> {
        let mut vertices: Vec<VertexId> = self.mesh.neighbors(VertexId::GHOST).collect();
        vertices.sort_unstable();
        vertices
    }
}
