//! In blocks of points whose circles are orthogonal or farther apart (§4.5).
//!
//! A block is a maximal set of candidates that pass the boundary test and whose circles are mutually orthogonal or
//! further than orthogonal. Then none of its points is inside the circle of another, so each of their triangles is
//! still there when its turn comes.

use super::super::candidate::{Candidates, Site};
use super::super::independence::are_orthogonal_or_further;
use super::super::refiner::Refiner;
use crate::params::Candidate;
use crate::spheres::Spheres;
use crate::stop::Stop;
use delaunay_core::measure::triangle::circumradius;
use glam::DVec2;

/// A candidate with its circle.
struct Circle {
    site: Site,
    center: DVec2,
    radius: f64,
}

pub(super) fn run(refiner: &mut Refiner<'_>, kind: Candidate) -> Result<(), Stop> {
    let mut candidates = Candidates::new(kind);
    loop {
        refiner.begin_round();
        let mut sites = candidates.all(&refiner.region, &refiner.records);
        refiner.round().candidates = sites.len();
        sites.retain(|site| !candidates.is_rejected(site));
        let block = orthogonal_subset(refiner, &mut candidates, &sites);
        if block.is_empty() {
            return Ok(());
        }
        refiner.in_round(|refiner| insert_all(refiner, block))?;
    }
}

fn insert_all(refiner: &mut Refiner<'_>, block: Vec<Circle>) -> Result<(), Stop> {
    for Circle { site, center, .. } in block {
        // Rounding of a center, or a tie, may let a neighbour in the block spoil it.
        if site.is_there(&refiner.records) && refiner.propose(center, site.face, 0.0).is_ok() {
            refiner.insert_proposed()?;
        }
    }
    Ok(())
}

/// A maximal subset of the candidates that pass the boundary test with circles that are mutually orthogonal or further
/// than orthogonal, earlier ones first.
fn orthogonal_subset(
    refiner: &mut Refiner<'_>,
    candidates: &mut Candidates,
    sites: &[Site],
) -> Vec<Circle> {
    let mut block = Block {
        chosen: Vec::new(),
        spheres: Spheres::new(),
    };
    for &site in sites {
        let circle = Circle {
            site,
            center: site.point(&refiner.region),
            radius: circumradius(refiner.region.triangle(site.face)),
        };
        if refiner.propose(circle.center, site.face, 0.0).is_err() {
            candidates.reject(site);
            continue;
        }
        // Those without room are tested too: they count in figure 7.
        refiner.round().passed += 1;
        if block.has_room_for(&circle) {
            block.push(circle);
        }
    }
    block.chosen
}

/// Circles that are mutually orthogonal or further than orthogonal.
struct Block {
    chosen: Vec<Circle>,
    spheres: Spheres<[f64; 2]>,
}

impl Block {
    fn has_room_for(&self, &Circle { center, radius, .. }: &Circle) -> bool {
        self.spheres.near_all(
            center.to_array(),
            |largest| radius * radius + largest * largest,
            |other, its_radius| {
                are_orthogonal_or_further((DVec2::from(other), its_radius), (center, radius))
            },
        )
    }

    fn push(&mut self, circle: Circle) {
        self.spheres.insert(circle.center.to_array(), circle.radius);
        self.chosen.push(circle);
    }
}
