//! Meshes the bubble paper's regions and prints counts, qualities and times.
//!
//! `cargo run --release -p bubble-mesh --example mesh_region -- [SCALE] [TRIALS]`
#![allow(clippy::print_stdout, reason = "a program for a terminal")]

use bubble_mesh::graded::{GradedParams, mesh};
use bubble_mesh::{Domain, radius_ratio};
use delaunay_core::progress::silent;
use delaunay_core::{BuildOptions, Outline, VertexId};
use glam::DVec2;
use std::time::Instant;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let scale = std::env::args()
        .nth(1)
        .map_or(Ok(GradedParams::default().scale), |word| word.parse())?;
    let trials = std::env::args().nth(2).map_or(Ok(0), |word| word.parse())?;
    for (name, graph) in fixtures::outlines::bubble_regions() {
        let points = graph.points.into_iter().map(DVec2::from).collect();
        let segments = graph.segments.iter();
        let segments = segments.map(|ends| ends.map(|v| VertexId::new(v as usize)));
        let outline = Outline::new(points, segments.collect())?;
        let domain = Domain::new(&outline, BuildOptions::default(), &mut silent)?;
        let params = GradedParams {
            scale,
            trials,
            ..GradedParams::default()
        };
        let mut best = f64::INFINITY;
        let mut made = mesh(&domain, &params, &mut silent)?;
        for _ in 0..5 {
            let start = Instant::now();
            made = mesh(&domain, &params, &mut silent)?;
            best = best.min(start.elapsed().as_secs_f64());
        }
        let ratios = made
            .complex
            .faces()
            .map(|f| radius_ratio(made.complex.triangle(f)));
        let ratios: Vec<f64> = ratios.collect();
        let least = ratios.iter().copied().fold(1.0, f64::min);
        let mean = ratios.iter().sum::<f64>() / ratios.len() as f64;
        let below = ratios.iter().filter(|&&ratio| ratio < 0.85).count();
        println!(
            "{name:26} {:5} triangles, min {least:.4}, mean {mean:.5}, {below} below 0.85, {:.1} ms",
            ratios.len(),
            1e3 * best
        );
    }
    Ok(())
}
