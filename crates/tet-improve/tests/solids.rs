//! Solids of the sink paper, refined with few points and improved: what comes out, in numbers that are the same on every
//! machine.

#![allow(clippy::unwrap_used)]

use delaunay_core::geo_predicates::{Sign, orient3d};
use delaunay_core::measure::tetrahedron::{dihedral_angles, signed_volume};
use delaunay_core::progress::silent;
use delaunay_core::{BuildOptions, Complex3, Subcomplex3, Surface, VertexId};
use fixtures::surfaces::{self, Triangles};
use sink_refine::refine3;
use std::collections::BTreeSet;
use tet_improve::{Dihedrals, Outcome, Params, improve};

fn refined(set: Triangles) -> Complex3 {
    let triangles = set.triangles.iter().map(|t| t.map(VertexId::new));
    let surface = Surface::new(set.points, triangles.collect()).unwrap();
    let solid = surface.solid(BuildOptions::default(), &mut silent).unwrap();
    let solid = Subcomplex3::of(solid.delaunay(), |t| solid.is_inside(t));
    let outcome = refine3(solid, &sink_refine::Params::default(), &mut silent);
    Complex3::from(outcome.unwrap().solid)
}

fn boundary(solid: &Complex3) -> BTreeSet<[VertexId; 3]> {
    let facets = solid.boundary().map(|f| {
        let mut corners = solid.mesh().facet_vertices(f);
        corners.sort_unstable();
        corners
    });
    facets.collect()
}

fn volume(solid: &Complex3) -> f64 {
    let volumes = solid.tets().map(|t| signed_volume(solid.tetrahedron(t)));
    volumes.sum()
}

/// Improved; the mesh is one, and its boundary that given.
fn improved(given: &Complex3, angle: f64) -> Outcome {
    let params = Params {
        goal: angle,
        vertices_below: angle,
        ..Params::default()
    };
    let outcome = improve(given.clone(), &params, &mut silent).unwrap();
    let solid = &outcome.solid;
    assert_eq!(solid.mesh().check(), Ok(()));
    for t in solid.tets() {
        let [a, b, c, d] = solid.tetrahedron(t);
        assert_eq!(orient3d(a, b, c, d), Sign::Positive);
    }
    assert_eq!(boundary(solid), boundary(given));
    assert!((volume(solid) / volume(given) - 1.0).abs() < 1e-13);
    outcome
}

/// One line: tetrahedra, extreme dihedral angles, tetrahedra with an angle below 5°, 10°, 20°, 30°.
fn line(solid: &Complex3) -> String {
    let smallest = |t| {
        dihedral_angles(solid.tetrahedron(t))
            .into_iter()
            .fold(180.0, f64::min)
    };
    let smallest: Vec<f64> = solid.tets().map(smallest).collect();
    let below = |bound: f64| smallest.iter().filter(|&&angle| angle < bound).count();
    let Dihedrals { min, max } = Dihedrals::of(solid).unwrap();
    format!(
        "{} tets, {min:.1} to {max:.1} degrees, below 5, 10, 20, 30: {:?}",
        smallest.len(),
        [5.0, 10.0, 20.0, 30.0].map(below)
    )
}

fn table(set: Triangles, angles: &[f64]) -> String {
    let given = refined(set);
    let mut lines = vec![line(&given)];
    for &angle in angles {
        let outcome = improved(&given, angle);
        let counters = outcome.counters;
        lines.push(format!("{angle}: {}", line(&outcome.solid)));
        lines.push(format!(
            "  {:?}, {} left; {} edges, {} facets removed, {} moves, {} contractions, {} insertions",
            outcome.stop,
            outcome.low.len(),
            counters.edges_removed,
            counters.facets_removed,
            counters.moves,
            counters.contractions,
            counters.insertions
        ));
    }
    lines.join("\n")
}

#[test]
fn the_cuboctahedron_is_left_without_slivers() {
    insta::assert_snapshot!(table(surfaces::cuboctahedron(), &[20.0, 30.0]));
}

#[test]
fn the_paraboloid_is_left_without_slivers() {
    insta::assert_snapshot!(table(surfaces::paraboloid(), &[20.0, 30.0]));
}

/// Its fins are one or two tetrahedra thick.
#[test]
fn the_star_is_left_without_slivers() {
    insta::assert_snapshot!(table(surfaces::star(), &[20.0]));
}
