//! The Voronoi diagram, dual of the Delaunay triangulation: vertices, edges, clipped cells.
//!
//! Cells are cut out of a window by the bisectors between a vertex and its Delaunay neighbours. No
//! Voronoi vertex is needed for that, so triangles with huge circumcircles, common along the hull, do
//! no harm: their centers lie outside the window and are never computed.

use super::carve::Carving;
use super::convex::ConvexPolygon;
use super::delaunay::Delaunay2;
use crate::ids::{FaceId, HalfEdgeId, VertexId};
use crate::measure::triangle::circumcenter;
use glam::DVec2;

/// The Voronoi diagram of the vertices, see [`Delaunay2::voronoi`].
#[derive(Clone, Copy, Debug)]
pub struct Voronoi<'a> {
    delaunay: &'a Delaunay2,
}

/// The Voronoi edge across a Delaunay edge: the points nearest to the two ends of that edge.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum VoronoiEdge {
    /// Between two Voronoi vertices. Both are the same point when four vertices are on one circle.
    Segment {
        /// Center of the triangle on the right of the half-edge.
        from: DVec2,
        /// Center of the triangle on the left of the half-edge.
        to: DVec2,
    },
    /// From a Voronoi vertex to infinity, across a hull edge.
    Ray {
        /// Center of the triangle on the hull edge.
        from: DVec2,
        /// Away from the hull, at a right angle to the hull edge and as long as it.
        direction: DVec2,
    },
}

impl Delaunay2 {
    /// The Voronoi diagram of the vertices. Nothing is computed before it is asked for.
    ///
    /// ```
    /// # use delaunay_core::{ConvexPolygon, Delaunay2, VertexId};
    /// # use glam::DVec2;
    /// let points = [[0.0, 0.0], [2.0, 0.0], [0.0, 2.0], [2.0, 2.0], [1.0, 1.0]];
    /// let delaunay = Delaunay2::build(&points.map(DVec2::from))?;
    /// let window = ConvexPolygon::rectangle(DVec2::splat(-1.0), DVec2::splat(3.0))?;
    /// let cell = delaunay.voronoi().cell(VertexId::new(4), &window);
    /// assert_eq!(cell.area(), 2.0);
    /// assert_eq!(cell.centroid(), Some(DVec2::splat(1.0)));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn voronoi(&self) -> Voronoi<'_> {
        Voronoi { delaunay: self }
    }
}

impl Voronoi<'_> {
    /// The Voronoi vertex of the triangle `f`: its circumcenter.
    ///
    /// The error is near 1e-15 of the circumradius except for triangles thinner than the coordinates
    /// resolve, whose centers may come out infinite.
    ///
    /// # Panics
    /// When there is no face `f` or it is a ghost.
    #[must_use]
    pub fn vertex(&self, f: FaceId) -> DVec2 {
        circumcenter(self.delaunay.triangle(f))
    }

    /// All Voronoi edges, each with the Delaunay half-edge that it crosses from right to left.
    ///
    /// One half-edge for each Delaunay edge, by id; on the hull the one with the triangle on its left.
    pub fn edges(&self) -> impl Iterator<Item = (HalfEdgeId, VoronoiEdge)> + '_ {
        let mesh = self.delaunay.mesh();
        mesh.half_edges().filter_map(move |h| {
            let twin = mesh.twin(h);
            match [h, twin].map(|side| mesh.is_ghost_face(side.face())) {
                [false, false] if h < twin => Some((h, self.segment(h))),
                [false, true] => Some((h, self.ray(h))),
                _ => None,
            }
        })
    }

    /// The cell of `v`: the part of `window` that is nearer to `v` than to any other vertex.
    ///
    /// Empty when `v` is not a vertex or its cell lies outside the window. The cells of all vertices
    /// tile the window up to rounding. Takes time linear in the degree of `v` and the corners of the
    /// window.
    #[must_use]
    pub fn cell(&self, v: VertexId, window: &ConvexPolygon) -> ConvexPolygon {
        if !self.delaunay.contains_vertex(v) {
            return ConvexPolygon::default();
        }
        // Relative to the center, where the bisectors round least.
        let center = self.delaunay.point(v);
        let mut normals = self
            .turning_neighbors(v)
            .map(|u| self.delaunay.point(u) - center)
            .peekable();
        let first = normals.peek().copied().unwrap_or(DVec2::X);
        let mut cell = Carving::new(window, -center, first);
        for normal in normals {
            cell.cut(normal, normal.length_squared() / 2.0);
        }
        cell.finish(center)
    }

    /// The real neighbours of `v`, counterclockwise by less than a turn: on the hull from the ghost on,
    /// because there two of them may be more than half a turn apart.
    fn turning_neighbors(&self, v: VertexId) -> impl Iterator<Item = VertexId> + '_ {
        let mesh = self.delaunay.mesh();
        let ghost = mesh.neighbors(v).position(VertexId::is_ghost);
        let after = mesh.neighbors(v).skip(ghost.map_or(0, |ghost| ghost + 1));
        after.chain(mesh.neighbors(v).take(ghost.unwrap_or(0)))
    }

    fn segment(&self, h: HalfEdgeId) -> VoronoiEdge {
        let twin = self.delaunay.mesh().twin(h);
        VoronoiEdge::Segment {
            from: self.vertex(twin.face()),
            to: self.vertex(h.face()),
        }
    }

    fn ray(&self, h: HalfEdgeId) -> VoronoiEdge {
        let mesh = self.delaunay.mesh();
        let [start, end] = [mesh.origin(h), mesh.target(h)].map(|v| self.delaunay.point(v));
        VoronoiEdge::Ray {
            from: self.vertex(h.face()),
            direction: -(end - start).perp(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_center_of_a_flat_triangle_far_from_the_origin_keeps_its_digits() {
        // Height h over a base of length 2: circumradius (1 + h^2) / (2 h), center below the apex.
        let h = 2.0_f64.powi(-30);
        let corner = |x, y| DVec2::new(1e6, -3e6) + DVec2::new(x, y);
        let points = [corner(-1.0, 0.0), corner(1.0, 0.0), corner(0.0, h)];
        let delaunay = Delaunay2::build(&points).unwrap();
        let center = delaunay.voronoi().vertex(delaunay.faces().next().unwrap());
        // The apex as rounded beside 3e6.
        let h = points[2].y - points[0].y;
        let exact = corner(0.0, 0.0) + DVec2::new(0.0, h - (1.0 + h * h) / (2.0 * h));
        assert!(
            center.distance(exact) < 1e-14 * (0.5 / h),
            "{center} {exact}"
        );
    }
}
