//! In rounds of independent points, on all threads (§4.5).
//!
//! Each round inserts a maximal subset of the candidates with disjoint closed prestars: in the order of the
//! candidates, each that shares no vertex with an earlier one. Prestars are searched at the same time, a batch after
//! the other; a search ends where it meets a vertex that is taken, for then the candidate is not in the subset, and, of
//! circumcenters, which may be far from their tetrahedra, does not begin where the point or a chosen one is inside the other's
//! sphere: then they have prestars in common. The
//! subset depends on the order alone, so the mesh is the same for any number of threads. By the Independence Lemma none of
//! its points is inside the circumsphere of another one's prestar.

use super::super::candidate::{Candidates, Site};
use super::super::proposal::{Proposal, Rejection3};
use super::super::refiner::Refiner;
use crate::params::Candidate;
use crate::spheres::Spheres;
use crate::stop::Stop;
use crate::taken::Taken;
use delaunay_core::{FacetId, Subcomplex3, TetId, VertexId};
use glam::DVec3;
use rayon::prelude::*;

/// The most candidates whose prestars are searched at the same time.
const BATCH: usize = 64;

/// A candidate that has passed the boundary test.
struct Tested {
    point: DVec3,
    prestar: Vec<TetId>,
    boundary: Vec<FacetId>,
}

pub(super) fn run(refiner: &mut Refiner<'_>, kind: Candidate) -> Result<(), Stop> {
    let mut candidates = Candidates::new(kind);
    loop {
        refiner.begin_round();
        let mut sites = candidates.all(&refiner.solid, &refiner.records);
        refiner.round().candidates = sites.len();
        sites.retain(|site| !candidates.is_rejected(site));
        let chosen = independent_subset(refiner, &mut candidates, &sites);
        if chosen.is_empty() {
            return Ok(());
        }
        let proposals = chosen.into_iter().map(Tested::into_proposal);
        refiner.in_round(|refiner| refiner.insert_all(proposals))?;
    }
}

impl Tested {
    /// The vertices of the closed prestar, some of them several times.
    fn vertices(&self, solid: &Subcomplex3) -> impl Iterator<Item = VertexId> + Clone {
        let facets = self.boundary.iter();
        facets.flat_map(|&f| solid.mesh().facet_vertices(f))
    }

    fn into_proposal(self) -> Proposal {
        let mut proposal = Proposal {
            point: self.point,
            ..Proposal::default()
        };
        proposal.prestar.assign(&self.prestar, &self.boundary);
        proposal
    }
}

/// A maximal subset of the candidates that pass the boundary test with disjoint closed prestars, earlier ones first.
fn independent_subset(
    refiner: &mut Refiner<'_>,
    candidates: &mut Candidates,
    sites: &[Site],
) -> Vec<Tested> {
    let mut taken = Taken::none(refiner.solid.points().len());
    let mut chosen = Vec::new();
    let mut waiting = sites.iter().copied();
    let mut spheres = candidates.are_far_away().then(Spheres::new);
    loop {
        // Where the first few prestars cover most of the mesh, more at the same time would be searched in vain.
        let size = (2 * chosen.len()).clamp(2, BATCH);
        let solid = &refiner.solid;
        let is_open = |site: &Site| {
            taken.is_free(solid.mesh().tet_vertices(site.tet))
                && spheres
                    .as_ref()
                    .is_none_or(|spheres| is_outside_all(spheres, site.sphere(solid)))
        };
        let batch: Vec<Site> = waiting.by_ref().filter(is_open).take(size).collect();
        if batch.is_empty() {
            return chosen;
        }
        for (&site, tested) in batch.iter().zip(test(&refiner.solid, &taken, &batch)) {
            refiner.count_test(
                tested
                    .as_ref()
                    .and_then(|tested| tested.as_ref().err().copied()),
            );
            refiner.round().passed += usize::from(matches!(tested, Some(Ok(_))));
            match tested {
                Some(Ok(tested)) if taken.take(tested.vertices(&refiner.solid)) => {
                    if let Some(spheres) = &mut spheres {
                        let (center, radius) = site.sphere(&refiner.solid);
                        spheres.insert(center.to_array(), radius);
                    }
                    chosen.push(tested);
                }
                Some(Ok(_)) | None => {}
                Some(Err(_)) => candidates.reject(site),
            }
        }
    }
}

/// Whether no sphere contains the center of another one, up to rounding: what is said to be inside is so.
fn is_outside_all(spheres: &Spheres<[f64; 3]>, (center, radius): (DVec3, f64)) -> bool {
    const INSIDE: f64 = 1.0 - 1e-9;
    let reach = |largest: f64| largest.max(radius).powi(2);
    spheres.near_all(center.to_array(), reach, |other, its_radius| {
        DVec3::from(other).distance_squared(center) >= INSIDE * reach(its_radius)
    })
}

/// Finds and tests the prestars of candidates; `None` for those that meet a vertex taken.
fn test(
    solid: &Subcomplex3,
    taken: &Taken,
    sites: &[Site],
) -> Vec<Option<Result<Tested, Rejection3>>> {
    sites
        .par_iter()
        .map_init(Proposal::default, |proposal, site| {
            let point = site.point(solid);
            let is_free = |corners| taken.is_free(corners);
            let made = proposal.make_within(solid, point, site.tet, is_free)?;
            Some(made.map(|()| Tested {
                point,
                prestar: proposal.prestar.tets().to_vec(),
                boundary: proposal.prestar.boundary().to_vec(),
            }))
        })
        .collect()
}
