//! Blocks round two particles: who touches whom, and how good the cells are.
//!
//! `cargo run -p medial-blocking --example two_particles`

// An example may print.
#![allow(clippy::print_stdout)]

use delaunay_core::measure::AngleSummary;
use glam::DVec2;
use medial_blocking::{BlockingError, Circle, Domain, Params, mesh};

fn main() -> Result<(), BlockingError> {
    let particles = [
        Circle::new(DVec2::new(-1.0, 0.0), 0.5),
        Circle::new(DVec2::new(1.0, 0.2), 0.4),
    ];
    let domain = Domain::in_circle(Circle::new(DVec2::ZERO, 2.5), &particles)?;
    let mesh = mesh(&domain, &Params::default())?;
    let blocking = mesh.blocking();
    for (id, block) in blocking.block_ids().zip(blocking.blocks()) {
        let neighbours = block.neighbours;
        println!(
            "{id}: wall {}, across the arc {}, round the wall {} and {}",
            domain.name(block.wall),
            neighbours.xi0.0,
            neighbours.eta0,
            neighbours.eta1
        );
    }
    if let Some(angles) = AngleSummary::of_quads(mesh.cells()) {
        println!(
            "{} cells, angles {:.1} to {:.1} degrees",
            mesh.cell_count(),
            angles.min,
            angles.max
        );
    }
    Ok(())
}
