//! Regular triangulations of the plane: unique, complete, and Delaunay for equal weights.

#![allow(clippy::unwrap_used)]

mod clouds;

use clouds::{cloud, grid, hard_cases, rng, uniform};
use delaunay_core::geo_predicates::coordinate::MIN_WEIGHT;
use delaunay_core::geo_predicates::{Sign, WeightedPoint2, power_circle};
use delaunay_core::{BuildError, Delaunay2, Extent, Regular2, RegularError, TriMesh, VertexId};
use glam::DVec2;
use proptest::prelude::*;
use rand::RngExt;
use rand::seq::SliceRandom;

/// Weights up to the squared size of the cloud over `part`.
fn random_weights(points: &[DVec2], part: f64, seed: u64) -> Vec<f64> {
    let sizes = points.iter().map(|p| p.abs().max_element());
    let span = sizes.fold(0.0, f64::max);
    let mut rng = rng(seed);
    let mut weight = || rng.random_range(-1.0..1.0) * span * span / part;
    let accepted = |weight: f64| {
        if weight.abs() < MIN_WEIGHT {
            0.0
        } else {
            weight
        }
    };
    points.iter().map(|_| accepted(weight())).collect()
}

/// Weights of few values, so that ties are the common case.
fn few_weights(count: usize, seed: u64) -> Vec<f64> {
    let mut rng = rng(seed);
    let mut weight = || [0.0, 0.0, 1.0, 2.0, -1.0][rng.random_range(0..5)];
    (0..count).map(|_| weight()).collect()
}

fn weighted(regular: &Regular2, v: VertexId) -> WeightedPoint2 {
    WeightedPoint2 {
        point: regular.point(v),
        weight: regular.weights()[v.index()],
    }
}

/// No lifted point at all is strictly below a facet of the lower hull: quadratic, independent of ties.
fn assert_lower_hull(regular: &Regular2, name: &str) {
    let all: Vec<VertexId> = (0..regular.points().len()).map(VertexId::new).collect();
    for f in regular.faces() {
        let corners = regular.mesh().face_vertices(f);
        let [a, b, c] = corners.map(|v| weighted(regular, v));
        let below = |&&v: &&VertexId| power_circle(a, b, c, weighted(regular, v)) == Sign::Positive;
        assert_eq!(all.iter().find(below), None, "{name}: {f}");
    }
}

fn assert_complete(regular: &Regular2) {
    let (vertices, hidden) = (regular.vertices().count(), regular.hidden());
    assert_eq!(vertices, regular.vertex_count());
    let apart = hidden.len() + regular.duplicates().len();
    assert_eq!(vertices + apart, regular.points().len());
    assert!(hidden.iter().all(|&v| !regular.contains_vertex(v)));
}

/// The triangles over places, which do not depend on the numbering.
fn faces_by_place(regular: &Regular2) -> Vec<[[u64; 2]; 3]> {
    let place = |p: DVec2| p.to_array().map(f64::to_bits);
    let sorted = |f| {
        let mut corners = regular.triangle(f).map(place);
        corners.sort_unstable();
        corners
    };
    let mut faces: Vec<[[u64; 2]; 3]> = regular.faces().map(sorted).collect();
    faces.sort_unstable();
    faces
}

#[test]
fn equal_weights_give_the_delaunay_triangulation_bit_for_bit() {
    for (name, points) in hard_cases() {
        let delaunay = Delaunay2::build(&points).unwrap();
        let regular = Regular2::build(&points, &vec![-0.25; points.len()]).unwrap();
        assert_eq!(regular.check(), Ok(()), "{name}");
        assert!(regular.hidden().is_empty(), "{name}");
        assert_eq!(regular.duplicates(), delaunay.duplicates(), "{name}");
        let [ours, theirs] = [regular.mesh(), delaunay.mesh()].map(TriMesh::canonical);
        assert!(ours == theirs, "{name}");
    }
}

#[test]
fn every_hard_case_with_weights_is_the_lower_hull_of_the_lifted_points() {
    for (name, points) in hard_cases() {
        let sets = [
            random_weights(&points, 2.0, 1),
            random_weights(&points, 100.0, 2),
            few_weights(points.len(), 3),
        ];
        for weights in sets {
            let regular = Regular2::build(&points, &weights).unwrap();
            assert_eq!(regular.check(), Ok(()), "{name}");
            assert_complete(&regular);
            assert_lower_hull(&regular, name);
        }
    }
}

