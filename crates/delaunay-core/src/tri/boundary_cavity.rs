//! The cavity of a point that is to become a vertex of the boundary of a subcomplex.
//!
//! ```text
//!      ghost         Triangles in conflict with the point, and the ghost on the boundary edge that it
//!    a---p---b       divides. The star of the point that takes their place has ghosts on both halves.
//!     \ / \ /
//! ```

use super::cavity::Cavity;
use super::subcomplex::Subcomplex2;
use crate::ids::{HalfEdgeId, VertexId};
use geo_predicates::Sign;
use glam::DVec2;

impl Subcomplex2 {
    /// Fills `cavity` with what has to give way when `p` becomes a vertex of the boundary between the ends of the boundary edge
    /// `h`: the triangles in conflict with it that are connected with that of `h`, and the ghost on `h`. `p` must be an
    /// accepted point.
    ///
    /// Answers whether [`fill`](Self::fill) may follow: `p` is in conflict with the triangle of `h` and sees every edge round
    /// the cavity, but `h`, strictly from inside. The cavity is of no use otherwise. Where `p` is on `h` the region stays what
    /// it is; else it gains or loses the triangle between. Whether the halves of the edge cross others of the boundary is not
    /// known here, see [`segments_cross`](super::segments_cross). Exact. Takes time proportional to the size of the cavity.
    #[must_use]
    pub fn dig_on(&self, p: DVec2, h: HalfEdgeId, cavity: &mut Cavity) -> bool {
        let mesh = self.mesh();
        if !self.is_boundary(h) || !self.in_conflict(p, h.face()) {
            return false;
        }
        let sight = self.sight(p);
        let ends = [mesh.origin(h), mesh.target(h)];
        cavity.dig(mesh, &sight, h.face(), |corners, backwards| {
            match corners.map(|seen| seen.vertex) {
                [end, start, VertexId::GHOST] => [start, end] == ends,
                [_, start, _] if start.is_ghost() => false,
                [end, ..] => !end.is_ghost() && sight.in_conflict(corners, backwards),
            }
        });
        let round: Vec<VertexId> = cavity.vertices().collect();
        let next = round.iter().cycle().skip(1);
        round.iter().zip(next).all(|(&a, &b)| {
            let is_real = !a.is_ghost() && !b.is_ghost();
            !is_real || sight.side(&sight.see(a), &sight.see(b)) == Sign::Positive
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tri::Delaunay2;

    #[test]
    fn a_boundary_edge_is_divided_on_it_or_beside_it() {
        let square = [DVec2::ZERO, DVec2::X, DVec2::ONE, DVec2::Y];
        let square = Subcomplex2::of(&Delaunay2::build(&square).unwrap(), |_| true);
        let is_bottom = |h: &HalfEdgeId| square.segment(*h).iter().all(|p| p.y == 0.0);
        let bottom = square.boundary().find(is_bottom).unwrap();
        for y in [0.0, 0.1, -0.1] {
            let mut divided = square.clone();
            let mut cavity = Cavity::default();
            let p = DVec2::new(0.5, y);
            assert!(divided.dig_on(p, bottom, &mut cavity));
            let v = divided.fill(p, &mut cavity).unwrap();
            assert_eq!(divided.check(), Ok(()));
            assert!(divided.mesh().is_on_hull(v));
            assert_eq!(
                (divided.faces().count(), divided.boundary().count()),
                (3, 5)
            );
        }
    }

    #[test]
    fn a_point_that_does_not_see_the_rest_is_refused() {
        let square = [DVec2::ZERO, DVec2::X, DVec2::ONE, DVec2::Y];
        let square = Subcomplex2::of(&Delaunay2::build(&square).unwrap(), |_| true);
        let mut cavity = Cavity::default();
        for h in square.boundary() {
            // Beyond the opposite side, at a corner, and far off.
            let [a, b] = square.segment(h);
            let inward = (b - a).perp();
            assert!(!square.dig_on(a.midpoint(b) + inward * 1.05, h, &mut cavity));
            assert!(!square.dig_on(a, h, &mut cavity));
            assert!(!square.dig_on(a - inward * 9.0, h, &mut cavity));
        }
    }
}
