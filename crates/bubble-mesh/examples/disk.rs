//! A disk meshed by the method of the paper from nothing but the nodes of its boundary, once even and once with a finer quarter.
//!
//! `cargo run --release -p bubble-mesh --example disk`
#![allow(clippy::print_stdout)]

use std::error::Error;
use std::f64::consts::TAU;

use bubble_mesh::paper::{Params, generate, optimize};
use bubble_mesh::{Domain, radius_ratio};
use delaunay_core::measure::{AngleSummary, Statistics};
use delaunay_core::progress::silent;
use delaunay_core::{BuildOptions, Outline, Subcomplex2, VertexId};
use glam::DVec2;

fn main() -> Result<(), Box<dyn Error>> {
    let even = (0..60).map(|i| f64::from(i) / 60.0);
    describe("even", even)?;
    let fine = (0..45).map(|i| f64::from(i) / 180.0);
    let coarse = (0..45).map(|i| 0.25 + f64::from(i) / 60.0);
    describe("finer quarter", fine.chain(coarse))
}

/// Meshes the disk whose boundary has nodes at these parts of a turn.
fn describe(name: &str, turns: impl Iterator<Item = f64>) -> Result<(), Box<dyn Error>> {
    let nodes: Vec<DVec2> = turns.map(|turn| DVec2::from_angle(turn * TAU)).collect();
    let count = nodes.len();
    let edges = (0..count).map(|i| [i, (i + 1) % count].map(VertexId::new));
    let outline = Outline::new(nodes, edges.collect())?;
    let domain = Domain::new(&outline, BuildOptions::default(), &mut silent)?;

    let params = Params::paper();
    let mesh = generate(&domain, &params, &mut silent);
    let optimized = optimize(&mesh, &params, &mut silent)?;
    println!("{name}: {} nodes ({:?})", mesh.bubbles().len(), mesh.stop());
    print_quality("generated", mesh.region());
    print_quality("optimized", &optimized.region);
    Ok(())
}

fn print_quality(name: &str, region: &Subcomplex2) {
    let triangles = region.faces().map(|f| region.triangle(f));
    let angles = AngleSummary::of_triangles(triangles.clone());
    let quality = Statistics::of(triangles.map(radius_ratio).enumerate());
    if let (Some(quality), Some(angles)) = (quality, angles) {
        println!(
            "  {name}: {} triangles, radius ratio {:.3} on average, {:.3} at least, angles {:.1}° to {:.1}°",
            quality.count(),
            quality.mean(),
            quality.min(),
            angles.min,
            angles.max
        );
    }
}
