//! Which edges of a boundary make a smooth chain, and the curve through its nodes.
//!
//! A node is a corner when the boundary turns there by more than an angle, when its edges are of different kinds, or when it has
//! not just two of them. Chains run from corner to corner, or round a loop without corners.

use delaunay_core::VertexId;
use delaunay_core::geo_predicates::{Sign, orient2d};
use glam::DVec2;

use crate::curve::{Curve, CurveError, Piece};

/// Edges one after the other.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Chain {
    /// From corner to corner; the first is not named again at the end of a loop.
    pub(super) nodes: Vec<VertexId>,
    pub(super) is_loop: bool,
    /// One of its edges, by index.
    pub(super) segment: usize,
}

/// A node may be passed where one edge is so many times as long as the other: a curve would bulge beyond the longer one.
const MOST_UNEVEN: f64 = 4.0;

/// The chains of a boundary, each edge in one of them; those that start at the smallest node come first. Takes n log n time.
///
/// An edge given twice is one, edges without length are none. `crease` is the angle of the smallest turn at a corner, in radians; `alike`
/// tells whether two edges are of one kind.
pub(super) fn chains(
    points: &[DVec2],
    segments: &[[VertexId; 2]],
    crease: f64,
    alike: impl Fn(usize, usize) -> bool,
) -> Vec<Chain> {
    let mut walk = Walk::of(points, segments);
    let corners: Vec<bool> = (0..points.len())
        .map(|v| walk.is_corner(VertexId::new(v), crease, &alike))
        .collect();
    let mut chains = Vec::new();
    for wants_corner in [true, false] {
        for v in (0..points.len()).filter(|&v| corners[v] == wants_corner) {
            while let Some(segment) = walk.unused_at(VertexId::new(v)) {
                chains.push(walk.follow(VertexId::new(v), segment, &corners));
            }
        }
    }
    chains
}

/// Edges by node, while chains are taken from them.
struct Walk<'a> {
    points: &'a [DVec2],
    segments: &'a [[VertexId; 2]],
    /// By vertex, where its edges start in `at`; one more at the end.
    starts: Vec<usize>,
    at: Vec<usize>,
    used: Vec<bool>,
}

impl<'a> Walk<'a> {
    fn of(points: &'a [DVec2], segments: &'a [[VertexId; 2]]) -> Self {
        let sorted = |[a, b]: [VertexId; 2]| [a.min(b), a.max(b)];
        let mut order: Vec<usize> = (0..segments.len()).collect();
        order.sort_by_key(|&s| (sorted(segments[s]), s));
        order.dedup_by_key(|s| sorted(segments[*s]));
        order.retain(|&s| segments[s][0] != segments[s][1]);
        let ends = order.iter().flat_map(|&s| segments[s].map(|v| (v, s)));
        let mut ends: Vec<(VertexId, usize)> = ends.collect();
        ends.sort_unstable();
        let count = points.len();
        Self {
            points,
            segments,
            starts: (0..=count)
                .map(|v| ends.partition_point(|&(w, _)| w.index() < v))
                .collect(),
            at: ends.into_iter().map(|(_, s)| s).collect(),
            used: vec![false; segments.len()],
        }
    }

    fn edges(&self, v: VertexId) -> &[usize] {
        &self.at[self.starts[v.index()]..self.starts[v.index() + 1]]
    }

    fn other_end(&self, segment: usize, v: VertexId) -> VertexId {
        let [a, b] = self.segments[segment];
        if a == v { b } else { a }
    }

    fn is_corner(&self, v: VertexId, crease: f64, alike: &impl Fn(usize, usize) -> bool) -> bool {
        let &[s, t] = self.edges(v) else {
            return true;
        };
        let [a, b] = [s, t].map(|s| self.points[self.other_end(s, v).index()]);
        let here = self.points[v.index()];
        let [back, ahead] = [here - a, b - here];
        let turns = match orient2d(a, here, b) {
            Sign::Zero if back.dot(ahead) > 0.0 => false,
            _ => back.angle_to(ahead).abs() > crease,
        };
        let [back, ahead] = [back, ahead].map(DVec2::length);
        let is_bent = orient2d(a, here, b) != Sign::Zero;
        let is_uneven = back.max(ahead) > MOST_UNEVEN * back.min(ahead);
        turns || (is_bent && is_uneven) || !alike(s, t)
    }

