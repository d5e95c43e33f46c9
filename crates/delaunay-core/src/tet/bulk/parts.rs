//! A round cut into parts that grow at the same time, each on a thread of its own.
//!
//! The curve of the insertion order is cut into intervals. A vertex belongs to the part of the interval
//! it lies in, and a part inserts those of its points whose cavities have no corner in another part: see
//! [`arena`](super::arena) for why that needs no locks. What a part cannot do comes late: once more with the
//! borders moved by half a part, and what is left then on one thread.
//!
//! Which points are late depends on the number of parts but not on time, so neither do the ids.

use super::growth::{Growth, MOST_POINTS};
use super::inserter::{Inserter, Outcome};
use crate::error::BuildError;
use crate::ids::{TetId, VertexId};
use crate::order::Order;
use crate::progress::{Cancelled, Meter};
use std::sync::atomic::{AtomicBool, Ordering};

/// Points of a part below which cutting costs more than it gains.
const LEAST_POINTS: usize = 5000;

/// Points between two looks at whether the work was cancelled.
const PATIENCE: usize = 256;

/// Tetrahedra looked at for each stretch of the curve to find one to start from.
const TRIES: usize = 16;

/// The part of each stretch of the curve.
type Parts = [u16; Order::STRETCHES];

/// By stretch of the curve, a tetrahedron there with all real corners in the part of the stretch.
type Anchors = [Option<TetId>; Order::STRETCHES];

/// The parts of the stretches for `count` parts, their borders moved by `shift` half parts; what is
/// moved over the end of the curve is joined with its beginning.
fn parts(count: usize, shift: usize) -> Parts {
    let moved = shift * Order::STRETCHES / (2 * count);
    std::array::from_fn(|stretch| {
        let place = (stretch + moved) % Order::STRETCHES;
        (place * count / Order::STRETCHES) as u16
    })
}

/// What is the same for all parts of a round.
struct Plan<'a> {
    /// Slots at which the round comes to each stretch.
    stretches: &'a [u32; Order::STRETCHES],
    anchors: Anchors,
    cancelled: AtomicBool,
}

/// One part's work, and what came of it; in cache lines of its own, because it changes with every point and lies beside
/// that of another thread.
#[repr(align(128))]
struct Task {
    inserter: Inserter<true>,
    points: Vec<VertexId>,
    late: Vec<VertexId>,
    duplicates: Vec<(VertexId, VertexId)>,
}

impl Growth {
    /// Inserts the vertices of round number `round`, on as many of `threads` as pay.
    pub(super) fn insert_round(
        &mut self,
        order: &Order,
        round: usize,
        threads: usize,
        meter: &mut Meter<'_>,
    ) -> Result<(), BuildError> {
        let ranks = order.rounds[round].clone();
        let vertices = ranks.map(|rank| VertexId::from_slot(rank + 1));
        let mut points: Vec<VertexId> = vertices.filter(|&v| !self.is_in_simplex(v)).collect();
        for shift in [0, 1] {
            let count = threads.min(points.len() / LEAST_POINTS);
            let count = count.min(Order::STRETCHES / 2);
            // Before the first round is in, cavities reach across everything.
            if count < 2 || round == 0 || points.len() > MOST_POINTS {
                break;
            }
            points = self.insert_in_parts(order, round, &parts(count, shift), &points, meter)?;
        }
        self.insert_all(&points, meter)
    }

    /// Inserts those of `points`, of round number `round` and in its order, that lie in one part; returns
    /// the others.
    fn insert_in_parts(
        &mut self,
        order: &Order,
        round: usize,
        parts: &Parts,
        points: &[VertexId],
        meter: &mut Meter<'_>,
    ) -> Result<Vec<VertexId>, BuildError> {
        self.mark_parts(order, round, parts);
        let plan = Plan {
            stretches: &order.stretches[round],
            anchors: self.anchors(order, round, parts),
            cancelled: AtomicBool::new(false),
        };
        let count = usize::from(parts.iter().copied().max().unwrap_or(0)) + 1;
        let mut shares = vec![Vec::new(); count];
        for &v in points {
            shares[usize::from(self.part_of(v))].push(v);
        }
        let sizes: Vec<usize> = shares.iter().map(Vec::len).collect();
        let inserters = self.inserters(&sizes);
        let mut tasks: Vec<Task> = inserters
            .into_iter()
            .zip(shares)
            .map(|(inserter, points)| Task {
                inserter,
                points,
                late: Vec::new(),
                duplicates: Vec::new(),
            })
            .collect();
        let finished = run_all(&mut tasks, &plan, meter);
        let mut late = Vec::new();
        let mut inserters = Vec::new();
        for task in tasks {
            late.extend(task.late);
            self.note_duplicates(task.duplicates);
            inserters.push(task.inserter);
        }
        self.take_back(inserters, points.len() - late.len());
        finished?;
        late.sort_unstable();
        Ok(late)
    }

