//! Algorithm 1: the medial axis approximated from the Delaunay triangulation of the domain (§2).
//!
//! Vertices are the circumcentres of interior triangles. An arc is the sequence of triangles
//! between two interior ones: it enters a boundary triangle through one of its two interior sides
//! and leaves through the other, until it enters an interior triangle.

use glam::DVec2;

use crate::corner::{Corner, corner_point};
use crate::domain::Domain;
use crate::sample::Samples;
use crate::triangulation::{Across, DomainTriangulation, SideId, TriangleId};
use crate::wall::Shift;

/// A triangle that an arc enters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Entry {
    /// The side through which the triangle is entered, seen from inside it: λ0 of Algorithm 2.
    pub side: SideId,
    /// The periods by which the triangle is moved to lie next to the one before.
    pub shift: Shift,
}

/// A sequence of triangles from one interior triangle to the next: an arc of the sampled medial
/// axis.
#[derive(Clone, Debug)]
pub struct TriangleSequence {
    /// The side through which the arc leaves its first triangle, which is at home.
    pub start: SideId,
    /// The triangles entered one after the other; the last one is interior.
    pub entries: Vec<Entry>,
}

impl TriangleSequence {
    /// The triangles of the sequence with the periods by which they are moved, first to last.
    pub fn triangles(&self) -> impl Iterator<Item = (TriangleId, Shift)> + '_ {
        std::iter::once((self.start.triangle, Shift::ZERO)).chain(
            self.entries
                .iter()
                .map(|entry| (entry.side.triangle, entry.shift)),
        )
    }

    /// The polyline of circumcentres that approximates the arc: the curve `M` of Algorithm 2.
    #[must_use]
    pub fn polyline(&self, axis: &SampledAxis<'_>) -> Vec<DVec2> {
        self.triangles()
            .map(|(triangle, shift)| axis.circumcenter(triangle, shift))
            .collect()
    }
}

/// The medial axis as far as the samples know it.
#[derive(Clone, Copy, Debug)]
pub struct SampledAxis<'a> {
    /// The domain.
    pub domain: &'a Domain,
    /// Its boundary samples.
    pub samples: &'a Samples,
    /// Their triangulation.
    pub triangulation: &'a DomainTriangulation,
}

impl SampledAxis<'_> {
    /// The arcs, each once: from every interior triangle through every side not yet visited.
    ///
    /// O(number of triangles).
    #[must_use]
    pub fn arcs(&self) -> Vec<TriangleSequence> {
        let mut visited = vec![false; 3 * self.triangulation.triangles().len()];
        let mut arcs = Vec::new();
        for triangle in self.triangulation.interior() {
            for side in (0..3).map(|side| SideId { triangle, side }) {
                if visited[side.index()] {
                    continue;
                }
                let arc = self.follow(side);
                for end in std::iter::once(side).chain(arc.entries.last().map(|entry| entry.side)) {
                    visited[end.index()] = true;
                }
                arcs.push(arc);
            }
        }
        arcs
    }

    /// The sequence of triangles that starts across `start`, a side of an interior triangle.
    fn follow(&self, start: SideId) -> TriangleSequence {
        let mut entries = Vec::new();
        let (mut leaving, mut at) = (start, Shift::ZERO);
        while let Across::Triangle { side, shift } = self.triangulation.across(leaving) {
            at += shift;
            entries.push(Entry { side, shift: at });
            let (after, before) = (side.next(), side.next().next());
            let is_wall = |side| self.triangulation.across(side) == Across::Wall;
            leaving = match (is_wall(after), is_wall(before)) {
                (false, true) => after,
                (true, false) => before,
                _ => break,
            };
        }
        TriangleSequence { start, entries }
    }

    /// Centre of the circle through a triangle's corners, the triangle moved by `shift`.
    #[must_use]
    pub fn circumcenter(&self, triangle: TriangleId, shift: Shift) -> DVec2 {
        let corners = self
            .triangulation
            .triangle(triangle)
            .corners
            .map(|corner| self.point(corner));
        delaunay_core::measure::triangle::circumcenter(corners) + self.domain.translation(shift)
    }

    /// Where a corner lies.
    #[must_use]
    pub fn point(&self, corner: Corner) -> DVec2 {
        corner_point(self.domain, self.samples, corner)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Blocking;
    use crate::example_domains::{one_hole, three_holes, two_periodic_holes};

    #[test]
    fn an_arc_runs_through_boundary_triangles_from_one_interior_triangle_to_another() {
        for domain in [three_holes(), two_periodic_holes()] {
            let blocking = Blocking::of(&domain).unwrap();
            let axis = blocking.sampled_axis();
            for arc in axis.arcs() {
                let interior: Vec<bool> = arc
                    .triangles()
                    .map(|(triangle, _)| axis.triangulation.triangle(triangle).is_interior())
                    .collect();
                let (first, rest) = interior.split_first().unwrap();
                let (last, between) = rest.split_last().unwrap();
                assert!(*first && *last && !between.contains(&true));
            }
        }
    }

    #[test]
    fn the_arcs_leave_every_side_of_every_interior_triangle_once() {
        let blocking = Blocking::of(&three_holes()).unwrap();
        let axis = blocking.sampled_axis();
        let mut ends: Vec<SideId> = axis
            .arcs()
            .iter()
            .flat_map(|arc| [arc.start, arc.entries.last().unwrap().side])
            .collect();
        ends.sort_unstable();
        let sides = |triangle| (0..3).map(move |side| SideId { triangle, side });
        let expected: Vec<SideId> = axis.triangulation.interior().flat_map(sides).collect();
        assert_eq!(ends, expected);
    }

    #[test]
    fn circumcentres_lie_near_the_bisector_of_the_walls_of_their_arc() {
        let domain = three_holes();
        let blocking = Blocking::of(&domain).unwrap();
        let axis = blocking.sampled_axis();
        for (sequence, arc) in axis.arcs().iter().zip(blocking.arcs()) {
            for p in sequence.polyline(&axis) {
                let [right, left] =
                    [arc.right, arc.left].map(|wall| domain.wall_image(wall).distance(p));
                assert!((right - left).abs() < 0.05, "{right} {left}");
            }
        }
    }

    #[test]
    fn a_single_hole_has_no_arc_because_no_triangle_is_interior() {
        let blocking = Blocking::of(&one_hole()).unwrap();
        assert!(blocking.sampled_axis().arcs().is_empty());
    }
}
