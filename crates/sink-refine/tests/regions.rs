//! Regions of the plane refined: what is promised of every method, and the planar data set of the paper.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

mod data_sets;

use data_sets::usa;
use delaunay_core::measure::Summary;
use delaunay_core::measure::triangle::radius_edge_ratio;
use delaunay_core::progress::{Progress, silent};
use delaunay_core::{Delaunay2, HalfEdgeId, Subcomplex2, VertexId};
use glam::DVec2;
use proptest::prelude::*;
use sink_refine::tri::stable_faces;
use sink_refine::{
    Candidate, Coarsening, End, Method, Outcome2, Params, Reason2, RefineError, Schedule, Sinks,
    Stop, refine2,
};
use std::collections::BTreeSet;
use std::ops::ControlFlow;

const SCHEDULES: [Schedule; 3] = [Schedule::Incremental, Schedule::Block, Schedule::Parallel];

fn paper(candidate: Candidate, schedule: Schedule) -> Method {
    Method::Paper {
        candidate,
        schedule,
    }
}

fn papers() -> impl Iterator<Item = Method> {
    let candidates = [Candidate::Sink, Candidate::Circumcenter].into_iter();
    candidates.flat_map(|candidate| SCHEDULES.map(|schedule| paper(candidate, schedule)))
}

fn economical() -> [Method; 3] {
    [Coarsening::None, Coarsening::Removal, Coarsening::Merging].map(Method::Economical)
}

fn refine(region: &Subcomplex2, method: Method) -> Outcome2 {
    let params = Params {
        ratio: 1.0,
        method,
        ..Params::default()
    };
    refine2(region.clone(), &params, &mut silent).unwrap()
}

fn boundary(region: &Subcomplex2) -> BTreeSet<[VertexId; 2]> {
    let ends = |h: HalfEdgeId| [region.mesh().origin(h), region.mesh().target(h)];
    region.boundary().map(ends).collect()
}

/// The hull of a few points, or the stable part of it, with an edge of a thousandth of the width at least.
fn clouds() -> impl Strategy<Value = Subcomplex2> {
    let side = prop_oneof![Just(4), Just(40), Just(1000)];
    let points =
        side.prop_flat_map(|side: i32| prop::collection::vec([-side..=side, -side..=side], 4..40));
    (points, any::<bool>()).prop_filter_map("flat", |(points, stable)| {
        let points: Vec<DVec2> = points
            .into_iter()
            .map(|p| DVec2::from(p.map(f64::from)))
            .collect();
        let delaunay = Delaunay2::build(&points).ok()?;
        let stays = stable_faces(&delaunay, |_| true);
        Some(Subcomplex2::of(&delaunay, |f| !stable || stays[f.index()]))
    })
}

/// What holds whatever the method.
fn check_outcome(given: &Subcomplex2, outcome: &Outcome2) -> Result<(), TestCaseError> {
    let region = &outcome.region;
    prop_assert_eq!(region.check(), Ok(()));
    prop_assert_eq!(boundary(region), boundary(given));
    prop_assert_eq!(&region.points()[..given.points().len()], given.points());
    let ratio = |f| radius_edge_ratio(region.triangle(f));
    let low = region.faces().filter(|&f| ratio(f) > 1.0 + 1e-12).count();
    prop_assert!(low <= outcome.low.len());
    prop_assert_eq!(outcome.stop == Stop::AllGood, outcome.low.is_empty());
    prop_assert!(outcome.low.is_sorted_by(|a, b| a.ratio >= b.ratio));
    let last = outcome.rounds.last().unwrap();
    prop_assert_eq!(
        (last.elements, last.low),
        (region.faces().count(), outcome.low.len())
    );
    prop_assert_eq!(last.vertices, region.vertex_count());
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn the_method_of_the_paper_keeps_boundary_separation_and_bound(given in clouds()) {
        for method in papers() {
            let outcome = refine(&given, method);
            check_outcome(&given, &outcome)?;
            let separation = outcome.separation;
            prop_assert!(separation.reached >= separation.given * (1.0 - 1e-9), "{:?}", separation);
            prop_assert!(outcome.region.vertex_count() as f64 <= separation.vertex_bound);
        }
    }

    #[test]
    fn fewer_points_keep_the_boundary_and_leave_no_more(given in clouds()) {
        let [none, removal, merging] = economical().map(|method| refine(&given, method));
        for outcome in [&none, &removal, &merging] {
            check_outcome(&given, outcome)?;
        }
        prop_assert!(removal.region.faces().count() <= none.region.faces().count());
        prop_assert!(removal.low.len() <= none.low.len());
        prop_assert!(merging.region.faces().count() <= removal.region.faces().count());
        prop_assert!(merging.low.len() <= removal.low.len());
    }

    #[test]
    fn no_flow_leaves_the_stable_part_and_it_is_the_largest(given in clouds(), within in any::<u64>()) {
        let Ok(delaunay) = Delaunay2::build(given.points()) else { return Ok(()) };
        let stays = stable_faces(&delaunay, |f| within >> (f.index() % 64) & 1 == 1 || f.index() % 3 > 0);
        let part = Subcomplex2::of(&delaunay, |f| stays[f.index()]);
        prop_assert!(!part.boundary().any(|h| part.flows_through(h)));
        prop_assert!(Sinks::of(&part).ancestors(End::Outside).is_empty());
        // Peeled again, nothing goes.
        prop_assert_eq!(&stable_faces(&delaunay, |f| stays[f.index()]), &stays);
    }
}

/// Triangles, those of low quality among them, and the largest ratio in thousandths.
fn counts(outcome: &Outcome2) -> (usize, usize, u32) {
    let region = &outcome.region;
    let ratios = region
        .faces()
        .map(|f| radius_edge_ratio(region.triangle(f)));
    let Summary { count, max, .. } = Summary::of(ratios).unwrap();
    (count, outcome.low.len(), (1000.0 * max).round() as u32)
}

