//! The Delaunay triangulation of the domain (§2): the triangles of the samples' triangulation that
//! lie inside the domain.
//!
//! A triangle lies outside exactly when its three corners lie on one wall. Of the others, *boundary
//! triangles* have one edge on a wall and *interior triangles* none. A side is on the boundary when
//! its ends lie on the same wall; the paper's sampling assumption, that such ends are always
//! neighbours and that every piece of wall is a side, is checked, and where it fails the caller
//! learns which pieces to halve.
//!
//! In a periodic domain the triangulation is that of the infinite tiling, each class of triangles
//! once: every corner carries the periods by which its sample is moved, and so does the step across
//! a side.

use crate::Report;
use crate::corner::{Corner, wall_image};
use crate::domain::Domain;
use crate::error::BlockingError;
use crate::periodic::Tiling;
use crate::sample::{SampleId, Samples};
use crate::wall::Shift;

/// A triangle of the domain.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct TriangleId(pub(crate) u32);

impl TriangleId {
    /// Position in [`DomainTriangulation::triangles`].
    #[must_use]
    pub const fn index(self) -> usize {
        self.0 as usize
    }
}

/// A side of a triangle, directed counterclockwise round it: side `k` runs from corner `k` to
/// corner `k + 1`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct SideId {
    /// The triangle on the left.
    pub triangle: TriangleId,
    /// 0, 1 or 2.
    pub side: u8,
}

impl SideId {
    /// The side that follows counterclockwise round the same triangle.
    #[must_use]
    pub const fn next(self) -> Self {
        Self {
            triangle: self.triangle,
            side: (self.side + 1) % 3,
        }
    }

    /// Its position among the sides of all triangles, `3 t + k`.
    #[must_use]
    pub const fn index(self) -> usize {
        3 * self.triangle.index() + self.side as usize
    }
}

/// What lies across a side of a triangle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Across {
    /// A wall: the side is a piece of the boundary.
    Wall,
    /// The same side seen from the neighbour, which must be moved by `shift` to lie there.
    Triangle {
        /// The neighbour's side.
        side: SideId,
        /// The periods by which the neighbour is moved.
        shift: Shift,
    },
}

/// A triangle of the domain: corners counterclockwise, and what lies across each side.
#[derive(Clone, Copy, Debug)]
pub struct Triangle {
    /// Corners, counterclockwise.
    pub corners: [Corner; 3],
    /// `across[k]` lies across the side from corner `k` to corner `k + 1`.
    pub across: [Across; 3],
}

impl Triangle {
    /// Whether no side is on the boundary: its circumcentre is a vertex of the medial axis.
    #[must_use]
    pub fn is_interior(&self) -> bool {
        !self.across.contains(&Across::Wall)
    }

    fn wall_sides(&self) -> usize {
        self.across
            .iter()
            .filter(|across| **across == Across::Wall)
            .count()
    }
}

/// The triangles inside the domain and how they are glued.
#[derive(Clone, Debug)]
pub struct DomainTriangulation {
    triangles: Vec<Triangle>,
}

/// Pieces of wall, each named by the sample at its clockwise end, that are too long for the
/// triangulation to represent the domain.
pub(crate) struct TooCoarse(pub(crate) Vec<SampleId>);

impl DomainTriangulation {
    /// Triangulates the domain, or tells which pieces of wall are too long.
    ///
    /// O(s log s) for s samples.
    pub(crate) fn of(
        domain: &Domain,
        samples: &Samples,
        report: &mut Report<'_>,
    ) -> Result<Result<Self, TooCoarse>, BlockingError> {
        let tiling = Tiling::of(domain, samples, report)?;
        let triangulation = Self::from_tiling(samples, &tiling);
        let coarse = triangulation.coarse_pieces(samples);
        Ok(if coarse.is_empty() {
            Ok(triangulation)
        } else {
            Err(TooCoarse(coarse))
        })
    }

    fn from_tiling(samples: &Samples, tiling: &Tiling) -> Self {
        let mut kept = tiling.triangle_classes(|corners| !on_one_wall(samples, corners));
        kept.sort_unstable_by_key(|corners| corners.map(Corner::key));
        let triangles = (0..kept.len())
            .map(|t| Triangle {
                corners: kept[t],
                across: [Across::Wall; 3],
            })
            .collect();
        let mut triangulation = Self { triangles };
        triangulation.glue(samples);
        triangulation
    }

    /// All triangles, in a canonical order.
    #[must_use]
    pub fn triangles(&self) -> &[Triangle] {
        &self.triangles
    }

    /// The triangle with this id.
    #[must_use]
    pub fn triangle(&self, id: TriangleId) -> &Triangle {
        &self.triangles[id.index()]
    }

    /// The ids of all triangles.
    pub fn ids(&self) -> impl Iterator<Item = TriangleId> + use<> {
        (0..self.triangles.len() as u32).map(TriangleId)
    }

