//! How far a node is from having six triangles round it, which is what equilateral ones want.

use delaunay_core::{Complex2, VertexId};
use std::f64::consts::FRAC_PI_3;

/// The number of triangles at a node less the number that fits: six, on the boundary the angle there over 60 degrees.
pub(super) fn defect(complex: &Complex2, v: VertexId) -> f64 {
    let mesh = complex.mesh();
    let star = mesh.star(v).filter(|&f| !mesh.is_ghost_face(f));
    if complex.is_inner(v) {
        return star.count() as f64 - 6.0;
    }
    let here = complex.point(v);
    let link = mesh.link(v).filter(|h| !mesh.is_ghost_face(h.face()));
    let angles = link.map(|h| {
        let [a, b] = [mesh.origin(h), mesh.target(h)].map(|v| complex.point(v) - here);
        a.perp_dot(b).atan2(a.dot(b))
    });
    let (count, angle) = angles.fold((0.0, 0.0), |(count, sum), angle| (count + 1.0, sum + angle));
    count - angle / FRAC_PI_3
}
