//! Whether the halves of a boundary edge keep clear of all others.
//!
//! A vertex that is put outside a boundary edge pulls the boundary with it, by a rounding error where it is straight, by the
//! height of the curve over the edge where it is smooth. Another part of the boundary may be in the way.

use delaunay_core::geo_predicates::{Sign, orient2d};
use delaunay_core::{HalfEdgeId, Subcomplex2, segments_cross};
use glam::DVec2;
use rstar::primitives::Line;
use rstar::{AABB, RTree};

/// The boundary edges, once they have been asked for.
#[derive(Debug, Default)]
pub(super) struct Clearance {
    edges: Option<RTree<Line<[f64; 2]>>>,
}

impl Clearance {
    /// Whether both halves of the boundary edge `h`, pulled to the point `p`, cross no other boundary edge and have nothing in the
    /// triangle that the region gains. Exact; takes time log n and what is near, the first time n log n.
    pub(super) fn is_given(&mut self, region: &Subcomplex2, h: HalfEdgeId, p: DVec2) -> bool {
        let [a, b] = region.segment(h);
        if orient2d(a, b, p) != Sign::Negative {
            return true;
        }
        let edges = self.edges.get_or_insert_with(|| {
            let all = region.boundary();
            RTree::bulk_load(all.map(|h| line(region.segment(h))).collect())
        });
        let reach = AABB::from_points(&[a, b, p].map(|q| q.to_array()));
        let is_inside = |q: DVec2| {
            let sides = [[b, a], [a, p], [p, b]].map(|[from, to]| orient2d(from, to, q));
            q != a && q != b && !sides.contains(&Sign::Negative)
        };
        let near = edges.locate_in_envelope_intersecting(reach);
        let mut others = near
            .into_iter()
            .map(|line| [line.from, line.to].map(DVec2::from));
        others.all(|edge| {
            edge == [a, b]
                || !(edge.into_iter().any(is_inside)
                    || segments_cross(edge, [a, p])
                    || segments_cross(edge, [p, b]))
        })
    }

    /// Takes note that a boundary edge has been divided at `p`.
    pub(super) fn note(&mut self, [a, b]: [DVec2; 2], p: DVec2) {
        if let Some(edges) = &mut self.edges {
            edges.remove(&line([a, b]));
            edges.insert(line([a, p]));
            edges.insert(line([p, b]));
        }
    }
}

fn line([a, b]: [DVec2; 2]) -> Line<[f64; 2]> {
    Line::new(a.to_array(), b.to_array())
}

#[cfg(test)]
mod tests {
    use super::*;
    use delaunay_core::Delaunay2;

    #[test]
    fn what_is_in_the_way_is_seen() {
        // Two triangles with their tips toward each other.
        let points = [
            [0.0, 0.0],
            [4.0, 0.0],
            [2.0, -4.0],
            [2.0, 2.5],
            [1.0, 5.0],
            [3.0, 5.0],
        ]
        .map(DVec2::from);
        let delaunay = Delaunay2::build(&points).unwrap();
        let is_one = |f| {
            let corners = delaunay.mesh().face_vertices(f);
            let lower = corners.iter().filter(|v| v.index() < 3).count();
            lower == 0 || lower == 3
        };
        let both = Subcomplex2::of(&delaunay, is_one);
        assert_eq!(both.faces().count(), 2);
        let top = both
            .boundary()
            .find(|&h| both.segment(h).iter().all(|p| p.y == 0.0))
            .unwrap();
        let mut clearance = Clearance::default();
        for (y, expected) in [
            (-0.5, true),
            (0.0, true),
            (2.4, true),
            (2.5, false),
            (9.0, false),
        ] {
            assert_eq!(
                clearance.is_given(&both, top, DVec2::new(2.0, y)),
                expected,
                "{y}"
            );
        }
    }
}
