//! Refinement within outlines whose segments are not Delaunay: constrained edges are a boundary like any other.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

use delaunay_core::measure::triangle::radius_edge_ratio;
use delaunay_core::progress::silent;
use delaunay_core::{BuildOptions, HalfEdgeId, Outline, Subcomplex2, VertexId};
use glam::DVec2;
use proptest::prelude::*;
use sink_refine::{
    Boundary, Candidate, Coarsening, Method, Outcome2, Params, Schedule, Stop, refine2,
};
use std::collections::BTreeSet;
use std::f64::consts::TAU;

/// A loop round the origin with one corner for each radius, counterclockwise.
fn star(radii: &[f64]) -> impl Iterator<Item = DVec2> {
    let step = TAU / radii.len() as f64;
    let corner = move |(i, &r): (usize, &f64)| r * DVec2::from_angle(i as f64 * step);
    radii.iter().enumerate().map(corner)
}

/// A star with a star as hole.
fn region(outer: &[f64], inner: &[f64]) -> Subcomplex2 {
    let points: Vec<DVec2> = star(outer).chain(star(inner)).collect();
    let closed = |first: usize, count: usize| {
        let next = move |i: usize| first + (i + 1 - first) % count;
        (first..first + count).map(move |i| [i, next(i)].map(VertexId::new))
    };
    let segments = closed(0, outer.len()).chain(closed(outer.len(), inner.len()));
    let outline = Outline::new(points, segments.collect()).unwrap();
    let region = outline.region(BuildOptions::default(), &mut silent);
    region.unwrap().subcomplex()
}

fn boundary_ends(region: &Subcomplex2) -> BTreeSet<[VertexId; 2]> {
    let ends = |h: HalfEdgeId| [region.mesh().origin(h), region.mesh().target(h)];
    region.boundary().map(ends).collect()
}

fn refined(region: &Subcomplex2, method: Method, boundary: Boundary, ratio: f64) -> Outcome2 {
    let params = Params {
        ratio,
        method,
        boundary,
        max_new_vertices: 20_000,
        ..Params::default()
    };
    refine2(region.clone(), &params, &mut silent).unwrap()
}

fn methods() -> impl Strategy<Value = Method> {
    let paper = |candidate| {
        move |schedule| Method::Paper {
            candidate,
            schedule,
        }
    };
    let schedules = || {
        prop_oneof![
            Just(Schedule::Incremental),
            Just(Schedule::Block),
            Just(Schedule::Parallel)
        ]
    };
    prop_oneof![
        schedules().prop_map(paper(Candidate::Sink)),
        schedules().prop_map(paper(Candidate::Circumcenter)),
        Just(Method::Economical(Coarsening::Removal)),
        Just(Method::Economical(Coarsening::Merging)),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(96))]

    #[test]
    fn a_jagged_outline_is_refined_and_kept(
        outer in prop::collection::vec(1.0..4.0f64, 8..40),
        inner in prop::collection::vec(0.05..0.7f64, 8..20),
        method in methods(),
    ) {
        let region = region(&outer, &inner);
        let outcome = refined(&region, method, Boundary::Keep, 1.0);
        prop_assert_eq!(outcome.region.check(), Ok(()));
        prop_assert_eq!(boundary_ends(&outcome.region), boundary_ends(&region));
    }

    #[test]
    fn a_jagged_outline_is_divided_until_all_is_good(
        outer in prop::collection::vec(1.0..4.0f64, 8..40),
        inner in prop::collection::vec(0.05..0.7f64, 8..20),
        method in methods(),
    ) {
        let region = region(&outer, &inner);
        let outcome = refined(&region, method, Boundary::Split { crease: 0.0 }, 1.25);
        prop_assert_eq!(outcome.region.check(), Ok(()));
        prop_assert_eq!(outcome.stop == Stop::AllGood, outcome.low.is_empty());
        let poor = outcome.region.faces().filter(|&f| radius_edge_ratio(outcome.region.triangle(f)) > 1.25 + 1e-9);
        prop_assert_eq!(poor.count(), outcome.low.len());
    }
}
