//! The vertex nearest to a point.

use super::cavity::Cavity;
use super::delaunay::Delaunay2;
use super::locate::Location;
use crate::ids::VertexId;
use geo_predicates::CoordinateError;
use glam::DVec2;

impl Delaunay2 {
    /// The vertex nearest to `p`.
    ///
    /// The nearest vertex is one that `p` would have as a neighbour, so it is on the rim of the cavity
    /// of `p`, which is found exactly. Rounding enters only when the distances of those few are
    /// compared: the answer is nearest up to a relative 1e-15; of equal distances the smallest id wins.
    /// Takes the time of [`locate`](Self::locate) and the size of the cavity, which is small where vertices
    /// are evenly spread and may be all faces at the center of a circle of vertices or far outside.
    ///
    /// # Errors
    /// [`CoordinateError`] when a coordinate of `p` is not accepted.
    pub fn nearest_vertex(&self, p: DVec2) -> Result<VertexId, CoordinateError> {
        let location = self.locate(p)?;
        Ok(self.nearest_from(p, location))
    }

    /// As [`nearest_vertex`](Self::nearest_vertex), located from `hint`, a vertex near `p`.
    ///
    /// # Errors
    /// [`CoordinateError`] when a coordinate of `p` is not accepted.
    pub fn nearest_vertex_near(
        &self,
        p: DVec2,
        hint: VertexId,
    ) -> Result<VertexId, CoordinateError> {
        let location = self.locate_near(p, hint)?;
        Ok(self.nearest_from(p, location))
    }

    fn nearest_from(&self, p: DVec2, location: Location) -> VertexId {
        let seed = match self.seed(location) {
            Ok(seed) => seed,
            Err(vertex) => return vertex,
        };
        let mut cavity = Cavity::default();
        self.dig(p, seed, &mut cavity);
        let distance = |v: VertexId| self.point_of(v).distance_squared(p);
        let real = cavity.vertices().filter(|v| !v.is_ghost());
        let nearest = real.min_by(|&a, &b| distance(a).total_cmp(&distance(b)).then(a.cmp(&b)));
        // A rim has three vertices, at most one of them the ghost.
        nearest.unwrap_or(VertexId::GHOST)
    }
}
