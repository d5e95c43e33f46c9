//! Sizes asked for, beyond the paper: what every method makes of a field and of limits of regions, and that no field however
//! strange does harm.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

use sink_refine::{Candidate, Coarsening, Method, Params, Schedule};

const SCHEDULES: [Schedule; 3] = [Schedule::Incremental, Schedule::Block, Schedule::Parallel];

fn methods() -> impl Iterator<Item = Method> {
    let candidates = [Candidate::Sink, Candidate::Circumcenter].into_iter();
    let papers = candidates.flat_map(|candidate| {
        SCHEDULES.map(|schedule| Method::Paper {
            candidate,
            schedule,
        })
    });
    let coarsenings = [Coarsening::None, Coarsening::Removal, Coarsening::Merging];
    papers.chain(coarsenings.map(Method::Economical))
}

fn params(ratio: f64, method: Method) -> Params {
    Params {
        ratio,
        method,
        ..Params::default()
    }
}

/// Runs `work` on one, two and eight threads.
fn on_threads<T: Send>(work: impl Fn() -> T + Sync) -> [T; 3] {
    [1, 2, 8].map(|threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
        pool.unwrap().install(&work)
    })
}

mod plane {
    use super::*;
    use delaunay_core::measure::triangle::{area, circumradius, longest_edge, radius_edge_ratio};
    use delaunay_core::progress::silent;
    use delaunay_core::{Delaunay2, FaceId, Subcomplex2};
    use glam::{DVec2, DVec3};
    use proptest::prelude::*;
    use sink_refine::{
        Outcome2, Reason2, RefineError, RegionLimit, Sizing, Stop, UnusableSize, refine2,
        refine2_sized,
    };
    use std::collections::BTreeSet;
    use std::ops::ControlFlow;

    type Field<'a> = &'a (dyn Fn(DVec2) -> f64 + Sync);

    /// The corners of a square on its lower left corner and on all its sides, `n` edges each.
    fn rim(n: u32, corner: DVec2, side: f64) -> impl Iterator<Item = DVec2> {
        let k = f64::from(n);
        let sides =
            (0..n).flat_map(move |i| [[0, n], [1, 0], [n, 1], [1, n]].map(|_| f64::from(i)));
        sides.enumerate().map(move |(i, t)| {
            let place = [[t, 0.0], [k, t], [k - t, k], [0.0, k - t]][i % 4];
            corner + DVec2::from(place) * (side / k)
        })
    }

    fn square(n: u32) -> Subcomplex2 {
        let points: Vec<DVec2> = rim(n, DVec2::ZERO, 1.0).collect();
        Subcomplex2::of(&Delaunay2::build(&points).unwrap(), |_| true)
    }

    /// Two squares, one of them on the right of x = 2.
    fn two_squares(n: u32) -> Subcomplex2 {
        let left = rim(n, DVec2::ZERO, 1.0);
        let points: Vec<DVec2> = left.chain(rim(n, DVec2::X * 3.0, 1.0)).collect();
        let delaunay = Delaunay2::build(&points).unwrap();
        Subcomplex2::of(&delaunay, |f| {
            let [a, b, c] = delaunay.triangle(f).map(|p| p.x > 2.0);
            a == b && b == c
        })
    }

    fn refined(region: &Subcomplex2, params: &Params, field: Field<'_>) -> Outcome2 {
        let sizing = Sizing {
            field: Some(field),
            regions: &[],
        };
        refine2_sized(region.clone(), params, &sizing, &mut silent).unwrap()
    }

    fn size(outcome: &Outcome2, f: FaceId, field: Field<'_>) -> f64 {
        let corners = outcome.region.triangle(f);
        let centroid = corners.iter().sum::<DVec2>() / 3.0;
        circumradius(corners) * 3.0_f64.sqrt() / field(centroid)
    }

