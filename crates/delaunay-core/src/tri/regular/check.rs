//! Every invariant of a regular triangulation, as a typed [`RegularViolation2`].

use super::Regular2;
use super::sight::PowerSight2;
use crate::ids::{FaceId, HalfEdgeId, VertexId};
use crate::tri::check::Violation;
use crate::tri::sight::precedes;
use geo_predicates::{Sign, orient2d};
use thiserror::Error;

/// The first invariant found broken.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum RegularViolation2 {
    /// The mesh is broken, a triangle not counterclockwise or the hull not convex.
    #[error(transparent)]
    Mesh(#[from] Violation),
    /// The lifted vertex across an edge is below the plane of the lifted triangle, ties broken.
    #[error("{vertex} is in conflict with the face of {half_edge}")]
    NotRegular {
        /// The half-edge of the triangle.
        half_edge: HalfEdgeId,
        /// The vertex across it.
        vertex: VertexId,
    },
    /// A point outside the triangulation would be a vertex if it were inserted.
    #[error("{vertex} is missing in the triangulation")]
    NotHidden {
        /// The point.
        vertex: VertexId,
    },
}

impl Regular2 {
    /// Checks every invariant: those of the [mesh](crate::TriMesh::check), 2 n - 2 faces, counterclockwise
    /// triangles, a convex hull, locally regular edges with the tie rule, and that hidden points are
    /// where they would change nothing.
    ///
    /// Together they say that this is *the* regular triangulation of its points. Takes linear time, and
    /// a walk for each hidden point.
    ///
    /// # Errors
    /// The first [`RegularViolation2`], in the order above, then by id.
    pub fn check(&self) -> Result<(), RegularViolation2> {
        self.mesh.check()?;
        let (vertices, faces) = (self.vertex_count(), self.mesh.face_count());
        if faces + 2 != 2 * vertices {
            return Err(Violation::Euler { vertices, faces }.into());
        }
        self.faces().try_for_each(|f| self.check_orientation(f))?;
        self.mesh.faces().try_for_each(|f| self.check_hull(f))?;
        self.mesh
            .half_edges()
            .try_for_each(|h| self.check_edge(h))?;
        let mut start = FaceId::new(0);
        for &vertex in &self.hidden {
            let sight = PowerSight2::new(self, vertex);
            start = sight.walk(start);
            if sight.in_conflict(start) {
                return Err(RegularViolation2::NotHidden { vertex });
            }
        }
        Ok(())
    }

    fn check_orientation(&self, face: FaceId) -> Result<(), Violation> {
        let [a, b, c] = self.triangle(face);
        match orient2d(a, b, c) {
            Sign::Positive => Ok(()),
            _ => Err(Violation::Orientation { face }),
        }
    }

    /// Checks that the hull does not turn outwards, nor back, after the hull edge of the ghost `f`.
    fn check_hull(&self, f: FaceId) -> Result<(), Violation> {
        let Some(base) = self.mesh.ghost_base(f) else {
            return Ok(());
        };
        // The hull is on the right of the base of a ghost, so the bases follow it clockwise.
        let after = self.mesh.twin(base.next()).next();
        let ends = [
            self.mesh.origin(base),
            self.mesh.origin(after),
            self.mesh.target(after),
        ];
        let [a, b, c] = ends.map(|v| self.point(v));
        let straight_on = precedes(a, b) == precedes(b, c);
        match orient2d(a, b, c) {
            Sign::Negative => Ok(()),
            Sign::Zero if straight_on => Ok(()),
            _ => Err(Violation::HullNotConvex {
                half_edge: self.mesh.twin(after),
            }),
        }
    }

    fn check_edge(&self, half_edge: HalfEdgeId) -> Result<(), RegularViolation2> {
        let vertex = self.mesh.apex(self.mesh.twin(half_edge));
        let face = half_edge.face();
        let real = !vertex.is_ghost() && !self.mesh.is_ghost_face(face);
        match real && PowerSight2::new(self, vertex).in_real_conflict(face) {
            true => Err(RegularViolation2::NotRegular { half_edge, vertex }),
            false => Ok(()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec2;

    fn square(center_weight: f64) -> Regular2 {
        let points = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [1.0, 0.5]];
        let weights = [0.0, 0.0, 0.0, 0.0, center_weight];
        Regular2::build(&points.map(DVec2::from), &weights).unwrap()
    }

    #[test]
    fn weights_that_no_longer_fit_are_found() {
        let center = VertexId::new(4);
        let mut hidden = square(-9.0);
        assert_eq!((hidden.hidden(), hidden.check()), (&[center][..], Ok(())));
        hidden.weights[center.slot()] = 0.0;
        let missing = RegularViolation2::NotHidden { vertex: center };
        assert_eq!(hidden.check(), Err(missing));

        let mut seen = square(0.0);
        assert_eq!((seen.hidden().len(), seen.check()), (0, Ok(())));
        seen.weights[center.slot()] = -9.0;
        assert!(matches!(
            seen.check(),
            Err(RegularViolation2::NotRegular { .. })
        ));
    }

    #[test]
    fn a_vertex_that_leaves_its_place_is_found() {
        let mut regular = square(0.0);
        regular.coords[1] = DVec2::splat(3.0);
        let found = regular.check();
        assert!(
            matches!(found, Err(RegularViolation2::Mesh(_))),
            "{found:?}"
        );
    }
}
