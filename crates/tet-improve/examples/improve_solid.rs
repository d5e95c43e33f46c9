//! The solids of the sink paper refined with few points, and their tetrahedra improved: dihedral angles before and after.
//!
//! `cargo run --release -p tet-improve --example improve_solid [SET [GOAL [VERTICES_BELOW]]]`; parts of names will do.
#![allow(clippy::print_stdout)]

use delaunay_core::measure::tetrahedron::dihedral_angles;
use delaunay_core::progress::silent;
use delaunay_core::{BuildOptions, Complex3, Subcomplex3, Surface, VertexId};
use fixtures::surfaces::{self, Triangles};
use sink_refine::refine3;
use std::error::Error;
use std::time::Instant;
use tet_improve::{Params, improve};

fn main() -> Result<(), Box<dyn Error>> {
    let mut args = std::env::args().skip(1);
    let wanted = args.next().unwrap_or_default();
    let mut params = Params::default();
    for angle in [&mut params.goal, &mut params.vertices_below] {
        if let Some(given) = args.next() {
            *angle = given.parse()?;
        }
    }
    type Set = (&'static str, fn() -> Triangles);
    let sets: [Set; 4] = [
        ("cuboctahedron", surfaces::cuboctahedron),
        ("paraboloid", surfaces::paraboloid),
        ("star", surfaces::star),
        ("head", surfaces::head),
    ];
    for (name, set) in sets {
        if name.contains(&wanted) {
            println!("{name}");
            refine_and_improve(set(), &params)?;
        }
    }
    Ok(())
}

fn refine_and_improve(set: Triangles, params: &Params) -> Result<(), Box<dyn Error>> {
    let triangles = set.triangles.iter().map(|t| t.map(VertexId::new));
    let surface = Surface::new(set.points, triangles.collect())?;
    let solid = surface.solid(BuildOptions::default(), &mut silent)?;
    let solid = Subcomplex3::of(solid.delaunay(), |t| solid.is_inside(t));
    let refined = refine3(solid, &sink_refine::Params::default(), &mut silent)?.solid;
    let refined = Complex3::from(refined);
    print(&refined);
    let count = refined.tets().count();
    let start = Instant::now();
    let outcome = improve(refined, params, &mut silent)?;
    let seconds = start.elapsed().as_secs_f64();
    print(&outcome.solid);
    println!("  {:?} {:?}", outcome.stop, outcome.counters);
    let rate = count as f64 / seconds;
    println!("  {seconds:.3} s, {rate:.0} tetrahedra/s");
    Ok(())
}

/// One line: tetrahedra, extreme dihedral angles, and how many tetrahedra have one below 5°, 10°, 20°, 30°.
fn print(solid: &Complex3) {
    let smallest = |t| {
        dihedral_angles(solid.tetrahedron(t))
            .into_iter()
            .fold(180.0, f64::min)
    };
    let smallest: Vec<f64> = solid.tets().map(smallest).collect();
    let count = smallest.len();
    let shares = [5.0, 10.0, 20.0, 30.0].map(|bound| {
        let below = smallest.iter().filter(|&&angle| angle < bound).count();
        format!("{below:6} ({:.2}%)", 100.0 * below as f64 / count as f64)
    });
    let extremes = tet_improve::Dihedrals::of(solid).map_or([0.0; 2], |d| [d.min, d.max]);
    println!(
        "  {count:7} tetrahedra, {:5.2} to {:6.2} degrees; below 5, 10, 20, 30: {}",
        extremes[0],
        extremes[1],
        shares.join(" ")
    );
}
