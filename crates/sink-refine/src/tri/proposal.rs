//! A point that may be inserted, with its prestar (§4.1), and the tests that it has to pass (§4.4, §5.1).

use delaunay_core::geo_predicates::{Sign, check_point2, in_diametral_circle};
use delaunay_core::{Cavity, FaceId, HalfEdgeId, Subcomplex2, VertexId};
use glam::DVec2;

/// Why a point is not inserted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Rejection2 {
    /// It is outside, on the boundary or at a vertex.
    Outside,
    /// It is inside the diametral circle of this boundary edge, which bounds its prestar.
    Encroaches(HalfEdgeId),
    /// It is nearer to this vertex than it may be.
    TooNear(VertexId),
}

/// A point and its prestar.
#[derive(Clone, Debug, Default)]
pub(crate) struct Proposal {
    pub(crate) point: DVec2,
    pub(crate) prestar: Cavity,
}

impl Proposal {
    /// Finds the prestar of `point` from `seed`, a triangle whose circumcircle contains it, and tests it.
    ///
    /// `separation` is the least distance from vertices that is tested; 0 where it holds by itself.
    pub(crate) fn make(
        &mut self,
        region: &Subcomplex2,
        point: DVec2,
        seed: FaceId,
        separation: f64,
    ) -> Result<(), Rejection2> {
        let made = self.make_within(region, point, seed, |_| true);
        made.unwrap_or(Err(Rejection2::Outside))?;
        self.test_separation(region, separation)
    }

    /// Finds the prestar of a point as [`make`](Self::make) does, without any other test.
    pub(crate) fn make_anywhere(
        &mut self,
        region: &Subcomplex2,
        point: DVec2,
        seed: FaceId,
    ) -> Result<(), Rejection2> {
        self.point = point;
        match is_accepted(point) && region.dig(point, seed, &mut self.prestar) {
            true => Ok(()),
            false => Err(Rejection2::Outside),
        }
    }

    /// As [`make`](Self::make), but gives up with `None` when a triangle of the prestar is not `open`.
    pub(crate) fn make_within(
        &mut self,
        region: &Subcomplex2,
        point: DVec2,
        seed: FaceId,
        open: impl Fn([VertexId; 3]) -> bool,
    ) -> Option<Result<(), Rejection2>> {
        self.point = point;
        if !is_accepted(point) {
            return Some(Err(Rejection2::Outside));
        }
        let inside = region.dig_within(point, seed, &mut self.prestar, open)?;
        Some(match inside {
            true => self.test_boundary(region),
            false => Err(Rejection2::Outside),
        })
    }

    /// The boundary test: no boundary edge of the closed prestar has the point inside its diametral circle (§5.1).
    fn test_boundary(&self, region: &Subcomplex2) -> Result<(), Rejection2> {
        let mesh = region.mesh();
        for outer in self.prestar.rim().iter().map(|edge| edge.outer) {
            if mesh.is_ghost_face(outer.face()) {
                let [a, b] = region.segment(outer);
                if in_diametral_circle(a, b, self.point) == Sign::Positive {
                    return Err(Rejection2::Encroaches(mesh.twin(outer)));
                }
            }
        }
        Ok(())
    }

    fn test_separation(&self, region: &Subcomplex2, separation: f64) -> Result<(), Rejection2> {
        if separation == 0.0 {
            return Ok(());
        }
        let near =
            |v: &VertexId| region.point(*v).distance_squared(self.point) < separation * separation;
        match self.prestar.vertices().find(near) {
            Some(v) => Err(Rejection2::TooNear(v)),
            None => Ok(()),
        }
    }
}

/// Whether the coordinates of a computed point are in the range in which signs are exact: it may be at infinity, or so near
/// to an axis that doubles run out.
fn is_accepted(point: DVec2) -> bool {
    check_point2(0, point).is_ok()
}
