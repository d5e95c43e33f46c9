//! One triangle after the other, the worst first (§4.5).
//!
//! The sink of the triangle is inserted, or its circumcenter. One whose candidate is rejected is put aside; when
//! the others are done it gets another turn, because its flow may end elsewhere by then. The schedule is finite:
//! every point keeps the minimum separation, and a pass that inserts nothing is the last.

use super::super::candidate::Candidates;
use super::super::refiner::Refiner;
use crate::params::Candidate;
use crate::stop::Stop;
use delaunay_core::FaceId;

pub(super) fn run(refiner: &mut Refiner<'_>, kind: Candidate) -> Result<(), Stop> {
    let mut candidates = Candidates::new(kind);
    refiner.in_passes(|refiner, face| insert_for(refiner, &mut candidates, face))
}

/// Inserts the candidate of a triangle if it passes the tests, or puts the triangle aside.
fn insert_for(
    refiner: &mut Refiner<'_>,
    candidates: &mut Candidates,
    face: FaceId,
) -> Result<(), Stop> {
    let stamp = refiner.records.stamp(face);
    let mut inserted = false;
    if let Some(site) = candidates.of(&refiner.region, &refiner.records, face) {
        let point = site.point(&refiner.region);
        if refiner.propose(point, site.face, 0.0).is_ok() {
            refiner.insert_proposed()?;
            inserted = true;
        } else {
            candidates.reject(site);
        }
    }
    refiner.put_back(face, stamp, inserted);
    Ok(())
}
