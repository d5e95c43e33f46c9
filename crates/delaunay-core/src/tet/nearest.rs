//! The vertex nearest to a point.

use super::cavity::Cavity3;
use super::delaunay::Delaunay3;
use super::locate::Location3;
use crate::ids::VertexId;
use geo_predicates::CoordinateError;
use glam::DVec3;

impl Delaunay3 {
    /// The vertex nearest to `p`.
    ///
    /// The nearest vertex is one that `p` would have as a neighbour, so it bounds the cavity of `p`, which
    /// is found exactly. Rounding enters only when the distances of those few are compared: the answer
    /// is nearest up to a relative 1e-15; of equal distances the smallest id wins. Takes the time of
    /// [`locate`](Self::locate) and the size of the cavity, which is small where vertices are evenly spread
    /// and may be all tetrahedra at the center of a sphere of vertices or far outside.
    ///
    /// # Errors
    /// [`CoordinateError`] when a coordinate of `p` is not accepted.
    ///
    /// ```
    /// # use delaunay_core::{Delaunay3, VertexId};
    /// # use glam::DVec3;
    /// let delaunay = Delaunay3::build(&[DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z])?;
    /// assert_eq!(delaunay.nearest_vertex(DVec3::new(0.1, 0.2, 5.0))?, VertexId::new(3));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn nearest_vertex(&self, p: DVec3) -> Result<VertexId, CoordinateError> {
        let location = self.locate(p)?;
        Ok(self.nearest_from(p, location))
    }

    /// As [`nearest_vertex`](Self::nearest_vertex), located from `hint`, a vertex near `p`.
    ///
    /// # Errors
    /// [`CoordinateError`] when a coordinate of `p` is not accepted.
    pub fn nearest_vertex_near(
        &self,
        p: DVec3,
        hint: VertexId,
    ) -> Result<VertexId, CoordinateError> {
        let location = self.locate_near(p, hint)?;
        Ok(self.nearest_from(p, location))
    }

    fn nearest_from(&self, p: DVec3, location: Location3) -> VertexId {
        let seed = match self.seed(location) {
            Ok(seed) => seed,
            Err(vertex) => return vertex,
        };
        let mut cavity = Cavity3::default();
        self.dig(p, seed, &mut cavity);
        let corners = cavity
            .tets()
            .iter()
            .flat_map(|&t| self.mesh.tet_vertices(t));
        let real = corners.filter(|v| !v.is_ghost());
        let measured = real.map(|v| (self.point_of(v).distance_squared(p), v));
        let nearest = measured.min_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        // A tetrahedron has at least three real corners.
        nearest.map_or(VertexId::GHOST, |(_, v)| v)
    }
}
