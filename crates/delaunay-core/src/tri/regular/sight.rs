//! Weighted vertices as seen from a weighted point, with exact answers.

use super::Regular2;
use crate::ids::{FaceId, HalfEdgeId, VertexId};
use geo_predicates::{Sign, WeightedPoint2, orient2d, power_circle_perturbed};

/// A regular triangulation as seen from one of its points.
pub(super) struct PowerSight2<'a> {
    regular: &'a Regular2,
    from: WeightedPoint2,
}

impl<'a> PowerSight2<'a> {
    pub(super) fn new(regular: &'a Regular2, v: VertexId) -> Self {
        let from = regular.weighted(v);
        Self { regular, from }
    }

    /// The real face that contains the point, or a ghost strictly beyond whose hull edge it lies: a
    /// visibility walk from `start`.
    ///
    /// It ends for the reason given in [`locate`](crate::tri::locate), for weighted distances as well.
    pub(super) fn walk(&self, start: FaceId) -> FaceId {
        let mesh = &self.regular.mesh;
        let base = mesh.ghost_base(start);
        let mut face = base.map_or(start, |base| mesh.twin(base).face());
        let mut entry = None;
        while !mesh.is_ghost_face(face) {
            let beyond = |h: &HalfEdgeId| Some(*h) != entry && self.side(*h) == Sign::Negative;
            let Some(exit) = face.half_edges().into_iter().find(beyond) else {
                break;
            };
            let twin = mesh.twin(exit);
            (face, entry) = (twin.face(), Some(twin));
        }
        face
    }

    /// Whether the point is in conflict with the face `f`: its lift is below the plane of the lifted
    /// corners, ties broken.
    ///
    /// A ghost is in conflict with points outside its hull edge, and with those on the line of the edge
    /// that are in conflict with the triangle behind.
    pub(super) fn in_conflict(&self, f: FaceId) -> bool {
        let mesh = &self.regular.mesh;
        let Some(base) = mesh.ghost_base(f) else {
            return self.in_real_conflict(f);
        };
        match self.side(base) {
            Sign::Positive => true,
            Sign::Negative => false,
            Sign::Zero => self.in_real_conflict(mesh.twin(base).face()),
        }
    }

    /// Whether the point is in conflict with the triangle `f`.
    pub(super) fn in_real_conflict(&self, f: FaceId) -> bool {
        let corners = self.regular.mesh.face_vertices(f);
        let [a, b, c] = corners.map(|v| self.regular.weighted(v));
        power_circle_perturbed(a, b, c, self.from)
    }

    /// On which side of the half-edge between real vertices the point lies; `Positive` is the left.
    fn side(&self, h: HalfEdgeId) -> Sign {
        let ends = [self.regular.mesh.origin(h), self.regular.mesh.target(h)];
        let [a, b] = ends.map(|v| self.regular.coords[v.slot()]);
        orient2d(a, b, self.from.point)
    }
}

impl Regular2 {
    fn weighted(&self, v: VertexId) -> WeightedPoint2 {
        WeightedPoint2 {
            point: self.coords[v.slot()],
            weight: self.weights[v.slot()],
        }
    }
}
