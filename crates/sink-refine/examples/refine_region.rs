//! The planar region of the paper refined by every method: triangles, ratios and work, beside the paper's counts.
//!
//! `cargo run --release -p sink-refine --example refine_region`
#![allow(clippy::print_stdout)]

use delaunay_core::measure::Summary;
use delaunay_core::measure::triangle::radius_edge_ratio;
use delaunay_core::progress::silent;
use delaunay_core::{BuildOptions, Outline, Subcomplex2, VertexId};
use glam::DVec2;
use sink_refine::{Boundary, Candidate, Coarsening, Method, Params, Schedule, refine2};
use std::error::Error;
use std::time::Instant;

fn main() -> Result<(), Box<dyn Error>> {
    let usa = fixtures::outlines::usa();
    let points = usa.points.iter().copied().map(DVec2::from).collect();
    let segments = usa.segments.iter();
    let segments = segments.map(|ends| ends.map(|v| VertexId::new(v as usize)));
    let outline = Outline::new(points, segments.collect())?;
    let region = outline.region(BuildOptions::default(), &mut silent)?;
    let region = region.subcomplex();
    print("given", &region, "");
    for (what, params) in all_params() {
        let start = Instant::now();
        let outcome = refine2(region.clone(), &params, &mut silent)?;
        let work = format!(
            "{:4} low  {:5} tested {:4} inserted ({} on the boundary)  {:.1} ms",
            outcome.low.len(),
            outcome.counters.tested,
            outcome.counters.inserted,
            outcome.counters.split,
            1e3 * start.elapsed().as_secs_f64(),
        );
        print(&what, &outcome.region, &work);
    }
    println!("the paper: 229; sinks 879 in blocks, 841 one by one; circumcenters 941 and 997");
    Ok(())
}

fn print(what: &str, region: &Subcomplex2, work: &str) {
    let ratios = region
        .faces()
        .map(|f| radius_edge_ratio(region.triangle(f)));
    if let Some(Summary {
        count,
        min,
        mean,
        max,
        ..
    }) = Summary::of(ratios)
    {
        println!("{what:30} {count:4} triangles  r/l {min:.2} {mean:.3} {max:.3} {work}");
    }
}

/// Every method, with the boundary kept and with the boundary split.
fn all_params() -> impl Iterator<Item = (String, Params)> {
    methods().into_iter().flat_map(|(what, method)| {
        let kept = Params {
            ratio: 1.0,
            method,
            ..Params::default()
        };
        let split = Params {
            boundary: Boundary::Split { crease: 0.0 },
            ..kept
        };
        [(what.clone(), kept), (format!("{what}, split"), split)]
    })
}

fn methods() -> Vec<(String, Method)> {
    let mut methods = Vec::new();
    for candidate in [Candidate::Sink, Candidate::Circumcenter] {
        for schedule in [Schedule::Incremental, Schedule::Block, Schedule::Parallel] {
            let method = Method::Paper {
                candidate,
                schedule,
            };
            methods.push((format!("{candidate:?}, {schedule:?}"), method));
        }
    }
    for coarsening in [Coarsening::None, Coarsening::Removal, Coarsening::Merging] {
        let method = Method::Economical(coarsening);
        methods.push((format!("Economical, {coarsening:?}"), method));
    }
    methods
}
