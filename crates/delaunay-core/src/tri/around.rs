//! Iterators round a vertex: its star, its link, its neighbours.
//!
//! ```text
//!          l2 ---- l1        around(v): v->l0, v->l1, ... counterclockwise
//!         /  \    /  \       star(v):   the faces on their left
//!        /    \  /    \      link(v):   l0->l1, l1->l2, ... the far side of each face
//!      l3 ---- v ---- l0
//! ```

use super::mesh::TriMesh;
use crate::ids::{FaceId, HalfEdgeId, VertexId};

impl TriMesh {
    /// The half-edges that leave `v`, counterclockwise, from [`outgoing`](TriMesh::outgoing).
    ///
    /// Empty when `v` is not in the mesh. Round [`VertexId::GHOST`] they lead to the vertices of the
    /// hull, clockwise along it.
    #[must_use]
    pub fn around(&self, v: VertexId) -> Around<'_> {
        let start = self.outgoing(v);
        Around {
            mesh: self,
            start,
            here: start,
        }
    }

    /// The faces with corner `v`, counterclockwise.
    pub fn star(&self, v: VertexId) -> impl Iterator<Item = FaceId> + '_ {
        self.around(v).map(HalfEdgeId::face)
    }

    /// For each face of the star of `v` its half-edge opposite `v`, counterclockwise.
    pub fn link(&self, v: VertexId) -> impl Iterator<Item = HalfEdgeId> + '_ {
        self.around(v).map(HalfEdgeId::next)
    }

    /// The vertices that an edge joins to `v`, counterclockwise; the ghost is one of them when `v`
    /// is on the hull.
    pub fn neighbors(&self, v: VertexId) -> impl Iterator<Item = VertexId> + '_ {
        self.around(v).map(|h| self.target(h))
    }

    /// Whether `v` is a corner of a ghost face: a vertex on the border of the convex hull.
    ///
    /// Takes time proportional to the degree of `v`.
    #[must_use]
    pub fn is_on_hull(&self, v: VertexId) -> bool {
        self.neighbors(v).any(VertexId::is_ghost)
    }
}

/// Iterator over the half-edges that leave a vertex, see [`TriMesh::around`].
#[derive(Clone, Debug)]
pub struct Around<'a> {
    mesh: &'a TriMesh,
    start: Option<HalfEdgeId>,
    here: Option<HalfEdgeId>,
}

impl Iterator for Around<'_> {
    type Item = HalfEdgeId;

    fn next(&mut self) -> Option<HalfEdgeId> {
        let here = self.here?;
        let left = self.mesh.twin(here.prev());
        self.here = Some(left).filter(|_| Some(left) != self.start);
        Some(here)
    }
}
