//! Small meshes of every kind, improved step by step: what stays as it is, what never falls, and how it ends.

#![allow(clippy::unwrap_used)]

use delaunay_core::geo_predicates::{Sign, orient3d};
use delaunay_core::measure::tetrahedron::{dihedral_angles, signed_volume};
use delaunay_core::progress::silent;
use delaunay_core::{Complex3, Delaunay3, Subcomplex3, TetId, VertexId};
use glam::DVec3;
use proptest::prelude::*;
use std::collections::BTreeSet;
use std::ops::ControlFlow;
use tet_improve::{ImproveError, Outcome, Params, Stop, improve};

/// A lattice of the given size whose inner vertices are shifted; the tetrahedra that `keep` keeps.
fn shaken(side: u32, shifts: &[[f64; 3]], keep: impl FnMut(TetId) -> bool) -> Complex3 {
    let mut shifts = shifts.iter().cycle();
    let mut points = Vec::new();
    for x in 0..=side {
        for y in 0..=side {
            for z in 0..=side {
                let place = [x, y, z];
                let inside = place.iter().all(|&i| 0 < i && i < side);
                let shift = shifts
                    .next()
                    .filter(|_| inside)
                    .copied()
                    .unwrap_or_default();
                points.push(DVec3::from(place.map(f64::from)) + DVec3::from(shift));
            }
        }
    }
    Complex3::from(Subcomplex3::of(&Delaunay3::build(&points).unwrap(), keep))
}

fn shift() -> impl Strategy<Value = [f64; 3]> {
    prop::array::uniform3(prop_oneof![-0.45..0.45, Just(0.0), Just(1e-9)])
}

fn boundary(solid: &Complex3) -> BTreeSet<[(VertexId, [u64; 3]); 3]> {
    let facets = solid.boundary().map(|f| {
        let corners = solid.mesh().facet_vertices(f);
        let mut corners = corners.map(|v| (v, solid.point(v).to_array().map(f64::to_bits)));
        corners.sort_unstable();
        corners
    });
    facets.collect()
}

fn volume(solid: &Complex3) -> f64 {
    let volumes = solid.tets().map(|t| signed_volume(solid.tetrahedron(t)));
    volumes.sum()
}

/// The sine of the smallest dihedral angle, or of the largest if that is smaller.
fn worst(solid: &Complex3) -> f64 {
    let angles = solid
        .tets()
        .flat_map(|t| dihedral_angles(solid.tetrahedron(t)));
    let sines = angles.map(|angle| angle.to_radians().sin());
    sines.fold(1.0, f64::min)
}

fn assert_sound(given: &Complex3, outcome: &Outcome) {
    let solid = &outcome.solid;
    for f in solid.mesh().facets() {
        let twin = solid.mesh().twin(f);
        assert!(twin != f && solid.mesh().twin(twin) == f);
    }
    for t in solid.tets() {
        let [a, b, c, d] = solid.tetrahedron(t);
        assert_eq!(orient3d(a, b, c, d), Sign::Positive);
    }
    assert_eq!(boundary(solid), boundary(given));
    assert!((volume(solid) / volume(given) - 1.0).abs() < 1e-13);
}

/// Two meshes are the same, bit for bit.
fn assert_same(a: &Complex3, b: &Complex3) {
    assert!(a.mesh() == b.mesh() && a.points() == b.points());
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(8))]

    /// The mesh after k changes is seen by stopping there: the worst quality never falls from one to the next.
    #[test]
    fn every_change_keeps_the_frame_and_the_worst_quality(
        shifts in prop::collection::vec(shift(), 64),
        keep in prop_oneof![Just(vec![true]), prop::collection::vec(prop::bool::weighted(0.95), 60)],
        goal in 15.0..30.0_f64,
    ) {
        let given = shaken(3, &shifts, |t| keep[t.index() % keep.len()]);
        let mut quality = worst(&given);
        for max_changes in (1..).step_by(3) {
            let params = Params { goal, vertices_below: goal, max_changes };
            let outcome = improve(given.clone(), &params, &mut silent).unwrap();
            assert_sound(&given, &outcome);
            let now = worst(&outcome.solid);
            prop_assert!(now >= quality * (1.0 - 1e-9), "{} {} {}", max_changes, now, quality);
            quality = now;
            prop_assert!(outcome.counters.total() <= max_changes);
            if outcome.stop != Stop::OutOfChanges {
                break;
            }
        }
    }
}

#[test]
fn improvement_is_the_same_each_time_and_at_each_size() {
    let params = Params {
        goal: 25.0,
        vertices_below: 15.0,
        ..Params::default()
    };
    // Inserted one by one, tetrahedra have the same ids at each size.
    let scattered = (1..200_u32).map(|i| DVec3::new(0.7548, 0.5698, 0.4301) * f64::from(i));
    let cube: Vec<DVec3> = (0..8_u32)
        .map(|i| DVec3::new(f64::from(i & 1), f64::from(i >> 1 & 1), f64::from(i >> 2)))
        .collect();
    let improved = |size: f64| {
        let corners = [0, 1, 2, 4].map(|i| cube[i] * size);
        let mut delaunay = Delaunay3::build(&corners).unwrap();
        for p in cube
            .iter()
            .copied()
            .chain(scattered.clone().map(DVec3::fract))
        {
            let _ = delaunay.insert(p * size).unwrap();
        }
        let given = Complex3::from(Subcomplex3::of(&delaunay, |_| true));
        improve(given, &params, &mut silent).unwrap()
    };
    let [one, again] = [1.0, 1.0].map(improved);
    assert!(one.counters.total() > 100, "{:?}", one.counters);
    assert_same(&one.solid, &again.solid);
    for size in [2f64.powi(-100), 2f64.powi(150)] {
        let other = improved(size);
        assert!(one.solid.mesh() == other.solid.mesh());
        let points = other.solid.points().iter().map(|&p| p / size);
        assert!(points.eq(one.solid.points().iter().copied()));
    }
}