    /// The mesh is sound, and all of it has the sizes and ratios asked for, or is listed with what is wrong with it.
    fn check(outcome: &Outcome2, ratio: f64, field: Field<'_>) {
        let region = &outcome.region;
        assert_eq!(region.check(), Ok(()));
        let listed: BTreeSet<FaceId> = outcome.low.iter().map(|low| low.face).collect();
        for f in region.faces().filter(|f| !listed.contains(f)) {
            assert!(size(outcome, f, field) <= 1.0 + 1e-12);
            assert!(radius_edge_ratio(region.triangle(f)) <= ratio + 1e-12);
        }
        for low in &outcome.low {
            let there = size(outcome, low.face, field);
            assert!((low.size / there - 1.0).abs() < 1e-9, "{low:?} {there}");
            assert!(low.size > 1.0 - 1e-12 || low.ratio > ratio, "{low:?}");
        }
        let badness = |low: &sink_refine::Low2| low.ratio.max(ratio * low.size);
        let low = &outcome.low;
        assert!(low.is_sorted_by(|a, b| badness(a) >= badness(b)));
        assert_eq!(outcome.rounds.last().unwrap().low, low.len());
        assert!(region.vertex_count() as f64 <= outcome.separation.vertex_bound);
    }

    #[test]
    fn every_method_obeys_a_uniform_size() {
        let region = square(20);
        for method in methods() {
            let field = |_| 0.06;
            let outcome = refined(&region, &params(1.0, method), &field);
            check(&outcome, 1.0, &field);
            assert!(outcome.low.len() <= 4, "{method:?} {:?}", outcome.low);
            let edges = outcome.region.faces();
            let longest = edges.map(|f| longest_edge(outcome.region.triangle(f)));
            let longest = longest.fold(0.0, f64::max);
            assert!(!outcome.low.is_empty() || longest <= 0.06 * 2.0 / 3.0_f64.sqrt());
            // Not many more than regular triangles of that size.
            let regular = 1.0 / (0.06 * 0.06 * 3.0_f64.sqrt() / 4.0);
            let count = outcome.region.faces().count() as f64;
            assert!(count < 2.0 * regular, "{method:?}: {count} of {regular}");
        }
    }

    #[test]
    fn points_for_sizes_keep_their_distance() {
        let region = square(40);
        for method in methods().filter(|method| matches!(method, Method::Paper { .. })) {
            for h in [0.05, 0.03] {
                let outcome = refined(&region, &params(1.0, method), &|_| h);
                let least = f64::min(1.0 / 40.0, h / 3.0_f64.sqrt());
                assert!(outcome.separation.reached >= least * (1.0 - 1e-9));
            }
        }
    }

    #[test]
    fn every_method_obeys_a_graded_size() {
        let region = square(40);
        let field = |p: DVec2| 0.03 + 0.3 * p.distance(DVec2::new(0.3, 0.4));
        for method in methods() {
            let outcome = refined(&region, &params(1.0, method), &field);
            check(&outcome, 1.0, &field);
            assert_eq!((outcome.stop, outcome.low.len()), (Stop::AllGood, 0));
        }
    }

    #[test]
    fn a_coarse_boundary_is_the_reason_for_what_is_too_large() {
        let region = square(20);
        for method in methods() {
            let field = |_| 0.04;
            let outcome = refined(&region, &params(1.0, method), &field);
            check(&outcome, 1.0, &field);
            assert_eq!(outcome.stop, Stop::NothingToInsert);
            let edges = outcome.low.iter().filter_map(|low| match low.reason {
                Reason2::BoundaryEdge(h) => Some(h),
                _ => None,
            });
            let edges: BTreeSet<_> = edges.collect();
            // One for each edge of the boundary, but for two at a corner in one triangle.
            assert!(edges.len() >= 76 && edges.iter().all(|&h| outcome.region.is_boundary(h)));
        }
    }

    #[test]
    fn sizes_that_ask_for_nothing_change_nothing() {
        let region = square(10);
        for method in methods() {
            let params = params(1.0, method);
            let plain = refine2(region.clone(), &params, &mut silent).unwrap();
            for field in [|_: DVec2| f64::INFINITY, |_: DVec2| f64::MAX, |_| 7.0] {
                let sized = refined(&region, &params, &field);
                assert!(sized.region.mesh() == plain.region.mesh());
                assert_eq!(sized.region.points(), plain.region.points());
                assert_eq!(sized.counters, plain.counters);
            }
        }
    }

