//! What the module promises, tested on curves of all kinds.

use std::f64::consts::{PI, TAU};

use delaunay_core::VertexId;
use glam::DVec2;
use proptest::prelude::*;

use super::sample::{sample, sample_all};
use super::track::{Sizes, Track};
use super::{Curve, Piece, Sampled, Sampling, SamplingError};

/// An edge, by arc lengths of its curve.
#[derive(Clone, Copy, Debug)]
struct Edge {
    curve: usize,
    arcs: [f64; 2],
    ends: [DVec2; 2],
    /// The place in the middle of the arc.
    middle: DVec2,
}

impl Edge {
    fn length(&self) -> f64 {
        self.arcs[1] - self.arcs[0]
    }
}

fn edges(curves: &[Curve], sampled: &Sampled) -> Vec<Edge> {
    let traces: Vec<_> = curves.iter().map(trace).collect();
    let segments = sampled.segments.iter().zip(&sampled.curve_of);
    let edge = |(ends, &curve): (&[VertexId; 2], &usize)| {
        let [start, end] = ends.map(|v| sampled.arc_of[v.index()]);
        let end = if end > start {
            end
        } else {
            curves[curve].length()
        };
        Edge {
            curve,
            arcs: [start, end],
            ends: ends.map(|v| sampled.points[v.index()]),
            middle: along(&traces[curve], start.midpoint(end)),
        }
    };
    segments.map(edge).collect()
}

/// Arc lengths and places along a curve, very many.
fn trace(curve: &Curve) -> Vec<(f64, DVec2)> {
    let track = Track::of(curve, &Sampling::new(curve.length()), Sizes::Free);
    let mut arc = 0.0;
    let mut traced = Vec::new();
    for interval in &track.intervals {
        let at = |k: u32| interval.from + (interval.to - interval.from) * f64::from(k) / 200.0;
        for k in 0..200 {
            traced.push((arc, interval.stretch.point(at(k))));
            arc += interval.stretch.length(at(k), at(k + 1));
        }
    }
    traced
}

/// The place at an arc length.
fn along(trace: &[(f64, DVec2)], arc: f64) -> DVec2 {
    let after = trace
        .partition_point(|&(at, _)| at < arc)
        .clamp(1, trace.len() - 1);
    let [(a, p), (b, q)] = [trace[after - 1], trace[after]];
    p.lerp(q, (arc - a) / (b - a))
}

fn distance(place: DVec2, [a, b]: [DVec2; 2]) -> f64 {
    let part = (place - a).dot(b - a) / (b - a).length_squared();
    place.distance(a.lerp(b, part.clamp(0.0, 1.0)))
}

/// What is promised of every edge.
fn check_edges(curves: &[Curve], sampling: &Sampling, edges: &[Edge]) -> Result<(), TestCaseError> {
    let traces: Vec<_> = curves.iter().map(trace).collect();
    for edge in edges {
        prop_assert!(edge.length() <= sampling.size * (1.0 + 1e-8), "{edge:?}");
        let trace = &traces[edge.curve];
        let start = trace.partition_point(|&(arc, _)| arc < edge.arcs[0]);
        let inside = trace[start..]
            .iter()
            .take_while(|&&(arc, _)| arc <= edge.arcs[1]);
        let stray = inside
            .map(|&(_, place)| distance(place, edge.ends))
            .fold(0.0, f64::max);
        prop_assert!(
            stray <= sampling.chord * (1.0 + 1e-6),
            "{edge:?} strays by {stray}"
        );
    }
    Ok(())
}

/// What is promised of neighbours.
fn check_neighbours(
    curves: &[Curve],
    sampling: &Sampling,
    edges: &[Edge],
) -> Result<(), TestCaseError> {
    let grade = sampling.grade;
    let joint = grade.exp_m1() / -(-0.5 * grade).exp_m1();
    for (c, curve) in curves.iter().enumerate() {
        let own: Vec<&Edge> = edges.iter().filter(|edge| edge.curve == c).collect();
        let least = 1 + 2 * usize::from(curve.is_closed());
        prop_assert!(own.len() >= least);
        let corners: Vec<DVec2> = curve.pieces().iter().map(|piece| piece.ends()[0]).collect();
        for corner in &corners {
            prop_assert!(own.iter().any(|edge| edge.ends[0] == *corner));
        }
        for pair in 0..own.len() - usize::from(!curve.is_closed()) {
            let [a, b] = [own[pair], own[(pair + 1) % own.len()]];
            prop_assert_eq!(a.ends[1], b.ends[0]);
            let bound = if corners.contains(&b.ends[0]) {
                joint
            } else {
                grade.exp()
            };
            let ratio = (a.length() / b.length()).max(b.length() / a.length());
            prop_assert!(ratio <= bound * (1.0 + 1e-7), "{ratio} of {a:?} and {b:?}");
        }
    }
    Ok(())
}

