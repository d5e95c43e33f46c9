//! Refinement that may divide the boundary: nothing of low quality is left but where the boundary forbids it, and the shape
//! stays.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

mod data_sets;

use data_sets::{solid, usa};
use delaunay_core::geo_predicates::{Sign, orient3d};
use delaunay_core::measure::{tetrahedron, triangle};
use delaunay_core::progress::{Progress, silent};
use delaunay_core::{
    BuildOptions, Delaunay2, Delaunay3, SolidError, Subcomplex2, Subcomplex3, Surface, VertexId,
};
use fixtures::surfaces;
use glam::{DVec2, DVec3};
use proptest::prelude::*;
use rustc_hash::FxHashMap;
use sink_refine::{
    Boundary, Candidate, Coarsening, Method, Outcome2, Outcome3, Params, Schedule, Sizing2,
    Sizing3, Stop, refine2, refine2_sized, refine3, refine3_sized,
};
use std::f64::consts::TAU;
use std::ops::ControlFlow;

const FLAT: Boundary = Boundary::Split { crease: 0.0 };
const SMOOTH: Boundary = Boundary::Split { crease: 30.0 };

fn methods() -> impl Iterator<Item = Method> {
    let schedules = [Schedule::Incremental, Schedule::Block, Schedule::Parallel];
    let candidates = [Candidate::Sink, Candidate::Circumcenter].into_iter();
    let papers = candidates.flat_map(move |candidate| {
        schedules.map(|schedule| Method::Paper {
            candidate,
            schedule,
        })
    });
    let economical = [Coarsening::None, Coarsening::Removal, Coarsening::Merging];
    papers.chain(economical.map(Method::Economical))
}

fn params(ratio: f64, method: Method, boundary: Boundary) -> Params {
    Params {
        ratio,
        method,
        boundary,
        ..Params::default()
    }
}

fn area(region: &Subcomplex2) -> f64 {
    let areas = region.faces().map(|f| triangle::area(region.triangle(f)));
    areas.sum()
}

fn volume(solid: &Subcomplex3) -> f64 {
    let volumes = solid
        .tets()
        .map(|t| tetrahedron::signed_volume(solid.tetrahedron(t)));
    volumes.sum()
}

/// What holds of every region refined.
fn check_region(given: &Subcomplex2, outcome: &Outcome2) -> Result<(), TestCaseError> {
    let region = &outcome.region;
    prop_assert_eq!(region.check(), Ok(()));
    prop_assert_eq!(&region.points()[..given.points().len()], given.points());
    let grown = region.boundary().count() - given.boundary().count();
    prop_assert_eq!(grown, outcome.counters.split);
    prop_assert!(outcome.region.vertex_count() as f64 <= outcome.separation.vertex_bound);
    prop_assert_eq!(outcome.stop == Stop::AllGood, outcome.low.is_empty());
    Ok(())
}

/// What holds of every solid refined: a mesh without flat or inverted tetrahedra, within a surface that does not meet itself.
fn check_solid(given: &Subcomplex3, outcome: &Outcome3) -> Result<(), TestCaseError> {
    let solid = &outcome.solid;
    prop_assert_eq!(solid.mesh().check(), Ok(()));
    prop_assert_eq!(&solid.points()[..given.points().len()], given.points());
    for t in solid.tets() {
        let [a, b, c, d] = solid.tetrahedron(t);
        prop_assert_eq!(orient3d(a, b, c, d), Sign::Positive);
    }
    // Each vertex on the surface adds two triangles to it.
    let grown = solid.boundary().count() - given.boundary().count();
    prop_assert_eq!(grown, 2 * outcome.counters.split);
    let surface = surface_of(solid);
    let met = surface.solid(BuildOptions::default(), &mut silent);
    let meets_itself = matches!(met, Err(SolidError::SelfIntersection { .. }));
    prop_assert!(!meets_itself);
    prop_assert_eq!(outcome.stop == Stop::AllGood, outcome.low.is_empty());
    Ok(())
}

fn surface_of(solid: &Subcomplex3) -> Surface {
    let mut names = FxHashMap::default();
    let mut points = Vec::new();
    let mut triangles = Vec::new();
    for f in solid.boundary() {
        triangles.push(solid.mesh().facet_vertices(f).map(|v| {
            *names.entry(v).or_insert_with(|| {
                points.push(solid.point(v));
                VertexId::new(points.len() - 1)
            })
        }));
    }
    Surface::new(points, triangles).unwrap()
}

