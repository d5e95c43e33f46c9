//! A mesh on its way: the subcomplex, the quality of its triangles, and those that wait to be improved.

use super::proposal::{Proposal, Rejection2};
use super::records::Records;
use crate::history::{Counters, Round};
use crate::stamp::Stamp;
use crate::stop::Stop;
use crate::worklist::{Entry, Worklist};
use delaunay_core::measure::Summary;
use delaunay_core::progress::Meter;
use delaunay_core::{FaceId, Patch2, Refilled, Subcomplex2, VertexId};
use glam::DVec2;

/// Which triangle is the most urgent.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Urgency {
    /// The one with the largest ratio, or the one that is as bad for its size.
    #[default]
    Worst,
    /// The one with the shortest edge.
    ShortestEdge,
}

/// The state that all schedules share.
#[derive(Debug)]
pub(crate) struct Refiner<'a> {
    pub(crate) region: Subcomplex2,
    pub(crate) records: Records<'a>,
    urgency: Urgency,
    worklist: Worklist<FaceId>,
    pub(crate) counters: Counters,
    pub(crate) rounds: Vec<Round>,
    /// The point tested last.
    pub(crate) proposal: Proposal,
    /// Vertices that may still be added.
    budget: usize,
    meter: Meter<'a>,
    /// Points tested at the last report that was due to them.
    reported: usize,
    gone: Vec<FaceId>,
}