/// An edge is long between 0.9 of the least and all of the greatest that a size in its middle permits.
fn check_gaps(sampling: &Sampling, edges: &[Edge]) -> Result<(), TestCaseError> {
    let half = 0.5 * sampling.grade;
    let (greatest, least) = (half.exp_m1() / half, 0.9 * -(-half).exp_m1() / half);
    for coarse in edges {
        for fine in edges {
            let gap = coarse.middle.distance(fine.middle);
            let excess = coarse.length() / greatest - fine.length() / least;
            // Places in the middle are nearly exact.
            let permitted = sampling.grade * gap + 1e-3 * sampling.size;
            prop_assert!(
                excess <= permitted,
                "{coarse:?} beside {fine:?}: {excess} over {gap}"
            );
        }
    }
    Ok(())
}

fn check(curves: &[Curve], sampling: &Sampling) -> Result<Sampled, TestCaseError> {
    let sampled = sample_all(curves, sampling).expect("enough nodes");
    let edges = edges(curves, &sampled);
    check_edges(curves, sampling, &edges)?;
    check_neighbours(curves, sampling, &edges)?;
    check_gaps(sampling, &edges)?;
    prop_assert_eq!(&sample_all(curves, sampling).expect("again"), &sampled);
    Ok(sampled)
}

/// Points round a center, at even angles.
fn star(center: DVec2, radii: &[f64]) -> Vec<DVec2> {
    let step = TAU / radii.len() as f64;
    let place = |(i, &r): (usize, &f64)| center + r * DVec2::from_angle(i as f64 * step);
    radii.iter().enumerate().map(place).collect()
}

