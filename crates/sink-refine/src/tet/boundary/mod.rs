//! The boundary is divided where it is in the way, beyond the paper, which keeps it.
//!
//! What the tests of §5.1 have rejected is tried again, the worst tetrahedron first. A boundary facet is
//! divided when it is of low quality itself or too large, when it has a candidate inside its diametral sphere, or when the flow
//! leaves through it; but first the [creases](creases) that the new vertex would be too near to. Smooth parts keep their
//! [shape](patch).
//!
//! It ends: points inside keep a separation that is tested, the shortest edge of the tetrahedron or the size, and points on the
//! boundary a part of the size given there ([`PARTS`](crate::boundary::PARTS)), so all vertices stay apart and there is room
//! for finitely many.

mod clearance;
mod creases;
mod patch;
mod split;

use super::flow::{FlowWalk, Successor3, sink};
use super::low::{large_boundary, skinny_boundary};
use super::proposal::Rejection3;
use super::refiner::Refiner;
use crate::params::Boundary;
use crate::stop::Stop;
use delaunay_core::measure::tetrahedron::{circumcenter, shortest_edge};
use delaunay_core::{FacetId, TetId};
use glam::DVec3;
use split::Splitter;

/// Improves what is left of low quality by dividing the boundary, if that is allowed.
///
/// # Errors
/// Why it ended before nothing more could be done.
pub(crate) fn run(refiner: &mut Refiner<'_>, at: Boundary) -> Result<(), Stop> {
    let Boundary::Split { crease } = at else {
        return Ok(());
    };
    let mut cure = Cure {
        splitter: Splitter::new(&refiner.solid, crease),
        walk: FlowWalk::default(),
        candidates: Vec::new(),
        in_the_way: Vec::new(),
    };
    refiner.list_all();
    refiner.in_passes(|refiner, tet| cure.one(refiner, tet))
}

/// Room for curing.
struct Cure {
    splitter: Splitter,
    walk: FlowWalk,
    candidates: Vec<(DVec3, TetId)>,
    /// Boundary facets, the first is to be divided first.
    in_the_way: Vec<FacetId>,
}

impl Cure {
    /// Inserts a point for a tetrahedron, inside or on the boundary; or puts the tetrahedron aside.
    fn one(&mut self, refiner: &mut Refiner<'_>, tet: TetId) -> Result<(), Stop> {
        let stamp = refiner.records.stamp(tet);
        let done = self.insert_inside(refiner, tet)? || self.split(refiner)?;
        refiner.put_back(tet, stamp, done);
        Ok(())
    }

    /// Inserts the first candidate that passes the tests; tells whether there is one, and lists what is in the way of the others.
    fn insert_inside(&mut self, refiner: &mut Refiner<'_>, tet: TetId) -> Result<bool, Stop> {
        self.in_the_way.clear();
        self.list_candidates(refiner, tet);
        let allowed = refiner.records.largest_radius(&refiner.solid, tet);
        let separation = shortest_edge(refiner.solid.tetrahedron(tet)).min(allowed);
        for &(point, seed) in &self.candidates {
            match refiner.propose(point, seed, separation) {
                Ok(()) => return refiner.insert_proposed().map(|_| true),
                Err(Rejection3::Encroaches(f)) => self.in_the_way.push(f),
                Err(_) => {}
            }
        }
        Ok(false)
    }

    /// Lists the sinks of a tetrahedron and its circumcenter, and the boundary facets that have to be divided in any case.
    fn list_candidates(&mut self, refiner: &Refiner<'_>, tet: TetId) {
        let (solid, records) = (&refiner.solid, &refiner.records);
        self.in_the_way.extend(skinny_boundary(solid, records, tet));
        self.in_the_way.extend(large_boundary(solid, records, tet));
        let sinks = self.walk.follow(solid, tet, |t| records.flow(t)).iter();
        self.candidates.clear();
        self.candidates.extend(sinks.map(|&s| (sink(solid, s), s)));
        self.candidates
            .push((circumcenter(solid.tetrahedron(tet)), tet));
        for &t in self.walk.passed() {
            for successor in records.flow(t).successors(solid, t) {
                if let Successor3::Outside(f) = successor {
                    self.in_the_way.push(f);
                }
            }
        }
    }

    /// Divides the first facet in the way that can be; tells whether there is one.
    fn split(&mut self, refiner: &mut Refiner<'_>) -> Result<bool, Stop> {
        for &f in &self.in_the_way {
            if self.splitter.split_facet(refiner, f)? {
                return Ok(true);
            }
        }
        Ok(false)
    }
}