    #[test]
    fn regions_have_their_own_sizes_in_every_method() {
        let region = two_squares(20);
        let limit = |x: f64, size: f64| RegionLimit {
            seed: DVec2::new(x, 0.5),
            size,
        };
        let limits = [
            limit(0.5, 0.07),
            limit(0.2, 0.06),
            limit(3.5, 0.12),
            limit(99.0, f64::INFINITY),
        ];
        for method in methods() {
            let sizing = Sizing {
                field: None,
                regions: &limits,
            };
            let outcome =
                refine2_sized(region.clone(), &params(1.0, method), &sizing, &mut silent).unwrap();
            let field = |p: DVec2| if p.x < 2.0 { 0.06 } else { 0.12 };
            check(&outcome, 1.0, &field);
            // The least of several counts, and with a field the least of both.
            let both = Sizing {
                field: Some(&|_| 0.07),
                regions: &limits,
            };
            let outcome =
                refine2_sized(region.clone(), &params(1.0, method), &both, &mut silent).unwrap();
            check(&outcome, 1.0, &|p: DVec2| field(p).min(0.07));
        }
    }

    #[test]
    fn a_region_that_is_none_is_an_error() {
        let region = two_squares(2);
        let error = |x: f64, size: f64| {
            let first = RegionLimit {
                seed: DVec2::new(1.0, 0.0),
                size: 1.0,
            };
            let second = RegionLimit {
                seed: DVec2::new(x, 0.5),
                size,
            };
            let sizing = Sizing {
                field: None,
                regions: &[first, second],
            };
            refine2_sized(region.clone(), &Params::default(), &sizing, &mut silent).unwrap_err()
        };
        for place in [2.0, -1e9, f64::NAN, 1e300] {
            assert_eq!(error(place, 1.0), RefineError::RegionOutside { region: 1 });
        }
        for size in [0.0, -1.0, f64::NEG_INFINITY, f64::NAN] {
            let found = error(0.5, size);
            assert!(matches!(found, RefineError::RegionSize { region: 1, .. }));
        }
        insta::assert_snapshot!(error(2.0, 1.0), @"the point of region 1 is outside of the mesh");
        insta::assert_snapshot!(error(0.5, -1.0), @"the size -1 of region 1 is not a number above zero");
    }

    #[test]
    fn what_is_no_size_stops_the_work_and_is_told_with_its_place() {
        let region = square(10);
        for bad in [f64::NAN, 0.0, -0.0, -1.0, f64::NEG_INFINITY] {
            for method in methods() {
                // At once, and where small triangles come only later.
                let at_once = |_: DVec2| bad;
                let later = |p: DVec2| {
                    if p.distance(DVec2::splat(0.5)) < 0.1 {
                        bad
                    } else {
                        0.12
                    }
                };
                for field in [&at_once as Field<'_>, &later] {
                    let outcome = refined(&region, &params(1.0, method), field);
                    assert_eq!(outcome.region.check(), Ok(()));
                    let Stop::UnusableSize(UnusableSize { place, size }) = outcome.stop else {
                        panic!("{:?} of {bad} by {method:?}", outcome.stop);
                    };
                    assert_eq!(size.to_bits(), bad.to_bits());
                    let DVec3 { x, y, z } = place;
                    assert!((0.0..1.0).contains(&x) && (0.0..1.0).contains(&y) && z == 0.0);
                }
            }
        }
    }

    #[test]
    fn a_size_too_small_to_wait_for_ends_with_the_budget() {
        let region = square(4);
        for h in [1e-7, 1e-300, f64::MIN_POSITIVE, f64::from_bits(1)] {
            for method in methods() {
                let params = Params {
                    max_new_vertices: 300,
                    ..params(1.0, method)
                };
                let outcome = refined(&region, &params, &|_| h);
                assert_eq!(outcome.region.check(), Ok(()));
                assert_eq!(outcome.stop, Stop::OutOfVertices, "{h} {method:?}");
                assert_eq!(outcome.region.vertex_count(), 16 + 300);
                let in_rounds: usize = outcome.rounds.iter().map(|round| round.inserted).sum();
                assert_eq!(in_rounds, 300, "{method:?}");
                assert!(!outcome.low.is_empty());
            }
        }
    }

    #[test]
    fn a_search_for_vertices_that_are_not_needed_can_be_cancelled() {
        let region = square(60);
        let reports = |coarsening| {
            let sizing = Sizing {
                field: Some(&|_| 0.018),
                regions: &[],
            };
            let params = params(1.0, Method::Economical(coarsening));
            let mut count = 0;
            let mut report = |_| {
                count += 1;
                ControlFlow::Continue(())
            };
            let outcome = refine2_sized(region.clone(), &params, &sizing, &mut report).unwrap();
            assert!(outcome.counters.inserted > 4096 && outcome.counters.removed < 50);
            count
        };
        assert!(reports(Coarsening::Removal) > reports(Coarsening::None));
    }

