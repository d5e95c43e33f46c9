//! Graded meshes: no poor triangle where the boundary allows it, valid whatever the boundary, the same on any number of threads.

mod regions;

use std::collections::BTreeSet;
use std::f64::consts::TAU;
use std::ops::ControlFlow;

use bubble_mesh::graded::{GradedError, GradedMesh, GradedParams, Stop, mesh, mesh_sized};
use bubble_mesh::{Domain, Resampling, Spacing, radius_ratio, resample};
use delaunay_core::measure::triangle;
use delaunay_core::progress::{Progress, silent};
use delaunay_core::{BuildOptions, Complex2, HalfEdgeId, Outline, TriMesh, VertexId};
use glam::DVec2;
use proptest::prelude::*;
use regions::{circle, domain, even, of_the_paper, square};

fn meshed(domain: &Domain) -> GradedMesh {
    mesh(domain, &GradedParams::default(), &mut silent).expect("default parameters")
}

/// The least radius ratio and the mean.
fn quality(complex: &Complex2) -> (f64, f64) {
    let ratios = complex.faces().map(|f| radius_ratio(complex.triangle(f)));
    let ratios: Vec<f64> = ratios.collect();
    let least = ratios.iter().copied().fold(1.0, f64::min);
    (least, ratios.iter().sum::<f64>() / ratios.len() as f64)
}

fn boundary(mesh: &TriMesh) -> BTreeSet<[VertexId; 2]> {
    let ghosts = mesh.faces().filter_map(|f| mesh.ghost_base(f));
    let ends = |h: HalfEdgeId| [mesh.origin(h), mesh.target(h)];
    ghosts.map(ends).collect()
}

/// What holds of every mesh.
fn check(domain: &Domain, mesh: &GradedMesh) -> Result<(), TestCaseError> {
    let complex = &mesh.complex;
    prop_assert_eq!(complex.check(), Ok(()));
    let given = domain.region();
    prop_assert_eq!(boundary(complex.mesh()), boundary(given.mesh()));
    prop_assert_eq!(&complex.points()[..given.points().len()], given.points());
    let areas = complex.faces().map(|f| triangle::area(complex.triangle(f)));
    prop_assert!((areas.sum::<f64>() / domain.area() - 1.0).abs() < 1e-12);
    Ok(())
}

/// Both diagonals of a rectangle are equally good, so rounding alone says which one is better, and it may say so of both.
#[test]
fn thin_rectangles_are_meshed() -> Result<(), TestCaseError> {
    for k in 1..200 {
        let across = DVec2::from_angle(f64::from(k));
        let high = 0.5_f64.powf(1.0 + f64::from(k % 37) / 4.0) * across.perp();
        let loops = [vec![DVec2::ZERO, across, across + high, high]];
        let domain = domain(&loops);
        check(&domain, &meshed(&domain))?;
    }
    Ok(())
}

/// The figures that other programs reach at best on these regions are 0.883, 0.683, 0.702, 0.749 and 0.989, 0.967, 0.975, 0.982.
#[test]
fn the_regions_of_the_paper_have_no_poor_triangle() {
    let mut found = String::new();
    let asked = [0.992, 0.978, 0.980, 0.985]
        .into_iter()
        .zip([0.993, 0.981, 0.985, 0.988]);
    for ((name, domain), (plain, searched)) in of_the_paper().into_iter().zip(asked) {
        for (trials, least, mean) in [(0, 0.90, plain), (1000, 0.92, searched)] {
            let params = GradedParams {
                trials,
                ..GradedParams::default()
            };
            let mesh = mesh(&domain, &params, &mut silent).expect("good parameters");
            assert_eq!(mesh.stop, Stop::Done);
            check(&domain, &mesh).expect("a valid mesh");
            let reached = quality(&mesh.complex);
            assert!(
                reached.0 >= least && reached.1 >= mean,
                "{name}, {trials}: {reached:?}"
            );
            let count = mesh.complex.faces().count();
            found += &format!(
                "{name}, {trials} trials: {count} triangles, {:.3} least, {:.4} mean\n",
                reached.0, reached.1
            );
        }
    }
    insta::assert_snapshot!(found);
}

/// A closed curve, at even parts of a turn.
fn curve(count: u32, at: impl Fn(f64) -> DVec2) -> Vec<DVec2> {
    even(count).map(|turn| at(turn * TAU)).collect()
}

