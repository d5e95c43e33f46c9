//! The solids of the paper (§5.3 to §5.6), refined by every method: what each run leaves, in numbers that are the same on
//! every machine, beside what the paper printed.

#![allow(clippy::unwrap_used)]

mod data_sets;

use data_sets::solid;
use delaunay_core::measure::Summary;
use delaunay_core::measure::tetrahedron::{radius_edge_ratio, signed_volume};
use delaunay_core::progress::silent;
use delaunay_core::{Subcomplex3, TetId, VertexId};
use fixtures::surfaces;
use sink_refine::{Candidate, Coarsening, Method, Outcome3, Params, Schedule, refine3};
use std::collections::BTreeSet;

fn paper(candidate: Candidate, schedule: Schedule) -> Method {
    Method::Paper {
        candidate,
        schedule,
    }
}

fn refined(solid: &Subcomplex3, method: Method) -> Outcome3 {
    let params = Params {
        method,
        ..Params::default()
    };
    let outcome = refine3(solid.clone(), &params, &mut silent).unwrap();
    assert_sound(solid, &outcome);
    outcome
}

/// Facets of the boundary by their corners.
fn boundary(solid: &Subcomplex3) -> BTreeSet<[VertexId; 3]> {
    let facets = solid.boundary().map(|f| solid.mesh().facet_vertices(f));
    facets
        .map(|mut corners| {
            corners.sort_unstable();
            corners
        })
        .collect()
}

fn volume(solid: &Subcomplex3) -> f64 {
    let volumes = solid.tets().map(|t| signed_volume(solid.tetrahedron(t)));
    volumes.sum()
}

/// The boundary and the volume are those given, the mesh is Delaunay, and what is said to be left is all there is.
fn assert_sound(given: &Subcomplex3, outcome: &Outcome3) {
    let solid = &outcome.solid;
    assert_eq!(solid.mesh().check(), Ok(()));
    assert_eq!(boundary(solid), boundary(given));
    assert!((volume(solid) / volume(given) - 1.0).abs() < 1e-12);
    for f in solid.tets().flat_map(TetId::facets) {
        let apex = solid.mesh().apex(solid.mesh().twin(f));
        assert!(apex.is_ghost() || !solid.in_conflict(solid.point(apex), f.tet()));
    }
    let low = solid
        .tets()
        .filter(|&t| radius_edge_ratio(solid.tetrahedron(t)) > 2.0 + 1e-12);
    let listed: BTreeSet<TetId> = outcome.low.iter().map(|low| low.tet).collect();
    assert!(low.collect::<BTreeSet<TetId>>().is_subset(&listed));
    assert!(outcome.solid.vertex_count() as f64 <= outcome.separation.vertex_bound);
}

/// One line: tetrahedra, those of low quality, least, mean and largest ratio, points tested and inserted.
fn line(outcome: &Outcome3) -> String {
    let solid = &outcome.solid;
    let ratios = solid
        .tets()
        .map(|t| radius_edge_ratio(solid.tetrahedron(t)));
    let ratios = Summary::of(ratios).unwrap();
    let [low, tested, inserted] = [
        outcome.low.len(),
        outcome.counters.tested,
        outcome.counters.inserted,
    ];
    format!(
        "{} tets, {low} low, r/l {:.2} {:.2} {:.2}, {tested} tested, {inserted} inserted",
        ratios.count, ratios.min, ratios.mean, ratios.max
    )
}

/// All methods, one line each.
fn table(solid: &Subcomplex3) -> String {
    let mut lines = Vec::new();
    for candidate in [Candidate::Sink, Candidate::Circumcenter] {
        for schedule in [Schedule::Incremental, Schedule::Block, Schedule::Parallel] {
            let outcome = refined(solid, paper(candidate, schedule));
            assert!(outcome.separation.reached >= outcome.separation.given);
            lines.push(format!("{candidate:?} {schedule:?}: {}", line(&outcome)));
        }
    }
    for coarsening in [Coarsening::None, Coarsening::Removal, Coarsening::Merging] {
        let outcome = refined(solid, Method::Economical(coarsening));
        lines.push(format!("Economical {coarsening:?}: {}", line(&outcome)));
    }
    lines.join("\n")
}