    /// The ids of the interior triangles.
    pub fn interior(&self) -> impl Iterator<Item = TriangleId> + '_ {
        self.ids().filter(|&id| self.triangle(id).is_interior())
    }

    /// What lies across a side.
    #[must_use]
    pub fn across(&self, side: SideId) -> Across {
        self.triangle(side.triangle).across[usize::from(side.side)]
    }

    /// The corners at the two ends of a side.
    #[must_use]
    pub fn ends(&self, side: SideId) -> [Corner; 2] {
        let corners = &self.triangle(side.triangle).corners;
        [
            corners[usize::from(side.side)],
            corners[usize::from(side.next().side)],
        ]
    }

    /// The corner that a side does not touch.
    #[must_use]
    pub fn apex(&self, side: SideId) -> Corner {
        self.triangle(side.triangle).corners[usize::from(side.next().next().side)]
    }

    /// Finds for every side that is not on a wall the same side of the neighbour.
    fn glue(&mut self, samples: &Samples) {
        let mut sides: Vec<(SideKey, SideId, Shift)> = self
            .ids()
            .flat_map(|triangle| (0..3u8).map(move |side| SideId { triangle, side }))
            .filter(|&side| !self.ends_on_one_wall(samples, side))
            .map(|side| {
                let (key, home) = side_key(self.ends(side));
                (key, side, home)
            })
            .collect();
        sides.sort_unstable_by_key(|&(key, side, _)| (key, side));
        for pair in sides.chunk_by(|a, b| a.0 == b.0) {
            if let [(_, a, home_a), (_, b, home_b)] = *pair {
                self.set_across(
                    a,
                    Across::Triangle {
                        side: b,
                        shift: home_a - home_b,
                    },
                );
                self.set_across(
                    b,
                    Across::Triangle {
                        side: a,
                        shift: home_b - home_a,
                    },
                );
            }
        }
    }

    fn set_across(&mut self, side: SideId, across: Across) {
        self.triangles[side.triangle.index()].across[usize::from(side.side)] = across;
    }

    fn ends_on_one_wall(&self, samples: &Samples, side: SideId) -> bool {
        let [a, b] = self.ends(side).map(|corner| wall_image(samples, corner));
        a == b
    }

    /// Pieces of wall that are no side, and pieces next to triangles that a good sampling does not
    /// have.
    fn coarse_pieces(&self, samples: &Samples) -> Vec<SampleId> {
        let mut is_side = vec![false; samples.len()];
        let mut coarse = Vec::new();
        for triangle in &self.triangles {
            let regular = triangle.wall_sides() <= 1;
            for k in (0..3).filter(|&k| triangle.across[k] == Across::Wall) {
                let [a, b] = [
                    triangle.corners[k].sample,
                    triangle.corners[(k + 1) % 3].sample,
                ];
                for (from, to) in [(a, b), (b, a)] {
                    if samples.next(from) == to && regular {
                        is_side[from.index()] = true;
                    }
                }
            }
        }
        coarse.extend(
            (0..samples.len() as u32)
                .map(SampleId)
                .filter(|sample| !is_side[sample.index()]),
        );
        coarse
    }
}

fn on_one_wall(samples: &Samples, corners: [Corner; 3]) -> bool {
    let [a, b, c] = corners.map(|corner| wall_image(samples, corner));
    a == b && b == c
}

/// The two ends of a side moved so that the end with the smaller key is at home, the same from both
/// triangles.
type SideKey = [(SampleId, [i32; 2]); 2];

/// The key of a side and the periods by which the key must be moved to lie where the side does.
fn side_key([a, b]: [Corner; 2]) -> (SideKey, Shift) {
    // Both ends can be images of one sample: then the smaller shift decides, which moves with the
    // side.
    let (low, high) = if a.key() < b.key() { (a, b) } else { (b, a) };
    let home = low.shift;
    ([low.moved(-home).key(), high.moved(-home).key()], home)
}

#[cfg(test)]
mod tests {
    use delaunay_core::geo_predicates::orient2d;

    use super::*;
    use crate::Blocking;
    use crate::example_domains::{three_holes, two_periodic_holes};

    fn each_domain(look: impl Fn(&Blocking)) {
        for domain in [three_holes(), two_periodic_holes()] {
            look(&Blocking::of(&domain).unwrap());
        }
    }

    #[test]
    fn triangles_are_counterclockwise_and_have_at_most_one_side_on_a_wall() {
        each_domain(|blocking| {
            let axis = blocking.sampled_axis();
            for triangle in axis.triangulation.triangles() {
                let [a, b, c] = triangle.corners.map(|corner| axis.point(corner));
                assert!(orient2d(a, b, c).is_positive());
                assert!(triangle.wall_sides() <= 1);
            }
        });
    }

    #[test]
    fn every_piece_of_wall_is_the_side_of_one_triangle() {
        each_domain(|blocking| {
            let axis = blocking.sampled_axis();
            let sides = axis.triangulation.triangles();
            let count: usize = sides.iter().map(Triangle::wall_sides).sum();
            assert_eq!(count, axis.samples.len());
        });
    }

    #[test]
    fn a_side_is_seen_the_same_from_both_its_triangles() {
        each_domain(|blocking| {
            let triangulation = blocking.sampled_axis().triangulation;
            for triangle in triangulation.ids() {
                for side in (0..3).map(|side| SideId { triangle, side }) {
                    let Across::Triangle { side: twin, shift } = triangulation.across(side) else {
                        continue;
                    };
                    let back = Across::Triangle {
                        side,
                        shift: -shift,
                    };
                    assert_eq!(triangulation.across(twin), back);
                    let [a, b] = triangulation.ends(side);
                    let [c, d] = triangulation.ends(twin).map(|corner| corner.moved(shift));
                    assert_eq!((a, b), (d, c));
                }
            }
        });
    }

    /// Euler's formula: a disk with h holes triangulated with s vertices on its walls has s + 2 (h
    /// − 1) triangles.
    #[test]
    fn the_number_of_triangles_is_that_of_the_domain() {
        let blocking = Blocking::of(&three_holes()).unwrap();
        let axis = blocking.sampled_axis();
        assert_eq!(axis.triangulation.triangles().len(), axis.samples.len() + 4);
        assert_eq!(axis.triangulation.interior().count(), 4);
    }
}