#[test]
fn without_new_vertices_there_are_none() {
    let shifts = [[0.4, -0.3, 0.1], [-0.2, 0.4, 0.4], [0.1, 0.1, -0.4]];
    let given = shaken(5, &shifts, |_| true);
    let params = Params {
        goal: 50.0,
        vertices_below: 0.0,
        ..Params::default()
    };
    let outcome = improve(given.clone(), &params, &mut silent).unwrap();
    assert_sound(&given, &outcome);
    assert_eq!(outcome.stop, Stop::NothingHelps);
    assert_eq!(outcome.solid.points().len(), given.points().len());
    assert_eq!(
        (outcome.counters.insertions, outcome.counters.contractions),
        (0, 0)
    );
    assert!(worst(&outcome.solid) > worst(&given));

    // What is left is listed, worst first, and nothing else.
    let sine = 50f64.to_radians().sin();
    let sines = |&t: &TetId| {
        let angles = dihedral_angles(outcome.solid.tetrahedron(t));
        angles
            .map(|angle| angle.to_radians().sin())
            .into_iter()
            .fold(1.0, f64::min)
    };
    let below: BTreeSet<TetId> = outcome.solid.tets().filter(|t| sines(t) < sine).collect();
    assert_eq!(
        outcome
            .low
            .iter()
            .map(|low| low.tet)
            .collect::<BTreeSet<_>>(),
        below
    );
    assert!(outcome.low.is_sorted_by_key(|low| low.angle));
    for low in &outcome.low {
        assert!((low.angle.to_radians().sin() - sines(&low.tet)).abs() < 1e-12);
    }
    let after = outcome.after.unwrap();
    let angles = outcome
        .solid
        .tets()
        .flat_map(|t| dihedral_angles(outcome.solid.tetrahedron(t)));
    let angles: Vec<f64> = angles.collect();
    assert_eq!(after.min, angles.iter().copied().fold(180.0, f64::min));
    assert_eq!(after.max, angles.iter().copied().fold(0.0, f64::max));
}

/// A tetrahedron alone and an octahedron of four: no vertex is inside, and there is one edge to remove at most.
#[test]
fn where_nothing_can_change_nothing_does() {
    let simplex = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::splat(0.01)];
    let given = Complex3::from(Subcomplex3::of(
        &Delaunay3::build(&simplex).unwrap(),
        |_| true,
    ));
    let params = Params {
        vertices_below: 0.0,
        ..Params::default()
    };
    let outcome = improve(given.clone(), &params, &mut silent).unwrap();
    assert_same(&outcome.solid, &given);
    assert_eq!(
        (outcome.stop, outcome.counters.total()),
        (Stop::NothingHelps, 0)
    );
    assert_eq!((outcome.low.len(), outcome.low[0].fixed_corners), (1, 4));

    let nothing = Complex3::from(Subcomplex3::of(
        &Delaunay3::build(&simplex).unwrap(),
        |_| false,
    ));
    let outcome = improve(nothing, &Params::default(), &mut silent).unwrap();
    assert_eq!(
        (outcome.stop, outcome.before, outcome.after),
        (Stop::AllGood, None, None)
    );
}

#[test]
fn cancelling_leaves_a_valid_mesh() {
    let shifts = [[0.4, -0.3, 0.1], [-0.2, 0.4, 0.4], [0.1, 0.1, -0.4]];
    let given = shaken(9, &shifts, |_| true);
    let params = Params {
        goal: 45.0,
        vertices_below: 45.0,
        ..Params::default()
    };
    let mut reports = 0;
    let mut stop_at = |limit: usize| {
        reports = 0;
        improve(given.clone(), &params, &mut |_| {
            reports += 1;
            match reports > limit {
                true => ControlFlow::Break(()),
                false => ControlFlow::Continue(()),
            }
        })
    };
    assert!(matches!(stop_at(0), Err(ImproveError::Cancelled(_))));
    let outcome = stop_at(1).unwrap();
    assert_sound(&given, &outcome);
    assert!(
        matches!(outcome.stop, Stop::Cancelled(_)),
        "{:?}",
        outcome.stop
    );
    assert!(outcome.counters.total() > 0);
}

#[test]
fn angles_that_no_tetrahedron_has_are_refused() {
    let given = shaken(2, &[[0.0; 3]], |_| true);
    for (goal, vertices_below) in [
        (0.0, 0.0),
        (71.0, 0.0),
        (f64::NAN, 0.0),
        (20.0, -1.0),
        (20.0, 80.0),
    ] {
        let params = Params {
            goal,
            vertices_below,
            ..Params::default()
        };
        let refused = improve(given.clone(), &params, &mut silent);
        assert!(matches!(refused, Err(ImproveError::Angle { .. })));
    }
    let params = Params {
        goal: 90.0,
        ..Params::default()
    };
    let error = improve(given, &params, &mut silent).unwrap_err();
    insta::assert_snapshot!(error, @"90 degrees are not an angle to ask for, above 0 and at most 70");
}
