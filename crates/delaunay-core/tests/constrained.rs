//! Constrained triangulations: invariants on random input, hard cases, errors.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

use delaunay_core::geo_predicates::{Sign, orient2d};
use delaunay_core::progress::silent;
use delaunay_core::{
    BuildError, BuildOptions, Cavity, ConstrainError, Constrained2, Crossings, HalfEdgeId,
    VertexId, segments_cross,
};
use glam::DVec2;
use proptest::prelude::*;
use std::collections::BTreeSet;
use std::ops::ControlFlow;

fn ids(segments: &[[usize; 2]]) -> Vec<[VertexId; 2]> {
    let named = segments.iter().map(|ends| ends.map(VertexId::new));
    named.collect()
}

fn build(points: &[DVec2], segments: &[[usize; 2]]) -> Result<Constrained2, ConstrainError> {
    build_with(points, segments, Crossings::Refuse)
}

fn build_with(
    points: &[DVec2],
    segments: &[[usize; 2]],
    crossings: Crossings,
) -> Result<Constrained2, ConstrainError> {
    let options = BuildOptions::default();
    Constrained2::build(points, &ids(segments), crossings, options, &mut silent)
}

/// Checks the triangulation, that each segment is a chain of constrained edges along the straight way, and that there are no
/// other constrained edges.
fn check(constrained: &Constrained2, segments: &[[usize; 2]]) {
    assert_eq!(constrained.check(), Ok(()));
    let mut on_chains = BTreeSet::new();
    for ends in ids(segments) {
        let chain = constrained.chain(ends).unwrap();
        let mesh = constrained.mesh();
        for pair in chain.windows(2) {
            let h = mesh.find_half_edge(pair[0], pair[1]).unwrap();
            assert!(constrained.is_constrained(h), "{ends:?} at {pair:?}");
            on_chains.insert(h.min(mesh.twin(h)));
        }
        let [start, end] = ends.map(|v| constrained.point(v));
        let along = (end - start).normalize();
        for &v in &chain {
            let off = along.perp_dot(constrained.point(v) - start).abs();
            assert!(
                off <= 1e-9 * (1.0 + start.length()),
                "{v} is {off} off {ends:?}"
            );
        }
    }
    assert!(constrained.constrained_edges().eq(on_chains));
}

/// Points near each other, on a coarse grid, or anywhere in the unit square.
fn points(most: usize) -> impl Strategy<Value = Vec<DVec2>> {
    let coordinate = || {
        prop_oneof![
            (0..8i32).prop_map(|k| f64::from(k) / 8.0),
            (0..8i32).prop_map(|k| f64::from(k) / 8.0),
            0.0..1.0f64,
        ]
    };
    let point = (coordinate(), coordinate()).prop_map(|(x, y)| DVec2::new(x, y));
    prop::collection::vec(point, 3..most)
}

/// The segments that do not cross those before them: where they meet, if anywhere, a point is.
fn without_crossings(points: &[DVec2], segments: &[[usize; 2]]) -> Vec<[usize; 2]> {
    let mut kept: Vec<[usize; 2]> = Vec::new();
    for ends in segments.iter().map(|ends| ends.map(|v| v % points.len())) {
        let segment = ends.map(|v| points[v]);
        let apart = |other: &[usize; 2]| {
            let other = other.map(|v| points[v]);
            let meet_at = |&p: &DVec2| is_on(p, segment) && is_on(p, other);
            !segments_cross(segment, other) || points.iter().any(meet_at)
        };
        if segment[0] != segment[1] && kept.iter().all(apart) {
            kept.push(ends);
        }
    }
    kept
}

/// Checks that the segments that an error names cross where it says.
fn check_crossings(error: &ConstrainError, points: &[DVec2], segments: &[[usize; 2]]) {
    let ConstrainError::Crossing { crossings } = error else {
        panic!("{error}");
    };
    for crossing in crossings {
        let pair = crossing.segments.map(|s| segments[s].map(|v| points[v]));
        assert!(segments_cross(pair[0], pair[1]), "{crossing:?}");
        for [a, b] in pair {
            let off = (b - a).normalize().perp_dot(crossing.place - a).abs();
            assert!(off <= 1e-9, "{crossing:?} is {off} off");
        }
    }
}