/// The paper, parallel schedule: 15,948 tetrahedra by sinks, 15,066 by circumcenters; r/l at most 2.00 (figure 8).
#[test]
fn the_cuboctahedron_is_refined_by_all_methods() {
    insta::assert_snapshot!(table(&solid(surfaces::cuboctahedron())));
}

/// The paper, parallel schedule: 14,793 tetrahedra by sinks, 13,639 by circumcenters; r/l at most 2.00 (figure 9).
#[test]
fn the_paraboloid_is_refined_by_all_methods() {
    insta::assert_snapshot!(table(&solid(surfaces::paraboloid())));
}

/// The paper, parallel schedule: 118,633 tetrahedra by sinks with 481 of low quality, 119,442 by circumcenters with 1,867
/// (figure 10).
#[test]
fn the_star_is_refined_in_parallel_and_with_few_points() {
    let star = solid(surfaces::star());
    let sinks = refined(&star, paper(Candidate::Sink, Schedule::Parallel));
    let few = refined(&star, Method::Economical(Coarsening::Removal));
    insta::assert_snapshot!([line(&sinks), line(&few)].join("\n"));
}

/// The paper, parallel schedule: 190,269 tetrahedra by sinks with 245 of low quality, 183,027 by circumcenters with 104
/// (figure 11).
#[test]
fn the_head_is_refined_in_parallel_and_with_few_points() {
    let head = solid(surfaces::head());
    let sinks = refined(&head, paper(Candidate::Sink, Schedule::Parallel));
    let few = refined(&head, Method::Economical(Coarsening::Removal));
    insta::assert_snapshot!([line(&sinks), line(&few)].join("\n"));
}

#[test]
fn any_number_of_threads_gives_the_same_mesh() {
    let solid = solid(surfaces::cuboctahedron());
    let on = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
        let method = paper(Candidate::Sink, Schedule::Parallel);
        pool.unwrap().install(|| refined(&solid, method).solid)
    };
    let one = on(1);
    for threads in [2, 3, 8] {
        let many = on(threads);
        assert!(
            many.mesh() == one.mesh() && many.points() == one.points(),
            "{threads}"
        );
    }
}

#[test]
fn the_budget_of_vertices_is_kept_and_cancelling_leaves_a_valid_mesh() {
    use sink_refine::Stop;
    let solid = solid(surfaces::paraboloid());
    let params = Params {
        max_new_vertices: 100,
        ..Params::default()
    };
    let outcome = refine3(solid.clone(), &params, &mut silent).unwrap();
    assert_sound(&solid, &outcome);
    assert_eq!(outcome.stop, Stop::OutOfVertices);
    assert_eq!(outcome.solid.vertex_count(), solid.vertex_count() + 100);

    let params = Params {
        method: paper(Candidate::Sink, Schedule::Incremental),
        ..Params::default()
    };
    let star = data_sets::solid(surfaces::star());
    let mut reports = 0;
    let outcome = refine3(star.clone(), &params, &mut |_| {
        reports += 1;
        match reports {
            1 => std::ops::ControlFlow::Continue(()),
            _ => std::ops::ControlFlow::Break(()),
        }
    });
    let outcome = outcome.unwrap();
    assert_sound(&star, &outcome);
    assert!(matches!(outcome.stop, Stop::Cancelled(_)));
}

#[test]
fn ratios_below_one_are_refused() {
    let solid = solid(surfaces::paraboloid());
    for ratio in [0.99, f64::NAN, f64::INFINITY] {
        let params = Params {
            ratio,
            ..Params::default()
        };
        assert!(refine3(solid.clone(), &params, &mut silent).is_err());
    }
    let params = Params {
        ratio: 0.5,
        ..Params::default()
    };
    let error = refine3(solid, &params, &mut silent).unwrap_err();
    insta::assert_snapshot!(error, @"the ratio 0.5 is not a number from 1 on, below which refinement might not end");
}