/// Regions that the parameters were not chosen on.
#[test]
fn other_regions_have_no_poor_triangle_either() {
    let ellipse = curve(80, |t| DVec2::new(2.0 * t.cos(), t.sin()));
    let lobes = curve(120, |t| {
        (1.5 + 0.2 * (3.0 * t).cos()) * DVec2::from_angle(t)
    });
    let hole = |x: f64, y: f64, r: f64, count| circle(DVec2::new(x, y), r, even(count));
    let holes = [
        hole(0.6, 0.0, 0.2, 24),
        hole(-0.5, 0.5, 0.25, 24),
        hole(-0.4, -0.6, 0.2, 20),
    ];
    let turned = square(12, 0.3).into_iter().map(|p| 3.0 * p).collect();
    let oval = curve(36, |t| DVec2::new(1.0 + 0.5 * t.cos(), 1.9 + 0.3 * t.sin()));
    for (name, loops) in [
        ("ellipse", vec![ellipse]),
        (
            "lobes with three holes",
            [vec![lobes], holes.to_vec()].concat(),
        ),
        ("square with oval hole", vec![turned, oval]),
    ] {
        let domain = domain(&loops);
        let mesh = meshed(&domain);
        check(&domain, &mesh).expect("a valid mesh");
        let (least, mean) = quality(&mesh.complex);
        assert!(least > 0.82 && mean > 0.97, "{name}: {least} {mean}");
    }
}

#[test]
fn sizes_make_it_finer_and_what_is_no_size_is_named() {
    let domain = domain(&[square(8, 0.0)]);
    let count = |mesh: &GradedMesh| mesh.complex.faces().count();
    let plain = count(&meshed(&domain));
    let params = GradedParams::default();
    let fine = |p: DVec2| 0.02 + 0.2 * p.distance(DVec2::splat(0.5));
    let sized = mesh_sized(&domain, &params, Some(&fine), &mut silent).expect("sizes");
    check(&domain, &sized).expect("a valid mesh");
    assert!(count(&sized) > 2 * plain);
    let edge = |f| triangle::shortest_edge(sized.complex.triangle(f));
    let shortest = sized.complex.faces().map(edge).fold(1.0, f64::min);
    assert!((0.012..0.03).contains(&shortest), "{shortest}");
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let sizing = move |_: DVec2| bad;
        let error = mesh_sized(&domain, &params, Some(&sizing), &mut silent).expect_err("no size");
        assert!(matches!(error, GradedError::Size { .. }), "{error}");
    }
    for scale in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let params = GradedParams { scale, ..params };
        let error = mesh(&domain, &params, &mut silent).expect_err("no scale");
        assert!(error.to_string().starts_with("the scale"));
    }
    for crease in [-0.1, f64::NAN] {
        let params = GradedParams {
            sliding: Some(crease),
            ..params
        };
        let error = mesh(&domain, &params, &mut silent).expect_err("no angle");
        assert!(error.to_string().starts_with("the crease"));
    }
}

/// The report closure stops all threads at once, and is not asked again, however it would answer; any number of steps may be asked for.
#[test]
fn a_report_that_stops_once_stops_all() {
    let domain = domain(&[square(8, 0.1)]);
    let params = GradedParams {
        trials: 1,
        ..GradedParams::default()
    };
    let stopped_at = |call: usize, params: &GradedParams| {
        let mut calls = 0;
        let mut report = |_: Progress| {
            calls += 1;
            match calls == call {
                true => ControlFlow::Break(()),
                false => ControlFlow::Continue(()),
            }
        };
        let mesh = mesh(&domain, params, &mut report).expect("good parameters");
        (mesh, calls)
    };
    for call in 1..8 {
        let (mesh, calls) = stopped_at(call, &params);
        assert_eq!((mesh.stop, calls), (Stop::Cancelled, call));
        check(&domain, &mesh).expect("a valid mesh");
    }
    let endless = GradedParams {
        relaxation: usize::MAX,
        ..params
    };
    let (mesh, _) = stopped_at(9, &endless);
    assert_eq!(mesh.stop, Stop::Cancelled);
}

