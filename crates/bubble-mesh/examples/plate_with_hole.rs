//! A plate with a spline for its outline and a round hole, meshed from nothing but its curves.
//!
//! `cargo run --release -p bubble-mesh --example plate_with_hole -- [SIZE]`
#![allow(clippy::print_stdout, reason = "a program for a terminal")]

use std::error::Error;

use bubble_mesh::curve::{Curve, Sampling, sample_all};
use bubble_mesh::graded::{GradedParams, mesh};
use bubble_mesh::{Domain, radius_ratio};
use delaunay_core::measure::{AngleSummary, Statistics};
use delaunay_core::{BuildOptions, progress::silent};
use glam::DVec2;

/// Points of the outline.
const OUTLINE: [[f64; 2]; 7] = [
    [0.0, 0.0],
    [3.0, -0.5],
    [6.0, 0.0],
    [6.5, 2.0],
    [4.0, 3.0],
    [1.5, 4.5],
    [-0.5, 2.5],
];

fn main() -> Result<(), Box<dyn Error>> {
    let size = std::env::args()
        .nth(1)
        .map_or(Ok(0.4), |word| word.parse())?;
    let outline = Curve::closed_spline(&OUTLINE.map(DVec2::from))?;
    let hole = Curve::circle(DVec2::new(1.5, 2.2), 0.6)?;
    let sampled = sample_all(&[outline, hole], &Sampling::new(size))?;
    for (curve, name) in ["outline", "hole"].into_iter().enumerate() {
        let edges = sampled.curve_of.iter().filter(|&&c| c == curve).count();
        println!("{name}: {edges} edges");
    }

    let domain = Domain::new(&sampled.outline()?, BuildOptions::default(), &mut silent)?;
    let mesh = mesh(&domain, &GradedParams::default(), &mut silent)?;
    let triangles = mesh.complex.faces().map(|f| mesh.complex.triangle(f));
    let angles = AngleSummary::of_triangles(triangles.clone());
    let quality = Statistics::of(triangles.map(radius_ratio).enumerate());
    if let (Some(quality), Some(angles)) = (quality, angles) {
        println!(
            "mesh: {} triangles ({:?}), radius ratio {:.3} on average, {:.3} at least, angles {:.1}° to {:.1}°",
            quality.count(),
            mesh.stop,
            quality.mean(),
            quality.min(),
            angles.min,
            angles.max
        );
    }
    Ok(())
}
