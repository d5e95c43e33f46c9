//! Point location by a straight walk from a vertex.
//!
//! A walk that only asks on which side of an edge the point is may go round in circles in a triangulation that is not Delaunay. One
//! along a straight line comes closer with every triangle, so it ends.

use super::ahead::{Ahead, Turn};
use super::triangulation::Constrained2;
use crate::ids::{HalfEdgeId, VertexId};
use crate::tri::locate::Location;
use crate::tri::sight::{Sight, precedes};
use geo_predicates::{CoordinateError, Sign, check_point2};
use glam::DVec2;

impl Constrained2 {
    /// Where `p` is, by a walk from `hint`, a vertex near `p`, or from any vertex when `hint` is none.
    ///
    /// Takes time proportional to the number of triangles on the straight way, √n on average from any vertex.
    ///
    /// # Errors
    /// [`CoordinateError`] when a coordinate of `p` is not accepted.
    pub fn locate_near(&self, p: DVec2, hint: VertexId) -> Result<Location, CoordinateError> {
        check_point2(0, p)?;
        let is_vertex = !hint.is_ghost() && self.mesh.outgoing(hint).is_some();
        let any = || self.mesh.neighbors(VertexId::GHOST).next();
        let start = if is_vertex { Some(hint) } else { any() };
        Ok(self.walk(p + DVec2::ZERO, start.unwrap_or(hint)))
    }

    fn walk(&self, p: DVec2, start: VertexId) -> Location {
        let sight = Sight::new(&self.coords, self.filter, p);
        let mut from = start;
        loop {
            if sight.point(from) == p {
                return Location::Vertex(from);
            }
            let step = match Turn::new(&self.mesh, sight, from).find() {
                Some(Ahead::Along(h)) => self.pass(&sight, h),
                Some(Ahead::Across(first)) => self.walk_across(&sight, from, first),
                None => Ok(Location::Outside(self.hull_edge_before(&sight, from))),
            };
            match step {
                Ok(location) => return location,
                Err(vertex) => from = vertex,
            }
        }
    }

    /// The location of a point on the edge of `h`, or the end of the edge when the point is there or beyond.
    fn pass(&self, sight: &Sight<'_>, h: HalfEdgeId) -> Result<Location, VertexId> {
        let [start, end] = [self.mesh.origin(h), self.mesh.target(h)];
        let [a, b] = [start, end].map(|v| sight.point(v));
        let is_before_end = sight.from() != b && precedes(a, b) == precedes(sight.from(), b);
        match is_before_end {
            true => Ok(Location::Edge(self.real_side(h))),
            false => Err(end),
        }
    }

    /// Walks on across `crossed`, half-edge opposite `start`; to the location of the point, or to a vertex on the way.
    fn walk_across(
        &self,
        sight: &Sight<'_>,
        start: VertexId,
        mut crossed: HalfEdgeId,
    ) -> Result<Location, VertexId> {
        let here = sight.see(start);
        loop {
            let ends = [self.mesh.origin(crossed), self.mesh.target(crossed)];
            let [a, b] = ends.map(|v| sight.see(v));
            match sight.side(&a, &b) {
                Sign::Positive => return Ok(Location::Face(crossed.face())),
                Sign::Zero => return Ok(Location::Edge(crossed)),
                Sign::Negative => {}
            }
            let entry = self.mesh.twin(crossed);
            let apex = self.mesh.apex(entry);
            if apex.is_ghost() {
                return Ok(Location::Outside(crossed));
            }
            crossed = match sight.side(&here, &sight.see(apex)) {
                Sign::Negative => entry.next(),
                Sign::Positive => entry.prev(),
                Sign::Zero => {
                    let [a, b] = [start, apex].map(|v| sight.point(v));
                    let is_before =
                        sight.from() != b && precedes(a, b) == precedes(sight.from(), b);
                    return match is_before {
                        true => Ok(Location::Face(entry.face())),
                        false => Err(apex),
                    };
                }
            };
        }
    }

    /// A half-edge of the hull at the hull vertex `v` that has the point strictly on its right.
    fn hull_edge_before(&self, sight: &Sight<'_>, v: VertexId) -> HalfEdgeId {
        let ghosts = self.mesh.star(v).filter_map(|f| self.mesh.ghost_base(f));
        let mut edges = ghosts.map(|base| self.mesh.twin(base));
        let sees = |h: &HalfEdgeId| {
            let ends = [self.mesh.origin(*h), self.mesh.target(*h)];
            let [a, b] = ends.map(|v| sight.see(v));
            sight.side(&a, &b) == Sign::Negative
        };
        edges.find(sees).unwrap_or(HalfEdgeId::new(0))
    }

    /// `h`, or its twin when `h` bounds a ghost face.
    fn real_side(&self, h: HalfEdgeId) -> HalfEdgeId {
        match self.mesh.is_ghost_face(h.face()) {
            true => self.mesh.twin(h),
            false => h,
        }
    }
}
