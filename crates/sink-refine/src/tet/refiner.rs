//! A mesh on its way: the subcomplex, the quality of its tetrahedra, and those that wait to be improved.

use super::proposal::{Proposal, Rejection3};
use super::records::Records;
use crate::history::{Counters, Round};
use crate::stamp::Stamp;
use crate::stop::Stop;
use crate::worklist::{Entry, Worklist};
use delaunay_core::progress::Meter;
use delaunay_core::{FacetId, Merge, Patch, Subcomplex3, TetId, VertexId};
use glam::DVec3;

/// The state that all schedules share.
#[derive(Debug)]
pub(crate) struct Refiner<'a> {
    pub(crate) solid: Subcomplex3,
    pub(crate) records: Records<'a>,
    worklist: Worklist<TetId>,
    pub(crate) counters: Counters,
    pub(crate) rounds: Vec<Round>,
    /// The point tested last.
    pub(crate) proposal: Proposal,
    /// Vertices that may still be added.
    budget: usize,
    meter: Meter<'a>,
    /// Points tested at the last report that was due to them.
    reported: usize,
    gone: Vec<TetId>,
}

impl<'a> Refiner<'a> {
    pub(crate) fn new(
        solid: Subcomplex3,
        records: Records<'a>,
        budget: usize,
        meter: Meter<'a>,
    ) -> Self {
        Self {
            solid,
            records,
            worklist: Worklist::new(),
            counters: Counters::default(),
            rounds: Vec::new(),
            proposal: Proposal::default(),
            budget,
            meter,
            reported: 0,
            gone: Vec::new(),
        }
    }

    /// Tests a point, see [`Proposal::make`].
    pub(crate) fn propose(
        &mut self,
        point: DVec3,
        seed: TetId,
        separation: f64,
    ) -> Result<(), Rejection3> {
        let made = self.proposal.make(&self.solid, point, seed, separation);
        self.count_test(made.err());
        made
    }

    /// Tests a point without the boundary test.
    pub(crate) fn propose_anywhere(&mut self, point: DVec3, seed: TetId) -> Result<(), Rejection3> {
        self.counters.tested += 1;
        self.proposal.make_anywhere(&self.solid, point, seed)
    }

    /// Counts a point that was tested elsewhere.
    pub(crate) fn count_test(&mut self, rejection: Option<Rejection3>) {
        self.counters.tested += 1;
        self.counters.encroaching +=
            usize::from(matches!(rejection, Some(Rejection3::Encroaches(_))));
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
        self.gone.clear();
        let vertex = self.fill(proposal)?;
        self.records.forget(self.gone.drain(..));
        self.examine(proposal.prestar.tets())?;
        self.meter.advance()?;
        Ok(vertex)
    }

    /// Inserts a point on the boundary facet `on`, with the ghosts in its prestar; else as [`insert`](Self::insert) does.
    ///
    /// # Errors
    /// As [`insert`](Self::insert).
    pub(crate) fn insert_on_boundary(
        &mut self,
        proposal: &mut Proposal,
        on: FacetId,
    ) -> Result<VertexId, Stop> {
        self.gone.clear();
        let vertex = self.fill(proposal)?;
        // When all tetrahedra stay, the new ones are in the region of those under them.
        self.records.inherit(proposal.prestar.tets(), &[on.tet()]);
        self.counters.split += 1;
        self.records.forget(self.gone.drain(..));
        let star = proposal.prestar.tets().iter().copied();
        let real: Vec<TetId> = star
            .filter(|&t| !self.solid.mesh().is_ghost_tet(t))
            .collect();
        self.examine(&real)?;
        self.meter.advance()?;
        Ok(vertex)
    }

    /// Inserts independent points that have passed their tests. What comes of them is measured on all threads.
    ///
    /// # Errors
    /// Why not all points were inserted; the others were.
    pub(crate) fn insert_all(
        &mut self,
        proposals: impl IntoIterator<Item = Proposal>,
    ) -> Result<(), Stop> {
        self.gone.clear();
        let mut new = Vec::new();
        let mut ended = Ok(());
        for mut proposal in proposals {
            ended = self.fill(&mut proposal).map(|_| ());
            if ended.is_err() {
                break;
            }
            new.extend_from_slice(proposal.prestar.tets());
        }
        self.records.forget(self.gone.drain(..));
        self.records.examine_together(&self.solid, &new);
        self.records.check_sizes()?;
        self.meter.reach(self.counters.inserted)?;
        ended
    }