fn samplings() -> impl Strategy<Value = Sampling> {
    (0.05..1.0f64, 0.002..0.3f64, 0.1..0.6f64).prop_map(|(size, chord, grade)| Sampling {
        size,
        chord: chord * size,
        grade,
        at_most: 1_000_000,
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn splines_and_holes_keep_all_promises(
        outer in prop::collection::vec(1.0..2.0f64, 4..12),
        holes in prop::collection::vec((-0.5..0.5f64, -0.5..0.5f64, 0.02..0.3f64), 0..3),
        sampling in samplings(),
    ) {
        let mut curves = vec![Curve::closed_spline(&star(DVec2::ZERO, &outer)).expect("a spline")];
        for &(x, y, r) in &holes {
            curves.push(Curve::ellipse(DVec2::new(x, y), [r, 0.5 * r], 10.0 * x).expect("an ellipse"));
        }
        check(&curves, &sampling)?;
    }

    #[test]
    fn chains_keep_all_promises(
        places in prop::collection::vec((0.0..1.0f64, 0.0..1.0f64), 3..8),
        kinds in prop::collection::vec(0..4usize, 8),
        is_closed: bool,
        sampling in samplings(),
    ) {
        let points: Vec<DVec2> = places.iter().enumerate().map(|(i, &(x, y))| DVec2::new(x + i as f64, y)).collect();
        let piece = |i: usize| {
            let [a, b] = [points[i], points[(i + 1) % points.len()]];
            let [c, d] = [0.3, 0.7].map(|t| a.lerp(b, t) + DVec2::new(-0.4, 0.5 - t));
            match kinds[i] {
                0 => Piece::line(a, b),
                1 => Piece::arc_through(a, a.lerp(b, 0.3) + 0.4 * (b - a).perp(), b),
                2 => Piece::bezier([a, c, d, b]),
                _ => Piece::spline(&[a, c, d, b]),
            }
            .expect("a piece")
        };
        let count = points.len() - usize::from(!is_closed);
        let pieces = (0..count).map(piece).collect();
        let curve = if is_closed { Curve::closed(pieces) } else { Curve::open(pieces) };
        check(&[curve.expect("pieces that meet")], &sampling)?;
    }

    #[test]
    fn a_circle_has_as_many_equal_edges_as_it_takes(radius in 0.01..10.0f64, size in 0.1..30.0f64) {
        let sampling = Sampling { chord: f64::INFINITY, ..Sampling::new(size) };
        let circle = Curve::circle(DVec2::new(3.0, -1.0), radius).expect("a circle");
        let sampled = check(&[circle], &sampling)?;
        let count = (TAU * radius / size).ceil().max(3.0);
        prop_assert_eq!(sampled.points.len() as f64, count);
        for (i, point) in sampled.points.iter().enumerate() {
            let place = DVec2::new(3.0, -1.0) + radius * DVec2::from_angle(TAU * i as f64 / count);
            prop_assert!(place.distance(*point) < 1e-11 * radius);
        }
    }
}

#[test]
fn equal_arcs_get_equal_edges() {
    let [a, b, c, d] = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]].map(DVec2::from);
    let arc = |a: DVec2, b: DVec2| Piece::arc_through(a, a.midpoint(b) - (b - a).perp() / 2.0, b);
    let pieces = [Piece::line(a, b), arc(b, c), Piece::line(c, d), arc(d, a)];
    let stadium = Curve::closed(pieces.map(Result::unwrap).to_vec()).unwrap();
    let sampled = sample(&stadium, &Sampling::new(0.15)).unwrap();
    let edges = edges(&[stadium], &sampled);
    let on_arcs: Vec<&Edge> = edges
        .iter()
        .filter(|edge| (edge.middle.x - 1.0).abs() > 1.0)
        .collect();
    assert_eq!(on_arcs.len(), 2 * (PI / 0.15).ceil() as usize);
    assert!(
        on_arcs
            .iter()
            .all(|edge| (edge.length() - on_arcs[0].length()).abs() < 1e-12)
    );
}

#[test]
fn a_cusp_takes_few_nodes() {
    let control = [
        [1.0, -1.0],
        [-1.0 / 3.0, 1.0],
        [-1.0 / 3.0, -1.0],
        [1.0, 1.0],
    ];
    let cusp = Curve::open(vec![Piece::bezier(control.map(DVec2::from)).unwrap()]).unwrap();
    let sampled = check(
        &[cusp],
        &Sampling {
            chord: 1e-3,
            ..Sampling::new(0.1)
        },
    )
    .unwrap();
    assert!(sampled.points.len() < 120, "{}", sampled.points.len());
}

/// A fine circle close to a long side that would be one edge.
#[test]
fn a_side_is_divided_where_a_fine_circle_is_near() {
    let square = Curve::polygon(&[[0.0, 0.0], [9.0, 0.0], [9.0, 9.0], [0.0, 9.0]].map(DVec2::from));
    let circle = Curve::circle(DVec2::new(4.0, 0.02), 0.01);
    let curves = [square.unwrap(), circle.unwrap()];
    let sampling = Sampling {
        chord: 1e-3,
        ..Sampling::new(3.0)
    };
    let alone = sample(&curves[0], &sampling).unwrap();
    assert_eq!(alone.points.len(), 12);
    let together = check(&curves, &sampling).unwrap();
    assert!(together.points.len() > 40);
    let near = edges(&curves, &together)
        .into_iter()
        .filter(|edge| edge.curve == 0);
    let shortest = near.map(|edge| edge.length()).fold(9.0, f64::min);
    assert!(shortest < 0.015, "{shortest}");
}

#[test]
fn open_curves_that_meet_bound_a_region_together() {
    let [a, b] = [DVec2::ZERO, DVec2::X];
    let chain =
        |piece: Result<Piece, super::CurveError>| Curve::open(vec![piece.unwrap()]).unwrap();
    let lens = [
        chain(Piece::arc_through(a, DVec2::new(0.5, 0.2), b)),
        chain(Piece::spline(&[b, DVec2::new(0.4, -0.1), a])),
    ];
    let sampled = sample_all(&lens, &Sampling::new(0.1)).unwrap();
    assert_eq!(sampled.points.len(), sampled.segments.len());
    assert!(sampled.outline().is_ok());
    assert!(
        sample(&lens[0], &Sampling::new(0.1))
            .unwrap()
            .outline()
            .is_err()
    );
}

