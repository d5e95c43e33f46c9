//! Weighted vertices as seen from a weighted point, with exact answers.

use super::Regular3;
use crate::ids::{TetId, VertexId};
use crate::tet::mesh::TetMesh;
use crate::tet::sight::Sight3;
use geo_predicates::filter::Filter3;
use geo_predicates::{Sign, WeightedPoint3, power_sphere_perturbed};

/// The vertices of a regular triangulation as seen from one of its points.
pub(super) struct PowerSight3<'a> {
    regular: &'a Regular3,
    from: WeightedPoint3,
}

impl<'a> PowerSight3<'a> {
    pub(super) fn new(regular: &'a Regular3, v: VertexId) -> Self {
        let from = regular.weighted(v);
        Self { regular, from }
    }

    /// What is seen of places, weights aside.
    pub(super) fn places(&self) -> Sight3<&'a [glam::DVec3]> {
        let coords = self.regular.coords.as_slice();
        Sight3::new(coords, Filter3::GENERAL, self.from.point)
    }

    /// Whether the point is in conflict with the tetrahedron `t`: its lift is below the hyperplane of the
    /// lifted corners, ties broken.
    ///
    /// A ghost is in conflict with points outside its hull facet, and with those in the plane of the
    /// facet that are in conflict with the tetrahedron behind.
    pub(super) fn in_conflict(&self, mesh: &TetMesh, t: TetId) -> bool {
        let [a, b, c, d] = mesh.tet_vertices(t);
        if d.is_ghost() {
            return match self.places().side([a, b, c]) {
                Sign::Positive => true,
                Sign::Negative => false,
                Sign::Zero => self.in_real_conflict(mesh.tet_vertices(mesh.neighbor(t, 3))),
            };
        }
        self.in_real_conflict([a, b, c, d])
    }

    /// Whether the point is in conflict with the tetrahedron of four real vertices.
    pub(super) fn in_real_conflict(&self, corners: [VertexId; 4]) -> bool {
        let [a, b, c, d] = corners.map(|v| self.regular.weighted(v));
        power_sphere_perturbed(a, b, c, d, self.from)
    }
}

impl Regular3 {
    fn weighted(&self, v: VertexId) -> WeightedPoint3 {
        WeightedPoint3 {
            point: self.coords[v.slot()],
            weight: self.weights[v.slot()],
        }
    }
}
