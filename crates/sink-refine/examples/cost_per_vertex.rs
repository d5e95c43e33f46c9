//! What an inserted vertex costs as meshes grow: boxes, whose surfaces have more and more vertices, from 10^4 to 10^6 tetrahedra.
//!
//! `cargo run --release -p sink-refine --example cost_per_vertex [SHAPE [METHOD]]`; parts of names will do.
//!
//! A plate has the same thickness in every size: it is the same task, more often. In a cube the first sinks see all of the
//! surface, which has more vertices the larger it is.
#![allow(clippy::print_stdout)]

use delaunay_core::progress::silent;
use delaunay_core::{Delaunay3, Subcomplex3};
use fixtures::boxes;
use sink_refine::{Candidate, Coarsening, Method, Params, Schedule, refine3};
use std::error::Error;
use std::time::Instant;

/// Edges of the surface along the sides of the boxes.
const SHAPES: [(&str, [[u32; 3]; 3]); 2] = [
    ("plate", [[30, 30, 6], [100, 100, 6], [322, 322, 6]]),
    ("cube", [[20, 20, 20], [58, 58, 58], [177, 177, 177]]),
];

fn main() -> Result<(), Box<dyn Error>> {
    let mut wanted = std::env::args().skip(1);
    let [shape_wanted, method_wanted] = [(); 2].map(|()| wanted.next().unwrap_or_default());
    println!(
        "shape  method                      tets out  inserted  tested per vertex  seconds  µs per vertex"
    );
    for (shape, sizes) in SHAPES
        .iter()
        .filter(|(shape, _)| shape.contains(&shape_wanted))
    {
        for (name, method) in methods().filter(|(name, _)| name.contains(&method_wanted)) {
            for &cells in sizes {
                let hull = Delaunay3::build(&boxes::jittered(cells, 1))?;
                let solid = Subcomplex3::of(&hull, |_| true);
                let params = Params {
                    method,
                    ..Params::default()
                };
                let start = Instant::now();
                let outcome = refine3(solid, &params, &mut silent)?;
                let seconds = start.elapsed().as_secs_f64();
                let inserted = outcome.counters.inserted;
                println!(
                    "{shape:5}  {name:26} {:9} {inserted:9} {:18.2} {seconds:8.3} {:14.1}",
                    outcome.solid.tets().count(),
                    outcome.counters.tested as f64 / inserted as f64,
                    1e6 * seconds / inserted as f64,
                );
            }
        }
    }
    Ok(())
}

fn methods() -> impl Iterator<Item = (String, Method)> {
    let schedules = [Schedule::Incremental, Schedule::Block, Schedule::Parallel];
    let paper = schedules.map(|schedule| Method::Paper {
        candidate: Candidate::Sink,
        schedule,
    });
    let economical = [Coarsening::None, Coarsening::Removal].map(Method::Economical);
    let name = |method| match method {
        Method::Paper {
            candidate,
            schedule,
        } => format!("{candidate:?}, {schedule:?}"),
        Method::Economical(coarsening) => format!("Economical, {coarsening:?}"),
    };
    paper
        .into_iter()
        .chain(economical)
        .map(move |method| (name(method), method))
}
