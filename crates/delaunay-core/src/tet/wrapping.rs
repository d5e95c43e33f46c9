//! Gift wrapping: a hole is filled with Delaunay tetrahedra, one after the other, in rounded numbers
//! (Chand and Kapur 1970).
//!
//! ```text
//!   a ───── b      A facet that faces the hole gets the tetrahedron whose circumsphere is empty on that side: of all
//!    \     /       points on that side, its apex makes the circumcenter lie farthest back. The other facets of the
//!     \ d /        tetrahedron face the hole in turn, unless they close up with one that does already.
//! ```
//!
//! A hole of a few dozen points is filled several times faster than by triangulating its points with exact signs. What is
//! found is a proposal: whether the tetrahedra fill the hole, and are Delaunay, has to be checked before a mesh is made of them.
//! Where points are on a common sphere they may not.

use super::mesh::FACET_CORNERS;
use glam::DVec3;

/// Tetrahedra for a facet of the hole, at most.
const MANY: usize = 4;

/// Points round a hole, at most: as many as keys of facets have room for.
const MOST_POINTS: usize = 1 << 10;

/// Keys compared at once.
const BLOCK: usize = 16;

/// Shares of a facet's plane: points as near to the plane as this, for their distance, count as on it.
const FLAT: f64 = 1e-10;

/// The tetrahedra that fill a hole; keeps its room from one hole to the next.
#[derive(Clone, Debug, Default)]
pub struct Wrapping {
    tets: Vec<WrappedTet>,
    open: Vec<Open>,
    /// The keys of the open facets.
    keys: Vec<u32>,
}

/// A tetrahedron that fills a hole.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WrappedTet {
    /// Its corners among the points, right-handed.
    pub corners: [usize; 4],
    /// What is beyond the facet opposite each corner.
    pub across: [Across; 4],
    /// Where one of its corners is.
    place: DVec3,
    /// The circumcenter as seen from there: where tetrahedra are nearly flat it is far away, and digits would be lost.
    center: DVec3,
}

/// What is on the other side of a facet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Across {
    /// Another tetrahedron of the hole.
    Tet(usize),
    /// What is round the hole, beyond one of the facets given.
    Facet(usize),
}

impl WrappedTet {
    /// Whether a point is inside the circumsphere, in rounded numbers.
    #[must_use]
    #[inline]
    pub fn is_in_conflict(&self, point: DVec3) -> bool {
        let seen = point - self.place;
        seen.length_squared() < 2.0 * seen.dot(self.center)
    }

    /// The circumcenter, rounded.
    #[must_use]
    pub fn circumcenter(&self) -> DVec3 {
        self.place + self.center
    }
}

/// A facet that faces the hole.
#[derive(Clone, Copy, Debug)]
struct Open {
    /// Counterclockwise as seen from outside the hole.
    corners: [usize; 3],
    behind: Behind,
}

#[derive(Clone, Copy, Debug)]
enum Behind {
    Facet(usize),
    /// This facet of a tetrahedron.
    Tet(usize, usize),
}

impl Wrapping {
    /// Fills the hole between `facets`, whose corners among `points` are counterclockwise as seen from outside the hole.
    ///
    /// `None` when the tetrahedra do not close up, when `accept` does not accept one of them as soon as it is found, and when
    /// there are more than 1024 points. Takes time proportional to the number of points times the number of tetrahedra, of
    /// which there are at most four for each facet.
    ///
    /// # Panics
    /// When a corner is beyond all points.
    ///
    /// ```
    /// use delaunay_core::{Across, Wrapping};
    /// use glam::DVec3;
    ///
    /// let points = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z];
    /// let facets = [[1, 2, 3], [2, 0, 3], [0, 1, 3], [2, 1, 0]];
    /// let mut wrapping = Wrapping::default();
    /// let tets = wrapping.fill(&points, facets, |_| true).unwrap();
    /// assert_eq!((tets.len(), tets[0].circumcenter()), (1, DVec3::splat(0.5)));
    /// assert!(facets.iter().enumerate().all(|(i, _)| tets[0].across.contains(&Across::Facet(i))));
    /// ```
    pub fn fill(
        &mut self,
        points: &[DVec3],
        facets: impl IntoIterator<Item = [usize; 3]>,
        mut accept: impl FnMut(&WrappedTet) -> bool,
    ) -> Option<&[WrappedTet]> {
        self.tets.clear();
        self.open.clear();
        self.keys.clear();
        if points.len() > MOST_POINTS {
            return None;
        }
        for (number, corners) in facets.into_iter().enumerate() {
            self.push(corners, Behind::Facet(number));
        }
        let most = MANY * self.open.len();
        while let Some(open) = self.pop() {
            if self.tets.len() == most {
                return None;
            }
            let tet = self.wrap(points, &open)?;
            if !accept(&tet) {
                return None;
            }
            self.tets.push(tet);
        }
        Some(&self.tets)
    }