    /// So far off that there are eight doubles to a side.
    #[test]
    fn a_size_below_the_last_bit_of_the_coordinates_ends_where_there_is_no_place_left() {
        let far = DVec2::splat(2.0_f64.powi(52));
        let points: Vec<DVec2> = rim(2, far, 8.0).collect();
        let region = Subcomplex2::of(&Delaunay2::build(&points).unwrap(), |_| true);
        for method in methods() {
            let outcome = refined(&region, &params(1.0, method), &|_| 1e-3);
            assert_eq!(outcome.region.check(), Ok(()));
            assert_eq!(outcome.stop, Stop::NothingToInsert);
            assert!(outcome.region.vertex_count() <= 81);
        }
    }

    #[test]
    fn a_size_that_vanishes_at_a_place_inside_needs_few_points_to_the_last_bit() {
        let region = square(4);
        let field = |p: DVec2| p.distance(DVec2::new(0.37, 0.41)).max(f64::MIN_POSITIVE);
        for method in methods() {
            let params = Params {
                max_new_vertices: 2000,
                ..params(1.5, method)
            };
            let outcome = refined(&region, &params, &field);
            assert_eq!(outcome.region.check(), Ok(()));
            assert_eq!(outcome.stop, Stop::NothingToInsert, "{method:?}");
        }
    }

    #[test]
    fn threads_do_not_change_a_mesh_with_sizes() {
        let region = square(40);
        for candidate in [Candidate::Sink, Candidate::Circumcenter] {
            let method = Method::Paper {
                candidate,
                schedule: Schedule::Parallel,
            };
            let field = |p: DVec2| 0.03 + 0.1 * p.x;
            let [one, two, eight] = on_threads(|| {
                let outcome = refined(&region, &params(1.0, method), &field);
                (
                    outcome.region.points().to_vec(),
                    outcome.region.mesh().clone(),
                    outcome.rounds,
                    outcome.low,
                )
            });
            assert!(one == two && one == eight);
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(48))]

        /// Linear fields; some of them fall below zero somewhere.
        #[test]
        fn a_linear_field_is_obeyed_or_what_is_left_is_listed(
            least in 0.05..0.3, slope in -0.2..0.4, turn in 0.0..6.3, which in 0_usize..9, ratio in 1.0..2.0,
        ) {
            let region = square(12);
            let along = DVec2::from_angle(turn);
            let field = |p: DVec2| least + slope * p.dot(along);
            let method = methods().nth(which).unwrap();
            let outcome = refined(&region, &params(ratio, method), &field);
            if let Stop::UnusableSize(UnusableSize { place, size }) = outcome.stop {
                prop_assert!(size <= 0.0 && field(place.truncate()) == size);
                prop_assert_eq!(outcome.region.check(), Ok(()));
            } else {
                check(&outcome, ratio, &field);
                prop_assert_eq!(outcome.stop == Stop::AllGood, outcome.low.is_empty());
            }
            let total: f64 = outcome.region.faces().map(|f| area(outcome.region.triangle(f))).sum();
            prop_assert!((total - 1.0).abs() < 1e-12);
        }
    }
}

mod space {
    use super::*;
    use delaunay_core::measure::tetrahedron::{
        circumradius, longest_edge, radius_edge_ratio, signed_volume,
    };
    use delaunay_core::progress::silent;
    use delaunay_core::{Delaunay3, Subcomplex3, TetId};
    use glam::DVec3;
    use proptest::prelude::*;
    use sink_refine::{
        Outcome3, Reason3, RefineError, RegionLimit, Sizing, Stop, UnusableSize, refine3,
        refine3_sized,
    };
    use std::collections::BTreeSet;
    use std::ops::ControlFlow;

    type Field<'a> = &'a (dyn Fn(DVec3) -> f64 + Sync);

    /// The lattice points on the surface of a cube, `n` edges to a side.
    fn surface(n: i32, corner: DVec3, side: f64) -> impl Iterator<Item = DVec3> {
        let all = (0..(n + 1).pow(3))
            .map(move |i| [i % (n + 1), i / (n + 1) % (n + 1), i / (n + 1).pow(2)]);
        let outer = all.filter(move |p| p.iter().any(|x| x % n == 0));
        outer.map(move |p| corner + DVec3::from(p.map(f64::from)) * (side / f64::from(n)))
    }

