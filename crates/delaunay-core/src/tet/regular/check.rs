//! Every invariant of a regular triangulation, as a typed [`RegularViolation3`].

use super::Regular3;
use super::sight::PowerSight3;
use crate::ids::{FacetId, TetId, VertexId};
use crate::tet::check::Violation3;
use crate::tet::locate::walk;
use thiserror::Error;

/// The first invariant found broken.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum RegularViolation3 {
    /// The mesh is broken, a tetrahedron not right-handed or the hull not convex.
    #[error(transparent)]
    Mesh(#[from] Violation3),
    /// The lifted vertex across a facet is below the hyperplane of the lifted tetrahedron, ties broken.
    #[error("{vertex} is in conflict with the tetrahedron of {facet}")]
    NotRegular {
        /// The facet of the tetrahedron.
        facet: FacetId,
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

impl Regular3 {
    /// Checks every invariant: those of the [mesh](crate::TetMesh::check), the Euler characteristic of a
    /// closed space, right-handed tetrahedra, a convex hull, locally regular facets with the tie rule, and
    /// that hidden points are where they would change nothing.
    ///
    /// Together they say that this is *the* regular triangulation of its points. Takes linear time, and
    /// a walk for each hidden point.
    ///
    /// # Errors
    /// The first [`RegularViolation3`], in the order above, then by id.
    pub fn check(&self) -> Result<(), RegularViolation3> {
        self.mesh
            .check_embedding(&self.coords, self.vertex_count())?;
        let mut facets = self.tets().flat_map(TetId::facets);
        facets.try_for_each(|f| self.check_facet(f))?;
        let mut start = self.tets().next().unwrap_or(TetId::new(0));
        for &vertex in &self.hidden {
            let sight = PowerSight3::new(self, vertex);
            let seed = walk(&self.mesh, &sight.places(), start).seed(&self.mesh);
            match seed {
                Ok(tet) if !sight.in_conflict(&self.mesh, tet) => start = tet,
                _ => return Err(RegularViolation3::NotHidden { vertex }),
            }
        }
        Ok(())
    }

    fn check_facet(&self, facet: FacetId) -> Result<(), RegularViolation3> {
        let vertex = self.mesh.apex(self.mesh.twin(facet));
        if vertex.is_ghost() {
            return Ok(());
        }
        let corners = self.mesh.tet_vertices(facet.tet());
        match PowerSight3::new(self, vertex).in_real_conflict(corners) {
            true => Err(RegularViolation3::NotRegular { facet, vertex }),
            false => Ok(()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    fn pyramid(inner_weight: f64) -> Regular3 {
        let points = [
            DVec3::ZERO,
            DVec3::X,
            DVec3::Y,
            DVec3::Z,
            DVec3::ONE,
            DVec3::splat(0.2),
        ];
        let weights = [0.0, 0.0, 0.0, 0.0, 0.0, inner_weight];
        Regular3::build(&points, &weights).unwrap()
    }

    #[test]
    fn weights_that_no_longer_fit_are_found() {
        let inner = VertexId::new(5);
        let mut hidden = pyramid(-1.0);
        assert_eq!((hidden.hidden(), hidden.check()), (&[inner][..], Ok(())));
        hidden.weights[inner.slot()] = 0.0;
        let missing = RegularViolation3::NotHidden { vertex: inner };
        assert_eq!(hidden.check(), Err(missing));
        insta::assert_snapshot!(missing, @"v5 is missing in the triangulation");

        let mut seen = pyramid(0.0);
        assert_eq!((seen.hidden().len(), seen.check()), (0, Ok(())));
        seen.weights[inner.slot()] = -1.0;
        assert!(matches!(
            seen.check(),
            Err(RegularViolation3::NotRegular { .. })
        ));
    }
}
