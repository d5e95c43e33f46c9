//! Conditions under which two points may be inserted together (§4.4).

use delaunay_core::{Cavity, VertexId};
use glam::DVec2;

/// Whether the closures of two prestars are disjoint: they have no vertex in common.
///
/// Then the two points are not neighbours once both are inserted, and none is inside a Delaunay circle of the other's
/// prestar (Independence Lemma). Takes time n log n in the sizes of the prestars.
#[must_use]
pub fn are_independent(first: &Cavity, second: &Cavity) -> bool {
    let mut vertices: Vec<VertexId> = second.vertices().collect();
    vertices.sort_unstable();
    let common = |v| vertices.binary_search(&v).is_ok();
    !first.vertices().any(common)
}

/// Whether two circles, given by centers and radii, are orthogonal or farther apart: |y − z|² ≥ q² + r².
///
/// Then none of the centers is inside the other circle, and they are at least as far apart as the larger radius.
#[must_use]
pub fn are_orthogonal_or_further((y, q): (DVec2, f64), (z, r): (DVec2, f64)) -> bool {
    y.distance_squared(z) >= q * q + r * r
}