    /// For each stretch, if one is found, a tetrahedron whose real corners are all in its part.
    fn anchors(&self, order: &Order, round: usize, parts: &Parts) -> Anchors {
        let mut anchors = [None; Order::STRETCHES];
        let step = (self.tets().len() / (TRIES * Order::STRETCHES)).max(1);
        for (slot, tet) in self.tets().iter().enumerate().step_by(step) {
            let [first, rest @ ..] = tet.vertex;
            let is_real = !first.is_ghost() && !rest[2].is_ghost();
            if !is_real || rest.iter().any(|&v| self.part_of(v) != self.part_of(first)) {
                continue;
            }
            let stretch = stretch_of(order, round, first);
            // The first four vertices may be of a round to come, on no stretch yet.
            if parts[stretch] == self.part_of(first) {
                anchors[stretch] = Some(TetId::from_raw(slot as u32));
            }
        }
        anchors
    }

    /// Tells every vertex up to round number `round` its part.
    fn mark_parts(&mut self, order: &Order, round: usize, parts: &Parts) {
        for (ranks, starts) in order.rounds.iter().zip(&order.stretches).take(round + 1) {
            for (stretch, &part) in parts.iter().enumerate() {
                let start = starts[stretch] as usize;
                let end = starts
                    .get(stretch + 1)
                    .map_or(ranks.end, |&end| end as usize);
                self.set_part(start + 1..end + 1, part);
            }
        }
    }
}

/// The stretch of the curve on which `v` is, a vertex of one of the rounds up to `last`.
fn stretch_of(order: &Order, last: usize, v: VertexId) -> usize {
    let rank = v.slot() - 1;
    let round = order.rounds[..last].partition_point(|ranks| ranks.end <= rank);
    stretch(&order.stretches[round], v)
}

fn stretch(starts: &[u32; Order::STRETCHES], v: VertexId) -> usize {
    let after = starts.partition_point(|&start| (start as usize) < v.slot());
    after.saturating_sub(1)
}

/// Runs all tasks, the first on this thread, which counts its points for all.
fn run_all(tasks: &mut [Task], plan: &Plan<'_>, meter: &mut Meter<'_>) -> Result<(), Cancelled> {
    let Some((first, others)) = tasks.split_first_mut() else {
        return Ok(());
    };
    let done = rayon::in_place_scope(|scope| {
        for task in &mut *others {
            scope.spawn(|_| task.run(plan, || plan.cancelled.load(Ordering::Relaxed)));
        }
        let mut outcome = Ok(());
        first.run(plan, || {
            let step = (0..PATIENCE).try_for_each(|_| meter.advance());
            outcome = step;
            plan.cancelled.store(step.is_err(), Ordering::Relaxed);
            step.is_err()
        });
        outcome
    });
    let elsewhere = others
        .iter()
        .map(|task| task.points.len() - task.late.len());
    done.and_then(|()| (0..elsewhere.sum()).try_for_each(|_| meter.advance()))
}

impl Task {
    /// Inserts what lies in the part alone. Looks every now and then whether it `must_stop`.
    fn run(&mut self, plan: &Plan<'_>, mut must_stop: impl FnMut() -> bool) {
        let mut is_lost = true;
        for i in 0..self.points.len() {
            if i % PATIENCE == PATIENCE - 1 && must_stop() {
                return;
            }
            let v = self.points[i];
            let anchor = plan.anchors[stretch(plan.stretches, v)].filter(|_| is_lost);
            if let Some(start) = anchor.and_then(|t| self.inserter.real_at(t)) {
                self.inserter.last = start;
                self.inserter.has_start = true;
            }
            let next = self.points.get(i + 1).copied().unwrap_or(v);
            is_lost = !self.inserter.has_start || self.is_late(v, next);
            if is_lost {
                self.late.push(v);
            }
        }
    }

    /// Inserts one point if its time has come.
    fn is_late(&mut self, v: VertexId, next: VertexId) -> bool {
        let [p, next] = [v, next].map(|v| self.inserter.arena.place(v));
        match self.inserter.insert(v, p, next) {
            Outcome::Inserted => false,
            Outcome::Duplicate(vertex) => {
                self.duplicates.push((v, vertex));
                false
            }
            Outcome::Late | Outcome::Full => true,
        }
    }
}