#[test]
fn a_budget_and_the_report_end_it_with_a_valid_mesh() {
    let domain = domain(&[square(20, 0.1), circle(DVec2::new(0.4, 0.5), 0.2, even(40))]);
    let given = domain.region().points().len();
    for (nodes, trials) in [(0, 0), (given, 50), (given + 7, 50), (given + 100, 0)] {
        let params = GradedParams {
            nodes,
            trials,
            ..GradedParams::default()
        };
        let mesh = mesh(&domain, &params, &mut silent).expect("good parameters");
        assert_eq!(mesh.stop, Stop::OutOfNodes);
        check(&domain, &mesh).expect("a valid mesh");
        assert!(mesh.complex.points().len() <= nodes.max(given));
    }
    for calls in 0..12 {
        let mut left = calls;
        let mut report = |_: Progress| {
            left -= 1;
            if left < 0 {
                ControlFlow::Break(())
            } else {
                ControlFlow::Continue(())
            }
        };
        let params = GradedParams {
            trials: 50,
            ..GradedParams::default()
        };
        let mesh = mesh(&domain, &params, &mut report).expect("good parameters");
        check(&domain, &mesh).expect("a valid mesh");
        assert!(calls > 5 || mesh.stop == Stop::Cancelled, "{calls}");
    }
}

#[test]
fn any_number_of_threads_gives_the_same_mesh() {
    let (_, domain) = of_the_paper().into_iter().nth(2).expect("four regions");
    let params = GradedParams {
        trials: 100,
        ..GradedParams::default()
    };
    let on = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
        let made = pool
            .expect("a pool")
            .install(|| mesh(&domain, &params, &mut silent));
        let complex = made.expect("good parameters").complex;
        (complex.points().to_vec(), complex.mesh().canonical())
    };
    let one = on(1);
    assert!([2, 3, 8].into_iter().all(|threads| on(threads) == one));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn any_region_gets_a_valid_mesh(
        outer in prop::collection::vec(1.0..4.0f64, 5..40),
        inner in prop::collection::vec(0.02..0.7f64, 3..20),
        trials in 0..20usize,
    ) {
        let star = |radii: &[f64]| -> Vec<DVec2> {
            let step = TAU / radii.len() as f64;
            radii.iter().enumerate().map(|(i, &r)| r * DVec2::from_angle(i as f64 * step)).collect()
        };
        let domain = domain(&[star(&outer), star(&inner)]);
        let params = GradedParams { trials, nodes: 20_000, ..GradedParams::default() };
        let mesh = mesh(&domain, &params, &mut silent).expect("good parameters");
        check(&domain, &mesh)?;
    }
}

/// The figures of the given boundary, with sliding, and with a boundary sampled anew.
#[test]
fn boundary_nodes_that_slide_or_are_sampled_anew_make_better_triangles() {
    let mut found = String::new();
    for (name, fixed) in of_the_paper() {
        let params = GradedParams {
            sliding: Some(0.5),
            ..GradedParams::default()
        };
        let kept = meshed(&fixed);
        let slid = mesh(&fixed, &params, &mut silent).expect("good parameters");
        assert_eq!(slid.complex.check(), Ok(()));
        let moved = fixed.region().points().iter().zip(slid.complex.points());
        assert!(moved.filter(|(p, q)| p != q).count() > 10, "{name}");
        let area = slid
            .complex
            .faces()
            .map(|f| triangle::area(slid.complex.triangle(f)));
        let area = area.sum::<f64>() / fixed.area() - 1.0;
        let again = sampled_anew(&fixed);
        let resampled = meshed(&again);
        check(&again, &resampled).expect("a valid mesh");
        let [kept, slid, resampled] = [kept, slid, resampled].map(|mesh| quality(&mesh.complex));
        assert!(slid.1 > kept.1 && slid.0 > 0.9, "{name}: {slid:?} {kept:?}");
        found += &format!(
            "{name}: fixed {:.3} {:.4}, sliding {:.3} {:.4} (area by {area:.1e}), {} nodes anew for {} {:.3} {:.4}\n",
            kept.0,
            kept.1,
            slid.0,
            slid.1,
            again.region().points().len(),
            fixed.region().points().len(),
            resampled.0,
            resampled.1
        );
    }
    insta::assert_snapshot!(found);
}

fn sampled_anew(domain: &Domain) -> Domain {
    let region = domain.region();
    let segments: Vec<_> = domain.segments().collect();
    let anew = resample(
        region.points(),
        &segments,
        |_, _| true,
        &Resampling::default(),
    );
    let anew = anew.expect("a boundary with curves");
    let outline = Outline::new(anew.points, anew.segments).expect("a closed outline");
    Domain::new(&outline, BuildOptions::default(), &mut silent).expect("a region")
}

