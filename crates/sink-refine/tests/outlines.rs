//! Refinement within outlines whose segments are not Delaunay: constrained edges are a boundary like any other.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

use delaunay_core::measure::triangle::{area, radius_edge_ratio};
use delaunay_core::progress::silent;
use delaunay_core::{
    BuildOptions, Constrained2, Crossings, HalfEdgeId, Outline, Subcomplex2, VertexId,
};
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

    #[test]
    fn regions_side_by_side_are_refined_to_one_mesh(
        ring in prop::collection::vec(0.1..0.9f64, 5..20),
        loose in 0..5usize,
        method in methods(),
        divided: bool,
    ) {
        // A square with a star as second region, and segments that end inside it.
        let mut points: Vec<DVec2> = [[-2.0, -2.0], [2.0, -2.0], [2.0, 2.0], [-2.0, 2.0]].map(DVec2::from).to_vec();
        points.extend(star(&ring));
        let corner = |i: usize| 4 + i % ring.len();
        let mut segments: Vec<[usize; 2]> = (0..4).map(|i| [i, (i + 1) % 4]).collect();
        segments.extend((0..ring.len()).map(|i| [corner(i), corner(i + 1)]));
        for i in 0..loose {
            segments.push([corner(i), points.len()]);
            points.push(points[corner(i)] * 1.5);
        }
        let ids: Vec<[VertexId; 2]> = segments.iter().map(|ends| ends.map(VertexId::new)).collect();
        let options = BuildOptions::default();
        let built = Constrained2::build(&points, &ids, Crossings::Refuse, options, &mut silent);
        prop_assume!(built.is_ok());
        let regions = built.unwrap().subcomplex(|_| true);
        let boundary = if divided { Boundary::Split { crease: 0.0 } } else { Boundary::Keep };
        let outcome = refined(&regions, method, boundary, 1.25);
        let refined = &outcome.region;
        prop_assert_eq!(refined.check(), Ok(()));
        let inner = |h: &HalfEdgeId| refined.segment(*h).iter().all(|p| p.abs().max_element() < 2.0);
        let inner: Vec<HalfEdgeId> = refined.boundary().filter(inner).collect();
        prop_assert!(inner.iter().all(|&h| refined.partner(h).is_some()));
        if !divided {
            prop_assert_eq!(inner.len(), 2 * (segments.len() - 4));
        }
        let areas = refined.faces().map(|f| area(refined.triangle(f)));
        prop_assert!((areas.sum::<f64>() - 16.0).abs() < 1e-9);
    }
}
