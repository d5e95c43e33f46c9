//! The solids of the paper refined by every method: tetrahedra, ratios and work, beside the paper's counts.
//!
//! `cargo run --release -p sink-refine --example refine_solid [SET [METHOD]]`; parts of names will do.
#![allow(clippy::print_stdout)]

use delaunay_core::measure::Summary;
use delaunay_core::measure::tetrahedron::radius_edge_ratio;
use delaunay_core::progress::silent;
use delaunay_core::{BuildOptions, Subcomplex3, Surface, VertexId};
use fixtures::surfaces::{self, Triangles};
use sink_refine::{Boundary, Candidate, Coarsening, Method, Params, Schedule, refine3};
use std::error::Error;
use std::time::Instant;

fn main() -> Result<(), Box<dyn Error>> {
    let mut wanted = std::env::args().skip(1);
    let [set_wanted, method_wanted] = [(); 2].map(|()| wanted.next().unwrap_or_default());
    type Set = (&'static str, fn() -> Triangles);
    let sets: [Set; 4] = [
        ("cuboctahedron", surfaces::cuboctahedron),
        ("paraboloid", surfaces::paraboloid),
        ("star", surfaces::star),
        ("head", surfaces::head),
    ];
    for (name, set) in sets {
        if name.contains(&set_wanted) {
            refine_all_ways(name, set(), &method_wanted)?;
        }
    }
    Ok(())
}

fn refine_all_ways(name: &str, set: Triangles, wanted: &str) -> Result<(), Box<dyn Error>> {
    let triangles = set.triangles.iter().map(|t| t.map(VertexId::new));
    let surface = Surface::new(set.points, triangles.collect())?;
    let solid = surface.solid(BuildOptions::default(), &mut silent)?;
    let solid = Subcomplex3::of(solid.delaunay(), |t| solid.is_inside(t));
    println!("{name}: {} tetrahedra", solid.tets().count());
    for (what, params) in all_params().filter(|(what, _)| what.contains(wanted)) {
        let start = Instant::now();
        let outcome = refine3(solid.clone(), &params, &mut silent)?;
        let seconds = start.elapsed().as_secs_f64();
        let solid = &outcome.solid;
        let ratios = solid
            .tets()
            .map(|t| radius_edge_ratio(solid.tetrahedron(t)));
        let Some(ratios) = Summary::of(ratios) else {
            continue;
        };
        println!(
            "{what:30} {:7} tets {:5} low  r/l {:.2} {:.3} {:.3}  {:6} tested {:5} inserted ({} on the boundary)  {seconds:.3} s",
            ratios.count,
            outcome.low.len(),
            ratios.min,
            ratios.mean,
            ratios.max,
            outcome.counters.tested,
            outcome.counters.inserted,
            outcome.counters.split,
        );
    }
    Ok(())
}

/// Every method with the boundary kept, then some with the boundary split.
fn all_params() -> impl Iterator<Item = (String, Params)> {
    let with = |what: &str, method, boundary| {
        let params = Params {
            method,
            boundary,
            ..Params::default()
        };
        (what.to_owned(), params)
    };
    let mut all = Vec::new();
    for candidate in [Candidate::Sink, Candidate::Circumcenter] {
        for schedule in [Schedule::Incremental, Schedule::Block, Schedule::Parallel] {
            let method = Method::Paper {
                candidate,
                schedule,
            };
            all.push(with(
                &format!("{candidate:?}, {schedule:?}"),
                method,
                Boundary::Keep,
            ));
            if candidate == Candidate::Sink {
                let what = format!("{candidate:?}, {schedule:?}, split");
                all.push(with(&what, method, SPLIT));
            }
        }
    }
    for coarsening in [Coarsening::None, Coarsening::Removal, Coarsening::Merging] {
        let method = Method::Economical(coarsening);
        let what = format!("Economical, {coarsening:?}");
        all.push(with(&what, method, Boundary::Keep));
        all.push(with(&format!("{what}, split"), method, SPLIT));
    }
    all.into_iter()
}

/// Of a surface that is smooth where it turns by up to 30 degrees.
const SPLIT: Boundary = Boundary::Split { crease: 30.0 };