/// A loop round a center, with lobes of some depth, whose edges differ in length by a factor of `uneven` at most from one side to the
/// other and by chance.
fn lobed(
    center: DVec2,
    radius: f64,
    lobes: (f64, f64),
    uneven: f64,
    chances: &[f64],
) -> Vec<DVec2> {
    let count = chances.len();
    let step = |i: usize| {
        let turn = i as f64 / count as f64 * TAU;
        uneven.powf(turn.cos() + 0.3 * chances[i])
    };
    let total: f64 = (0..count).map(step).sum();
    let mut sum = 0.0;
    let node = |i: usize| {
        sum += step(i);
        let turn = sum / total * TAU;
        center + radius * (1.0 + lobes.1 * (lobes.0 * turn).cos()) * DVec2::from_angle(turn)
    };
    (0..count).map(node).collect()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]
    /// The bound on what is given: where no corner is sharp, no size steep and no gap narrow, no triangle is below 0.7.
    #[test]
    fn what_is_poor_has_something_against_it(
        outer in prop::collection::vec(-1.0..1.0, 12..120),
        inner in prop::collection::vec(-1.0..1.0, 5..60),
        lobes in (2.0f64..6.0, 0.0..0.3),
        uneven in [1.0f64..2.5, 1.0..2.5],
        hole in (0.0..0.45, 0.05..0.45f64),
    ) {
        let lobes = (lobes.0.floor(), lobes.1);
        let (away, radius) = hole;
        let loops = [
            lobed(DVec2::ZERO, 1.0, lobes, uneven[0], &outer),
            lobed(DVec2::new(0.6 * away, 0.3 * away), 0.6 * radius, (3.0, 0.1), uneven[1], &inner),
        ];
        let Some(domain) = regions::try_domain(&loops) else {
            return Err(TestCaseError::reject("loops that cross"));
        };
        let mesh = meshed(&domain);
        check(&domain, &mesh)?;
        let spacing = Spacing::of(&domain);
        for f in mesh.complex.faces() {
            let corners = mesh.complex.triangle(f);
            let ratio = radius_ratio(corners);
            prop_assert!(ratio >= 0.7 || spacing.against(corners).is_some(), "{ratio} at {corners:?}");
        }
    }
}

/// The way round in a gap of 1.3 edges, which is too wide for one row of triangles and too narrow for two.
#[test]
fn a_narrow_spiral_has_it_said_against_it() {
    let (count, turns, width) = (66, 1.972_998_071_207_734, 0.287_402_882_440_429_83);
    let at = |i: usize, out: f64| {
        let turn = turns * i as f64 / count as f64;
        (1.0 + turn + out) * DVec2::from_angle(turn * TAU)
    };
    let there = (0..=count).map(|i| at(i, 0.0));
    let back = (0..=count).rev().map(|i| at(i, width));
    let domain = domain(&[there.chain(back).collect()]);
    let mesh = meshed(&domain).complex;
    let spacing = Spacing::of(&domain);
    let mut triangles = mesh.faces().map(|f| mesh.triangle(f));
    assert!(triangles.all(|t| radius_ratio(t) >= 0.7 || spacing.against(t).is_some()));
}

/// A small fine hole in a coarse region: sizes do not grow faster than they may.
#[test]
fn a_hole_much_finer_than_the_rest_has_no_poor_triangle() {
    let hole = circle(DVec2::new(0.2, 0.1), 0.04, even(24));
    let domain = domain(&[circle(DVec2::ZERO, 1.0, even(24)), hole]);
    let mesh = meshed(&domain);
    check(&domain, &mesh).expect("a valid mesh");
    let (least, mean) = quality(&mesh.complex);
    assert!(least > 0.8 && mean > 0.95, "{least} {mean}");
}

/// Sizes that hardly grow are those of the shortest edge, and fall to it from the longest.
#[test]
fn sizes_that_hardly_grow_fall_slowly_from_long_edges() {
    let turn = |i: u32| {
        let even = f64::from(i) / 60.0;
        TAU * (even + 0.9 * (TAU * even).sin() / TAU)
    };
    let nodes = (0..60).map(|i| DVec2::from_angle(turn(i)));
    let domain = domain(&[nodes.collect()]);
    let params = GradedParams {
        grade: 1e-6,
        ..GradedParams::default()
    };
    let mesh = mesh(&domain, &params, &mut silent).expect("good parameters");
    check(&domain, &mesh).expect("a valid mesh");
    let (least, mean) = quality(&mesh.complex);
    assert!(least > 0.7 && mean > 0.98, "{least} {mean}");
}