fn is_on(p: DVec2, [a, b]: [DVec2; 2]) -> bool {
    orient2d(a, b, p) == Sign::Zero && p.clamp(a.min(b), a.max(b)) == p
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn segments_that_do_not_cross_become_edges_in_any_order(
        points in points(60),
        segments in prop::collection::vec([0..60usize, 0..60], 0..40),
        turn in 0..40usize,
    ) {
        let mut segments = without_crossings(&points, &segments);
        let constrained = match build(&points, &segments) {
            Ok(constrained) => constrained,
            Err(ConstrainError::Build(_)) => return Ok(()),
            Err(error) => panic!("{error}"),
        };
        check(&constrained, &segments);
        if !segments.is_empty() {
            let turn = turn % segments.len();
            segments.rotate_left(turn);
            segments.reverse();
            let again = build(&points, &segments).unwrap();
            prop_assert_eq!(again.mesh().canonical(), constrained.mesh().canonical());
        }
    }

    #[test]
    fn segments_that_cross_are_divided_or_refused(
        points in points(30),
        segments in prop::collection::vec([0..30usize, 0..30], 0..30),
    ) {
        let count = points.len();
        let segments: Vec<[usize; 2]> = segments.iter()
            .map(|ends| ends.map(|v| v % count))
            .filter(|&[a, b]| points[a] != points[b])
            .collect();
        let constrained = match build_with(&points, &segments, Crossings::Divide { at_most: 100_000 }) {
            Ok(constrained) => constrained,
            Err(ConstrainError::Build(_)) => return Ok(()),
            Err(error) => panic!("{error}"),
        };
        check(&constrained, &segments);
        let cross = without_crossings(&points, &segments).len() < segments.len();
        let refused = build(&points, &segments);
        prop_assert_eq!(refused.is_err(), cross);
        if let Err(error) = refused {
            check_crossings(&error, &points, &segments);
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn what_is_cut_along_segments_is_sound_and_takes_points(
        points in points(40),
        segments in prop::collection::vec([0..40usize, 0..40], 0..30),
    ) {
        let segments = without_crossings(&points, &segments);
        let Ok(constrained) = build(&points, &segments) else { return Ok(()) };
        let mut cut = constrained.subcomplex(|_| true);
        prop_assert_eq!(cut.check(), Ok(()));
        let edges = constrained.constrained_edges();
        let on_hull = |h: &HalfEdgeId| {
            let mesh = constrained.mesh();
            mesh.is_ghost_face(h.face()) || mesh.is_ghost_face(mesh.twin(*h).face())
        };
        let inner = edges.filter(|h| !on_hull(h)).count();
        let hull = constrained.mesh().star(VertexId::GHOST).count();
        prop_assert_eq!(cut.boundary().count(), hull + 2 * inner);
        let mut cavity = Cavity::default();
        for f in cut.faces().collect::<Vec<_>>() {
            let center = cut.triangle(f).into_iter().sum::<DVec2>() / 3.0;
            if cut.dig(center, f, &mut cavity) {
                cut.fill(center, &mut cavity).unwrap();
                prop_assert_eq!(cut.check(), Ok(()));
            }
        }
        prop_assert_eq!(cut.boundary().count(), hull + 2 * inner);
    }
}

/// Points of a unit square, from a short multiplicative generator.
fn scattered(count: usize) -> Vec<DVec2> {
    let mut state = 12_345u64;
    let mut next = || {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1u64 << 53) as f64
    };
    (0..count).map(|_| DVec2::new(next(), next())).collect()
}

#[test]
fn one_segment_through_many_triangles() {
    let mut points = scattered(40_000);
    let count = points.len();
    points.extend([DVec2::new(-1.0, 0.31), DVec2::new(2.0, 0.67)]);
    let segments = [[count, count + 1]];
    let constrained = build(&points, &segments).unwrap();
    check(&constrained, &segments);
    assert_eq!(constrained.constrained_edges().count(), 1);
}

#[test]
fn segments_through_all_vertices_of_a_lattice() {
    let points: Vec<DVec2> = (0..400)
        .map(|i| DVec2::new(f64::from(i % 20), f64::from(i / 20)))
        .collect();
    let segments = [[0, 399], [19, 380], [0, 19], [20, 39], [200, 219]];
    let constrained = build_with(&points, &segments, Crossings::Divide { at_most: 9 }).unwrap();
    check(&constrained, &segments);
    let lengths = ids(&segments)
        .into_iter()
        .map(|ends| constrained.chain(ends).unwrap().len());
    // The diagonals meet in the middle of a square, where no vertex was.
    assert_eq!(lengths.collect::<Vec<_>>(), [21, 21, 20, 20, 20]);
    assert_eq!(constrained.points().len(), 401);
}

#[test]
fn segments_over_each_other_are_divided_together() {
    // On a coarse lattice many segments overlap, and most meet where no vertex is and rounding leads off them.
    let side = 6;
    let places = (0..side * side).map(|i| DVec2::new((i % side) as f64, (i / side) as f64));
    let points: Vec<DVec2> = places.collect();
    let random = scattered(60);
    let ends = random.iter().map(|p| {
        let [a, b] = p.to_array();
        [a, b].map(|share| (share * points.len() as f64) as usize)
    });
    let segments: Vec<[usize; 2]> = ends.filter(|[a, b]| a != b).collect();
    for count in 1..=segments.len() {
        let segments = &segments[..count];
        let divided = build_with(&points, segments, Crossings::Divide { at_most: 5000 });
        check(&divided.unwrap(), segments);
    }
}

#[test]
fn what_is_refused_and_what_is_divided_does_not_depend_on_threads() {
    let points = scattered(20_000);
    let near = |i: usize| {
        points
            .iter()
            .position(|p| *p != points[i] && p.distance(points[i]) < 0.05)
    };
    let segments: Vec<[usize; 2]> = (0..2000).filter_map(|i| Some([i, near(i)?])).collect();
    let on_threads = |threads, crossings| {
        let options = BuildOptions::on_threads(threads);
        Constrained2::build(&points, &ids(&segments), crossings, options, &mut silent)
    };
    let refused = [1, 2, 3].map(|threads| on_threads(threads, Crossings::Refuse).unwrap_err());
    check_crossings(&refused[0], &points, &segments);
    assert_eq!(refused[0], refused[1]);
    assert_eq!(refused[0], refused[2]);
    let divide = Crossings::Divide { at_most: 100_000 };
    let divided = [1, 2, 3].map(|threads| on_threads(threads, divide).unwrap());
    check(&divided[0], &segments);
    for other in &divided[1..] {
        assert_eq!(divided[0].points(), other.points());
        assert_eq!(divided[0].mesh().canonical(), other.mesh().canonical());
    }
}

#[test]
fn segments_that_have_been_bent_still_meet_in_one_vertex() {
    // Three of them go through (2, 5), which the second one misses by a rounding once it has been divided before it.
    let points = [
        [0.0, 2.0],
        [1.0, 6.0],
        [0.0, 6.0],
        [6.0, 3.0],
        [2.0, 0.0],
        [6.0, 4.0],
        [1.0, 1.0],
        [5.0, 2.0],
        [2.0, 5.0],
        [5.0, 4.0],
        [5.0, 3.0],
        [3.0, 4.0],
    ]
    .map(DVec2::from);
    let segments = [[0, 1], [2, 3], [4, 5], [6, 3], [1, 7], [8, 9]];
    let divided = build_with(&points, &segments, Crossings::Divide { at_most: 20 }).unwrap();
    check(&divided, &segments);
    let through = VertexId::new(8);
    for ends in [[2, 3], [1, 7]] {
        let chain = divided.chain(ends.map(VertexId::new)).unwrap();
        assert!(chain.contains(&through), "{chain:?}");
    }
}

#[test]
fn divisions_can_be_stopped() {
    // A few segments, and thousands of places where they cross.
    let lines = 70;
    let ends = (0..lines).flat_map(|i| {
        let at = f64::from(i) + 0.5;
        let far = f64::from(lines);
        [[0.0, at], [far, at], [at, 0.0], [at, far]].map(DVec2::from)
    });
    let points: Vec<DVec2> = ends.collect();
    let segments: Vec<[usize; 2]> = (0..points.len() / 2).map(|i| [2 * i, 2 * i + 1]).collect();
    let mut reports = Vec::new();
    let stopped = Constrained2::build(
        &points,
        &ids(&segments),
        Crossings::Divide { at_most: 10_000 },
        BuildOptions::default(),
        &mut |progress| {
            assert!(progress.done <= progress.total);
            reports.push((progress.stage, progress.done));
            match progress.done {
                0 => ControlFlow::Continue(()),
                _ => ControlFlow::Break(()),
            }
        },
    );
    assert!(matches!(
        stopped,
        Err(ConstrainError::Build(BuildError::Cancelled(_)))
    ));
    assert_eq!(reports.last(), Some(&("divide segments", 4096)));
}

#[test]
fn any_number_of_a_segment_and_any_seed_get_an_answer() {
    let points = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]].map(DVec2::from);
    let mut square = build(&points, &[]).unwrap();
    let sides = [[0, 1], [1, 2], [2, 3], [3, 0]];
    for (ends, number) in ids(&sides)
        .into_iter()
        .zip([7, u32::MAX as usize, usize::MAX, 0])
    {
        square.add_segment(number, ends).unwrap();
    }
    check(&square, &sides);
    let on = |ends: [usize; 2]| {
        let [a, b] = ends.map(VertexId::new);
        square.segment_of(square.mesh().find_half_edge(a, b).unwrap())
    };
    let most = u32::MAX as usize - 1;
    assert_eq!(sides.map(on), [7, most, most, 0].map(Some));
    let components = square.components(&mut silent).unwrap();
    let seeds = [DVec2::ONE, DVec2::new(f64::NAN, 1.0)];
    let error = square.parts_at(&components, &seeds).unwrap_err();
    assert!(
        error.to_string().starts_with("point 1 has x = NaN"),
        "{error}"
    );
}

