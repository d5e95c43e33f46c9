//! Where boundary edges are divided.

use crate::boundary::{TURN_TOLERANCE, is_acute, shell};
use delaunay_core::{FaceId, HalfEdgeId, Subcomplex2, VertexId};
use glam::DVec2;

/// The place that divides a boundary edge, when the boundary is smooth where it turns by up to `smooth` radians.
///
/// In the middle; but from a vertex where another boundary edge is near, at a power of two, so that both are divided at the same
/// distances and do not make each other be divided again (Ruppert 1995, concentric shells). On a smooth boundary not on the
/// edge but on the cubic Hermite curve between its ends, with speed |ab| along the tangents there.
pub(super) fn divide(region: &Subcomplex2, h: HalfEdgeId, smooth: f64) -> DVec2 {
    let [a, b] = region.segment(h);
    let chord = b - a;
    let [from, to] = [region.mesh().origin(h), region.mesh().target(h)];
    match [is_sharp(region, from, chord), is_sharp(region, to, -chord)] {
        [true, false] => return a + chord * shell(chord.length()),
        [false, true] => return b - chord * shell(chord.length()),
        _ => {}
    }
    if smooth == 0.0 {
        return a.midpoint(b);
    }
    let tangent = |before: DVec2, after: DVec2| {
        let is_smooth = before.angle_to(after).abs() <= smooth + TURN_TOLERANCE;
        // On a circle chords turn from the tangent in proportion to their lengths.
        let mean = before.normalize_or_zero() * after.length()
            + after.normalize_or_zero() * before.length();
        match is_smooth {
            true => mean.normalize_or_zero() * chord.length(),
            false => chord,
        }
    };
    let along = |h| {
        let [a, b] = region.segment(h);
        b - a
    };
    let leaving = tangent(along(before(region, h)), chord);
    let arriving = tangent(chord, along(after(region, h)));
    a.midpoint(b) + (leaving - arriving) / 8.0
}

/// Whether a boundary edge at `v` makes an acute angle with `chord`, which is one that leaves it.
fn is_sharp(region: &Subcomplex2, v: VertexId, chord: DVec2) -> bool {
    let mesh = region.mesh();
    let link = mesh.star(v).flat_map(FaceId::half_edges);
    let mut others = link.filter(|&h| {
        let ends = [mesh.origin(h), mesh.target(h)];
        ends.contains(&v)
            && !ends.contains(&VertexId::GHOST)
            && !mesh.is_ghost_face(h.face())
            && region.is_boundary(h)
    });
    let here = region.point(v);
    others.any(|h| {
        let [a, b] = region.segment(h);
        let other = if a == here { b - a } else { a - b };
        is_acute(other.angle_to(chord).abs())
    })
}

/// The boundary edge that ends where the boundary edge `h` starts, met first round what is outside.
fn before(region: &Subcomplex2, h: HalfEdgeId) -> HalfEdgeId {
    let mesh = region.mesh();
    mesh.twin(mesh.twin(mesh.twin(h).next()).next())
}

/// The boundary edge that starts where the boundary edge `h` ends.
fn after(region: &Subcomplex2, h: HalfEdgeId) -> HalfEdgeId {
    let mesh = region.mesh();
    mesh.twin(mesh.twin(mesh.twin(h).prev()).prev())
}
