//! Point location: a visibility walk from a nearby triangle.
//!
//! The walk crosses any edge that has the point strictly on its far side and stops in a triangle
//! without such an edge, or when it leaves the hull. Signs are exact.
//!
//! **It ends.** Let the power of `p` with respect to a triangle be its squared distance from the
//! circumcenter less the squared circumradius. Two triangles glued along an edge have equal powers
//! on the line of that edge, and because the triangulation is Delaunay the power of the farther
//! triangle is the smaller one for every `p` strictly beyond the edge (not greater; with ties broken
//! by raising the lifted points, strictly smaller). So the power falls at every step, no triangle
//! comes twice, and the walk takes at most as many steps as there are triangles. On uniform points
//! in insertion order it takes about one.
//!
//! Without a hint the walk starts at a vertex of a sparse sample, see [`crate::guide`].

use super::delaunay::Delaunay2;
use crate::ids::{FaceId, HalfEdgeId, VertexId};
use geo_predicates::{CoordinateError, Sign};
use glam::DVec2;

/// Where a point is in a triangulation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Location {
    /// Strictly inside a triangle.
    Face(FaceId),
    /// On an edge, strictly between its ends; the half-edge has a triangle on its left.
    Edge(HalfEdgeId),
    /// At a vertex.
    Vertex(VertexId),
    /// Outside the convex hull, strictly on the right of this counterclockwise hull half-edge.
    Outside(HalfEdgeId),
}

impl Delaunay2 {
    /// Where `p` is.
    ///
    /// Expected time log n: a tree over a sparse sample of the vertices tells where to start, and the walk from there
    /// takes a few steps; at most as many as there are triangles. The tree is made by the first call, and by the
    /// first one after many changes, in n log n time.
    ///
    /// # Errors
    /// [`CoordinateError`] when a coordinate of `p` is not accepted.
    pub fn locate(&self, p: DVec2) -> Result<Location, CoordinateError> {
        self.seat(p, None)
    }

    /// Where `p` is, by a walk from `hint`, a vertex near `p`.
    ///
    /// As [`locate`](Self::locate) when `hint` is not in the triangulation.
    ///
    /// # Errors
    /// [`CoordinateError`] when a coordinate of `p` is not accepted.
    pub fn locate_near(&self, p: DVec2, hint: VertexId) -> Result<Location, CoordinateError> {
        self.seat(p, Some(hint))
    }

    pub(super) fn seat(
        &self,
        p: DVec2,
        hint: Option<VertexId>,
    ) -> Result<Location, CoordinateError> {
        geo_predicates::check_point2(0, p)?;
        let hinted = hint.and_then(|v| self.mesh.outgoing(v));
        let guided = || {
            let lives = |v| self.contains_vertex(v);
            self.mesh.outgoing(self.guide.near(p, &self.coords, lives)?)
        };
        let start = hinted.or_else(guided);
        Ok(self.walk(p, self.real_side(start.unwrap_or(HalfEdgeId::new(0)))))
    }

    /// `h`, or a half-edge of a triangle beside it when `h` bounds a ghost face.
    pub(super) fn real_side(&self, h: HalfEdgeId) -> HalfEdgeId {
        let base = self.mesh.ghost_base(h.face());
        base.map_or(h, |base| self.mesh.twin(base))
    }

    /// Walks to `p` from `start`, a half-edge of a real face; its edge is tested first.
    #[inline]
    pub(super) fn walk(&self, p: DVec2, start: HalfEdgeId) -> Location {
        let sight = self.sight(p);
        let mut entry = start;
        let mut from = sight.see(self.mesh.origin(entry));
        let mut to = sight.see(self.mesh.target(entry));
        let mut side = sight.side(&from, &to);
        if side == Sign::Negative {
            entry = self.mesh.twin(entry);
            side = Sign::Positive;
            std::mem::swap(&mut from, &mut to);
        }
        loop {
            let apex = self.mesh.apex(entry);
            if apex.is_ghost() {
                return Location::Outside(self.mesh.twin(entry));
            }
            let apex = sight.see(apex);
            let ahead = sight.side(&to, &apex);
            if ahead == Sign::Negative {
                entry = self.mesh.twin(entry.next());
                from = apex;
            } else {
                let behind = sight.side(&apex, &from);
                if behind != Sign::Negative {
                    return self.settle(entry, [side, ahead, behind]);
                }
                entry = self.mesh.twin(entry.prev());
                to = apex;
            }
            side = Sign::Positive;
        }
    }

    /// The location of a point on no far side of the face of `h`, given its sides of `h`, of the
    /// half-edge after and of the one before.
    fn settle(&self, h: HalfEdgeId, sides: [Sign; 3]) -> Location {
        match sides.map(|side| side == Sign::Zero) {
            [false, false, false] => Location::Face(h.face()),
            [true, true, _] => Location::Vertex(self.mesh.target(h)),
            [_, true, true] => Location::Vertex(self.mesh.apex(h)),
            [true, _, true] => Location::Vertex(self.mesh.origin(h)),
            [true, _, _] => Location::Edge(h),
            [_, true, _] => Location::Edge(h.next()),
            [_, _, true] => Location::Edge(h.prev()),
        }
    }
}