impl<'a> Refiner<'a> {
    pub(crate) fn new(
        region: Subcomplex2,
        records: Records<'a>,
        budget: usize,
        meter: Meter<'a>,
    ) -> Self {
        let mut refiner = Self {
            region,
            records,
            urgency: Urgency::default(),
            worklist: Worklist::new(),
            counters: Counters::default(),
            rounds: Vec::new(),
            proposal: Proposal::default(),
            budget,
            meter,
            reported: 0,
            gone: Vec::new(),
        };
        refiner.list_all();
        refiner
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
    /// Why no more points are inserted; the mesh is as before then, but when cancelled or a size is unusable.
    pub(crate) fn insert(&mut self, proposal: &mut Proposal) -> Result<VertexId, Stop> {
        let vertex = self.fill(proposal)?;
        self.examine(proposal.prestar.faces())?;
        self.meter.advance()?;
        Ok(vertex)
    }

    /// Inserts a point on the boundary, with the ghost in its prestar; else as [`insert`](Self::insert) does.
    ///
    /// # Errors
    /// As [`insert`](Self::insert).
    pub(crate) fn insert_on_boundary(&mut self, proposal: &mut Proposal) -> Result<VertexId, Stop> {
        let vertex = self.fill(proposal)?;
        self.counters.split += 1;
        self.examine_real(proposal.prestar.faces())?;
        self.meter.advance()?;
        Ok(vertex)
    }

    /// Lets a vertex that has just been inserted on a boundary edge divide the edge on the other side of a cut, with the
    /// prestar there.
    ///
    /// # Errors
    /// As [`insert`](Self::insert).
    pub(crate) fn insert_on_other_side(
        &mut self,
        vertex: VertexId,
        proposal: &mut Proposal,
    ) -> Result<(), Stop> {
        self.gone.clear();
        self.gone.extend_from_slice(proposal.prestar.faces());
        if !self.region.fill_other_side(vertex, &mut proposal.prestar) {
            return Err(Stop::OutOfIds);
        }
        self.records.inherit(proposal.prestar.faces(), &self.gone);
        self.records.forget(self.gone.drain(..));
        self.examine_real(proposal.prestar.faces())
    }

    /// As [`examine`](Self::examine), of faces that may be ghosts.
    fn examine_real(&mut self, faces: &[FaceId]) -> Result<(), Stop> {
        let mut real = faces.to_vec();
        real.retain(|&f| !self.region.mesh().is_ghost_face(f));
        self.examine(&real)
    }

    /// Replaces a prestar by the star of its point, and forgets what is gone.
    fn fill(&mut self, proposal: &mut Proposal) -> Result<VertexId, Stop> {
        if self.budget == 0 {
            return Err(Stop::OutOfVertices);
        }
        self.gone.clear();
        self.gone.extend_from_slice(proposal.prestar.faces());
        let filled = self.region.fill(proposal.point, &mut proposal.prestar);
        let vertex = filled.ok_or(Stop::OutOfIds)?;
        self.budget -= 1;
        self.counters.inserted += 1;
        self.records.inherit(proposal.prestar.faces(), &self.gone);
        self.records.forget(self.gone.drain(..));
        Ok(vertex)
    }

    /// Removes the vertex of a patch just found.
    ///
    /// # Errors
    /// When cancelled, or when a size is unusable.
    pub(crate) fn remove(&mut self, patch: &Patch2) -> Result<Refilled, Stop> {
        let refilled = self.region.remove(patch);
        self.budget = self.budget.saturating_add(1);
        self.counters.removed += 1;
        self.records.forget(patch.star().iter().copied());
        self.records.rename(&refilled.moved);
        let mesh = self.region.mesh();
        let moved = refilled.moved.iter().map(|&(_, new)| new);
        let mut renewed: Vec<FaceId> = refilled.made.iter().copied().chain(moved).collect();
        // One that has moved twice is not where it was in between.
        renewed.retain(|f| f.index() < mesh.face_count() && !mesh.is_ghost_face(*f));
        renewed.sort_unstable();
        renewed.dedup();
        self.examine(&renewed)?;
        self.meter.advance()?;
        Ok(refilled)
    }

    /// Reports that work goes on, though nothing has changed.
    ///
    /// # Errors
    /// When cancelled.
    pub(crate) fn pause(&mut self) -> Result<(), Stop> {
        Ok(self.meter.advance()?)
    }

    /// Begins to work in another order.
    pub(crate) fn reorder(&mut self, urgency: Urgency) {
        self.urgency = urgency;
        self.worklist = Worklist::new();
        self.list_all();
    }

    /// Measures new triangles and puts those of low quality on the worklist.
    ///
    /// # Errors
    /// When a size is unusable.
    fn examine(&mut self, faces: &[FaceId]) -> Result<(), Stop> {
        self.records.examine(&self.region, faces.iter().copied());
        self.list(faces);
        self.records.check_sizes()
    }

    /// Lists all triangles of low quality.
    fn list_all(&mut self) {
        let all: Vec<FaceId> = self.region.faces().collect();
        self.list(&all);
    }

    /// Lists those of triangles that are of low quality.
    fn list(&mut self, faces: &[FaceId]) {
        for &face in faces {
            if self.records.is_low(face) {
                self.worklist.push(self.entry(face));
            }
        }
    }

    fn entry(&self, face: FaceId) -> Entry<FaceId> {
        let urgency = match self.urgency {
            Urgency::Worst => self.records.badness(face),
            Urgency::ShortestEdge => -self.records.squared_shortest(face),
        };
        Entry {
            urgency,
            id: face,
            stamp: self.records.stamp(face),
        }
    }

    /// Lets `insert_for` have each triangle of low quality, those put aside too, in passes that are recorded as rounds, until a
    /// pass inserts nothing.
    ///
    /// # Errors
    /// That of `insert_for`.
    pub(crate) fn in_passes(
        &mut self,
        mut insert_for: impl FnMut(&mut Self, FaceId) -> Result<(), Stop>,
    ) -> Result<(), Stop> {
        loop {
            self.begin_round();
            if self.in_round(|refiner| refiner.pass(&mut insert_for))? == 0 {
                return Ok(());
            }
            self.resume();
        }
    }

    /// Lets `insert` insert the points of the round begun last, and counts them, also when it ends early.
    ///
    /// # Errors
    /// That of `insert`.
    pub(crate) fn in_round<T>(
        &mut self,
        insert: impl FnOnce(&mut Self) -> Result<T, Stop>,
    ) -> Result<T, Stop> {
        let before = self.counters.inserted;
        let ended = insert(self);
        self.round().inserted = self.counters.inserted - before;
        ended
    }

    /// Lets `insert_for` have each triangle that is listed; tells how many points were inserted.
    ///
    /// # Errors
    /// That of `insert_for`.
    pub(crate) fn pass(
        &mut self,
        mut insert_for: impl FnMut(&mut Self, FaceId) -> Result<(), Stop>,
    ) -> Result<usize, Stop> {
        let before = self.counters.inserted;
        while let Some(face) = self.worklist.next(|id| self.records.stamp(id)) {
            insert_for(self, face)?;
            self.report_tests()?;
        }
        Ok(self.counters.inserted - before)
    }

    /// Reports when many points have been tested since: there may be no insertions for long.
    fn report_tests(&mut self) -> Result<(), Stop> {
        const STRIDE: usize = 1 << 8;
        if self.counters.tested >= self.reported + STRIDE {
            self.reported = self.counters.tested;
            self.meter.reach(self.counters.inserted)?;
        }
        Ok(())
    }

    /// Lists the triangles put aside again.
    pub(crate) fn resume(&mut self) {
        self.worklist.resume(|id| self.records.stamp(id));
    }

    /// Lists a triangle of the time of `stamp` again when something was inserted for it, else puts it aside; not when it is gone.
    pub(crate) fn put_back(&mut self, face: FaceId, stamp: Stamp, inserted: bool) {
        if self.records.stamp(face) == stamp {
            match inserted {
                true => self.list(&[face]),
                false => self.worklist.park(self.entry(face)),
            }
        }
    }

    /// Starts a round: takes down the size and quality of the mesh.
    pub(crate) fn begin_round(&mut self) -> &mut Round {
        let ratios = self.region.faces().map(|f| self.records.quality(f).ratio());
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
