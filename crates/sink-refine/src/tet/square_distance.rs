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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tet::{is_sink, sink};
    use delaunay_core::{Subcomplex3, VertexId};

    fn scattered(count: u32) -> Vec<DVec3> {
        let point = |i: u32| (f64::from(i * i) * DVec3::new(0.1234, 0.2345, 0.3456)).fract();
        (1..=count).map(point).collect()
    }

    /// At a sink both are the squared radius, but for the sign; at a vertex both are zero.
    #[test]
    fn sinks_are_maxima_of_one_distance_and_minima_of_the_other() {
        let delaunay = Delaunay3::build(&scattered(200)).unwrap();
        let solid = Subcomplex3::of(&delaunay, |_| true);
        let mut sinks = 0;
        for t in solid.tets().filter(|&t| is_sink(&solid, t)) {
            let center = sink(&solid, t);
            let square = center.distance_squared(solid.tetrahedron(t)[0]);
            let near = |x: f64, y: f64| (x - y).abs() <= 1e-12 * square;
            assert!(near(pi(&delaunay, center).unwrap(), square));
            assert!(near(phi(&delaunay, center).unwrap().unwrap(), -square));
            let beside = center + 0.01 * (solid.tetrahedron(t)[0] - center);
            assert!(pi(&delaunay, beside).unwrap() < square);
            assert!(phi(&delaunay, beside).unwrap().unwrap() > -square);
            sinks += 1;
        }
        assert!(sinks > 10);
        let vertex = delaunay.point(VertexId::new(7));
        assert_eq!(
            (pi(&delaunay, vertex), phi(&delaunay, vertex)),
            (Ok(0.0), Ok(Some(0.0)))
        );
        assert_eq!(phi(&delaunay, DVec3::splat(9.0)), Ok(None));
        assert!(pi(&delaunay, DVec3::NAN).is_err());
    }
}
