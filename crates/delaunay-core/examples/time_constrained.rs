//! Times a constrained triangulation of points and segments beside nothing else, and writes its input for other programs.
//!
//! ```text
//! cargo run --release -p delaunay-core --example time_constrained -- POINTS RUNS [OUT.txt]
//! ```
//!
//! The points are uniform in a square; a tenth of them are joined by edges of their own triangulation, as many as there
//! are points in that tenth. The file has the two counts, then a line for each point, then one for each segment.

#![allow(clippy::print_stdout, reason = "a program for a terminal")]

use delaunay_core::progress::silent;
use delaunay_core::{BuildOptions, Constrained2, Crossings, Delaunay2, VertexId};
use glam::DVec2;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use std::error::Error;
use std::io::Write;
use std::time::Instant;

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let number = |i: usize, default| arguments.get(i).map_or(Ok(default), |word| word.parse());
    let (count, runs): (usize, usize) = (number(0, 1_000_000)?, number(1, 5)?);
    let mut random = ChaCha8Rng::seed_from_u64(1);
    let points = (0..count).map(|_| DVec2::new(random.random(), random.random()));
    let points: Vec<DVec2> = points.collect();
    let segments = segments(&points)?;
    if let Some(path) = arguments.get(2) {
        write(path, &points, &segments)?;
    }
    for _ in 0..runs {
        let start = Instant::now();
        let options = BuildOptions::default();
        let built =
            Constrained2::build(&points, &segments, Crossings::Refuse, options, &mut silent)?;
        let seconds = start.elapsed().as_secs_f64();
        let triangles = built.faces().count();
        println!(
            "{count} points, {} segments, {triangles} triangles: {seconds:.3} s",
            segments.len()
        );
    }
    Ok(())
}

/// Edges of the triangulation of the first tenth of the points, from all over the plane.
fn segments(points: &[DVec2]) -> Result<Vec<[VertexId; 2]>, Box<dyn Error>> {
    let some = points.len() / 10;
    let coarse = Delaunay2::build(&points[..some])?;
    let mesh = coarse.mesh();
    let edges = mesh.half_edges().filter(|&h| h < mesh.twin(h));
    let ends = edges.map(|h| [mesh.origin(h), mesh.target(h)]);
    let real = ends.filter(|ends| !ends.iter().any(|v| v.is_ghost()));
    Ok(real.step_by(3).take(some).collect())
}

fn write(path: &str, points: &[DVec2], segments: &[[VertexId; 2]]) -> std::io::Result<()> {
    let mut file = std::io::BufWriter::new(std::fs::File::create(path)?);
    writeln!(file, "{} {}", points.len(), segments.len())?;
    for p in points {
        writeln!(file, "{} {}", p.x, p.y)?;
    }
    for [a, b] in segments {
        writeln!(file, "{} {}", a.index(), b.index())?;
    }
    file.flush()
}
