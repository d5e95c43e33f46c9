//! A mesh on its way: the tetrahedra, their quality, those that wait to be improved, and changes carried out.

use crate::insertion::Inserter;
use crate::outcome::{Counters, Stop};
use crate::plan::{Exchange, Insertion, Move};
use crate::records::{Moment, Records};
use crate::smoothing::Smoother;
use crate::worklist::Worklist;
use delaunay_core::progress::Meter;
use delaunay_core::{Complex3, TetId, VertexId};

/// How much better the worst of the tetrahedra has to become that give way to others, relative.
///
/// The list of qualities would rise without a margin, too. It spares changes that gain nothing.
pub(crate) const MARGIN: f64 = 1e-3;

/// The state of an improvement.
#[derive(Debug)]
pub(crate) struct Improver<'a> {
    pub(crate) complex: Complex3,
    pub(crate) records: Records,
    pub(crate) worklist: Worklist,
    pub(crate) counters: Counters,
    /// The quality to be reached.
    pub(crate) goal: f64,
    /// As [`MARGIN`], for vertices that move.
    pub(crate) margin: f64,
    /// By vertex: only tetrahedra with one of these corners are improved; all when there is none.
    pub(crate) region: Option<Vec<bool>>,
    /// Changes that may still be made.
    budget: usize,
    pub(crate) smoother: Smoother,
    pub(crate) inserter: Inserter,
    meter: Meter<'a>,
}

impl<'a> Improver<'a> {
    pub(crate) fn new(complex: Complex3, budget: usize, meter: Meter<'a>) -> Self {
        let records = Records::of(&complex);
        Self {
            complex,
            records,
            worklist: Worklist::default(),
            counters: Counters::default(),
            goal: 0.0,
            margin: MARGIN,
            region: None,
            // So that there is a moment for each change.
            budget: budget.min(Moment::LIMIT),
            smoother: Smoother::default(),
            inserter: Inserter::default(),
            meter,
        }
    }

    /// Counts a tetrahedron that is about to be improved.
    ///
    /// # Errors
    /// When cancelled, or when no more changes may be made.
    pub(crate) fn count_one(&mut self) -> Result<(), Stop> {
        self.meter.advance()?;
        match self.budget {
            0 => Err(Stop::OutOfChanges),
            _ => Ok(()),
        }
    }

    /// Carries out an exchange if it is an improvement and makes a mesh; tells whether it has.
    pub(crate) fn exchange(&mut self, plan: &Exchange) -> bool {
        let before = self.records.worst(&plan.gone);
        if !is_better(plan.quality, before, MARGIN) {
            return false;
        }
        let new = self.complex.replace(&plan.gone, &plan.made);
        new.is_ok_and(|new| self.note(&plan.gone, &new))
    }

    /// The same for an insertion.
    pub(crate) fn insert(&mut self, plan: &Insertion) -> bool {
        let before = self.records.worst(&plan.gone);
        if !is_better(plan.quality, before, MARGIN) {
            return false;
        }
        let new = self.complex.insert(&plan.gone, plan.place);
        new.is_ok_and(|(_, star)| self.note(&plan.gone, &star))
    }

    /// The same for a move of the vertex whose star was found last.
    pub(crate) fn carry_out(&mut self, plan: Move) -> bool {
        let star = self.smoother.stars.last().to_vec();
        let before = self.records.worst(&star);
        is_better(plan.quality, before, self.margin)
            && self.complex.move_vertex(plan.vertex, plan.place).is_ok()
            && self.note(&[], &star)
    }

    /// Takes down a change that was made.
    fn note(&mut self, gone: &[TetId], new: &[TetId]) -> bool {
        self.budget -= 1;
        self.records.note_change(&self.complex, gone, new);
        self.list(new);
        true
    }

    /// Lists all tetrahedra that are to be improved, and no others.
    pub(crate) fn list_all(&mut self) {
        self.worklist = Worklist::default();
        let all: Vec<TetId> = self.complex.tets().collect();
        self.list(&all);
    }

    /// Lists those of some tetrahedra that are to be improved.
    fn list(&mut self, tets: &[TetId]) {
        let is_in = |v: VertexId| {
            let region = self.region.as_ref();
            region.is_none_or(|region| region.get(v.index()).copied().unwrap_or(false))
        };
        let mesh = self.complex.mesh();
        for &t in tets {
            if self.records.quality(t) < self.goal && mesh.tet_vertices(t).into_iter().any(is_in) {
                self.worklist.push(&self.records, t);
            }
        }
    }
}

fn is_better(quality: f64, before: f64, margin: f64) -> bool {
    quality > before && quality > before * (1.0 + margin)
}
