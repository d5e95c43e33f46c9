//! The boundary is divided where it is in the way, beyond the paper, which keeps it.
//!
//! What the tests of §5.1 have rejected is tried again, the worst triangle first. A boundary edge is divided when it is too
//! long for the size asked for, when it has a candidate inside its diametral circle, or when the flow leaves through it. Smooth
//! parts keep their [shape](curve).
//!
//! It ends: points inside keep a separation that is tested, the shortest edge of the triangle or the size, and points on the
//! boundary a part of the size given there ([`PARTS`](crate::boundary::PARTS)), so all vertices stay apart and there is room
//! for finitely many.

mod clearance;
mod curve;
mod split;

use super::flow::{path, sink_triangle};
use super::low::long_edge;
use super::proposal::Rejection2;
use super::refiner::{Refiner, Urgency};
use crate::params::Boundary;
use crate::stop::Stop;
use delaunay_core::measure::triangle::{circumcenter, shortest_edge};
use delaunay_core::{FaceId, HalfEdgeId};
use glam::DVec2;
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
        splitter: Splitter::new(&refiner.region, crease),
        candidates: Vec::new(),
        in_the_way: Vec::new(),
    };
    refiner.reorder(Urgency::default());
    refiner.in_passes(|refiner, face| cure.one(refiner, face))
}

/// Room for curing.
struct Cure {
    splitter: Splitter,
    candidates: Vec<(DVec2, FaceId)>,
    /// Boundary edges, the first is to be divided first.
    in_the_way: Vec<HalfEdgeId>,
}

impl Cure {
    /// Inserts a point for a triangle, inside or on the boundary; or puts the triangle aside.
    fn one(&mut self, refiner: &mut Refiner<'_>, face: FaceId) -> Result<(), Stop> {
        let stamp = refiner.records.stamp(face);
        let done = self.insert_inside(refiner, face)? || self.split(refiner)?;
        refiner.put_back(face, stamp, done);
        Ok(())
    }

    /// Inserts the first candidate that passes the tests; tells whether there is one, and lists what is in the way of the others.
    fn insert_inside(&mut self, refiner: &mut Refiner<'_>, face: FaceId) -> Result<bool, Stop> {
        self.in_the_way.clear();
        self.list_candidates(refiner, face);
        let allowed = refiner.records.largest_radius(&refiner.region, face);
        let separation = shortest_edge(refiner.region.triangle(face)).min(allowed);
        for &(point, seed) in &self.candidates {
            match refiner.propose(point, seed, separation) {
                Ok(()) => return refiner.insert_proposed().map(|_| true),
                Err(Rejection2::Encroaches(h)) => self.in_the_way.push(h),
                Err(_) => {}
            }
        }
        Ok(false)
    }

    /// Lists the sink of a triangle and its circumcenter, and the boundary edges that have to be divided in any case.
    fn list_candidates(&mut self, refiner: &Refiner<'_>, face: FaceId) {
        let (region, records) = (&refiner.region, &refiner.records);
        self.in_the_way.extend(long_edge(region, records, face));
        self.candidates.clear();
        match sink_triangle(region.mesh(), face, |f| records.exit(f)) {
            Some(f) => self.candidates.push((circumcenter(region.triangle(f)), f)),
            None => {
                let last = path(region, face).last();
                self.in_the_way.extend(last.and_then(|f| records.exit(f)));
            }
        }
        self.candidates
            .push((circumcenter(region.triangle(face)), face));
    }

    /// Divides the first boundary edge in the way that can be; tells whether there is one.
    fn split(&mut self, refiner: &mut Refiner<'_>) -> Result<bool, Stop> {
        for &h in &self.in_the_way {
            if self.splitter.split(refiner, h)? {
                return Ok(true);
            }
        }
        Ok(false)
    }
}
