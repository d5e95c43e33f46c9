//! One tetrahedron after the other, the worst first (§4.5).
//!
//! All sinks of the tetrahedron are inserted, or its circumcenter. One whose candidates are all rejected is put aside; when
//! the others are done it gets another turn, because its flow may end elsewhere by then. The schedule is finite:
//! every point keeps the minimum separation, and a pass that inserts nothing is the last.

use super::super::candidate::{Candidates, Site};
use super::super::flow::FlowWalk;
use super::super::refiner::Refiner;
use crate::params::Candidate;
use crate::stop::Stop;
use delaunay_core::TetId;

pub(super) fn run(refiner: &mut Refiner<'_>, kind: Candidate) -> Result<(), Stop> {
    let mut candidates = Candidates::new(kind);
    let mut walk = FlowWalk::default();
    refiner.list_all();
    refiner.in_passes(|refiner, tet| {
        let (solid, records) = (&refiner.solid, &refiner.records);
        let sites = candidates.of(solid, records, &mut walk, tet).collect();
        insert_for(refiner, &mut candidates, tet, sites)
    })
}

/// Inserts the candidates of one tetrahedron that pass the tests.
fn insert_for(
    refiner: &mut Refiner<'_>,
    candidates: &mut Candidates,
    tet: TetId,
    sites: Vec<Site>,
) -> Result<(), Stop> {
    let stamp = refiner.records.stamp(tet);
    let mut inserted = false;
    for site in sites {
        // An earlier sink may have destroyed the tetrahedron of a later one.
        if site.is_there(&refiner.records) {
            let point = site.point(&refiner.solid);
            if refiner.propose(point, site.tet, 0.0).is_ok() {
                refiner.insert_proposed()?;
                inserted = true;
            } else {
                candidates.reject(site);
            }
        }
    }
    refiner.put_back(tet, stamp, inserted);
    Ok(())
}
