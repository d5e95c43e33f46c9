//! Triangles for which no candidate passed the tests: other points are tried, and taken when there are fewer low
//! triangles with them.
//!
//! 1. Points that a boundary edge rejected slide out of its diametral circle.
//! 2. Random points near the triangle.
//! 3. The same without the boundary test: then a boundary edge may have a vertex inside its diametral circle. The boundary
//!    itself stays in any case.
//!
//! Triangles on a boundary edge that is itself larger than their size allows are left as they are.
//!
//! Each point lowers the number of low triangles, so there are no more of them than there were leftovers.

use super::super::low::long_edge;
use super::super::proposal::{Proposal, Rejection2};
use super::super::refiner::Refiner;
use super::cascade::list_candidates;
use super::gain::Gain;
use super::off_center::OffCenters;
use crate::random_points::RandomPoints;
use crate::stamp::Stamp;
use crate::stop::Stop;
use delaunay_core::{FaceId, HalfEdgeId};
use glam::DVec2;
use rustc_hash::FxHashSet;

/// How often a point slides from one edge to the next.
const SLIDES: usize = 3;

/// Points tested with one effort, at most, in parts of the number of triangles. Leftovers are few unless much of the boundary
/// is in the way; then this keeps the work linear.
const TESTS: usize = 4;

/// What is tried.
#[derive(Clone, Copy)]
struct Effort {
    /// Random points for a triangle.
    trials: usize,
    respects_circles: bool,
}

const EFFORTS: [Effort; 3] = [
    Effort {
        trials: 0,
        respects_circles: true,
    },
    Effort {
        trials: 100,
        respects_circles: true,
    },
    Effort {
        trials: 100,
        respects_circles: false,
    },
];

pub(super) fn run(refiner: &mut Refiner<'_>) -> Result<(), Stop> {
    for effort in EFFORTS {
        let last = refiner
            .counters
            .tested
            .saturating_add(TESTS * refiner.records.slots());
        Cure::new(effort, last).all(refiner)?;
    }
    Ok(())
}

/// Room for curing.
struct Cure {
    effort: Effort,
    /// When so many points have been tested, it ends.
    last_test: usize,
    candidates: Vec<(DVec2, FaceId)>,
    best: Proposal,
    best_gain: Gain,
    /// Those tried that are too large, but not skinny.
    tried: FxHashSet<(FaceId, Stamp)>,
}

impl Cure {
    fn new(effort: Effort, last_test: usize) -> Self {
        Self {
            effort,
            last_test,
            candidates: Vec::new(),
            best: Proposal::default(),
            best_gain: Gain::default(),
            tried: FxHashSet::default(),
        }
    }

    /// Tries all leftovers, the most urgent first, until none of them can be cured.
    fn all(&mut self, refiner: &mut Refiner<'_>) -> Result<(), Stop> {
        loop {
            refiner.resume();
            if refiner.pass(|refiner, face| self.one(refiner, face))? == 0 {
                return Ok(());
            }
        }
    }

    /// Inserts the best point for a triangle, or puts the triangle aside.
    fn one(&mut self, refiner: &mut Refiner<'_>, face: FaceId) -> Result<(), Stop> {
        let stamp = refiner.records.stamp(face);
        if !self.is_worth_trying(refiner, face) {
            refiner.put_back(face, stamp, false);
            return Ok(());
        }
        self.best_gain = Gain::default();
        let off = OffCenters::of_triangle(refiner, face);
        list_candidates(refiner, face, &off, &mut self.candidates);
        self.add_random_points(refiner, face);
        for i in 0..self.candidates.len() {
            let (point, seed) = self.candidates[i];
            self.slide(refiner, point, seed, off.separation());
        }
        if self.best_gain.low < 0 {
            refiner.insert(&mut self.best)?;
        }
        refiner.put_back(face, stamp, false);
        Ok(())
    }

    /// Whether a point may cure a triangle.
    ///
    /// One whose only defect is its size is tried once: those are many where the boundary is too coarse, and a pass over
    /// all of them for each point inserted would take long.
    fn is_worth_trying(&mut self, refiner: &Refiner<'_>, face: FaceId) -> bool {
        let records = &refiner.records;
        if refiner.counters.tested >= self.last_test {
            return false;
        }
        let first = records.is_skinny(face) || self.tried.insert((face, records.stamp(face)));
        first && long_edge(&refiner.region, records, face).is_none()
    }

    /// Tries a point, and where it slides to.
    fn slide(
        &mut self,
        refiner: &mut Refiner<'_>,
        mut point: DVec2,
        seed: FaceId,
        separation: f64,
    ) {
        for _ in 0..=SLIDES {
            let tested = match self.effort.respects_circles {
                true => refiner.propose(point, seed, separation),
                false => refiner.propose_anywhere(point, seed),
            };
            match tested {
                Ok(()) => return self.keep_if_better(refiner),
                Err(Rejection2::Encroaches(edge)) => {
                    point = outside_diametral_circle(refiner, edge, point);
                }
                Err(_) => return,
            }
        }
    }

    fn keep_if_better(&mut self, refiner: &mut Refiner<'_>) {
        let gain = Gain::of(&refiner.region, &refiner.records, &refiner.proposal);
        let best = (self.best_gain.low, self.best_gain.excess);
        if gain.low < 0 && (gain.low, gain.excess) < best {
            self.best_gain = gain;
            std::mem::swap(&mut self.best, &mut refiner.proposal);
        }
    }

    /// Adds random points in the triangle and its neighbours, the same ones whenever it comes.
    fn add_random_points(&mut self, refiner: &Refiner<'_>, face: FaceId) {
        let mesh = refiner.region.mesh();
        let around = face.half_edges().map(|h| mesh.twin(h).face());
        let around = around.into_iter().filter(|&f| !mesh.is_ghost_face(f));
        let homes: Vec<FaceId> = std::iter::once(face).chain(around).collect();
        let corners = refiner.region.triangle(face);
        let mut random = RandomPoints::of(corners.iter().flat_map(DVec2::to_array));
        for trial in 0..self.effort.trials {
            let home = homes[trial % homes.len()];
            let point = random.next_in(refiner.region.triangle(home));
            self.candidates.push((point, home));
        }
    }
}

/// `point` moved just out of the diametral circle of a boundary edge, to the inside.
fn outside_diametral_circle(refiner: &Refiner<'_>, edge: HalfEdgeId, point: DVec2) -> DVec2 {
    const OUT: f64 = 1.0001;
    let [a, b] = refiner.region.segment(edge);
    let center = a.midpoint(b);
    let inward = (b - a).perp().normalize_or_zero();
    let way = point - center;
    let direction = match way.dot(inward) > 0.0 {
        true => way.normalize_or(inward),
        false => inward,
    };
    center + direction * (OUT * center.distance(a))
}