#[test]
fn the_order_of_weighted_points_does_not_show() {
    for (name, points) in hard_cases() {
        for weights in [
            random_weights(&points, 50.0, 4),
            few_weights(points.len(), 5),
        ] {
            let expected = Regular2::build(&points, &weights).unwrap();
            let mut order: Vec<usize> = (0..points.len()).collect();
            for seed in 0..3 {
                order.shuffle(&mut rng(seed));
                let points: Vec<DVec2> = order.iter().map(|&i| points[i]).collect();
                let weights: Vec<f64> = order.iter().map(|&i| weights[i]).collect();
                let regular = Regular2::build(&points, &weights).unwrap();
                let faces = faces_by_place(&regular);
                assert_eq!(faces, faces_by_place(&expected), "{name}");
                assert_eq!(regular.hidden().len(), expected.hidden().len(), "{name}");
            }
        }
    }
}

#[test]
fn a_heavy_point_swallows_those_around_it() {
    let mut weights = [0.0; 49];
    weights[24] = 100.0;
    let regular = Regular2::build(&grid(7, 7), &weights).unwrap();
    assert_eq!(regular.check(), Ok(()));
    // All inner points but the center are hidden; the 24 of the border are not.
    assert_eq!((regular.hidden().len(), regular.faces().count()), (24, 24));
    let spokes = regular.mesh().neighbors(VertexId::new(24)).count();
    assert_eq!(spokes, 24);
}

#[test]
fn a_heavy_point_on_the_border_hides_its_neighbours_there() {
    let mut weights = [0.0; 25];
    weights[2] = 2.5;
    let regular = Regular2::build(&grid(5, 5), &weights).unwrap();
    assert_eq!(regular.check(), Ok(()));
    assert_lower_hull(&regular, "heavy border");
    let hidden = [1, 3].map(VertexId::new);
    assert!(hidden.iter().all(|v| regular.hidden().contains(v)));
}

#[test]
fn weights_and_counts_that_do_not_fit_are_refused() {
    let error = |points: &[DVec2], weights: &[f64]| Regular2::build(points, weights).unwrap_err();
    let corners = [DVec2::ZERO, DVec2::X, DVec2::Y];
    let count = RegularError::Count {
        points: 3,
        weights: 4,
    };
    assert_eq!(error(&corners, &[0.0; 4]), count);
    for weight in [f64::NAN, f64::INFINITY, 1e200, 1e-100] {
        let weights = [0.0, 0.0, weight];
        assert!(matches!(error(&corners, &weights), RegularError::Weight(e) if e.index == 2));
    }
    let bad = error(&[DVec2::ZERO, DVec2::NAN], &[0.0; 2]);
    assert!(matches!(bad, RegularError::Build(BuildError::Coordinate(e)) if e.index == 1));
}

#[test]
fn points_on_a_line_are_described() {
    let points: Vec<DVec2> = [2.0, 1.0, 0.0, 1.0].map(DVec2::splat).to_vec();
    match Regular2::build(&points, &[0.0, 0.0, 0.0, 1.0]) {
        Err(RegularError::Build(BuildError::Flat(flat))) => {
            assert_eq!(flat.extent(), Extent::Line);
            assert_eq!(flat.vertices, [2, 3, 0].map(VertexId::new));
        }
        other => panic!("{other:?}"),
    }
}

#[test]
fn many_evenly_spread_points_with_weights() {
    let points = uniform(20_000, 21);
    let weights = random_weights(&points, 1e4, 22);
    let regular = Regular2::build(&points, &weights).unwrap();
    assert_eq!(regular.check(), Ok(()));
    assert_complete(&regular);
    assert!(regular.hidden().len() > 1000);
}

proptest! {
    #[test]
    fn any_weighted_cloud_is_a_lower_hull(points in cloud(24), seed in any::<u64>()) {
        for weights in [few_weights(points.len(), seed), random_weights(&points, 3.0, seed)] {
            match (Regular2::build(&points, &weights), Delaunay2::build(&points)) {
                (Ok(regular), Ok(_)) => {
                    prop_assert_eq!(regular.check(), Ok(()));
                    assert_complete(&regular);
                    assert_lower_hull(&regular, "cloud");
                }
                (Err(RegularError::Build(BuildError::Flat(weighted))), Err(BuildError::Flat(flat))) => {
                    prop_assert_eq!(weighted.extent(), flat.extent());
                }
                other => prop_assert!(false, "{:?}", other),
            }
        }
    }
}
