//! Meshes of the unit square like those of the paper's figure 1: even, and graded by a density.
//!
//! `cargo run --release -p cvt-tet --example square`
#![allow(clippy::print_stdout)]

use cvt_tet::{Generators, Outcome, Params, lloyd, lloyd_with};
use delaunay_core::ConvexPolygon;
use delaunay_core::measure::{Statistics, triangle};
use delaunay_core::progress::silent;
use glam::DVec2;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let square = ConvexPolygon::rectangle(DVec2::ZERO, DVec2::ONE)?;
    let start = Generators::new(square, &scattered(1000))?;
    let params = Params::default();

    let free = lloyd(start.clone(), &params, &mut silent);
    describe(
        "even",
        &lloyd(free.generators.attached()?, &params, &mut silent),
    );

    let density = |p: DVec2| (-10.0 * p.length_squared()).exp();
    let free = lloyd_with(start, density, &params, &mut silent)?;
    let bound = lloyd_with(free.generators.attached()?, density, &params, &mut silent)?;
    describe("graded", &bound);
    Ok(())
}

fn describe(name: &str, outcome: &Outcome) {
    let mesh = &outcome.generators;
    let ratio = |f| (f, triangle::radius_ratio(mesh.delaunay().triangle(f)));
    if let (Some(cost), Some(quality)) = (
        outcome.costs.last(),
        Statistics::of(mesh.triangles().map(ratio)),
    ) {
        let (moves, stop) = (outcome.costs.len() - 1, outcome.stop);
        println!(
            "{name}: {} triangles, cost {cost:.3e} after {moves} more moves ({stop:?})",
            quality.count()
        );
        println!(
            "  radius ratio: mean {:.3}, least {:.3}",
            quality.mean(),
            quality.min()
        );
    }
}

/// Points of the unit square without pattern: every step turns two wheels by a fraction and a bit more.
fn scattered(count: u32) -> Vec<DVec2> {
    let wheel = |i: u32, step: f64| (f64::from(i) * step + f64::from(i * i % 1009) * 0.137).fract();
    (0..count)
        .map(|i| DVec2::new(wheel(i, 0.754_877), wheel(i, 0.569_840)))
        .collect()
}
