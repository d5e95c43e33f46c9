//! For each tetrahedron of low quality, the worst first, the best of its sinks and some off-centers.
//!
//! None is inserted for a tetrahedron on a boundary facet that is itself of low quality: that one is always on such a
//! tetrahedron. Best is what takes most low tetrahedra away and adds fewest others. Points keep the minimum separation: each is at
//! least as far from all vertices as the shortest edge of its tetrahedron is long.

use super::super::flow::{FlowWalk, sink};
use super::super::low::skinny_boundary;
use super::super::proposal::Proposal;
use super::super::refiner::Refiner;
use super::gain::Gain;
use super::off_center::OffCenters;
use crate::stop::Stop;
use delaunay_core::TetId;
use glam::DVec3;

/// Heights of off-centers, in shares of the height at which they make a triangle of the bound.
const SHARES: [f64; 3] = [0.6, 0.5, 0.4];

pub(super) fn run(refiner: &mut Refiner<'_>) -> Result<(), Stop> {
    let mut greedy = Greedy::default();
    refiner.list_all();
    refiner.in_passes(|refiner, tet| greedy.insert_for(refiner, tet))
}

/// Room for choosing.
#[derive(Default)]
struct Greedy {
    walk: FlowWalk,
    candidates: Vec<(DVec3, TetId)>,
    best: Proposal,
}

impl Greedy {
    /// Inserts the best candidate of a tetrahedron that passes the tests, or puts the tetrahedron aside.
    fn insert_for(&mut self, refiner: &mut Refiner<'_>, tet: TetId) -> Result<(), Stop> {
        let stamp = refiner.records.stamp(tet);
        let incurable = skinny_boundary(&refiner.solid, &refiner.records, tet).is_some();
        let found = !incurable && self.choose(refiner, tet);
        if found {
            refiner.insert(&mut self.best)?;
        }
        refiner.put_back(tet, stamp, found);
        Ok(())
    }

    /// Finds the best candidate; tells whether there is one.
    fn choose(&mut self, refiner: &mut Refiner<'_>, tet: TetId) -> bool {
        let off = OffCenters::of_tetrahedron(refiner, tet);
        candidates(refiner, &mut self.walk, tet, &off, &mut self.candidates);
        let mut best = f64::NEG_INFINITY;
        for &(point, seed) in &self.candidates {
            if refiner.propose(point, seed, off.separation()).is_ok() {
                let score = score(refiner, tet);
                if score > best {
                    best = score;
                    std::mem::swap(&mut self.best, &mut refiner.proposal);
                }
            }
        }
        best > f64::NEG_INFINITY
    }
}

/// Lists the candidates of a tetrahedron, each with a tetrahedron whose circumball contains it.
pub(super) fn candidates(
    refiner: &Refiner<'_>,
    walk: &mut FlowWalk,
    tet: TetId,
    off: &OffCenters,
    list: &mut Vec<(DVec3, TetId)>,
) {
    let (solid, records) = (&refiner.solid, &refiner.records);
    let sinks = walk.follow(solid, tet, |t| records.flow(t)).iter();
    list.clear();
    list.extend(sinks.map(|&s| (sink(solid, s), s)));
    list.extend(SHARES.map(|share| (off.at(share, records.bound()), tet)));
}

/// How good it is to insert the point proposed for a tetrahedron; the weights are not critical.
fn score(refiner: &Refiner<'_>, tet: TetId) -> f64 {
    let gain = Gain::of(&refiner.solid, &refiner.records, &refiner.proposal);
    let survives = !refiner.proposal.prestar.tets().contains(&tet);
    -gain.low as f64 - 0.05 * gain.tets as f64 - 0.5 * f64::from(u8::from(survives))
}