/// The paper: 841 and 879 triangles, ratios up to 3.06 and 2.58, one by one and in blocks.
#[test]
fn sinks_refine_the_outline_of_the_paper() {
    let given = usa();
    let found = SCHEDULES.map(|schedule| counts(&refine(&given, paper(Candidate::Sink, schedule))));
    assert_eq!(found, [(815, 15, 1878), (797, 13, 2336), (839, 17, 2414)]);
}

/// The paper: 997 and 941 triangles, ratios up to 3.54.
#[test]
fn circumcenters_refine_the_outline_of_the_paper() {
    let given = usa();
    let found =
        SCHEDULES.map(|schedule| counts(&refine(&given, paper(Candidate::Circumcenter, schedule))));
    assert_eq!(found, [(839, 18, 1970), (919, 13, 1970), (919, 16, 1970)]);
}

#[test]
fn fewer_points_refine_the_outline_of_the_paper() {
    let given = usa();
    let found = economical().map(|method| {
        let outcome = refine(&given, method);
        assert_eq!(
            (outcome.region.check(), outcome.region.mesh().check()),
            (Ok(()), Ok(()))
        );
        assert_eq!(boundary(&outcome.region), boundary(&given));
        counts(&outcome)
    });
    assert_eq!(found, [(681, 2, 1867), (665, 2, 1867), (539, 2, 1867)]);
}

#[test]
fn many_triangles_share_few_sinks_at_first() {
    let outcome = refine(&usa(), paper(Candidate::Sink, Schedule::Block));
    let first = outcome.rounds.first().unwrap();
    assert_eq!((first.elements, first.vertices), (229, 231));
    assert!(first.candidates * 3 < first.low, "{first:?}");
}

#[test]
fn the_mesh_does_not_depend_on_the_number_of_threads() {
    let given = usa();
    for candidate in [Candidate::Sink, Candidate::Circumcenter] {
        let on = |threads: usize| {
            let pool = rayon::ThreadPoolBuilder::new()
                .num_threads(threads)
                .build()
                .unwrap();
            let outcome = pool.install(|| refine(&given, paper(candidate, Schedule::Parallel)));
            (
                outcome.region.points().to_vec(),
                outcome.region.mesh().clone(),
                outcome.rounds,
            )
        };
        let one = on(1);
        for threads in [2, 3, 8] {
            assert!(on(threads) == one, "{threads} threads");
        }
    }
}

#[test]
fn an_angle_of_the_boundary_is_a_reason() {
    let needle = [[0.0, 0.0], [10.0, -1.0], [10.0, 1.0]].map(DVec2::from);
    let region = Subcomplex2::of(&Delaunay2::build(&needle).unwrap(), |_| true);
    let outcome = refine(&region, paper(Candidate::Sink, Schedule::Incremental));
    assert_eq!(outcome.stop, Stop::NothingToInsert);
    let reasons: Vec<Reason2> = outcome.low.iter().map(|low| low.reason).collect();
    assert_eq!(reasons, [Reason2::BoundaryAngle(VertexId::new(0))]);
}

#[test]
fn a_budget_and_a_report_stop_the_work() {
    let given = usa();
    for method in papers().chain(economical()) {
        let params = Params {
            ratio: 1.0,
            method,
            max_new_vertices: 5,
            ..Params::default()
        };
        let outcome = refine2(given.clone(), &params, &mut silent).unwrap();
        assert_eq!(outcome.stop, Stop::OutOfVertices);
        assert_eq!(outcome.region.vertex_count(), given.vertex_count() + 5);
        assert_eq!(outcome.region.check(), Ok(()));
    }
    let mut stop = |_: Progress| ControlFlow::Break(());
    let stopped = refine2(given.clone(), &Params::default(), &mut stop);
    assert!(matches!(stopped, Err(RefineError::Cancelled(_))));
    for ratio in [0.99, f64::NAN, f64::INFINITY] {
        let params = Params {
            ratio,
            ..Params::default()
        };
        let error = refine2(given.clone(), &params, &mut silent).unwrap_err();
        assert!(matches!(error, RefineError::Ratio { .. }));
    }
}

/// Rounding makes triangles of such an edge low again, and points for them would fill the region as densely.
#[test]
fn two_points_very_near_to_each_other_do_not_need_many_more() {
    let corners = [DVec2::ZERO, DVec2::X, DVec2::ONE, DVec2::Y];
    for apart in [1e-8, 1e-11, 1e-14] {
        let pair = [0.0, apart].map(|y| DVec2::new(0.6, 0.7 + y));
        let points: Vec<DVec2> = corners.into_iter().chain(pair).collect();
        let given = Subcomplex2::of(&Delaunay2::build(&points).unwrap(), |_| true);
        for method in economical().into_iter().chain(papers()) {
            let params = Params {
                ratio: 1.0,
                method,
                max_new_vertices: 5000,
                ..Params::default()
            };
            let outcome = refine2(given.clone(), &params, &mut silent).unwrap();
            check_outcome(&given, &outcome).unwrap();
            assert_ne!(outcome.stop, Stop::OutOfVertices, "{method:?} {apart}");
        }
    }
}

#[test]
fn nothing_is_refined_to_nothing() {
    let delaunay = Delaunay2::build(&[DVec2::ZERO, DVec2::X, DVec2::Y]).unwrap();
    let nothing = Subcomplex2::of(&delaunay, |_| false);
    for method in papers().chain(economical()) {
        let outcome = refine(&nothing, method);
        assert_eq!(
            (outcome.stop, outcome.region.faces().count()),
            (Stop::AllGood, 0)
        );
    }
}
