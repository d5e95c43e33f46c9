//! In which order tetrahedra are improved, and when one is tried again.
//!
//! The worst comes first; what a change makes is listed at once. A tetrahedron that nothing helps is put aside and tried
//! again when something has changed round one of its corners. Vertices come and go in passes of their own, only where
//! nothing else helps any more: that takes the fewest.

use crate::improver::{Improver, MARGIN};
use crate::outcome::Stop;

/// What may be done for a tetrahedron.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Means {
    /// Exchanges between the same vertices.
    Exchanges,
    /// And moves of vertices.
    Moves,
    /// And changes of their number.
    Vertices,
}

/// How much better than asked for tetrahedra have to become round one that nothing helps.
const LOOSER: f64 = 1.25;

impl Improver<'_> {
    /// Makes the tetrahedra better that are worse than `goal`, those worse than `vertices_below` with other vertices, too.
    ///
    /// Cheap means first, and great gains first: where others have moved already, there is less to do.
    ///
    /// # Errors
    /// Why it ended before nothing helped any more.
    pub(crate) fn run(&mut self, goal: f64, vertices_below: f64) -> Result<(), Stop> {
        self.reach(goal, Means::Exchanges, MARGIN)?;
        self.reach(goal, Means::Moves, 0.03)?;
        self.reach(goal, Means::Moves, 0.01)?;
        self.reach(vertices_below, Means::Vertices, 0.01)?;
        self.reach(vertices_below, Means::Vertices, MARGIN)?;
        self.loosen(vertices_below)
    }

    /// A tetrahedron that nothing helps may be held by some round it that have just what was asked for. Makes those with a
    /// corner in common with one worse than `bound` better than that.
    fn loosen(&mut self, bound: f64) -> Result<(), Stop> {
        let mut region = vec![false; self.complex.points().len()];
        for t in self.complex.tets() {
            if self.records.quality(t) < bound {
                for v in self.complex.mesh().tet_vertices(t) {
                    region[v.index()] = true;
                }
            }
        }
        if !region.contains(&true) {
            return Ok(());
        }
        self.region = Some(region);
        self.reach(LOOSER * bound, Means::Vertices, MARGIN)
    }

    /// Tries `means` on all tetrahedra of the region worse than `goal` until nothing helps. A vertex that moves has to make
    /// its star better by `margin`, relative.
    fn reach(&mut self, goal: f64, means: Means, margin: f64) -> Result<(), Stop> {
        (self.goal, self.margin) = (goal, margin);
        self.records.unsettle();
        self.list_all();
        loop {
            self.keep_vertices(means != Means::Exchanges)?;
            if means != Means::Vertices || !self.change_vertices()? {
                return Ok(());
            }
        }
    }

    /// Improves the tetrahedra listed by exchanges and, if `may_move`, by moves, until nothing helps.
    fn keep_vertices(&mut self, may_move: bool) -> Result<(), Stop> {
        loop {
            while let Some((t, since)) = self.worklist.next(&self.records) {
                self.count_one()?;
                let changed = self.exchange_at(t, since) || may_move && self.move_corner(t);
                if !changed {
                    self.worklist.park(&self.records, t);
                }
            }
            if !self.worklist.resume(&self.complex, &self.records) {
                return Ok(());
            }
        }
    }

    /// Tries once for each tetrahedron put aside to improve it by contraction or insertion; tells whether that has changed
    /// anything.
    ///
    /// Where something has changed just before, moves may do as well, so tetrahedra there wait for the next pass. In a region
    /// they do not: what has withstood all else is freed more often by several new vertices at once.
    fn change_vertices(&mut self) -> Result<bool, Stop> {
        let start = self.records.now();
        for (t, made) in self.worklist.parked() {
            if self.records.made(t) != made {
                continue;
            }
            let corners = self.complex.mesh().tet_vertices(t);
            let is_news = |then| corners.into_iter().any(|v| self.records.is_news(v, then));
            let waits = self.region.is_none() && is_news(start);
            if waits || !is_news(self.records.given_up(t)) {
                continue;
            }
            self.count_one()?;
            if !(self.contract_edge(t) || self.insert_vertex(t)) {
                self.records.give_up(t);
            }
        }
        Ok(self.records.now() > start)
    }
}
