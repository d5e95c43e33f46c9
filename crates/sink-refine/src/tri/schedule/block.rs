//! In blocks of points whose circles are orthogonal or farther apart (§4.5).
//!
//! A block is a maximal set of candidates that pass the boundary test and whose circles are mutually orthogonal or
//! further than orthogonal. Then none of its points is inside the circle of another, so each of their triangles is
//! still there when its turn comes.

use super::super::candidate::{Candidates, Site};
use super::super::independence::are_orthogonal_or_further;
use super::super::refiner::Refiner;
use crate::params::Candidate;
use crate::stop::Stop;
use delaunay_core::measure::triangle::circumradius;
use glam::DVec2;
use rstar::RTree;
use rstar::primitives::GeomWithData;

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
        let sites = candidates.all(&refiner.region, &refiner.records);
        let block = orthogonal_subset(refiner, &mut candidates, &sites);
        let round = refiner.round();
        round.candidates = sites.len();
        round.inserted = block.len();
        if block.is_empty() {
            return Ok(());
        }
        for Circle { site, center, .. } in block {
            // Rounding of a center, or a tie, may let a neighbour in the block spoil it.
            if site.is_there(&refiner.records) && refiner.propose(center, site.face, 0.0).is_ok() {
                refiner.insert_proposed()?;
            }
        }
    }
}

/// A maximal subset of the candidates that pass the boundary test with circles that are mutually orthogonal or further
/// than orthogonal, earlier ones first.
fn orthogonal_subset(
    refiner: &mut Refiner<'_>,
    candidates: &mut Candidates,
    sites: &[Site],
) -> Vec<Circle> {
    let mut block = Block::default();
    for &site in sites {
        let circle = Circle {
            site,
            center: site.point(&refiner.region),
            radius: circumradius(refiner.region.triangle(site.face)),
        };
        if block.has_room_for(&circle) {
            match refiner.propose(circle.center, site.face, 0.0) {
                Ok(()) => block.push(circle),
                Err(_) => candidates.reject(site),
            }
        }
    }
    block.circles
}

/// Circles that are mutually orthogonal or further than orthogonal.
#[derive(Default)]
struct Block {
    circles: Vec<Circle>,
    /// With their radii.
    centers: RTree<GeomWithData<[f64; 2], f64>>,
    largest_square: f64,
}

impl Block {
    fn has_room_for(&self, circle: &Circle) -> bool {
        let square = circle.radius * circle.radius;
        let near = self
            .centers
            .locate_within_distance(circle.center.to_array(), square + self.largest_square);
        near.into_iter().all(|other| {
            let other = (DVec2::from(*other.geom()), other.data);
            are_orthogonal_or_further(other, (circle.center, circle.radius))
        })
    }

    fn push(&mut self, circle: Circle) {
        let square = circle.radius * circle.radius;
        let center = circle.center.to_array();
        self.centers
            .insert(GeomWithData::new(center, circle.radius));
        self.largest_square = self.largest_square.max(square);
        self.circles.push(circle);
    }
}