    fn push(&mut self, corners: [usize; 3], behind: Behind) {
        self.open.push(Open { corners, behind });
        self.keys.push(key(corners));
    }

    fn pop(&mut self) -> Option<Open> {
        self.keys.pop();
        self.open.pop()
    }

    /// Takes the facet that closes up with one of a new tetrahedron.
    fn take(&mut self, corners: [usize; 3]) -> Option<Open> {
        let sought = key(corners);
        // Whole blocks are compared at once.
        let has = |block: &[u32]| block.iter().fold(false, |met, &key| met | (key == sought));
        let (blocks, rest) = self.keys.as_chunks::<BLOCK>();
        let block = match has(rest) {
            true => blocks.len(),
            false => blocks.iter().rposition(|block| has(block))?,
        };
        let start = block * BLOCK;
        let place = start + self.keys[start..].iter().position(|&key| key == sought)?;
        self.keys.swap_remove(place);
        Some(self.open.swap_remove(place))
    }

    /// The tetrahedra found last, all of them if they fill the hole.
    #[must_use]
    pub fn tets(&self) -> &[WrappedTet] {
        &self.tets
    }

    /// The tetrahedron on a facet; the others know of it.
    fn wrap(&mut self, points: &[DVec3], base: &Open) -> Option<WrappedTet> {
        let [a, b, c] = base.corners;
        let (apex, center) = apex(points, base.corners)?;
        let tet = self.tets.len();
        let corners = [apex, a, b, c];
        let mut across = [self.close(tet, base.behind); 4];
        for (facet, beyond) in across.iter_mut().enumerate().skip(1) {
            let [p, q, r] = FACET_CORNERS[facet].map(|corner| corners[corner]);
            *beyond = if let Some(met) = self.take([p, q, r]) {
                self.close(tet, met.behind)
            } else {
                self.push([r, q, p], Behind::Tet(tet, facet));
                // Until the facet is closed.
                Across::Tet(tet)
            };
        }
        Some(WrappedTet {
            corners,
            across,
            place: points[a],
            center,
        })
    }

    /// What is across a facet of the tetrahedron `tet` that closes up with the one behind, which is told.
    fn close(&mut self, tet: usize, behind: Behind) -> Across {
        match behind {
            Behind::Facet(number) => Across::Facet(number),
            Behind::Tet(other, facet) => {
                self.tets[other].across[facet] = Across::Tet(tet);
                Across::Tet(other)
            }
        }
    }
}

/// The same for the rotations of a facet, another one for the facet turned over.
fn key([a, b, c]: [usize; 3]) -> u32 {
    let ascending = (a < b) ^ (b < c) ^ (a < c);
    let (least, greatest) = (a.min(b).min(c), a.max(b).max(c));
    let middle = a + b + c - least - greatest;
    let packed = least << 20 | middle << 10 | greatest;
    (packed << 1 | usize::from(ascending)) as u32
}

