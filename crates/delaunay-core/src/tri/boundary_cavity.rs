//! The cavity of a point that is to become a vertex of the boundary of a subcomplex.
//!
//! ```text
//!      ghost         Triangles in conflict with the point, and the ghost on the boundary edge that it
//!    a---p---b       divides. The star of the point that takes their place has ghosts on both halves.
//!     \ / \ /
//! ```

use super::cavity::Cavity;
use super::subcomplex::Subcomplex2;
use crate::ids::{FaceId, HalfEdgeId, VertexId};
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

/// Edges along which the region is cut apart.
impl Subcomplex2 {
    /// The other boundary edge with the ends of the boundary edge `h`, when the region is cut apart along it.
    ///
    /// # Panics
    /// When there is no half-edge `h`.
    #[must_use]
    pub fn partner(&self, h: HalfEdgeId) -> Option<HalfEdgeId> {
        let mesh = self.mesh();
        if !self.is_boundary(h) {
            return None;
        }
        // The ghost that comes before that of `h` round the start of `h`: its base starts there too.
        let base = mesh.twin(mesh.twin(h).next()).next();
        (mesh.target(base) == mesh.target(h)).then(|| mesh.twin(base))
    }

    /// Makes `v`, which has just divided one of two partners, divide the other one as well, in the cavity that
    /// [`dig_on`](Self::dig_on) has found on it since for the same point; as [`fill`](Self::fill) otherwise.
    ///
    /// Answers `false`, with nothing changed, when ids run out or `v` divides no boundary edge.
    #[must_use]
    pub fn fill_other_side(&mut self, v: VertexId, cavity: &mut Cavity) -> bool {
        let here = self.ghost_bases(v, self.mesh().star(v));
        let [Some(here_out), Some(here_in)] = here else {
            return false;
        };
        if !self.fill_with(v, cavity) {
            return false;
        }
        let there = self.ghost_bases(v, cavity.faces().iter().copied());
        if let [Some(there_out), Some(there_in)] = there {
            self.glue(here_in.next(), there_out.prev());
            self.glue(there_in.next(), here_out.prev());
        }
        true
    }

    /// Of the ghosts among some faces, the base that leaves `v` and the one that comes to it.
    fn ghost_bases(
        &self,
        v: VertexId,
        faces: impl Iterator<Item = FaceId>,
    ) -> [Option<HalfEdgeId>; 2] {
        let mut found = [None; 2];
        for base in faces.filter_map(|f| self.mesh().ghost_base(f)) {
            found[usize::from(self.mesh().origin(base) != v)] = Some(base);
        }
        found
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tri::{Constrained2, Delaunay2};

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

    #[test]
    fn a_cut_is_divided_on_both_sides_and_takes_points_afterwards() {
        let corners = [
            DVec2::ZERO,
            DVec2::X,
            DVec2::ONE,
            DVec2::Y,
            DVec2::splat(0.25),
        ];
        let [a, b] = [0, 4].map(VertexId::new);
        for ends in [[a, b], [a, VertexId::new(2)]] {
            let mut square = Constrained2::of(Delaunay2::build(&corners).unwrap());
            square.add_segment(0, ends).unwrap();
            let mut cut = square.subcomplex(|_| true);
            let before = cut.boundary().count();
            let h = cut.mesh().find_half_edge(a, b).unwrap();
            let t = cut.partner(h).unwrap();
            assert_eq!(cut.partner(t), Some(h));
            assert_eq!(
                cut.boundary().filter(|&h| cut.partner(h).is_some()).count(),
                before - 4
            );
            let mut cavity = Cavity::default();
            let p = DVec2::splat(0.125);
            assert!(cut.dig_on(p, h, &mut cavity));
            let v = cut.fill(p, &mut cavity).unwrap();
            assert!(cut.dig_on(p, t, &mut cavity));
            assert!(cut.fill_other_side(v, &mut cavity));
            assert_eq!(cut.check(), Ok(()));
            assert_eq!(cut.boundary().count(), before + 2);
            let partners = cut.boundary().filter(|&h| cut.partner(h).is_some());
            assert_eq!(partners.count(), before - 4 + 2);
            assert!(!cut.fill_other_side(VertexId::GHOST, &mut cavity));
        }
    }
}
