//! Triangles in a fixed boundary: whatever is done to them, they stay a triangulation of the same region.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

use delaunay_core::progress::silent;
use delaunay_core::{BuildOptions, Complex2, Constrained2, Crossings, FaceId, VertexId};
use glam::DVec2;

fn ids(segments: &[[usize; 2]]) -> Vec<[VertexId; 2]> {
    let named = segments.iter().map(|ends| ends.map(VertexId::new));
    named.collect()
}

/// The triangles between points, cut apart along segments.
fn cut(points: &[DVec2], segments: &[[usize; 2]]) -> Complex2 {
    let crossings = Crossings::Divide { at_most: 1000 };
    let options = BuildOptions::default();
    let built = Constrained2::build(points, &ids(segments), crossings, options, &mut silent);
    Complex2::of(built.unwrap().subcomplex(|_| true))
}

#[test]
fn a_piece_on_both_sides_of_a_cut_is_put_back_on_both() {
    let corners = [[0.0, 0.0], [8.0, 0.0], [8.0, 8.0], [0.0, 8.0]];
    let wall = [[3.0, 3.0], [4.0, 4.0], [5.0, 5.0]];
    let points: Vec<DVec2> = corners.into_iter().chain(wall).map(DVec2::from).collect();
    let whole = cut(&points, &[[4, 6]]);
    assert_eq!(whole.check(), Ok(()));
    let all: Vec<FaceId> = whole.faces().collect();
    for start in 0..all.len() {
        for end in start + 1..=all.len() {
            let piece = whole.piece(&all[start..end]);
            assert_eq!(piece.complex().check(), Ok(()));
            let mut again = whole.clone();
            again.put_back(&piece, piece.complex());
            assert_eq!(again.check(), Ok(()));
            assert_eq!(again.mesh().canonical(), whole.mesh().canonical());
        }
    }
}
