//! How many triangles of low quality share how many sinks.
//!
//! `cargo run --release -p sink-refine --example shared_sinks`
#![allow(clippy::print_stdout)]

use std::collections::BTreeSet;

use delaunay_core::Delaunay2;
use delaunay_core::measure::{Statistics, triangle};
use glam::DVec2;
use sink_refine::{End, Sinks};

fn main() -> Result<(), delaunay_core::BuildError> {
    let delaunay = Delaunay2::build(&scattered(10_000))?;
    let sinks = Sinks::of(&delaunay);
    let ratio = |&f: &_| triangle::radius_edge_ratio(delaunay.triangle(f));
    let low: Vec<_> = delaunay.faces().filter(|f| ratio(f) > 1.0).collect();
    let shared: BTreeSet<End> = low.iter().filter_map(|&f| sinks.end(f)).collect();
    println!(
        "{} of {} triangles have r/l above 1",
        low.len(),
        delaunay.faces().count()
    );
    println!("their flows end in {} places", shared.len());

    let sizes = sinks
        .watersheds()
        .map(|(end, ancestors)| (end, ancestors.len() as f64));
    if let Some(sizes) = Statistics::of(sizes) {
        println!(
            "a watershed has {:.2} triangles on average, {} at most",
            sizes.mean(),
            sizes.max()
        );
    }
    Ok(())
}

/// Points of the unit square without pattern: every step turns two wheels by a fraction and a bit more.
fn scattered(count: u32) -> Vec<DVec2> {
    let wheel = |i: u32, step: f64| (f64::from(i) * step + f64::from(i * i % 1009) * 0.137).fract();
    (0..count)
        .map(|i| DVec2::new(wheel(i, 0.754_877), wheel(i, 0.569_840)))
        .collect()
}
