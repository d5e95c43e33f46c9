//! For each triangle of low quality, that with the shortest edge first, the first of its off-center, its circumcenter
//! and its sink that passes the tests.
//!
//! Points keep the minimum separation: each is at least as far from all vertices as the shortest edge of its triangle is
//! long. Short edges come first because what is fine has to grow coarser away from them: cured in this order, triangles
//! elsewhere often need nothing any more.

use super::super::flow::sink_triangle;
use super::super::refiner::Refiner;
use super::super::sinks::sink;
use super::off_center::OffCenters;
use crate::stop::Stop;
use delaunay_core::FaceId;
use delaunay_core::measure::triangle::circumcenter;
use glam::DVec2;

/// The height of the off-center, as a share of that at which it makes a triangle of the bound with the shortest edge. The
/// whole height would leave to rounding whether that triangle is of low quality.
pub(super) const SHARE: f64 = 1.0 - 1e-9;

pub(super) fn run(refiner: &mut Refiner<'_>) -> Result<(), Stop> {
    let mut candidates = Vec::new();
    refiner.in_passes(|refiner, face| insert_for(refiner, &mut candidates, face))
}

/// Inserts the first candidate of a triangle that passes the tests, or puts the triangle aside.
fn insert_for(
    refiner: &mut Refiner<'_>,
    candidates: &mut Vec<(DVec2, FaceId)>,
    face: FaceId,
) -> Result<(), Stop> {
    let off = OffCenters::of_triangle(refiner, face);
    list_candidates(refiner, face, &off, candidates);
    let stamp = refiner.records.stamp(face);
    let mut candidates = candidates.iter();
    let passes =
        |&(point, seed): &(DVec2, FaceId)| refiner.propose(point, seed, off.separation()).is_ok();
    let found = candidates.any(passes);
    if found {
        refiner.insert_proposed()?;
    }
    refiner.put_back(face, stamp, found);
    Ok(())
}

/// Lists the candidates of a triangle, each with a triangle whose circumcircle contains it.
pub(super) fn list_candidates(
    refiner: &Refiner<'_>,
    face: FaceId,
    off: &OffCenters,
    list: &mut Vec<(DVec2, FaceId)>,
) {
    let (region, records) = (&refiner.region, &refiner.records);
    list.clear();
    list.push((off.at(SHARE, records.bound()), face));
    list.push((circumcenter(region.triangle(face)), face));
    let end = sink_triangle(region.mesh(), face, |f| records.exit(f));
    list.extend(end.map(|f| (sink(region, f), f)));
}
