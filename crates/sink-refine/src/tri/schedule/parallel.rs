//! In rounds of independent points, on all threads (§4.5).
//!
//! Each round inserts a maximal subset of the candidates with disjoint closed prestars: in the order of the
//! candidates, each that shares no vertex with an earlier one. Prestars are searched at the same time, a batch after
//! the other; a search ends where it meets a vertex that is taken, for then the candidate is not in the subset. The
//! subset depends on the order alone, so the mesh is the same for any number of threads. By the Independence Lemma none of
//! its points is inside the circumcircle of another one's prestar.

use super::super::candidate::{Candidates, Site};
use super::super::proposal::{Proposal, Rejection2};
use super::super::refiner::Refiner;
use crate::params::Candidate;
use crate::stop::Stop;
use crate::taken::Taken;
use delaunay_core::{FaceId, RimEdge, Subcomplex2};
use glam::DVec2;
use rayon::prelude::*;

/// The most candidates whose prestars are searched at the same time.
const BATCH: usize = 64;

/// A candidate that has passed the boundary test.
struct Tested {
    point: DVec2,
    prestar: Vec<FaceId>,
    rim: Vec<RimEdge>,
}

pub(super) fn run(refiner: &mut Refiner<'_>, kind: Candidate) -> Result<(), Stop> {
    let mut candidates = Candidates::new(kind);
    loop {
        refiner.begin_round();
        let mut sites = candidates.all(&refiner.region, &refiner.records);
        refiner.round().candidates = sites.len();
        sites.retain(|site| !candidates.is_rejected(site));
        let chosen = independent_subset(refiner, &mut candidates, &sites);
        if chosen.is_empty() {
            return Ok(());
        }
        refiner.in_round(|refiner| insert_all(refiner, &chosen))?;
    }
}

fn insert_all(refiner: &mut Refiner<'_>, chosen: &[Tested]) -> Result<(), Stop> {
    let mut proposal = Proposal::default();
    for tested in chosen {
        proposal.point = tested.point;
        proposal.prestar.assign(&tested.prestar, &tested.rim);
        refiner.insert(&mut proposal)?;
    }
    Ok(())
}

/// A maximal subset of the candidates that pass the boundary test with disjoint closed prestars, earlier ones first.
fn independent_subset(
    refiner: &mut Refiner<'_>,
    candidates: &mut Candidates,
    sites: &[Site],
) -> Vec<Tested> {
    let mut taken = Taken::none(refiner.region.points().len());
    let mut chosen = Vec::new();
    let mut waiting = sites.iter().copied();
    loop {
        // Where the first few prestars cover most of the mesh, more at the same time would be searched in vain.
        let size = (2 * chosen.len()).clamp(2, BATCH);
        let is_open = |site: &Site| taken.is_free(refiner.region.mesh().face_vertices(site.face));
        let batch: Vec<Site> = waiting.by_ref().filter(is_open).take(size).collect();
        if batch.is_empty() {
            return chosen;
        }
        for (&site, tested) in batch.iter().zip(test(&refiner.region, &taken, &batch)) {
            refiner.count_test(
                tested
                    .as_ref()
                    .and_then(|tested| tested.as_ref().err().copied()),
            );
            refiner.round().passed += usize::from(matches!(tested, Some(Ok(_))));
            match tested {
                Some(Ok(tested)) if taken.take(tested.rim.iter().map(|edge| edge.origin)) => {
                    chosen.push(tested);
                }
                Some(Ok(_)) | None => {}
                Some(Err(_)) => candidates.reject(site),
            }
        }
    }
}

/// Finds and tests the prestars of candidates; `None` for those that meet a vertex taken.
fn test(
    region: &Subcomplex2,
    taken: &Taken,
    sites: &[Site],
) -> Vec<Option<Result<Tested, Rejection2>>> {
    sites
        .par_iter()
        .map_init(Proposal::default, |proposal, site| {
            let point = site.point(region);
            let is_free = |corners| taken.is_free(corners);
            let made = proposal.make_within(region, point, site.face, is_free)?;
            Some(made.map(|()| Tested {
                point,
                prestar: proposal.prestar.faces().to_vec(),
                rim: proposal.prestar.rim().to_vec(),
            }))
        })
        .collect()
}
