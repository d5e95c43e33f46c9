//! Meshes squares of growing numbers of nodes and prints what each step takes, by node.
//!
//! `cargo run --release -p bubble-mesh --example time_graded -- [EDGES_PER_SIDE ...]`
#![allow(clippy::print_stdout, reason = "a program for a terminal")]

use std::collections::BTreeMap;
use std::error::Error;
use std::ops::ControlFlow;
use std::time::Instant;

use bubble_mesh::Domain;
use bubble_mesh::graded::{GradedParams, mesh};
use delaunay_core::progress::{Progress, silent};
use delaunay_core::{BuildOptions, Outline, VertexId};
use glam::DVec2;

fn main() -> Result<(), Box<dyn Error>> {
    let asked: Vec<usize> = std::env::args()
        .skip(1)
        .map(|word| word.parse())
        .collect::<Result<_, _>>()?;
    let sides = if asked.is_empty() {
        vec![80, 250, 800]
    } else {
        asked
    };
    // One start after the other, so that times are those of one core.
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build()?;
    for side in sides {
        pool.install(|| time(side).map_err(|error| error.to_string()))?;
    }
    Ok(())
}

fn time(side: usize) -> Result<(), Box<dyn Error>> {
    let corners = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].map(DVec2::from);
    let node = |i: usize| {
        let [a, b] = [i / side, i / side + 1].map(|corner| corners[corner % 4]);
        a.lerp(b, (i % side) as f64 / side as f64)
    };
    let count = 4 * side;
    let edges = (0..count).map(|i| [i, (i + 1) % count].map(VertexId::new));
    let outline = Outline::new((0..count).map(node).collect(), edges.collect())?;
    let domain = Domain::new(&outline, BuildOptions::default(), &mut silent)?;
    let params = GradedParams {
        nodes: usize::MAX,
        ..GradedParams::default()
    };
    let mut seconds: BTreeMap<&'static str, f64> = BTreeMap::new();
    let (mut stage, mut since) = ("", Instant::now());
    let mut report = |progress: Progress| {
        if progress.stage != stage {
            *seconds.entry(stage).or_default() += since.elapsed().as_secs_f64();
            (stage, since) = (progress.stage, Instant::now());
        }
        ControlFlow::Continue(())
    };
    let made = mesh(&domain, &params, &mut report)?.complex;
    *seconds.entry(stage).or_default() += since.elapsed().as_secs_f64();
    let nodes = made.points().len() as f64;
    // Two starts, each with all its steps.
    let of = |stage: &str| seconds.get(stage).copied().unwrap_or(0.0);
    let steps = 2.0 * nodes * params.relaxation as f64;
    println!(
        "{nodes} nodes: placed {:.2e}/s, relaxed {:.2e} node-iterations/s; seconds {:.2?}",
        2.0 * nodes / of("place nodes"),
        steps / of("relax"),
        seconds
    );
    Ok(())
}