    fn unused_at(&self, v: VertexId) -> Option<usize> {
        let mut edges = self.edges(v).iter().copied();
        edges.find(|&s| !self.used[s])
    }

    /// The chain from a node over an edge to the next corner, or round to the node.
    fn follow(&mut self, start: VertexId, segment: usize, corners: &[bool]) -> Chain {
        let mut nodes = vec![start];
        let (mut here, mut edge) = (start, segment);
        loop {
            self.used[edge] = true;
            here = self.other_end(edge, here);
            if here == start && !corners[start.index()] {
                let is_loop = true;
                return Chain {
                    nodes,
                    is_loop,
                    segment,
                };
            }
            nodes.push(here);
            match self.unused_at(here) {
                Some(next) if !corners[here.index()] => edge = next,
                _ => {
                    let is_loop = false;
                    return Chain {
                        nodes,
                        is_loop,
                        segment,
                    };
                }
            }
        }
    }
}

impl Chain {
    /// The smooth curve through the nodes: straight where they are in line, else a cubic spline.
    ///
    /// # Errors
    /// A coordinate that is not accepted, or two consecutive nodes at one place.
    pub(super) fn curve(&self, points: &[DVec2]) -> Result<Curve, CurveError> {
        let places: Vec<DVec2> = self.nodes.iter().map(|v| points[v.index()]).collect();
        if self.is_loop {
            return Curve::closed_spline(&places);
        }
        let in_line = places
            .windows(3)
            .all(|p| orient2d(p[0], p[1], p[2]) == Sign::Zero);
        let piece = match in_line {
            true => Piece::straight(&places)?,
            false => Piece::spline(&places)?,
        };
        Curve::open(vec![piece])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(points: &[[f64; 2]], segments: &[[usize; 2]], crease: f64) -> Vec<(Vec<usize>, bool)> {
        let points: Vec<DVec2> = points.iter().copied().map(DVec2::from).collect();
        let segments: Vec<_> = segments
            .iter()
            .map(|ends| ends.map(VertexId::new))
            .collect();
        let chains = chains(&points, &segments, crease, |_, _| true);
        let plain = |chain: Chain| {
            let nodes = chain.nodes.iter().map(|v| v.index()).collect();
            (nodes, chain.is_loop)
        };
        chains.into_iter().map(plain).collect()
    }

    #[test]
    fn chains_run_from_corner_to_corner_or_round_a_loop() {
        // A square with a node on its lower side, an edge of it given twice.
        let square = [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]];
        let edges = [[0, 1], [1, 2], [2, 3], [3, 4], [4, 0], [1, 0]];
        let open = |nodes: &[usize]| (nodes.to_vec(), false);
        assert_eq!(
            found(&square, &edges, 0.5),
            [
                open(&[0, 1, 2]),
                open(&[0, 4]),
                open(&[2, 3]),
                open(&[3, 4])
            ]
        );
        // All turns allowed.
        assert_eq!(found(&square, &edges, 4.0), [(vec![0, 1, 2, 3, 4], true)]);
        // Two loops that touch.
        let eight = [
            [0.0, 0.0],
            [1.0, 1.0],
            [1.0, -1.0],
            [-1.0, 1.0],
            [-1.0, -1.0],
        ];
        let edges = [[0, 1], [1, 2], [2, 0], [0, 3], [3, 4], [4, 0]];
        assert_eq!(
            found(&eight, &edges, 4.0),
            [open(&[0, 1, 2, 0]), open(&[0, 3, 4, 0])]
        );
    }
}
