//! The mesh of the moved nodes (§3.5): their constrained Delaunay triangulation.

use std::ops::ControlFlow;

use delaunay_core::progress::Progress;
use delaunay_core::{BuildOptions, ConstrainError, Constrained2, Crossings, Subcomplex2, VertexId};
use glam::DVec2;

use crate::bubble::Bubble;
use crate::error::OptimizeError;

/// The triangulation of the bubbles' centers, one for each vertex of `region`, within the boundary of `region`.
///
/// Interior nodes are strictly inside. Two in one place would be one vertex: then those that share a place go back to where they
/// were in `region`, and if others are there, all do.
pub(super) fn triangulated(
    region: &Subcomplex2,
    bubbles: &mut [Bubble],
    report: &mut dyn FnMut(Progress) -> ControlFlow<()>,
) -> Result<Subcomplex2, OptimizeError> {
    let places = apart(bubbles.iter().map(|bubble| bubble.center), region.points());
    for (bubble, &place) in bubbles.iter_mut().zip(&places) {
        bubble.center = place;
    }
    let mesh = region.mesh();
    let boundary: Vec<[VertexId; 2]> = region
        .boundary()
        .map(|h| [mesh.origin(h), mesh.target(h)])
        .collect();
    let options = BuildOptions::default();
    let moved = Constrained2::build(&places, &boundary, Crossings::Refuse, options, report)?;
    let parts = moved.components(report).map_err(ConstrainError::from)?;
    // The region is on the left of its boundary.
    let mut is_region = vec![false; parts.count()];
    for [a, b] in boundary {
        if let Some(h) = moved.mesh().find_half_edge(a, b) {
            is_region[parts.of(h.face())] = true;
        }
    }
    Ok(moved.subcomplex(|f| is_region[parts.of(f)]))
}

/// Places that no two nodes share, those given as far as possible.
fn apart(places: impl Iterator<Item = DVec2>, starts: &[DVec2]) -> Vec<DVec2> {
    let mut places: Vec<DVec2> = places.collect();
    if send_back_coincident(&mut places, starts) && has_coincident(&places) {
        places.copy_from_slice(starts);
    }
    places
}

/// Moves all nodes that share a place back to their starts; answers whether there were any.
fn send_back_coincident(places: &mut [DVec2], starts: &[DVec2]) -> bool {
    let order = by_place(places);
    let shared = order.chunk_by(|&v, &w| places[v.index()] == places[w.index()]);
    let shared = shared.filter(|group| group.len() > 1);
    let back: Vec<VertexId> = shared.flatten().copied().collect();
    for v in &back {
        places[v.index()] = starts[v.index()];
    }
    !back.is_empty()
}

fn has_coincident(places: &[DVec2]) -> bool {
    let order = by_place(places);
    let mut neighbors = order.windows(2);
    neighbors.any(|pair| places[pair[0].index()] == places[pair[1].index()])
}

/// The vertices, from left to right and from below upwards.
fn by_place(places: &[DVec2]) -> Vec<VertexId> {
    let mut order: Vec<VertexId> = (0..places.len()).map(VertexId::new).collect();
    // Adding 0.0 turns -0.0 into 0.0.
    let key = |v: &VertexId| places[v.index()] + DVec2::ZERO;
    order.sort_unstable_by(|v, w| {
        let [p, q] = [key(v), key(w)];
        p.x.total_cmp(&q.x).then(p.y.total_cmp(&q.y))
    });
    order
}

#[cfg(test)]
mod tests {
    use super::*;
    use delaunay_core::Delaunay2;
    use delaunay_core::progress::silent;

    fn square() -> Subcomplex2 {
        let corners = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
        let inside = [[0.5, 0.5], [-0.5, 0.25], [0.0, -0.5]];
        let points = [&corners[..], &inside].concat();
        let points: Vec<DVec2> = points.into_iter().map(DVec2::from).collect();
        Subcomplex2::of(&Delaunay2::build(&points).unwrap(), |_| true)
    }

    fn after(moves: &[(usize, [f64; 2])]) -> Vec<DVec2> {
        let region = square();
        let bubble = |&center: &DVec2| Bubble {
            center,
            radius: 1.0,
        };
        let mut bubbles: Vec<Bubble> = region.points().iter().map(bubble).collect();
        for &(node, place) in moves {
            bubbles[node].center = place.into();
        }
        let moved = triangulated(&region, &mut bubbles, &mut silent).unwrap();
        assert_eq!(moved.check(), Ok(()));
        assert_eq!(moved.faces().count(), 8);
        let places: Vec<DVec2> = bubbles.iter().map(|bubble| bubble.center).collect();
        assert_eq!(moved.points(), places);
        places
    }

    #[test]
    fn moved_nodes_are_triangulated_where_they_are() {
        let places = after(&[(4, [0.25, 0.25])]);
        assert_eq!(places[4], DVec2::splat(0.25));
    }

    #[test]
    fn nodes_that_meet_go_back() {
        let starts = after(&[]);
        let places = after(&[(4, [0.0, 0.0]), (5, [-0.0, 0.0])]);
        assert_eq!(places, starts);
        // Back at its start the first would meet the third.
        let places = after(&[(4, [0.0, 0.0]), (5, [0.0, 0.0]), (6, [0.5, 0.5])]);
        assert_eq!(places, starts);
    }
}
