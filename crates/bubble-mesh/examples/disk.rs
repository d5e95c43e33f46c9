//! A disk meshed from nothing but the nodes of its boundary, once even and once with a finer quarter.
//!
//! `cargo run --release -p bubble-mesh --example disk`
#![allow(clippy::print_stdout)]

use std::f64::consts::TAU;

use bubble_mesh::{Domain, DomainError, Params, generate, radius_ratio};
use delaunay_core::measure::{AngleSummary, Statistics};
use delaunay_core::progress::silent;
use glam::DVec2;

fn main() -> Result<(), DomainError> {
    let even = (0..60).map(|i| f64::from(i) / 60.0);
    describe("even", even)?;
    let fine = (0..45).map(|i| f64::from(i) / 180.0);
    let coarse = (0..45).map(|i| 0.25 + f64::from(i) / 60.0);
    describe("finer quarter", fine.chain(coarse))
}

/// Meshes the disk whose boundary has nodes at these parts of a turn.
fn describe(name: &str, turns: impl Iterator<Item = f64>) -> Result<(), DomainError> {
    let boundary: Vec<DVec2> = turns.map(|turn| DVec2::from_angle(turn * TAU)).collect();
    let mesh = generate(Domain::convex(&boundary)?, &Params::default(), &mut silent);

    let triangles = mesh.delaunay.faces().map(|f| mesh.delaunay.triangle(f));
    let angles = AngleSummary::of_triangles(triangles.clone());
    let quality = Statistics::of(triangles.map(radius_ratio).enumerate());
    if let (Some(quality), Some(angles)) = (quality, angles) {
        println!(
            "{name}: {} nodes, {} triangles ({:?})",
            mesh.bubbles.len(),
            quality.count(),
            mesh.stop
        );
        println!(
            "  radius ratio: mean {:.3}, least {:.3}",
            quality.mean(),
            quality.min()
        );
        println!("  angles: {:.1}° to {:.1}°", angles.min, angles.max);
    }
    Ok(())
}
