//! Generators put on the boundary of the region (§3.4, second approach: from the interior to the boundary).
//!
//! A tessellation made without any constraint shows which points belong on the boundary: those whose cells
//! reach it. The point nearest to a corner of the region takes the corner, the others go to the nearest point
//! of the edge that their cell shares the most with, and slide along it from then on.

use delaunay_core::{ConvexPolygon, VertexId};
use glam::DVec2;

use crate::error::GeneratorError;
use crate::generators::Generators;
use crate::place::Place;

/// How far, relative to its length, from an edge of the region a corner of a cell may be rounded.
const ROUNDING: f64 = 1e-9;

impl Generators {
    /// The same points, those whose cells reach the boundary moved to it and bound to it.
    ///
    /// Best called when the points are spread evenly. A corner remains without point when another corner has
    /// taken the nearest; then the mesh does not cover it. O(points times corners of the region). Source: §3.4.
    ///
    /// # Errors
    /// [`GeneratorError::OnOneLine`] when that would put all points on one line.
    pub fn attached(&self) -> Result<Self, GeneratorError> {
        let places = self.places_on_boundary();
        let points = self.points().iter().zip(&places);
        let targets = points
            .map(|(&point, place)| place.nearest(self.region(), point))
            .collect();
        self.moved(targets, places).ok_or(GeneratorError::OnOneLine)
    }

    /// The place of every point, by index.
    fn places_on_boundary(&self) -> Vec<Place> {
        let cells = (0..self.points().len()).map(|i| self.cell(i));
        let mut places: Vec<Place> = cells
            .map(|cell| shared_edge(self.region(), &cell))
            .collect();
        for (corner, &at) in self.region().corners().iter().enumerate() {
            let nearest = self.delaunay().nearest_vertex(at).ok().map(VertexId::index);
            match nearest.and_then(|i| places.get_mut(i)) {
                Some(Place::Corner(_)) | None => {}
                Some(place) => *place = Place::Corner(corner),
            }
        }
        places
    }
}

/// The edge of the region with which `cell` shares the most.
fn shared_edge(region: &ConvexPolygon, cell: &ConvexPolygon) -> Place {
    let shared = sides(region)
        .map(|edge| shared_length(edge, cell))
        .enumerate();
    match shared.max_by(|a, b| a.1.total_cmp(&b.1)) {
        Some((edge, length)) if length > 0.0 => Place::Edge(edge),
        _ => Place::Inside,
    }
}

/// The length that the sides of `cell` have in common with an edge of the region.
fn shared_length([a, b]: [DVec2; 2], cell: &ConvexPolygon) -> f64 {
    let reach = ROUNDING * (b - a).length_squared();
    let on_edge = |p: DVec2| (b - a).perp_dot(p - a).abs() <= reach;
    let shared = sides(cell).filter(|side| side.iter().all(|&end| on_edge(end)));
    shared.map(|[start, end]| start.distance(end)).sum()
}

fn sides(polygon: &ConvexPolygon) -> impl Iterator<Item = [DVec2; 2]> + '_ {
    let corners = polygon.corners();
    corners
        .iter()
        .zip(corners.iter().cycle().skip(1))
        .map(|(&start, &end)| [start, end])
}
