//! The square distance functions π and φ (§3.1).

use delaunay_core::geo_predicates::CoordinateError;
use delaunay_core::measure::triangle::circumcenter;
use delaunay_core::{Delaunay2, Location};
use glam::DVec2;

/// π(x): the squared distance to the nearest vertex. Its maxima inside the hull are the sinks. Expected time log n.
///
/// # Errors
/// [`CoordinateError`] when a coordinate of `x` is not accepted.
pub fn pi(delaunay: &Delaunay2, x: DVec2) -> Result<f64, CoordinateError> {
    let nearest = delaunay.nearest_vertex(x)?;
    Ok(delaunay.point(nearest).distance_squared(x))
}

/// φ(y): the least weighted square distance |y − z|² − r² from a Delaunay circle (z, r); that of the triangle which
/// contains y. Its minima are the sinks. `None` outside the convex hull. Expected time log n.
///
/// # Errors
/// [`CoordinateError`] when a coordinate of `y` is not accepted.
pub fn phi(delaunay: &Delaunay2, y: DVec2) -> Result<Option<f64>, CoordinateError> {
    let face = match delaunay.locate(y)? {
        Location::Vertex(_) => return Ok(Some(0.0)),
        Location::Face(f) => f,
        Location::Edge(h) => h.face(),
        Location::Outside(_) => return Ok(None),
    };
    let corners = delaunay.triangle(face);
    let center = circumcenter(corners);
    // |y − z|² − |a − z|² without the cancellation of two large squares.
    let [a, ..] = corners;
    Ok(Some((y - a).dot(y + a - 2.0 * center)))
}
