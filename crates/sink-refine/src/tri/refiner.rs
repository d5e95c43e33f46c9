//! A mesh on its way: the subcomplex, the quality of its triangles, and those that wait to be improved.

use super::proposal::{Proposal, Rejection2};
use super::records::Records;
use super::worklist::{Urgency, Worklist};
use crate::history::{Counters, Round};
use crate::stop::Stop;
use delaunay_core::measure::Summary;
use delaunay_core::progress::Meter;
use delaunay_core::{FaceId, Patch2, Refilled, Subcomplex2, VertexId};
use glam::DVec2;

/// The state that all schedules share.
#[derive(Debug)]
pub(crate) struct Refiner<'a> {
    pub(crate) region: Subcomplex2,
    pub(crate) records: Records,
    pub(crate) worklist: Worklist,
    pub(crate) counters: Counters,
    pub(crate) rounds: Vec<Round>,
    /// The point tested last.
    pub(crate) proposal: Proposal,
    /// Vertices that may still be added.
    budget: usize,
    meter: Meter<'a>,
    gone: Vec<FaceId>,
}

impl<'a> Refiner<'a> {
    pub(crate) fn new(
        region: Subcomplex2,
        records: Records,
        budget: usize,
        meter: Meter<'a>,
    ) -> Self {
        let mut worklist = Worklist::default();
        worklist.examine(&records, region.faces());
        Self {
            region,
            records,
            worklist,
            counters: Counters::default(),
            rounds: Vec::new(),
            proposal: Proposal::default(),
            budget,
            meter,
            gone: Vec::new(),
        }
    }

    /// Tests a point, see [`Proposal::make`].
    pub(crate) fn propose(
        &mut self,
        point: DVec2,
        seed: FaceId,
        separation: f64,
    ) -> Result<(), Rejection2> {
        let made = self.proposal.make(&self.region, point, seed, separation);
        self.count_test(made.err());
        made
    }

    /// Tests a point without the boundary test.
    pub(crate) fn propose_anywhere(
        &mut self,
        point: DVec2,
        seed: FaceId,
    ) -> Result<(), Rejection2> {
        self.counters.tested += 1;
        self.proposal.make_anywhere(&self.region, point, seed)
    }

    /// Counts a point that was tested elsewhere.
    pub(crate) fn count_test(&mut self, rejection: Option<Rejection2>) {
        self.counters.tested += 1;
        self.counters.encroaching +=
            usize::from(matches!(rejection, Some(Rejection2::Encroaches(_))));
    }

    /// Inserts the point tested last.
    pub(crate) fn insert_proposed(&mut self) -> Result<VertexId, Stop> {
        let mut proposal = std::mem::take(&mut self.proposal);
        let inserted = self.insert(&mut proposal);
        self.proposal = proposal;
        inserted
    }

    /// Inserts a point that has passed its tests since the mesh has changed last; its prestar becomes its star.
    ///
    /// # Errors
    /// Why no more points are inserted; the mesh is as before then, but when cancelled.
    pub(crate) fn insert(&mut self, proposal: &mut Proposal) -> Result<VertexId, Stop> {
        if self.budget == 0 {
            return Err(Stop::OutOfVertices);
        }
        self.gone.clear();
        self.gone.extend_from_slice(proposal.prestar.faces());
        let filled = self.region.fill(proposal.point, &mut proposal.prestar);
        let vertex = filled.ok_or(Stop::OutOfIds)?;
        self.budget -= 1;
        self.counters.inserted += 1;
        self.records.forget(self.gone.drain(..));
        self.examine(proposal.prestar.faces());
        self.meter.advance()?;
        Ok(vertex)
    }

    /// Removes the vertex of a patch just found.
    ///
    /// # Errors
    /// When cancelled.
    pub(crate) fn remove(&mut self, patch: &Patch2) -> Result<Refilled, Stop> {
        let refilled = self.region.remove(patch);
        self.budget = self.budget.saturating_add(1);
        self.counters.removed += 1;
        self.records.forget(patch.star().iter().copied());
        let mesh = self.region.mesh();
        let moved = refilled.moved.iter().map(|&(_, new)| new);
        let mut renewed: Vec<FaceId> = refilled.made.iter().copied().chain(moved).collect();
        // One that has moved twice is not where it was in between.
        renewed.retain(|f| f.index() < mesh.face_count() && !mesh.is_ghost_face(*f));
        renewed.sort_unstable();
        renewed.dedup();
        self.examine(&renewed);
        self.meter.advance()?;
        Ok(refilled)
    }

    /// Begins to work in another order.
    pub(crate) fn reorder(&mut self, urgency: Urgency) {
        self.worklist = Worklist::new(urgency);
        self.worklist.examine(&self.records, self.region.faces());
    }

    /// Measures new triangles and puts those of low quality on the worklist.
    pub(crate) fn examine(&mut self, faces: &[FaceId]) {
        self.records.examine(&self.region, faces.iter().copied());
        self.worklist.examine(&self.records, faces.iter().copied());
    }

    /// Starts a round: takes down the size and quality of the mesh.
    pub(crate) fn begin_round(&mut self) -> &mut Round {
        let ratios = self.region.faces().map(|f| self.records.ratio(f));
        let low = self.region.faces().filter(|&f| self.records.is_low(f));
        let mut round = Round {
            vertices: self.region.vertex_count(),
            low: low.count(),
            ..Round::default()
        };
        if let Some(ratios) = Summary::of(ratios) {
            round.elements = ratios.count;
            round.min_ratio = ratios.min;
            round.mean_ratio = ratios.mean;
            round.max_ratio = ratios.max;
        }
        self.rounds.push(round);
        self.round()
    }

    /// The round begun last.
    pub(crate) fn round(&mut self) -> &mut Round {
        if self.rounds.is_empty() {
            self.rounds.push(Round::default());
        }
        let last = self.rounds.len() - 1;
        &mut self.rounds[last]
    }
}
