//! Point location: a visibility walk from a nearby tetrahedron.
//!
//! The walk crosses any facet that has the point strictly on its far side and stops in a tetrahedron
//! without such a facet, or when it leaves the hull. Signs are exact.
//!
//! **It ends**, for the reason given for the plane: the power of the point with respect to the
//! circumspheres falls at every step, because the triangulation is Delaunay, so no tetrahedron comes
//! twice.
//!
//! Without a hint the walk starts at a vertex of a sparse sample, see [`crate::guide`].

use super::delaunay::Delaunay3;
use super::mesh::{FACET_CORNERS, TetMesh};
use super::sight::Sight3;
use crate::ids::{FacetId, TetId, VertexId};
use geo_predicates::{CoordinateError, Sign};
use glam::DVec3;

/// Where a point is in a triangulation of space.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Location3 {
    /// Strictly inside a tetrahedron.
    Tet(TetId),
    /// On a facet, strictly inside it; this side of it bounds a real tetrahedron.
    Facet(FacetId),
    /// On an edge, strictly between its ends.
    Edge {
        /// A real tetrahedron with that edge.
        tet: TetId,
        /// The ends of the edge.
        ends: [VertexId; 2],
    },
    /// At a vertex.
    Vertex(VertexId),
    /// Outside the convex hull, strictly beyond this hull facet of a real tetrahedron.
    Outside(FacetId),
}

impl Location3 {
    /// A tetrahedron in the cavity of a new vertex here, or the vertex that is here already.
    pub(super) fn seed(self, mesh: &TetMesh) -> Result<TetId, VertexId> {
        match self {
            Self::Tet(tet) | Self::Edge { tet, .. } => Ok(tet),
            Self::Facet(f) => Ok(f.tet()),
            Self::Outside(f) => Ok(mesh.twin(f).tet()),
            Self::Vertex(v) => Err(v),
        }
    }
}

impl Delaunay3 {
    /// Where `p` is.
    ///
    /// Expected time log n: a tree over a sparse sample of the vertices tells where to start, and the walk from there
    /// takes a few steps; at most as many as there are tetrahedra. The tree is made by the first call, and by the
    /// first one after many changes, in n log n time.
    ///
    /// # Errors
    /// [`CoordinateError`] when a coordinate of `p` is not accepted.
    pub fn locate(&self, p: DVec3) -> Result<Location3, CoordinateError> {
        self.seat(p, None)
    }

    /// Where `p` is, by a walk from `hint`, a vertex near `p`.
    ///
    /// As [`locate`](Self::locate) when `hint` is not in the triangulation.
    ///
    /// # Errors
    /// [`CoordinateError`] when a coordinate of `p` is not accepted.
    pub fn locate_near(&self, p: DVec3, hint: VertexId) -> Result<Location3, CoordinateError> {
        self.seat(p, Some(hint))
    }

    pub(super) fn seat(
        &self,
        p: DVec3,
        hint: Option<VertexId>,
    ) -> Result<Location3, CoordinateError> {
        geo_predicates::check_point3(0, p)?;
        let hinted = hint.and_then(|v| self.mesh.home(v));
        let guided = || {
            let lives = |v| self.contains_vertex(v);
            self.mesh.home(self.guide.near(p, &self.coords, lives)?)
        };
        let start = hinted.or_else(guided);
        let start = start.or_else(|| self.mesh.tets().next());
        let sight = Sight3::new(self.coords.as_slice(), self.filter, p);
        Ok(walk(&self.mesh, &sight, start.unwrap_or(TetId::new(0))))
    }
}

/// Walks to the point of `sight` from `start`, real or ghost.
pub(super) fn walk(mesh: &TetMesh, sight: &Sight3<&[DVec3]>, start: TetId) -> Location3 {
    let mut tet = match mesh.is_ghost_tet(start) {
        true => mesh.neighbor(start, 3),
        false => start,
    };
    let mut entry = None;
    loop {
        let corners = mesh.tet_vertices(tet);
        // While the walk waits for the places of the corners, what comes next is on its way.
        for facet in tet.facets() {
            mesh.prefetch_tet(mesh.twin(facet).tet());
        }
        let seen = corners.map(|v| sight.see(v));
        let mut sides = [Sign::Negative; 4];
        let mut exit = None;
        for (facet, [a, b, c]) in tet.facets().into_iter().zip(FACET_CORNERS) {
            if Some(facet) == entry {
                continue;
            }
            let side = sight.seen_side(
                [corners[a], corners[b], corners[c]],
                [seen[a], seen[b], seen[c]],
            );
            sides[facet.corner()] = side;
            if side == Sign::Positive {
                exit = Some(facet);
                break;
            }
        }
        match exit.map(|facet| (facet, mesh.twin(facet))) {
            None => return settle(tet, corners, sides),
            Some((facet, twin)) if mesh.is_ghost_tet(twin.tet()) => {
                return Location3::Outside(facet);
            }
            Some((_, twin)) => {
                tet = twin.tet();
                entry = Some(twin);
            }
        }
    }
}

/// The location of a point beyond no facet, given its side of each.
fn settle(tet: TetId, corners: [VertexId; 4], sides: [Sign; 4]) -> Location3 {
    let on: Vec<usize> = (0..4).filter(|&i| sides[i] == Sign::Zero).collect();
    match on[..] {
        [] => Location3::Tet(tet),
        [i] => Location3::Facet(tet.facet(i)),
        [i, j] => {
            let k = (0..4).find(|k| ![i, j].contains(k)).unwrap_or(0);
            let ends = [corners[k], corners[6 - i - j - k]];
            Location3::Edge { tet, ends }
        }
        [i, j, k] => Location3::Vertex(corners[6 - i - j - k]),
        // A tetrahedron that is right-handed has no point on all four planes.
        _ => Location3::Tet(tet),
    }
}
