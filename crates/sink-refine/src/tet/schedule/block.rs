//! In blocks of points whose spheres are orthogonal or farther apart (§4.5).
//!
//! A block is a maximal set of candidates that pass the boundary test and whose spheres are mutually orthogonal or
//! further than orthogonal. Then none of its points is inside the sphere of another, so each of their tetrahedra is
//! still there when its turn comes.

use super::super::candidate::{Candidates, Site};
use super::super::independence::are_orthogonal_or_further;
use super::super::refiner::Refiner;
use crate::params::Candidate;
use crate::spheres::Spheres;
use crate::stop::Stop;
use glam::DVec3;

/// A candidate with its sphere.
struct Sphere {
    site: Site,
    center: DVec3,
    radius: f64,
}

pub(super) fn run(refiner: &mut Refiner<'_>, kind: Candidate) -> Result<(), Stop> {
    let mut candidates = Candidates::new(kind);
    loop {
        refiner.begin_round();
        let mut sites = candidates.all(&refiner.solid, &refiner.records);
        refiner.round().candidates = sites.len();
        sites.retain(|site| !candidates.is_rejected(site));
        let block = orthogonal_subset(refiner, &mut candidates, &sites);
        refiner.round().passed = block.len();
        if block.is_empty() {
            return Ok(());
        }
        refiner.in_round(|refiner| insert_all(refiner, block))?;
    }
}

fn insert_all(refiner: &mut Refiner<'_>, block: Vec<Sphere>) -> Result<(), Stop> {
    for Sphere { site, center, .. } in block {
        // Rounding of a center, or a tie, may let a neighbour in the block spoil it.
        if site.is_there(&refiner.records) && refiner.propose(center, site.tet, 0.0).is_ok() {
            refiner.insert_proposed()?;
        }
    }
    Ok(())
}

/// A maximal subset of the candidates that pass the boundary test with spheres that are mutually orthogonal or further
/// than orthogonal, earlier ones first.
fn orthogonal_subset(
    refiner: &mut Refiner<'_>,
    candidates: &mut Candidates,
    sites: &[Site],
) -> Vec<Sphere> {
    let mut block = Block {
        chosen: Vec::new(),
        spheres: Spheres::new(),
    };
    for &site in sites {
        let (center, radius) = site.sphere(&refiner.solid);
        let sphere = Sphere {
            site,
            center,
            radius,
        };
        if block.has_room_for(&sphere) {
            match refiner.propose(sphere.center, site.tet, 0.0) {
                Ok(()) => block.push(sphere),
                Err(_) => candidates.reject(site),
            }
        }
    }
    block.chosen
}

/// Spheres that are mutually orthogonal or further than orthogonal.
struct Block {
    chosen: Vec<Sphere>,
    spheres: Spheres<[f64; 3]>,
}

impl Block {
    fn has_room_for(&self, &Sphere { center, radius, .. }: &Sphere) -> bool {
        self.spheres.near_all(
            center.to_array(),
            |largest| radius * radius + largest * largest,
            |other, its_radius| {
                are_orthogonal_or_further((DVec3::from(other), its_radius), (center, radius))
            },
        )
    }

    fn push(&mut self, sphere: Sphere) {
        self.spheres.insert(sphere.center.to_array(), sphere.radius);
        self.chosen.push(sphere);
    }
}