#[test]
fn the_teeth_of_a_comb_are_crossed_at_once() {
    // The comb's spine hides all teeth from each other but along the base.
    let teeth = 3000;
    let mut points = vec![
        DVec2::new(-1.0, -1.0),
        DVec2::new(f64::from(teeth) + 1.0, -1.0),
    ];
    for tooth in 0..teeth {
        let x = f64::from(tooth);
        points.extend([
            DVec2::new(x, 0.0),
            DVec2::new(x + 0.5, 40.0 + f64::from(tooth % 7)),
        ]);
    }
    let walls: Vec<[usize; 2]> = (2..points.len() - 1).map(|i| [i, i + 1]).collect();
    let with_base = [walls.as_slice(), &[[0, 1]]].concat();
    let constrained = build(&points, &with_base).unwrap();
    check(&constrained, &with_base);
}

#[test]
fn a_vertex_with_many_segments() {
    let spokes = 1000;
    let rim = |i: i32| {
        let t = f64::from(i) / f64::from(spokes) * 4.0 - 2.0;
        DVec2::new(1.0 - t * t, 2.0 * t) / (1.0 + t * t)
    };
    let mut points: Vec<DVec2> = (0..spokes).map(rim).collect();
    points.push(DVec2::new(0.1, 0.2));
    points.extend(scattered(3000).iter().map(|p| *p * 0.2));
    let hub = spokes as usize;
    let segments: Vec<[usize; 2]> = (0..hub).map(|i| [hub, i]).collect();
    let divided = build_with(&points, &segments, Crossings::Divide { at_most: 0 }).unwrap();
    check(&divided, &segments);
}

