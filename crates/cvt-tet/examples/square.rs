//! Meshes of the unit square like those of the paper's figure 1: even, and graded by a density.
//!
//! `cargo run --release -p cvt-tet --example square`
#![allow(clippy::print_stdout)]

use cvt_tet::{Generators, Outcome, Params, lloyd, lloyd_with};
use delaunay_core::measure::{Statistics, triangle};
use delaunay_core::progress::silent;
use delaunay_core::{ConvexPolygon, Delaunay2, FaceId, VertexId};
use glam::DVec2;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let square = ConvexPolygon::rectangle(DVec2::ZERO, DVec2::ONE)?;
    let start = Generators::new(square, &scattered(1000))?;
    let params = Params::default();

    describe("even", &lloyd(start.clone(), &params, &mut silent));
    let density = |p: DVec2| (-10.0 * p.length_squared()).exp();
    describe("graded", &lloyd_with(start, density, &params, &mut silent)?);
    Ok(())
}

fn describe(name: &str, outcome: &Outcome) {
    let delaunay = outcome.generators.delaunay();
    // No point lies on the boundary of the square: the triangles along the hull are no part of a good mesh.
    let inner = delaunay.faces().filter(|&f| !touches_hull(delaunay, f));
    let ratio = |f| (f, triangle::radius_ratio(delaunay.triangle(f)));
    if let (Some(first), Some(last), Some(quality)) = (
        outcome.costs.first(),
        outcome.costs.last(),
        Statistics::of(inner.map(ratio)),
    ) {
        let (moves, stop) = (outcome.costs.len() - 1, outcome.stop);
        println!("{name}: cost {first:.3e} to {last:.3e} in {moves} moves ({stop:?})");
        println!(
            "  radius ratio: mean {:.3}, least {:.3}",
            quality.mean(),
            quality.min()
        );
    }
}

fn touches_hull(delaunay: &Delaunay2, f: FaceId) -> bool {
    let mesh = delaunay.mesh();
    mesh.face_vertices(f)
        .iter()
        .any(|&v| mesh.neighbors(v).any(VertexId::is_ghost))
}

/// Points of the unit square without pattern: every step turns two wheels by a fraction and a bit more.
fn scattered(count: u32) -> Vec<DVec2> {
    let wheel = |i: u32, step: f64| (f64::from(i) * step + f64::from(i * i % 1009) * 0.137).fract();
    (0..count)
        .map(|i| DVec2::new(wheel(i, 0.754_877), wheel(i, 0.569_840)))
        .collect()
}