/// The paper keeps the boundary and leaves ratios of 2.58 to 3.54 (figure 7).
#[test]
fn no_triangle_of_the_planar_data_set_is_above_the_ratio() {
    let usa = usa();
    let mut lines = Vec::new();
    for method in methods() {
        let outcome = refine2(usa.clone(), &params(1.0, method, FLAT), &mut silent).unwrap();
        check_region(&usa, &outcome).unwrap();
        assert_eq!(outcome.stop, Stop::AllGood);
        assert!((area(&outcome.region) / area(&usa) - 1.0).abs() < 1e-12);
        let (faces, split) = (outcome.region.faces().count(), outcome.counters.split);
        lines.push(format!(
            "{method:?}: {faces} triangles, {split} points on the boundary"
        ));
    }
    insta::assert_snapshot!(lines.join("\n"));
}

/// The paper keeps the boundary and leaves 481 and 245 tetrahedra (figures 10 and 11).
#[test]
fn no_tetrahedron_of_the_star_and_the_head_is_above_the_ratio() {
    let sinks = Method::Paper {
        candidate: Candidate::Sink,
        schedule: Schedule::Parallel,
    };
    let few = Method::Economical(Coarsening::None);
    let mut lines = Vec::new();
    for (name, given) in [
        ("star", solid(surfaces::star())),
        ("head", solid(surfaces::head())),
    ] {
        for (what, method, boundary) in [
            ("sinks, smooth", sinks, SMOOTH),
            ("economical, flat", few, FLAT),
            ("economical, smooth", few, SMOOTH),
        ] {
            let outcome =
                refine3(given.clone(), &params(2.0, method, boundary), &mut silent).unwrap();
            check_solid(&given, &outcome).unwrap();
            assert_eq!(outcome.stop, Stop::AllGood);
            let change = volume(&outcome.solid) / volume(&given) - 1.0;
            match boundary == FLAT {
                true => assert!(change.abs() < 1e-12, "{change}"),
                false => assert!(change.abs() < 1e-3, "{change}"),
            }
            let (tets, split) = (outcome.solid.tets().count(), outcome.counters.split);
            lines.push(format!(
                "{name}, {what}: {tets} tets, {split} points on the boundary"
            ));
        }
    }
    insta::assert_snapshot!(lines.join("\n"));
}

/// A ring of points round the origin, and one in the middle.
fn wheel(corners: usize) -> Subcomplex2 {
    let place = |i: usize| DVec2::from_angle(TAU * i as f64 / corners as f64);
    let points: Vec<DVec2> = (0..corners)
        .map(place)
        .chain([DVec2::new(0.9, 0.01)])
        .collect();
    Subcomplex2::of(&Delaunay2::build(&points).unwrap(), |_| true)
}

#[test]
fn new_vertices_are_on_a_smooth_curve_or_on_the_edges() {
    let given = wheel(16);
    let chords = area(&given);
    let method = Method::Economical(Coarsening::None);
    let [flat, smooth] = [FLAT, SMOOTH].map(|boundary| {
        let outcome = refine2(given.clone(), &params(1.0, method, boundary), &mut silent).unwrap();
        check_region(&given, &outcome).unwrap();
        assert!(outcome.counters.split > 2);
        outcome.region
    });
    assert!((area(&flat) / chords - 1.0).abs() < 1e-12);
    // Of what the edges cut off from the disk, some is back.
    assert!(area(&smooth) > chords);
    let off_circle = |v: usize| (smooth.points()[v].length() - 1.0).abs();
    let on_boundary: Vec<VertexId> = smooth.boundary().map(|h| smooth.mesh().origin(h)).collect();
    let sagitta = 1.0 - (TAU / 32.0).cos();
    assert!(
        on_boundary
            .iter()
            .all(|v| off_circle(v.index()) < 0.05 * sagitta)
    );
}

#[test]
fn new_vertices_are_on_a_smooth_surface() {
    // An icosphere with a vertex near its surface.
    let golden = (1.0 + 5.0_f64.sqrt()) / 2.0;
    let mut points: Vec<DVec3> = Vec::new();
    for [a, b] in [
        [1.0, golden],
        [-1.0, golden],
        [1.0, -golden],
        [-1.0, -golden],
    ] {
        points.extend([
            DVec3::new(0.0, a, b),
            DVec3::new(a, b, 0.0),
            DVec3::new(b, 0.0, a),
        ]);
    }
    let edges = (0..12).flat_map(|i| (0..i).map(move |j| [i, j]));
    let corners = points.clone();
    let short = edges.filter(|&[i, j]| corners[i].distance(corners[j]) < 2.1);
    points.extend(short.map(|[i, j]| corners[i].midpoint(corners[j])));
    let mut points: Vec<DVec3> = points.into_iter().map(DVec3::normalize).collect();
    points.push(DVec3::new(0.88, 0.02, 0.03));
    let given = Subcomplex3::of(&Delaunay3::build(&points).unwrap(), |_| true);
    let method = Method::Economical(Coarsening::None);
    let smooth = Boundary::Split { crease: 40.0 };
    let outcome = refine3(given.clone(), &params(1.2, method, smooth), &mut silent).unwrap();
    check_solid(&given, &outcome).unwrap();
    assert!(outcome.counters.split > 2);
    assert!(volume(&outcome.solid) > volume(&given));
    let solid = &outcome.solid;
    let lowest = solid
        .boundary()
        .flat_map(|f| solid.mesh().facet_vertices(f));
    let heights = lowest.map(|v| (solid.point(v).length() - 1.0).abs());
    // The middles of the triangles are 0.06 below the sphere.
    let highest = heights.fold(0.0, f64::max);
    assert!(highest < 0.015, "{highest}");
}

