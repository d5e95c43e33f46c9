//! Tetrahedra for which no candidate passed the tests: other points are tried, and taken when there are fewer low
//! tetrahedra with them.
//!
//! 1. Points that a boundary facet rejected slide out of its diametral sphere.
//! 2. Random points near the tetrahedron.
//! 3. The same without the boundary test: then a boundary facet may have a vertex inside its diametral sphere. The boundary
//!    itself stays in any case.
//!
//! Tetrahedra on a boundary facet that is itself of low quality or larger than their size allows are left as they are.
//!
//! Each point lowers the number of low tetrahedra, so there are no more of them than there were leftovers.

use super::super::flow::FlowWalk;
use super::super::low::{large_boundary, skinny_boundary};
use super::super::proposal::{Proposal, Rejection3};
use super::super::refiner::Refiner;
use super::gain::Gain;
use super::greedy::candidates;
use super::off_center::OffCenters;
use crate::random_points::RandomPoints;
use crate::stamp::Stamp;
use crate::stop::Stop;
use delaunay_core::measure::facet::circumcenter;
use delaunay_core::{FacetId, TetId};
use glam::DVec3;
use rustc_hash::FxHashSet;

/// How often a point slides from one facet to the next.
const SLIDES: usize = 3;

/// Points tested with one effort, at most, in parts of the number of tetrahedra. Leftovers are few unless much of the boundary
/// is in the way; then this keeps the work linear.
const TESTS: usize = 4;

/// What is tried.
#[derive(Clone, Copy)]
struct Effort {
    /// Random points for a tetrahedron.
    trials: usize,
    respects_spheres: bool,
}

/// The last one is for a handful of tetrahedra.
const EFFORTS: [Effort; 3] = [
    Effort {
        trials: 0,
        respects_spheres: true,
    },
    Effort {
        trials: 40,
        respects_spheres: true,
    },
    Effort {
        trials: 400,
        respects_spheres: false,
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
    walk: FlowWalk,
    candidates: Vec<(DVec3, TetId)>,
    best: Proposal,
    best_gain: Gain,
    /// Those tried that are too large, but not skinny.
    tried: FxHashSet<(TetId, Stamp)>,
}

impl Cure {
    fn new(effort: Effort, last_test: usize) -> Self {
        Self {
            effort,
            last_test,
            walk: FlowWalk::default(),
            candidates: Vec::new(),
            best: Proposal::default(),
            best_gain: Gain::default(),
            tried: FxHashSet::default(),
        }
    }

    /// Tries all leftovers, the worst first, until none of them can be cured.
    fn all(&mut self, refiner: &mut Refiner<'_>) -> Result<(), Stop> {
        loop {
            refiner.resume();
            if refiner.pass(|refiner, tet| self.one(refiner, tet))? == 0 {
                return Ok(());
            }
        }
    }

    /// Inserts the best point for a tetrahedron, or puts the tetrahedron aside.
    fn one(&mut self, refiner: &mut Refiner<'_>, tet: TetId) -> Result<(), Stop> {
        let stamp = refiner.records.stamp(tet);
        if !self.is_worth_trying(refiner, tet) {
            refiner.put_back(tet, stamp, false);
            return Ok(());
        }
        self.best_gain = Gain::default();
        let off = OffCenters::of_tetrahedron(refiner, tet);
        candidates(refiner, &mut self.walk, tet, &off, &mut self.candidates);
        self.add_random_points(refiner, tet);
        for i in 0..self.candidates.len() {
            let (point, seed) = self.candidates[i];
            self.slide(refiner, point, seed, off.separation());
        }
        if self.best_gain.low < 0 {
            refiner.insert(&mut self.best)?;
        }
        refiner.put_back(tet, stamp, false);
        Ok(())
    }

    /// Whether a point may cure a tetrahedron.
    ///
    /// One whose only defect is its size is tried once: those are many where the boundary is too coarse, and a pass over
    /// all of them for each point inserted would take long.
    fn is_worth_trying(&mut self, refiner: &Refiner<'_>, tet: TetId) -> bool {
        let records = &refiner.records;
        if refiner.counters.tested >= self.last_test {
            return false;
        }
        let first = records.is_skinny(tet) || self.tried.insert((tet, records.stamp(tet)));
        let solid = &refiner.solid;
        first
            && large_boundary(solid, records, tet).is_none()
            && skinny_boundary(solid, records, tet).is_none()
    }

    /// Tries a point, and where it slides to.
    fn slide(&mut self, refiner: &mut Refiner<'_>, mut point: DVec3, seed: TetId, separation: f64) {
        for _ in 0..=SLIDES {
            let tested = match self.effort.respects_spheres {
                true => refiner.propose(point, seed, separation),
                false => refiner.propose_anywhere(point, seed),
            };
            match tested {
                Ok(()) => return self.keep_if_better(refiner),
                Err(Rejection3::Encroaches(facet)) => {
                    point = outside_diametral_sphere(refiner, facet, point);
                }
                Err(_) => return,
            }
        }
    }

    fn keep_if_better(&mut self, refiner: &mut Refiner<'_>) {
        let gain = Gain::of(&refiner.solid, &refiner.records, &refiner.proposal);
        let best = (self.best_gain.low, self.best_gain.excess);
        if gain.low < 0 && (gain.low, gain.excess) < best {
            self.best_gain = gain;
            std::mem::swap(&mut self.best, &mut refiner.proposal);
        }
    }

    /// Adds random points in the tetrahedron and its neighbours, the same ones whenever it comes.
    fn add_random_points(&mut self, refiner: &Refiner<'_>, tet: TetId) {
        let mesh = refiner.solid.mesh();
        let around = tet.facets().map(|f| mesh.twin(f).tet());
        let around = around.into_iter().filter(|&t| !mesh.is_ghost_tet(t));
        let homes: Vec<TetId> = std::iter::once(tet).chain(around).collect();
        let corners = refiner.solid.tetrahedron(tet);
        let mut random = RandomPoints::of(corners.iter().flat_map(DVec3::to_array));
        for trial in 0..self.effort.trials {
            let home = homes[trial % homes.len()];
            let point = random.next_in(refiner.solid.tetrahedron(home));
            self.candidates.push((point, home));
        }
    }
}

/// `point` moved just out of the diametral sphere of a boundary facet, to the inside.
fn outside_diametral_sphere(refiner: &Refiner<'_>, facet: FacetId, point: DVec3) -> DVec3 {
    const OUT: f64 = 1.0001;
    let [a, b, c] = refiner.solid.triangle(facet);
    let center = circumcenter([a, b, c]);
    let inward = (c - a).cross(b - a).normalize_or_zero();
    let way = point - center;
    let direction = match way.dot(inward) > 0.0 {
        true => way.normalize_or(inward),
        false => inward,
    };
    center + direction * (OUT * center.distance(a))
}