#[test]
fn a_budget_ends_it_at_once() {
    let circle = Curve::circle(DVec2::ZERO, 1.0).unwrap();
    let sampling = |size: f64, at_most: usize| Sampling {
        at_most,
        ..Sampling::new(size)
    };
    let hundred = TAU / 100.0;
    assert_eq!(
        sample(&circle, &sampling(hundred, 100))
            .unwrap()
            .points
            .len(),
        100
    );
    for (size, at_most) in [(hundred, 99), (1e-9, 10), (1e-300, 1000), (1e-12, 100_000)] {
        let error = sample(&circle, &sampling(size, at_most)).unwrap_err();
        assert_eq!(error, SamplingError::TooManyNodes { at_most });
    }
    assert_eq!(sample_all(&[], &sampling(1.0, 0)), Ok(Sampled::default()));
}

#[test]
fn odd_curves_are_sampled_too() {
    let bezier = |control: [[f64; 2]; 4]| Piece::bezier(control.map(DVec2::from));
    let [o, x] = [[0.0, 0.0], [1.0, 0.0]];
    let pieces = [
        bezier([o, o, o, x]),
        bezier([o, o, x, x]),
        bezier([o, x, x, o]),
        bezier([o, [3.0, 0.0], [-2.0, 0.0], x]),
        bezier([o, [3.0, 1e-9], [-2.0, 0.0], x]),
        bezier([o, [1.0, 1.0], [0.0, 1.0], x]),
        Piece::spline(&[o, [1e-12, 0.0], x, [1.0, 1e-12], o].map(DVec2::from)),
        Piece::elliptic_arc(DVec2::ZERO, [1.0, 1e-9], 0.0, [0.0, TAU]),
    ];
    for piece in pieces {
        let curve = Curve::open(vec![piece.expect("a piece")]).expect("a curve");
        for size in [10.0, 0.1] {
            let sampled = sample(&curve, &Sampling::new(size)).expect("few nodes");
            assert!(sampled.points.iter().all(|p| p.is_finite()));
            assert!((1..2000).contains(&sampled.segments.len()));
        }
    }
    for radius in [1e-42, 1e-20, 1.0, 1e20, 1e60] {
        let circle = Curve::circle(DVec2::ZERO, radius).expect("a circle");
        let sampled = sample(&circle, &Sampling::new(0.1 * radius)).expect("few nodes");
        assert_eq!(sampled.points.len(), 63);
        for size in [1e-70, 1e-200] {
            assert!(sample(&circle, &Sampling::new(size)).is_err());
        }
    }
}

#[test]
fn pieces_that_do_not_meet_are_named() {
    let line = |a: [f64; 2], b: [f64; 2]| Piece::line(a.into(), b.into()).expect("a line");
    let pieces = || vec![line([0.0, 0.0], [1.0, 0.0]), line([1.0, 0.0], [1.0, 1.0])];
    assert!(Curve::open(pieces()).is_ok());
    let apart = Curve::closed(pieces()).unwrap_err().to_string();
    assert!(
        apart.starts_with("piece 0 begins at a distance of 1.414"),
        "{apart}"
    );
    let mut gap = pieces();
    gap.push(line([1.0, 1.5], [0.0, 0.0]));
    let apart = Curve::closed(gap).unwrap_err().to_string();
    assert!(
        apart.starts_with("piece 2 begins at a distance of 5e-1"),
        "{apart}"
    );
    assert!(Curve::open(Vec::new()).is_err() && Curve::polygon(&[]).is_err());
}

#[test]
fn any_number_of_threads_gives_the_same_nodes() {
    let outer = Curve::closed_spline(&star(DVec2::ZERO, &[1.0, 2.0, 1.5, 1.2, 1.9])).unwrap();
    let curves = [outer, Curve::circle(DVec2::new(0.1, 0.0), 0.3).unwrap()];
    let on = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
        pool.unwrap()
            .install(|| sample_all(&curves, &Sampling::new(0.01)))
    };
    assert_eq!(on(1), on(4));
}