#[test]
fn segments_on_the_hull_and_beyond_each_other() {
    let points = [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [3.0, 0.0], [1.0, 2.0]].map(DVec2::from);
    let segments = [[0, 2], [1, 3], [3, 0], [2, 0]];
    let constrained = build(&points, &segments).unwrap();
    check(&constrained, &segments);
    assert_eq!(constrained.constrained_edges().count(), 3);
    let first = constrained
        .mesh()
        .find_half_edge(VertexId::new(1), VertexId::new(2));
    assert_eq!(constrained.segment_of(first.unwrap()), Some(0));
}

#[test]
fn defects_are_named() {
    let points = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0], [4.0, 0.0]].map(DVec2::from);
    let error = |segments: &[[usize; 2]]| build(&points, segments).unwrap_err().to_string();
    insta::assert_snapshot!(error(&[[0, 1], [1, 9]]), @"segment 1 ends at v9, but there are 5 points");
    insta::assert_snapshot!(error(&[[2, 2]]), @"segment 0 from v2 to v2 has no length");
    insta::assert_snapshot!(error(&[[0, 2], [4, 1]]), @"segment 1 from v4 to v1 has no length");
    insta::assert_snapshot!(error(&[[0, 2], [4, 3]]), @"segments 0 and 1 cross near (2, 2)");
    let divided = build_with(&points, &[[0, 2], [4, 3]], Crossings::Divide { at_most: 0 });
    insta::assert_snapshot!(divided.unwrap_err(), @"segments cross in more than the 0 places allowed");
}

