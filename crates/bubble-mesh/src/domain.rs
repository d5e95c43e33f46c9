//! What to mesh, judged once: a convex region given by the nodes of its boundary.

use delaunay_core::{Delaunay2, VertexId};
use glam::DVec2;

use crate::bubble::{Bubble, boundary_bubbles};
use crate::error::DomainError;

/// A convex region with refined boundary: its nodes, their bubbles and their triangulation, the initial boundary
/// mesh (§2.1).
///
/// In a convex region every boundary edge is an edge of the Delaunay triangulation of the nodes, and remains
/// one whatever nodes are put inside. So nothing has to be constrained.
#[derive(Clone, Debug)]
pub struct Domain {
    pub(crate) delaunay: Delaunay2,
    pub(crate) bubbles: Vec<Bubble>,
}

impl Domain {
    /// The region inside the closed boundary through `nodes`, in either sense; node i is vertex i.
    ///
    /// Nodes may divide a straight side if they are on it exactly. Takes the time of a Delaunay triangulation.
    ///
    /// # Errors
    /// [`DomainError`] when `nodes` are no closed boundary or not convex, with the node.
    pub fn convex(nodes: &[DVec2]) -> Result<Self, DomainError> {
        let bubbles = boundary_bubbles(nodes)?;
        let delaunay = Delaunay2::build(nodes)?;
        match misplaced(&delaunay, nodes.len()) {
            Some(node) => Err(DomainError::NotConvex { node }),
            None => Ok(Self { delaunay, bubbles }),
        }
    }

    /// The bubbles of the boundary nodes.
    #[must_use]
    pub fn bubbles(&self) -> &[Bubble] {
        &self.bubbles
    }

    /// The initial boundary mesh: the Delaunay triangulation of the boundary nodes.
    #[must_use]
    pub fn delaunay(&self) -> &Delaunay2 {
        &self.delaunay
    }
}

/// The first node that is not on the hull, or not beside its neighbors there.
fn misplaced(delaunay: &Delaunay2, count: usize) -> Option<usize> {
    let mesh = delaunay.mesh();
    let beside = |i: usize, j: usize| (i + 1) % count == j || (j + 1) % count == i;
    let inside = (0..count).find(|&node| !mesh.is_on_hull(VertexId::new(node)));
    inside.or_else(|| {
        let ends = delaunay
            .hull()
            .map(|h| [mesh.origin(h).index(), mesh.target(h).index()]);
        ends.filter(|&[i, j]| !beside(i, j))
            .map(|[i, j]| i.min(j))
            .min()
    })
}
