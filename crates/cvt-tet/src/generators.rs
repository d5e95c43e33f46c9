//! The generating points of a tessellation of a convex region: input, judged once.

use delaunay_core::geo_predicates::{Sign, coordinate::MIN_MAGNITUDE, orient2d};
use delaunay_core::{ConvexPolygon, Delaunay2, FaceId, VertexId};
use glam::DVec2;

use crate::error::GeneratorError;
use crate::place::Place;

/// Distinct points of a convex region, not all on one line, with their Delaunay triangulation.
#[derive(Clone, Debug)]
pub struct Generators {
    region: ConvexPolygon,
    delaunay: Delaunay2,
    /// By point.
    places: Vec<Place>,
}

impl Generators {
    /// The points as generators of Voronoi cells that tile `region`, all free to move. Points may lie on its
    /// boundary.
    ///
    /// Takes the time of a Delaunay triangulation, plus points times corners of the region.
    ///
    /// # Errors
    /// [`GeneratorError`] names the first point that is not accepted.
    pub fn new(region: ConvexPolygon, points: &[DVec2]) -> Result<Self, GeneratorError> {
        if region.is_empty() {
            return Err(GeneratorError::EmptyRegion);
        }
        let delaunay = Delaunay2::build(points)?;
        if let Some(point) = points.iter().position(|&p| !contains(&region, p)) {
            return Err(GeneratorError::Outside { point });
        }
        let repeated = delaunay.duplicates().iter().next();
        if let Some((second, first)) = repeated {
            let (first, second) = (first.index(), second.index());
            return Err(GeneratorError::Repeated { first, second });
        }
        let places = vec![Place::Inside; points.len()];
        Ok(Self {
            region,
            delaunay,
            places,
        })
    }

    /// The region.
    #[must_use]
    pub fn region(&self) -> &ConvexPolygon {
        &self.region
    }

    /// The points, in input order.
    #[must_use]
    pub fn points(&self) -> &[DVec2] {
        self.delaunay.points()
    }

    /// Their Delaunay triangulation, the mesh; vertex i is point i.
    ///
    /// It covers the convex hull of the points, see also [`triangles`](Self::triangles).
    #[must_use]
    pub fn delaunay(&self) -> &Delaunay2 {
        &self.delaunay
    }

    /// The Voronoi cell of point `index`, cut off at the boundary of the region; empty when there is no such
    /// point. The cells of all points tile the region.
    #[must_use]
    pub fn cell(&self, index: usize) -> ConvexPolygon {
        if index >= self.points().len() {
            return ConvexPolygon::default();
        }
        self.delaunay
            .voronoi()
            .cell(VertexId::new(index), &self.region)
    }

    /// Where each point may go, by point: [`Place::Inside`] for all unless they are
    /// [`attached`](Self::attached).
    #[must_use]
    pub fn places(&self) -> &[Place] {
        &self.places
    }

    /// The triangles of the mesh, by id: all of the triangulation but those between points of one edge of the
    /// region, which have an area by rounding only.
    ///
    /// When points are [`attached`](Self::attached) and every corner has one, they cover the region.
    pub fn triangles(&self) -> impl Iterator<Item = FaceId> + '_ {
        self.delaunay.faces().filter(|&f| !self.is_along_an_edge(f))
    }

    fn is_along_an_edge(&self, f: FaceId) -> bool {
        let corners = self.region.corners().len();
        let vertices = self.delaunay.mesh().face_vertices(f);
        let all_on = |edge: usize| {
            vertices.iter().all(|v| {
                self.places
                    .get(v.index())
                    .is_some_and(|p| p.is_on(edge, corners))
            })
        };
        (0..corners).any(all_on)
    }

    /// The same region with the points moved and bound to places; `None` when they have come to lie on one
    /// line. There are as many places as points.
    pub(crate) fn moved(&self, points: Vec<DVec2>, places: Vec<Place>) -> Option<Self> {
        let points: Vec<DVec2> = points.into_iter().map(accepted).collect();
        let delaunay = Delaunay2::build(&points).ok()?;
        Some(Self {
            region: self.region.clone(),
            delaunay,
            places,
        })
    }
}

/// Centers are rounded, and a coordinate that should be zero may come out too small to be accepted.
fn accepted(point: DVec2) -> DVec2 {
    let nearest = |x: f64| if x.abs() < MIN_MAGNITUDE { 0.0 } else { x };
    DVec2::new(nearest(point.x), nearest(point.y))
}

fn contains(region: &ConvexPolygon, p: DVec2) -> bool {
    let corners = region.corners();
    let mut edges = corners.iter().zip(corners.iter().cycle().skip(1));
    edges.all(|(&a, &b)| orient2d(a, b, p) != Sign::Negative)
}