/// Turns, patches and shares are measured where doubles do not run out.
#[test]
fn the_unit_of_length_does_not_matter() {
    let corner = |i: usize| DVec3::new((i & 1) as f64, (i >> 1 & 1) as f64, 0.2 * (i >> 2) as f64);
    let refined = |unit: f64| {
        let slab: Vec<DVec3> = (0..8).map(|i| corner(i) * unit).collect();
        let slab = Subcomplex3::of(&Delaunay3::build(&slab).unwrap(), |_| true);
        let params = params(2.0, Method::Economical(Coarsening::Merging), SMOOTH);
        let field = |_| 0.15 * unit;
        let sizing = Sizing3 {
            field: Some(&field),
            ..Sizing3::default()
        };
        let outcome = refine3_sized(slab.clone(), &params, &sizing, &mut silent).unwrap();
        check_solid(&slab, &outcome).unwrap();
        (outcome.stop, outcome.counters, outcome.solid.tets().count())
    };
    let usual = refined(1.0);
    assert_eq!(usual.0, Stop::AllGood);
    for unit in [2.0_f64.powi(-130), 2.0_f64.powi(160)] {
        assert_eq!(refined(unit), usual);
    }
}

#[test]
fn a_small_angle_of_the_boundary_ends_it() {
    let wedge = [[0.0, 0.0], [8.0, 0.0], [8.0, 0.3]].map(DVec2::from);
    let given = Subcomplex2::of(&Delaunay2::build(&wedge).unwrap(), |_| true);
    for method in methods() {
        let outcome = refine2(given.clone(), &params(1.0, method, FLAT), &mut silent).unwrap();
        check_region(&given, &outcome).unwrap();
        assert_eq!(outcome.stop, Stop::NothingToInsert);
        assert!(
            (1..20).contains(&outcome.low.len()),
            "{}",
            outcome.low.len()
        );
    }
    let wedge = [
        [0.0, 0.0, 0.0],
        [0.0, 4.0, 0.0],
        [8.0, 0.0, 0.0],
        [8.0, 4.0, 0.0],
        [8.0, 0.0, 0.4],
        [8.0, 4.0, 0.4],
    ];
    let given = Subcomplex3::of(&Delaunay3::build(&wedge.map(DVec3::from)).unwrap(), |_| {
        true
    });
    for method in methods() {
        let outcome = refine3(given.clone(), &params(2.0, method, FLAT), &mut silent).unwrap();
        check_solid(&given, &outcome).unwrap();
        assert!((volume(&outcome.solid) / volume(&given) - 1.0).abs() < 1e-12);
    }
}

#[test]
fn a_budget_or_a_cancellation_leaves_a_valid_mesh() {
    let usa = usa();
    let sinks = Method::Paper {
        candidate: Candidate::Sink,
        schedule: Schedule::Incremental,
    };
    let whole = refine2(usa.clone(), &params(1.0, sinks, FLAT), &mut silent).unwrap();
    let budget = Params {
        max_new_vertices: whole.counters.inserted - 3,
        ..params(1.0, sinks, FLAT)
    };
    let outcome = refine2(usa.clone(), &budget, &mut silent).unwrap();
    check_region(&usa, &outcome).unwrap();
    assert_eq!(outcome.stop, Stop::OutOfVertices);
    assert!(outcome.counters.split > 0);

    let star = solid(surfaces::star());
    let mut reports = 0;
    let mut stop = |_: Progress| {
        reports += 1;
        match reports {
            1 => ControlFlow::Continue(()),
            _ => ControlFlow::Break(()),
        }
    };
    let outcome = refine3(star.clone(), &params(2.0, sinks, FLAT), &mut stop).unwrap();
    check_solid(&star, &outcome).unwrap();
    assert!(matches!(outcome.stop, Stop::Cancelled(_)));
}

#[test]
fn crease_angles_that_are_none_are_refused() {
    let given = wheel(8);
    for crease in [-1.0, 181.0, f64::NAN, f64::INFINITY] {
        let params = params(
            1.0,
            Method::Economical(Coarsening::None),
            Boundary::Split { crease },
        );
        assert!(refine2(given.clone(), &params, &mut silent).is_err());
    }
    let params = params(
        1.0,
        Method::Economical(Coarsening::None),
        Boundary::Split { crease: -1.0 },
    );
    let error = refine2(given, &params, &mut silent).unwrap_err();
    insta::assert_snapshot!(error, @"the crease angle -1 is not a number of degrees from 0 to 180");
}

