//! Tetrahedra of low quality that are left, and why.

use super::flow::FlowWalk;
use super::proposal::{Proposal, Rejection3};
use super::records::Records;
use delaunay_core::measure::facet;
use delaunay_core::measure::tetrahedron::circumcenter;
use delaunay_core::{FacetId, Subcomplex3, TetId};

/// A tetrahedron of low quality that is left.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Low3 {
    /// The tetrahedron.
    pub tet: TetId,
    /// Its ratio r/l.
    pub ratio: f64,
    /// Why it is left.
    pub reason: Reason3,
}

/// Why a tetrahedron of low quality is left.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reason3 {
    /// A facet of it is on the boundary, and the ratio of that triangle alone is too large: no tetrahedron on it has a
    /// smaller one.
    BoundaryTriangle(FacetId),
    /// Its sinks and its circumcenter are inside diametral spheres of boundary facets, this one among them. When
    /// they might be divided: these have been as far as they may be.
    Encroaches(FacetId),
    /// Its flow leaves through the boundary, and its circumcenter is outside.
    Outside,
    /// A sink of it or its circumcenter passes the tests: refinement ended before its turn came, or its method does without
    /// that one.
    NotReached,
}

/// The tetrahedra of low quality that are left, worst first, equal ones by id.
pub(crate) fn left_over(solid: &Subcomplex3, records: &Records) -> Vec<Low3> {
    let mut walk = FlowWalk::default();
    let mut proposal = Proposal::default();
    let low = solid.tets().filter(|&t| records.is_low(t));
    let mut low: Vec<Low3> = low
        .map(|tet| Low3 {
            tet,
            ratio: records.ratio(tet),
            reason: reason(solid, records, &mut walk, &mut proposal, tet),
        })
        .collect();
    low.sort_by(|a, b| b.ratio.total_cmp(&a.ratio).then(a.tet.cmp(&b.tet)));
    low
}

fn reason(
    solid: &Subcomplex3,
    records: &Records,
    walk: &mut FlowWalk,
    proposal: &mut Proposal,
    tet: TetId,
) -> Reason3 {
    let on_boundary = tet.facets().into_iter().filter(|&f| solid.is_boundary(f));
    for f in on_boundary {
        if records.is_low_ratio(facet::radius_edge_ratio(solid.triangle(f)).powi(2)) {
            return Reason3::BoundaryTriangle(f);
        }
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