    fn cube(n: i32) -> Subcomplex3 {
        let points: Vec<DVec3> = surface(n, DVec3::ZERO, 1.0).collect();
        Subcomplex3::of(&Delaunay3::build(&points).unwrap(), |_| true)
    }

    /// Two cubes, one of them on the right of x = 2.
    fn two_cubes(n: i32) -> Subcomplex3 {
        let left = surface(n, DVec3::ZERO, 1.0);
        let points: Vec<DVec3> = left.chain(surface(n, DVec3::X * 3.0, 1.0)).collect();
        let delaunay = Delaunay3::build(&points).unwrap();
        Subcomplex3::of(&delaunay, |t| {
            let [a, b, c, d] = delaunay.tetrahedron(t).map(|p| p.x > 2.0);
            a == b && b == c && c == d
        })
    }

    fn refined(solid: &Subcomplex3, params: &Params, field: Field<'_>) -> Outcome3 {
        let sizing = Sizing {
            field: Some(field),
            regions: &[],
        };
        refine3_sized(solid.clone(), params, &sizing, &mut silent).unwrap()
    }

    fn size(outcome: &Outcome3, t: TetId, field: Field<'_>) -> f64 {
        let corners = outcome.solid.tetrahedron(t);
        let centroid = corners.iter().sum::<DVec3>() / 4.0;
        circumradius(corners) * 4.0 / 6.0_f64.sqrt() / field(centroid)
    }

    /// The mesh is sound, and all of it has the sizes and ratios asked for, or is listed with what is wrong with it.
    fn check(outcome: &Outcome3, ratio: f64, field: Field<'_>) {
        let solid = &outcome.solid;
        let listed: BTreeSet<TetId> = outcome.low.iter().map(|low| low.tet).collect();
        for t in solid.tets().filter(|t| !listed.contains(t)) {
            assert!(size(outcome, t, field) <= 1.0 + 1e-12);
            assert!(radius_edge_ratio(solid.tetrahedron(t)) <= ratio + 1e-12);
        }
        for low in &outcome.low {
            let there = size(outcome, low.tet, field);
            assert!((low.size / there - 1.0).abs() < 1e-9, "{low:?} {there}");
            assert!(low.size > 1.0 - 1e-12 || low.ratio > ratio, "{low:?}");
        }
        let badness = |low: &sink_refine::Low3| low.ratio.max(ratio * low.size);
        let low = &outcome.low;
        assert!(low.is_sorted_by(|a, b| badness(a) >= badness(b)));
        assert_eq!(outcome.rounds.last().unwrap().low, low.len());
        assert!(solid.vertex_count() as f64 <= outcome.separation.vertex_bound);
    }

    fn volume(solid: &Subcomplex3) -> f64 {
        let volumes = solid.tets().map(|t| signed_volume(solid.tetrahedron(t)));
        volumes.sum()
    }

    #[test]
    fn every_method_obeys_a_uniform_size() {
        let solid = cube(8);
        for method in methods() {
            let field = |_| 0.2;
            let outcome = refined(&solid, &params(2.0, method), &field);
            check(&outcome, 2.0, &field);
            assert_eq!(outcome.solid.mesh().check(), Ok(()));
            assert!(outcome.low.len() <= 20, "{method:?}: {}", outcome.low.len());
            let listed: BTreeSet<TetId> = outcome.low.iter().map(|low| low.tet).collect();
            let good = outcome.solid.tets().filter(|t| !listed.contains(t));
            let longest = good.map(|t| longest_edge(outcome.solid.tetrahedron(t)));
            assert!(longest.fold(0.0, f64::max) <= 0.2 * 6.0_f64.sqrt() / 2.0 + 1e-12);
        }
    }

    #[test]
    fn points_for_sizes_keep_their_distance() {
        let solid = cube(8);
        for method in methods().filter(|method| matches!(method, Method::Paper { .. })) {
            for h in [0.25, 0.16] {
                let outcome = refined(&solid, &params(2.0, method), &|_| h);
                let least = f64::min(1.0 / 8.0, h * 6.0_f64.sqrt() / 4.0);
                assert!(outcome.separation.reached >= least * (1.0 - 1e-9));
            }
        }
    }

