//! Triangles of low quality that are left, and why.

use super::flow::sink_triangle;
use super::proposal::{Proposal, Rejection2};
use super::records::Records;
use delaunay_core::measure::triangle::circumcenter;
use delaunay_core::{FaceId, HalfEdgeId, Subcomplex2, VertexId};

/// A triangle of low quality that is left: its ratio is too large, or itself.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Low2 {
    /// The triangle.
    pub face: FaceId,
    /// Its ratio r/l.
    pub ratio: f64,
    /// Its circumradius over the largest that the size asked for allows: above 1 it is too large. 0 where no size is asked for.
    pub size: f64,
    /// Why it is left.
    pub reason: Reason2,
}

/// Why a triangle of low quality is left.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reason2 {
    /// At this corner it fills the whole angle between two boundary edges, and that angle is too small: no triangle there
    /// has a smaller ratio.
    BoundaryAngle(VertexId),
    /// This edge of it is on the boundary and longer than twice the circumradius that the size asked for allows: every triangle
    /// on it is too large.
    BoundaryEdge(HalfEdgeId),
    /// Its sink and its circumcenter are inside diametral circles of boundary edges, this one among them. When
    /// they might be divided: these have been as far as they may be.
    Encroaches(HalfEdgeId),
    /// Its flow leaves through the boundary, and its circumcenter is outside; or they fall on a vertex or where doubles run out, so
    /// that there is no finer mesh.
    Outside,
    /// Its sink or its circumcenter passes the tests: refinement ended before its turn came, or its method does without that one
    /// of the two, which may be nearer to a vertex than it allows.
    NotReached,
}

/// The triangles of low quality that are left, worst first, equal ones by id.
pub(crate) fn left_over(region: &Subcomplex2, records: &Records<'_>) -> Vec<Low2> {
    let mut proposal = Proposal::default();
    let low = region.faces().filter(|&f| records.is_low(f));
    let mut low: Vec<Low2> = low
        .map(|face| Low2 {
            face,
            ratio: records.quality(face).ratio(),
            size: records.quality(face).size(),
            reason: reason(region, records, &mut proposal, face),
        })
        .collect();
    let badness = |low: &Low2| low.ratio.max(low.size * records.bound());
    low.sort_by(|a, b| badness(b).total_cmp(&badness(a)).then(a.face.cmp(&b.face)));
    low
}

fn reason(
    region: &Subcomplex2,
    records: &Records<'_>,
    proposal: &mut Proposal,
    face: FaceId,
) -> Reason2 {
    if let Some(vertex) = sharp_corner(region, records, face) {
        return Reason2::BoundaryAngle(vertex);
    }
    if let Some(edge) = long_edge(region, records, face) {
        return Reason2::BoundaryEdge(edge);
    }
    let end = sink_triangle(region.mesh(), face, |f| records.exit(f));
    let mut reason = Reason2::Outside;
    for f in end.into_iter().chain([face]) {
        let point = circumcenter(region.triangle(f));
        match proposal.make(region, point, f, 0.0) {
            Ok(()) => return Reason2::NotReached,
            Err(Rejection2::Encroaches(h)) => reason = Reason2::Encroaches(h),
            Err(_) => {}
        }
    }
    reason
}

/// The corner of a triangle between two boundary edges whose angle alone makes the ratio too large.
fn sharp_corner(region: &Subcomplex2, records: &Records<'_>, face: FaceId) -> Option<VertexId> {
    let mut between = face.half_edges().into_iter();
    let sharp = between.find(|&h| {
        let mesh = region.mesh();
        let [corner, a, b] =
            [mesh.origin(h), mesh.target(h), mesh.apex(h)].map(|v| region.point(v));
        let angle = (a - corner).angle_to(b - corner);
        // The least ratio with this angle is that of the triangle in which it faces the shortest edge.
        let least = 0.5 / angle.sin();
        let acute = angle < std::f64::consts::FRAC_PI_2;
        let on_both = region.is_boundary(h) && region.is_boundary(h.prev());
        on_both && acute && records.is_low_ratio(least * least)
    });
    sharp.map(|h| region.mesh().origin(h))
}

/// A boundary edge of a triangle whose length alone makes it too large, whatever its third corner.
pub(crate) fn long_edge(
    region: &Subcomplex2,
    records: &Records<'_>,
    face: FaceId,
) -> Option<HalfEdgeId> {
    let largest = 2.0 * records.largest_radius(region, face);
    let mut on_boundary = face.half_edges().into_iter();
    on_boundary.find(|&h| {
        let [a, b] = region.segment(h);
        region.is_boundary(h) && a.distance(b) > largest
    })
}