    /// Replaces a prestar by the star of its point; the records are those of before.
    fn fill(&mut self, proposal: &mut Proposal) -> Result<VertexId, Stop> {
        if self.budget == 0 {
            return Err(Stop::OutOfVertices);
        }
        let before = self.gone.len();
        self.gone.extend_from_slice(proposal.prestar.tets());
        let Some(vertex) = self.solid.fill(proposal.point, &mut proposal.prestar) else {
            self.gone.truncate(before);
            return Err(Stop::OutOfIds);
        };
        let gone = &self.gone[before..];
        self.records.inherit(proposal.prestar.tets(), gone);
        self.budget -= 1;
        self.counters.inserted += 1;
        Ok(vertex)
    }

    /// Removes the vertex of a patch just found. Gives the new tetrahedra; `None`, with nothing changed, when they do not
    /// fill the hole.
    ///
    /// # Errors
    /// When cancelled, or when a size is unusable.
    pub(crate) fn remove(&mut self, patch: &Patch) -> Result<Option<Vec<TetId>>, Stop> {
        let Some(tets) = self.solid.remove(patch) else {
            return Ok(None);
        };
        self.budget = self.budget.saturating_add(1);
        self.counters.removed += 1;
        self.records.forget(patch.star().iter().copied());
        self.records.inherit(&tets, patch.star());
        self.examine(&tets)?;
        self.meter.advance()?;
        Ok(Some(tets))
    }

    /// Makes one vertex of two, see [`Subcomplex3::merge`]; tells whether it did, or nothing has changed.
    ///
    /// # Errors
    /// When cancelled, or when a size is unusable.
    pub(crate) fn merge(&mut self, pair: [VertexId; 2], merge: &Merge) -> Result<bool, Stop> {
        let Some(tets) = self.solid.merge(pair, merge) else {
            return Ok(false);
        };
        self.budget = self.budget.saturating_add(1);
        self.counters.removed += 2;
        self.counters.inserted += 1;
        self.records.forget(merge.gone.iter().copied());
        self.records.inherit(&tets, &merge.gone);
        self.examine(&tets)?;
        self.meter.advance()?;
        Ok(true)
    }

    /// Reports that work goes on, though nothing has changed.
    ///
    /// # Errors
    /// When cancelled.
    pub(crate) fn pause(&mut self) -> Result<(), Stop> {
        Ok(self.meter.advance()?)
    }

    /// Measures new tetrahedra and puts those of low quality on the worklist.
    ///
    /// # Errors
    /// When a size is unusable.
    fn examine(&mut self, tets: &[TetId]) -> Result<(), Stop> {
        self.records.examine(&self.solid, tets);
        self.list(tets);
        self.records.check_sizes()
    }

    /// Lists all tetrahedra of low quality, for passes over them; rounds need no list.
    pub(crate) fn list_all(&mut self) {
        let all: Vec<TetId> = self.solid.tets().collect();
        self.list(&all);
    }

    /// Lists those of tetrahedra that are of low quality.
    fn list(&mut self, tets: &[TetId]) {
        for &tet in tets {
            if self.records.is_low(tet) {
                self.worklist.push(self.entry(tet));
            }
        }
    }

    fn entry(&self, tet: TetId) -> Entry<TetId> {
        Entry {
            urgency: self.records.badness(tet),
            id: tet,
            stamp: self.records.stamp(tet),
        }
    }

    /// Lets `insert_for` have each tetrahedron of low quality, those put aside too, in passes that are recorded as rounds, until a
    /// pass inserts nothing.
    ///
    /// # Errors
    /// That of `insert_for`.
    pub(crate) fn in_passes(
        &mut self,
        mut insert_for: impl FnMut(&mut Self, TetId) -> Result<(), Stop>,
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

    /// Lets `insert_for` have each tetrahedron that is listed; tells how many points were inserted.
    ///
    /// # Errors
    /// That of `insert_for`.
    pub(crate) fn pass(
        &mut self,
        mut insert_for: impl FnMut(&mut Self, TetId) -> Result<(), Stop>,
    ) -> Result<usize, Stop> {
        let before = self.counters.inserted;
        while let Some(tet) = self.worklist.next(|id| self.records.stamp(id)) {
            insert_for(self, tet)?;
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

    /// Lists the tetrahedra put aside again.
    pub(crate) fn resume(&mut self) {
        self.worklist.resume(|id| self.records.stamp(id));
    }

    /// Lists a tetrahedron of the time of `stamp` again when something was inserted for it, else puts it aside; not when it is
    /// gone.
    pub(crate) fn put_back(&mut self, tet: TetId, stamp: Stamp, inserted: bool) {
        if self.records.stamp(tet) == stamp {
            match inserted {
                true => self.list(&[tet]),
                false => self.worklist.park(self.entry(tet)),
            }
        }
    }

    /// Starts a round: takes down the size and quality of the mesh.
    pub(crate) fn begin_round(&mut self) -> &mut Round {
        let (ratios, low) = self.records.summary();
        let mut round = Round {
            vertices: self.solid.vertex_count(),
            low,
            ..Round::default()
        };
        if let Some(ratios) = ratios {
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
