//! The square distance functions π and φ (§3.1).

use delaunay_core::geo_predicates::CoordinateError;
use delaunay_core::measure::tetrahedron::circumcenter;
use delaunay_core::{Delaunay3, Location3};
use glam::DVec3;

/// π(x): the squared distance to the nearest vertex. Its maxima inside the hull are the sinks. Expected time log n.
///
/// # Errors
/// [`CoordinateError`] when a coordinate of `x` is not accepted.
pub fn pi(delaunay: &Delaunay3, x: DVec3) -> Result<f64, CoordinateError> {
    let nearest = delaunay.nearest_vertex(x)?;
    Ok(delaunay.point(nearest).distance_squared(x))
}

/// φ(y): the least weighted square distance |y − z|² − r² from a Delaunay sphere (z, r); that of the tetrahedron which
/// contains y. Its minima are the sinks. `None` outside the convex hull. Expected time log n.
///
/// # Errors
/// [`CoordinateError`] when a coordinate of `y` is not accepted.
pub fn phi(delaunay: &Delaunay3, y: DVec3) -> Result<Option<f64>, CoordinateError> {
    let tet = match delaunay.locate(y)? {
        Location3::Vertex(_) => return Ok(Some(0.0)),
        Location3::Tet(t) => t,
        Location3::Facet(f) => f.tet(),
        Location3::Edge { tet, .. } => tet,
        Location3::Outside(_) => return Ok(None),
    };
    let corners = delaunay.tetrahedron(tet);
    let center = circumcenter(corners);
    // |y − z|² − |a − z|² without the cancellation of two large squares.
    let [a, ..] = corners;
    Ok(Some((y - a).dot(y + a - 2.0 * center)))
}