    #[test]
    fn every_method_obeys_a_graded_size() {
        let solid = cube(12);
        let field = |p: DVec3| 0.1 + 0.3 * p.distance(DVec3::new(0.3, 0.4, 0.1));
        for method in methods() {
            let outcome = refined(&solid, &params(2.0, method), &field);
            check(&outcome, 2.0, &field);
            assert_eq!((outcome.stop, outcome.low.len()), (Stop::AllGood, 0));
        }
    }

    #[test]
    fn a_coarse_boundary_is_the_reason_for_what_is_too_large() {
        let solid = cube(3);
        for method in methods() {
            let field = |_| 0.2;
            let outcome = refined(&solid, &params(2.0, method), &field);
            check(&outcome, 2.0, &field);
            assert_eq!(outcome.stop, Stop::NothingToInsert);
            let facets = outcome.low.iter().filter_map(|low| match low.reason {
                Reason3::BoundaryTriangle(f) => Some(f),
                _ => None,
            });
            // All 108 triangles are too large, but a tetrahedron may have several and names one of them.
            let facets: BTreeSet<_> = facets.collect();
            assert!(facets.len() > 54 && facets.iter().all(|&f| outcome.solid.is_boundary(f)));
        }
    }

    #[test]
    fn sizes_that_ask_for_nothing_change_nothing() {
        let solid = cube(4);
        for method in methods() {
            let params = params(1.0, method);
            let plain = refine3(solid.clone(), &params, &mut silent).unwrap();
            for field in [|_: DVec3| f64::INFINITY, |_: DVec3| f64::MAX, |_| 9.0] {
                let sized = refined(&solid, &params, &field);
                assert!(sized.solid.mesh() == plain.solid.mesh());
                assert_eq!(sized.solid.points(), plain.solid.points());
                assert_eq!(sized.counters, plain.counters);
            }
        }
    }

    #[test]
    fn regions_have_their_own_sizes_in_every_method() {
        let solid = two_cubes(6);
        let limit = |x: f64, size: f64| RegionLimit {
            seed: DVec3::new(x, 0.5, 0.5),
            size,
        };
        let limits = [
            limit(0.5, 0.3),
            limit(0.2, 0.25),
            limit(3.5, 0.5),
            limit(99.0, f64::INFINITY),
        ];
        for method in methods() {
            let sizing = Sizing {
                field: None,
                regions: &limits,
            };
            let outcome =
                refine3_sized(solid.clone(), &params(2.0, method), &sizing, &mut silent).unwrap();
            let field = |p: DVec3| if p.x < 2.0 { 0.25 } else { 0.5 };
            check(&outcome, 2.0, &field);
        }
    }

    #[test]
    fn a_region_that_is_none_is_an_error() {
        let solid = two_cubes(2);
        let error = |x: f64, size: f64| {
            let limit = RegionLimit {
                seed: DVec3::new(x, 0.5, 0.5),
                size,
            };
            let sizing = Sizing {
                field: None,
                regions: &[limit],
            };
            refine3_sized(solid.clone(), &Params::default(), &sizing, &mut silent).unwrap_err()
        };
        for place in [2.0, -1e9, f64::NAN, 1e300] {
            assert_eq!(error(place, 1.0), RefineError::RegionOutside { region: 0 });
        }
        for size in [0.0, -1.0, f64::NEG_INFINITY, f64::NAN] {
            let found = error(0.5, size);
            assert!(matches!(found, RefineError::RegionSize { region: 0, .. }));
        }
    }

    #[test]
    fn what_is_no_size_stops_the_work_and_is_told_with_its_place() {
        let solid = cube(4);
        for bad in [f64::NAN, 0.0, -1.0, f64::NEG_INFINITY] {
            for method in methods() {
                let at_once = |_: DVec3| bad;
                let later = |p: DVec3| {
                    if p.distance(DVec3::splat(0.5)) < 0.2 {
                        bad
                    } else {
                        0.3
                    }
                };
                for field in [&at_once as Field<'_>, &later] {
                    let outcome = refined(&solid, &params(2.0, method), field);
                    assert_eq!(outcome.solid.mesh().check(), Ok(()));
                    let Stop::UnusableSize(UnusableSize { place, size }) = outcome.stop else {
                        panic!("{:?} of {bad} by {method:?}", outcome.stop);
                    };
                    assert_eq!(size.to_bits(), bad.to_bits());
                    assert!(place.cmpgt(DVec3::ZERO).all() && place.cmplt(DVec3::ONE).all());
                }
            }
        }
    }

