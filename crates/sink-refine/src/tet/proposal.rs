//! A point that may be inserted, with its prestar (§4.1), and the tests that it has to pass (§4.4, §5.1).

use delaunay_core::geo_predicates::{Sign, check_point3, in_diametral_ball};
use delaunay_core::{Cavity3, FacetId, Subcomplex3, TetId, VertexId};
use glam::DVec3;

/// Why a point is not inserted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Rejection3 {
    /// It is outside, on the boundary or at a vertex.
    Outside,
    /// It is inside the diametral sphere of this boundary facet, which bounds its prestar.
    Encroaches(FacetId),
    /// It is nearer to this vertex than it may be.
    TooNear(VertexId),
}

/// A point and its prestar.
#[derive(Clone, Debug, Default)]
pub(crate) struct Proposal {
    pub(crate) point: DVec3,
    pub(crate) prestar: Cavity3,
}

impl Proposal {
    /// Finds the prestar of `point` from `seed`, a tetrahedron whose circumball contains it, and tests it.
    ///
    /// `separation` is the least distance from vertices that is tested; 0 where it holds by itself.
    pub(crate) fn make(
        &mut self,
        solid: &Subcomplex3,
        point: DVec3,
        seed: TetId,
        separation: f64,
    ) -> Result<(), Rejection3> {
        let made = self.make_within(solid, point, seed, |_| true);
        made.unwrap_or(Err(Rejection3::Outside))?;
        self.test_separation(solid, separation)
    }

    /// Finds the prestar of a point as [`make`](Self::make) does, without any other test.
    pub(crate) fn make_anywhere(
        &mut self,
        solid: &Subcomplex3,
        point: DVec3,
        seed: TetId,
    ) -> Result<(), Rejection3> {
        self.point = point;
        match is_accepted(point) && solid.dig(point, seed, &mut self.prestar) {
            true => Ok(()),
            false => Err(Rejection3::Outside),
        }
    }

    /// As [`make`](Self::make), but gives up with `None` when a tetrahedron of the prestar is not `open`.
    pub(crate) fn make_within(
        &mut self,
        solid: &Subcomplex3,
        point: DVec3,
        seed: TetId,
        open: impl Fn([VertexId; 4]) -> bool,
    ) -> Option<Result<(), Rejection3>> {
        self.point = point;
        if !is_accepted(point) {
            return Some(Err(Rejection3::Outside));
        }
        let inside = solid.dig_within(point, seed, &mut self.prestar, open)?;
        Some(match inside {
            true => self.test_boundary(solid),
            false => Err(Rejection3::Outside),
        })
    }

    /// The boundary test: no boundary facet of the closed prestar has the point inside its diametral sphere (§5.1).
    fn test_boundary(&self, solid: &Subcomplex3) -> Result<(), Rejection3> {
        let mesh = solid.mesh();
        for &outer in self.prestar.boundary() {
            if mesh.is_ghost_tet(outer.tet()) {
                let [a, b, c] = solid.triangle(outer);
                if in_diametral_ball(a, b, c, self.point) == Sign::Positive {
                    return Err(Rejection3::Encroaches(mesh.twin(outer)));
                }
            }
        }
        Ok(())
    }

    fn test_separation(&self, solid: &Subcomplex3, separation: f64) -> Result<(), Rejection3> {
        if separation == 0.0 {
            return Ok(());
        }
        let mesh = solid.mesh();
        for &outer in self.prestar.boundary() {
            for v in mesh.facet_vertices(outer) {
                if solid.point(v).distance_squared(self.point) < separation * separation {
                    return Err(Rejection3::TooNear(v));
                }
            }
        }
        Ok(())
    }
}

/// Whether the coordinates of a computed point are in the range in which signs are exact: it may be at infinity, or so near
/// to a plane of the axes that doubles run out.
fn is_accepted(point: DVec3) -> bool {
    check_point3(0, point).is_ok()
}

#[cfg(test)]
mod tests {
    use super::*;
    use delaunay_core::Delaunay3;

    #[test]
    fn points_in_whose_coordinates_doubles_run_out_are_rejected() {
        let simplex = [
            DVec3::NEG_ONE,
            DVec3::X * 4.0,
            DVec3::Y * 4.0,
            DVec3::Z * 4.0,
        ];
        let solid = Subcomplex3::of(&Delaunay3::build(&simplex).unwrap(), |_| true);
        let seed = solid.tets().next().unwrap();
        let mut proposal = Proposal::default();
        for (x, expected) in [
            (1e-9, Ok(())),
            (1e-60, Err(Rejection3::Outside)),
            (f64::INFINITY, Err(Rejection3::Outside)),
            (f64::NAN, Err(Rejection3::Outside)),
        ] {
            let point = DVec3::new(x, 0.1, 0.2);
            assert_eq!(proposal.make_anywhere(&solid, point, seed), expected, "{x}");
        }
    }
}
