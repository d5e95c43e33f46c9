//! A boundary edge is divided by a vertex put on it.

use super::super::proposal::Proposal;
use super::super::refiner::Refiner;
use super::clearance::Clearance;
use super::curve::divide;
use crate::boundary::PARTS;
use crate::stop::Stop;
use delaunay_core::geo_predicates::check_point2;
use delaunay_core::{HalfEdgeId, Subcomplex2};
use glam::DVec2;

/// What has to be known of a boundary to divide it.
#[derive(Debug)]
pub(super) struct Splitter {
    /// The largest angle of a smooth turn, in radians.
    smooth: f64,
    clearance: Clearance,
    /// By vertex: the length of the shortest boundary edge there, as given; infinite inside.
    sizes: Vec<f64>,
    proposal: Proposal,
}

impl Splitter {
    /// For a boundary with corners where it turns by more than so many degrees.
    pub(super) fn new(region: &Subcomplex2, crease: f64) -> Self {
        let mut sizes = vec![f64::INFINITY; region.points().len()];
        for h in region.boundary() {
            let [a, b] = region.segment(h);
            for v in [region.mesh().origin(h), region.mesh().target(h)] {
                sizes[v.index()] = sizes[v.index()].min(a.distance(b));
            }
        }
        Self {
            smooth: crease.to_radians(),
            clearance: Clearance::default(),
            sizes,
            proposal: Proposal::default(),
        }
    }

    /// Divides a boundary edge; tells whether it did.
    ///
    /// # Errors
    /// Why no more points are inserted.
    pub(super) fn split(&mut self, refiner: &mut Refiner<'_>, h: HalfEdgeId) -> Result<bool, Stop> {
        let region = &refiner.region;
        let ends = region.segment(h);
        let point = divide(region, h, self.smooth);
        refiner.count_test(None);
        let region = &refiner.region;
        if !self.propose(refiner, h, point) {
            return Ok(false);
        }
        let size = self.size(region, h);
        let other = region.partner(h);
        let vertex = refiner.insert_on_boundary(&mut self.proposal)?;
        if let Some(other) = other {
            // What was proposed there is still so, but for the ids of ghosts.
            let divides = refiner
                .region
                .dig_on(point, other, &mut self.proposal.prestar);
            debug_assert!(divides, "{other} is divided as {h} is");
            refiner.insert_on_other_side(vertex, &mut self.proposal)?;
        }
        self.sizes
            .resize(refiner.region.points().len(), f64::INFINITY);
        self.sizes[vertex.index()] = size;
        self.clearance.note(ends, refiner.region.point(vertex));
        Ok(true)
    }

    /// Finds what has to give way when a point becomes a vertex on a boundary edge; tells whether it may, on both sides of a cut.
    fn propose(&mut self, refiner: &Refiner<'_>, h: HalfEdgeId, point: DVec2) -> bool {
        let other = refiner.region.partner(h);
        other.is_none_or(|other| self.propose_on_side(refiner, other, point))
            && self.propose_on_side(refiner, h, point)
    }

    fn propose_on_side(&mut self, refiner: &Refiner<'_>, h: HalfEdgeId, point: DVec2) -> bool {
        let region = &refiner.region;
        let allowed = refiner.records.largest_radius(region, h.face());
        let least = self.size(region, h).min(allowed) / PARTS;
        self.proposal.point = point;
        check_point2(0, point).is_ok()
            && region.dig_on(point, h, &mut self.proposal.prestar)
            && self.keeps_separation(region, least)
            && self.clearance.is_given(region, h, point)
    }

    /// Whether the point is at least so far from all vertices round it.
    fn keeps_separation(&self, region: &Subcomplex2, least: f64) -> bool {
        let mut round = self.proposal.prestar.vertices();
        round.all(|v| v.is_ghost() || region.point(v).distance(self.proposal.point) >= least)
    }

    /// The lesser of the sizes at the ends of a boundary edge.
    fn size(&self, region: &Subcomplex2, h: HalfEdgeId) -> f64 {
        let ends = [region.mesh().origin(h), region.mesh().target(h)];
        let [a, b] = ends.map(|v| self.sizes[v.index()]);
        a.min(b)
    }
}