    #[test]
    fn a_size_too_small_to_wait_for_ends_with_the_budget() {
        let solid = cube(6);
        for h in [1e-7, f64::from_bits(1)] {
            for method in methods() {
                let params = Params {
                    max_new_vertices: 60,
                    ..params(2.0, method)
                };
                let outcome = refined(&solid, &params, &|_| h);
                assert_eq!(outcome.solid.mesh().check(), Ok(()));
                assert_eq!(outcome.stop, Stop::OutOfVertices, "{h} {method:?}");
                assert_eq!(
                    outcome.solid.vertex_count(),
                    solid.vertex_count() + 60,
                    "{method:?}"
                );
                let in_rounds: usize = outcome.rounds.iter().map(|round| round.inserted).sum();
                assert_eq!(in_rounds, 60, "{method:?}");
                assert!(!outcome.low.is_empty());
            }
        }
    }

    #[test]
    fn a_search_for_vertices_that_are_not_needed_can_be_cancelled() {
        let solid = cube(16);
        let reports = |coarsening| {
            let sizing = Sizing {
                field: Some(&|_| 0.075),
                regions: &[],
            };
            let params = params(2.0, Method::Economical(coarsening));
            let mut count = 0;
            let mut report = |_| {
                count += 1;
                ControlFlow::Continue(())
            };
            let outcome = refine3_sized(solid.clone(), &params, &sizing, &mut report).unwrap();
            assert!(outcome.counters.inserted > 4096 && outcome.counters.removed < 200);
            count
        };
        assert!(reports(Coarsening::Removal) > reports(Coarsening::None));
    }

    /// So far off that there are four doubles to a side.
    #[test]
    fn a_size_below_the_last_bit_of_the_coordinates_ends_where_there_is_no_place_left() {
        let far = DVec3::splat(2.0_f64.powi(52));
        let points: Vec<DVec3> = surface(2, far, 4.0).collect();
        let solid = Subcomplex3::of(&Delaunay3::build(&points).unwrap(), |_| true);
        for method in methods() {
            let outcome = refined(&solid, &params(2.0, method), &|_| 1e-3);
            assert_eq!(outcome.solid.mesh().check(), Ok(()));
            assert_eq!(outcome.stop, Stop::NothingToInsert);
            assert!(outcome.solid.vertex_count() <= 125);
        }
    }

    #[test]
    fn threads_do_not_change_a_mesh_with_sizes() {
        let solid = cube(10);
        for candidate in [Candidate::Sink, Candidate::Circumcenter] {
            let method = Method::Paper {
                candidate,
                schedule: Schedule::Parallel,
            };
            let field = |p: DVec3| 0.15 + 0.1 * p.x;
            let [one, two, eight] = on_threads(|| {
                let outcome = refined(&solid, &params(2.0, method), &field);
                (
                    outcome.solid.points().to_vec(),
                    outcome.solid.mesh().canonical(),
                    outcome.rounds,
                    outcome.low.len(),
                )
            });
            assert!(one == two && one == eight);
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(16))]

        /// Linear fields; some of them fall below zero somewhere.
        #[test]
        fn a_linear_field_is_obeyed_or_what_is_left_is_listed(
            least in 0.2..0.5, slope in [-0.2..0.4, -0.2..0.4, -0.2..0.4], which in 0_usize..9, ratio in 1.2..2.5,
        ) {
            let solid = cube(5);
            let slope = DVec3::from(slope);
            let field = |p: DVec3| least + slope.dot(p);
            let method = methods().nth(which).unwrap();
            let outcome = refined(&solid, &params(ratio, method), &field);
            if let Stop::UnusableSize(UnusableSize { place, size }) = outcome.stop {
                prop_assert!(size <= 0.0 && field(place) == size);
            } else {
                check(&outcome, ratio, &field);
                prop_assert_eq!(outcome.stop == Stop::AllGood, outcome.low.is_empty());
            }
            prop_assert_eq!(outcome.solid.mesh().check(), Ok(()));
            prop_assert!((volume(&outcome.solid) - 1.0).abs() < 1e-12);
        }
    }
}
