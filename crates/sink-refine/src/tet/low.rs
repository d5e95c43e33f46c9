//! Tetrahedra of low quality that are left, and why.

use super::flow::FlowWalk;
use super::proposal::{Proposal, Rejection3};
use super::records::Records;
use delaunay_core::measure::facet;
use delaunay_core::measure::tetrahedron::circumcenter;
use delaunay_core::{FacetId, Subcomplex3, TetId};

/// A tetrahedron of low quality that is left: its ratio is too large, or itself.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Low3 {
    /// The tetrahedron.
    pub tet: TetId,
    /// Its ratio r/l.
    pub ratio: f64,
    /// Its circumradius over the largest that the size asked for allows: above 1 it is too large. 0 where no size is asked for.
    pub size: f64,
    /// Why it is left.
    pub reason: Reason3,
}

/// Why a tetrahedron of low quality is left.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reason3 {
    /// A facet of it is on the boundary, and the ratio or the circumradius of that triangle alone is too large: no tetrahedron
    /// on it has a smaller one.
    BoundaryTriangle(FacetId),
    /// Its sinks and its circumcenter are inside diametral spheres of boundary facets, this one among them. When
    /// they might be divided: these have been as far as they may be.
    Encroaches(FacetId),
    /// Its flow leaves through the boundary, and its circumcenter is outside; or they fall on a vertex or where doubles run out, so
    /// that there is no finer mesh.
    Outside,
    /// A sink of it or its circumcenter passes the tests: refinement ended before its turn came, or its method does without
    /// that one, which may be nearer to a vertex than it allows.
    NotReached,
}

/// The tetrahedra of low quality that are left, worst first, equal ones by id.
pub(crate) fn left_over(solid: &Subcomplex3, records: &Records<'_>) -> Vec<Low3> {
    let mut walk = FlowWalk::default();
    let mut proposal = Proposal::default();
    let low = solid.tets().filter(|&t| records.is_low(t));
    let mut low: Vec<Low3> = low
        .map(|tet| Low3 {
            tet,
            ratio: records.quality(tet).ratio(),
            size: records.quality(tet).size(),
            reason: reason(solid, records, &mut walk, &mut proposal, tet),
        })
        .collect();
    let badness = |low: &Low3| low.ratio.max(low.size * records.bound());
    low.sort_by(|a, b| badness(b).total_cmp(&badness(a)).then(a.tet.cmp(&b.tet)));
    low
}

fn reason(
    solid: &Subcomplex3,
    records: &Records<'_>,
    walk: &mut FlowWalk,
    proposal: &mut Proposal,
    tet: TetId,
) -> Reason3 {
    let skinny = skinny_boundary(solid, records, tet);
    if let Some(f) = skinny.or_else(|| large_boundary(solid, records, tet)) {
        return Reason3::BoundaryTriangle(f);
    }
    let sinks = walk.follow(solid, tet, |t| records.flow(t)).iter();
    let mut reason = Reason3::Outside;
    for &t in sinks.chain([&tet]) {
        let point = circumcenter(solid.tetrahedron(t));
        match proposal.make(solid, point, t, 0.0) {
            Ok(()) => return Reason3::NotReached,
            Err(Rejection3::Encroaches(f)) => reason = Reason3::Encroaches(f),
            Err(_) => {}
        }
    }
    reason
}

/// A boundary facet of a tetrahedron whose ratio alone makes that of the tetrahedron too large.
pub(crate) fn skinny_boundary(
    solid: &Subcomplex3,
    records: &Records<'_>,
    tet: TetId,
) -> Option<FacetId> {
    let ratio = |f: &FacetId| facet::radius_edge_ratio(solid.triangle(*f));
    let mut on_boundary = on_boundary(solid, tet);
    on_boundary.find(|f| records.is_low_ratio(ratio(f).powi(2)))
}

/// A boundary facet of a tetrahedron whose circumradius alone makes it too large, whatever its fourth corner.
pub(crate) fn large_boundary(
    solid: &Subcomplex3,
    records: &Records<'_>,
    tet: TetId,
) -> Option<FacetId> {
    let largest = records.largest_radius(solid, tet);
    let mut on_boundary = on_boundary(solid, tet);
    on_boundary.find(|&f| facet::circumradius(solid.triangle(f)) > largest)
}

fn on_boundary(solid: &Subcomplex3, tet: TetId) -> impl Iterator<Item = FacetId> {
    let facets = tet.facets().into_iter();
    facets.filter(|&f| solid.is_boundary(f))
}