#[test]
fn the_segments_that_an_error_names_cross() {
    // Segments laid after one that is refused give new numbers to the edges in its way.
    let points = [
        [4.0, 2.0],
        [1.0, 2.0],
        [3.0, 2.0],
        [0.0, 4.0],
        [4.0, 1.0],
        [4.0, 0.0],
        [3.0, 3.0],
        [0.0, 1.0],
    ]
    .map(DVec2::from);
    let segments = [
        [0, 1],
        [6, 7],
        [7, 1],
        [1, 2],
        [2, 7],
        [3, 5],
        [3, 2],
        [6, 5],
        [5, 4],
        [0, 6],
        [3, 4],
    ];
    let error = build(&points, &segments).unwrap_err();
    check_crossings(&error, &points, &segments);
}

#[test]
fn parts_are_told_apart_by_depth_and_by_seeds() {
    // A square, a square inside it, one inside that, a wall across the middle one and a loose segment.
    let square = |s: f64| [[-s, -s], [s, -s], [s, s], [-s, s]];
    let mut points = [square(8.0), square(4.0), square(2.0)].concat();
    points.extend([[6.0, 6.0], [7.0, 6.0]]);
    let points: Vec<DVec2> = points.into_iter().map(DVec2::from).collect();
    let loops = (0..12).map(|i| [i, if i % 4 == 3 { i - 3 } else { i + 1 }]);
    let segments: Vec<[usize; 2]> = loops.chain([[4, 8], [6, 10], [12, 13]]).collect();
    let constrained = build(&points, &segments).unwrap();
    check(&constrained, &segments);
    let components = constrained.components(&mut silent).unwrap();
    // The outside, the ring, the two halves of the next ring, the middle.
    let depths: Vec<usize> = (0..components.count())
        .map(|part| components.depth(part))
        .collect();
    assert_eq!(depths, [0, 1, 2, 2, 3]);
    let part = |x: f64, y: f64| constrained.parts_at(&components, &[DVec2::new(x, y)]);
    assert_eq!(part(7.0, 0.0).unwrap(), [1]);
    assert_eq!(
        part(6.5, 6.0).unwrap_err().to_string(),
        "seed 0 at (6.5, 6) is on segment 14"
    );
    assert_eq!(part(0.0, 0.0).unwrap(), [4]);
    assert_ne!(part(3.0, 0.0).unwrap(), part(0.0, 3.0).unwrap());
    assert_eq!(
        part(8.0, 8.0).unwrap_err().to_string(),
        "seed 0 at (8, 8) is on segment 1"
    );
    assert_eq!(
        part(9.0, 0.0).unwrap_err().to_string(),
        "seed 0 at (9, 0) is outside"
    );
    let odd: f64 = constrained
        .faces()
        .filter(|&f| components.is_odd(f))
        .map(|f| {
            let [a, b, c] = constrained.triangle(f);
            (b - a).perp_dot(c - a) / 2.0
        })
        .sum();
    assert_eq!(odd, 256.0 - 64.0 + 16.0);
}