/// The apex of the Delaunay tetrahedron on a facet, on the side from which the facet turns clockwise, and its circumcenter as seen
/// from the first corner of the facet.
fn apex(points: &[DVec3], facet: [usize; 3]) -> Option<(usize, DVec3)> {
    let [a, b, c] = facet.map(|corner| points[corner]);
    let (u, v) = (b - a, c - a);
    let inward = v.cross(u);
    let area = inward.length_squared();
    let middle = inward.cross(u.length_squared() * v - v.length_squared() * u) / (2.0 * area);
    let twice = 2.0 * middle;
    let flat = FLAT * FLAT * area;
    let mut best = None;
    // The circumcenter is `middle` plus `offset / height` times half of `inward`.
    let (mut least, mut least_height) = (f64::INFINITY, 1.0);
    for (number, &point) in points.iter().enumerate() {
        let w = point - a;
        let height = w.dot(inward);
        let squared = w.length_squared();
        if height > 0.0 && height * height > flat * squared {
            let offset = squared - w.dot(twice);
            if offset * least_height < least * height {
                best = Some(number);
                (least, least_height) = (offset, height);
            }
        }
    }
    let center = middle + inward * (least / (2.0 * least_height));
    best.map(|apex| (apex, center))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ids::VertexId;
    use crate::tet::Delaunay3;
    use proptest::prelude::*;
    use std::collections::BTreeSet;

    const SIMPLEX: [DVec3; 4] = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z];

    fn place() -> impl Strategy<Value = DVec3> {
        [-1.0..1.0, -1.0..1.0, -1.0..1.0_f64].prop_map(DVec3::from)
    }

    fn sorted(mut corners: [VertexId; 4]) -> [VertexId; 4] {
        corners.sort_unstable();
        corners
    }

    proptest! {
        #[test]
        fn the_hole_of_a_vertex_is_filled_as_by_exact_signs(
            points in prop::collection::vec(place(), 30..60),
        ) {
            let mut delaunay = Delaunay3::build(&points).unwrap();
            let mesh = delaunay.mesh();
            let is_inner = |v: &VertexId| !mesh.star(*v).any(|t| mesh.is_ghost_tet(t));
            let Some(v) = (0..points.len()).map(VertexId::new).find(is_inner) else { return Ok(()) };
            let link: Vec<[VertexId; 3]> = mesh.link(v).map(|f| mesh.facet_vertices(f)).collect();
            let facets = link.iter().map(|facet| facet.map(VertexId::index));
            let mut wrapping = Wrapping::default();
            // All points are given, also those that are not round the hole, and the vertex itself far away.
            let mut places = points.clone();
            places[v.index()] = DVec3::splat(1e6);
            let tets = wrapping.fill(&places, facets, |_| true).unwrap().to_vec();
            delaunay.remove(v).unwrap();
            let mesh = delaunay.mesh();
            let all: BTreeSet<[VertexId; 4]> = mesh.tets().map(|t| sorted(mesh.tet_vertices(t))).collect();
            for (index, tet) in tets.iter().enumerate() {
                prop_assert!(all.contains(&sorted(tet.corners.map(VertexId::new))));
                for (facet, across) in tet.across.iter().enumerate() {
                    let corners = FACET_CORNERS[facet].map(|corner| VertexId::new(tet.corners[corner]));
                    match *across {
                        Across::Facet(number) => prop_assert!(corners.iter().all(|v| link[number].contains(v))),
                        Across::Tet(other) => prop_assert!(tets[other].across.contains(&Across::Tet(index))),
                    }
                }
            }
            let beyond = tets.iter().flat_map(|tet| tet.across);
            prop_assert_eq!(beyond.filter(|across| matches!(across, Across::Facet(_))).count(), link.len());
        }
    }

    #[test]
    fn facets_that_do_not_close_up_are_refused() {
        let mut wrapping = Wrapping::default();
        for missing in 0..4 {
            let mut facets = FACET_CORNERS.to_vec();
            facets.remove(missing);
            assert_eq!(wrapping.fill(&SIMPLEX, facets, |_| true), None);
            // From outside there is nothing to build on.
            let outside = FACET_CORNERS.map(|[a, b, c]| [c, b, a]);
            assert_eq!(wrapping.fill(&SIMPLEX, outside, |_| true), None);
        }
        assert!(wrapping.fill(&SIMPLEX, FACET_CORNERS, |_| true).is_some());
    }

    #[test]
    fn it_gives_up_when_a_tetrahedron_is_not_accepted() {
        let mut wrapping = Wrapping::default();
        let mut asked = 0;
        let refuse = |tet: &WrappedTet| {
            asked += 1;
            assert!(
                tet.is_in_conflict(DVec3::splat(0.1)) && !tet.is_in_conflict(DVec3::splat(1.1))
            );
            false
        };
        assert_eq!(wrapping.fill(&SIMPLEX, FACET_CORNERS, refuse), None);
        assert_eq!(asked, 1);
    }
}
