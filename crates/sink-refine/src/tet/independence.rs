//! Conditions under which two points may be inserted together (§4.4).

use delaunay_core::{Cavity3, TetMesh};
use glam::DVec3;

/// Whether the closures of two prestars are disjoint: they have no vertex in common.
///
/// Then the two points are not neighbours once both are inserted, and none is inside a Delaunay sphere of the other's
/// prestar (Independence Lemma). Takes time n log n in the sizes of the prestars.
#[must_use]
pub fn are_independent(mesh: &TetMesh, first: &Cavity3, second: &Cavity3) -> bool {
    let vertices = second.vertices(mesh);
    let common = |v| vertices.binary_search(&v).is_ok();
    !first.vertices(mesh).into_iter().any(common)
}

/// Whether two spheres, given by centers and radii, are orthogonal or farther apart: |y − z|² ≥ q² + r².
///
/// Then none of the centers is inside the other sphere, and they are at least as far apart as the larger radius.
#[must_use]
pub fn are_orthogonal_or_further((y, q): (DVec3, f64), (z, r): (DVec3, f64)) -> bool {
    y.distance_squared(z) >= q * q + r * r
}