#[test]
fn elements_become_as_small_as_asked_for_when_the_boundary_may_be_divided() {
    let square = [DVec2::ZERO, DVec2::X, DVec2::ONE, DVec2::Y];
    let square = Subcomplex2::of(&Delaunay2::build(&square).unwrap(), |_| true);
    let field = |p: DVec2| 0.02 + 0.2 * p.length();
    let sizing = Sizing2 {
        field: Some(&field),
        ..Sizing2::default()
    };
    for method in methods() {
        let params = params(1.0, method, FLAT);
        let outcome = refine2_sized(square.clone(), &params, &sizing, &mut silent).unwrap();
        check_region(&square, &outcome).unwrap();
        assert_eq!(outcome.stop, Stop::AllGood, "{method:?}");
        assert!((area(&outcome.region) - 1.0).abs() < 1e-12);
    }
    let corner = |i: usize| DVec3::new((i & 1) as f64, (i >> 1 & 1) as f64, (i >> 2) as f64);
    let cube: Vec<DVec3> = (0..8).map(corner).collect();
    let cube = Subcomplex3::of(&Delaunay3::build(&cube).unwrap(), |_| true);
    let field = |p: DVec3| 0.1 + 0.3 * p.length();
    let sizing = Sizing3 {
        field: Some(&field),
        ..Sizing3::default()
    };
    for method in methods() {
        let params = params(2.0, method, FLAT);
        let outcome = refine3_sized(cube.clone(), &params, &sizing, &mut silent).unwrap();
        check_solid(&cube, &outcome).unwrap();
        assert!((volume(&outcome.solid) - 1.0).abs() < 1e-12);
    }
}

proptest! {
    #![proptest_config(ProptestConfig {
        cases: 24,
        failure_persistence: None,
        ..ProptestConfig::default()
    })]

    /// Stars with jagged outlines, holes in their middle.
    #[test]
    fn every_region_stays_valid(
        radii in prop::collection::vec(1.0_f64..4.0, 5..40),
        crease in prop_oneof![Just(0.0), 0.0_f64..180.0],
        pick in 0_usize..9,
    ) {
        let count = radii.len();
        let place = |i: usize| DVec2::from_angle(TAU * i as f64 / count as f64);
        let mut points: Vec<DVec2> = radii.iter().enumerate().map(|(i, r)| place(i) * *r).collect();
        points.extend((0..count).map(|i| place(i) * 0.5));
        let delaunay = Delaunay2::build(&points).unwrap();
        let is_ring = |f| {
            let corners = delaunay.mesh().face_vertices(f);
            corners.iter().any(|v| v.index() < count)
        };
        let given = Subcomplex2::of(&delaunay, is_ring);
        let method = methods().nth(pick).unwrap();
        let outcome = refine2(given.clone(), &params(1.0, method, Boundary::Split { crease }), &mut silent).unwrap();
        check_region(&given, &outcome)?;
        if crease == 0.0 {
            prop_assert!((area(&outcome.region) / area(&given) - 1.0).abs() < 1e-9);
        }
    }

    /// Parts of the triangulations of random points.
    #[test]
    fn every_solid_stays_valid(
        places in prop::collection::vec([-9_i32..=9, -9..=9, -9..=9], 8..30),
        within in any::<u64>(),
        crease in prop_oneof![Just(0.0), 0.0_f64..180.0],
        pick in 0_usize..8,
    ) {
        let points: Vec<DVec3> = places.iter().map(|p| DVec3::from(p.map(f64::from))).collect();
        let Ok(delaunay) = Delaunay3::build(&points) else { return Ok(()) };
        let given = Subcomplex3::of(&delaunay, |t| within >> (t.index() % 64) & 1 == 1 || t.index() % 3 > 0);
        let method = methods().nth(pick).unwrap();
        let params = params(2.0, method, Boundary::Split { crease });
        let outcome = refine3(given.clone(), &params, &mut silent).unwrap();
        let solid = &outcome.solid;
        // Where parts lie apart, outside has several surfaces, which the check does not know.
        if given.mesh().check() == Ok(()) {
            prop_assert_eq!(solid.mesh().check(), Ok(()));
        }
        for t in solid.tets() {
            let [a, b, c, d] = solid.tetrahedron(t);
            prop_assert_eq!(orient3d(a, b, c, d), Sign::Positive);
        }
        if crease == 0.0 && volume(&given) > 0.0 {
            prop_assert!((volume(solid) / volume(&given) - 1.0).abs() < 1e-9);
        }
    }
}
