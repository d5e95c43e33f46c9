//! Regular triangulations of weighted points: unique, complete, and Delaunay for equal weights.

#![allow(clippy::unwrap_used)]

mod clouds;

use clouds::space::{cloud, hard_sets, lattice, rng, uniform};
use delaunay_core::geo_predicates::{Sign, WeightedPoint3, power_sphere};
use delaunay_core::{BuildError, Delaunay3, Extent, Regular3, RegularError, VertexId};
use glam::DVec3;
use proptest::prelude::*;
use rand::RngExt;
use rand::seq::SliceRandom;

/// Weights up to the squared size of the cloud over `part`.
fn random_weights(points: &[DVec3], part: f64, seed: u64) -> Vec<f64> {
    let span = points
        .iter()
        .map(|p| p.abs().max_element())
        .fold(0.0, f64::max);
    let mut rng = rng(seed);
    let random = points
        .iter()
        .map(|_| rng.random_range(-1.0..1.0) * span * span / part);
    random.collect()
}

/// Weights of few values, so that ties are the common case.
fn few_weights(count: usize, seed: u64) -> Vec<f64> {
    let mut rng = rng(seed);
    (0..count)
        .map(|_| [0.0, 0.0, 1.0, 2.0, -1.0][rng.random_range(0..5)])
        .collect()
}

fn weighted(regular: &Regular3, v: VertexId) -> WeightedPoint3 {
    WeightedPoint3 {
        point: regular.point(v),
        weight: regular.weights()[v.index()],
    }
}

/// No lifted point at all is strictly below a facet of the lower hull: quadratic, independent of ties.
fn assert_lower_hull(regular: &Regular3, name: &str) {
    let all: Vec<VertexId> = (0..regular.points().len()).map(VertexId::new).collect();
    for t in regular.tets() {
        let [a, b, c, d] = regular.mesh().tet_vertices(t).map(|v| weighted(regular, v));
        let below =
            |&&v: &&VertexId| power_sphere(a, b, c, d, weighted(regular, v)) == Sign::Positive;
        assert_eq!(all.iter().find(below), None, "{name}: {t}");
    }
}

fn assert_complete(regular: &Regular3) {
    let (vertices, hidden) = (regular.vertices().count(), regular.hidden().len());
    assert_eq!(vertices, regular.vertex_count());
    assert_eq!(
        vertices + hidden + regular.duplicates().len(),
        regular.points().len()
    );
    assert!(
        regular
            .hidden()
            .iter()
            .all(|&v| !regular.contains_vertex(v))
    );
}

/// The tetrahedra over places, which do not depend on the numbering.
fn tets_by_place(regular: &Regular3) -> Vec<[[u64; 3]; 4]> {
    let place = |p: DVec3| p.to_array().map(f64::to_bits);
    let mut tets: Vec<[[u64; 3]; 4]> = regular
        .tets()
        .map(|t| {
            let mut corners = regular.tetrahedron(t).map(place);
            corners.sort_unstable();
            corners
        })
        .collect();
    tets.sort_unstable();
    tets
}

#[test]
fn equal_weights_give_the_delaunay_triangulation_bit_for_bit() {
    for (name, points) in hard_sets() {
        let delaunay = Delaunay3::build(&points).unwrap();
        let regular = Regular3::build(&points, &vec![0.25; points.len()]).unwrap();
        assert_eq!(regular.check(), Ok(()), "{name}");
        assert!(regular.hidden().is_empty(), "{name}");
        assert_eq!(regular.duplicates(), delaunay.duplicates(), "{name}");
        assert!(
            regular.mesh().canonical() == delaunay.mesh().canonical(),
            "{name}"
        );
    }
}

#[test]
fn every_hard_set_with_weights_is_the_lower_hull_of_the_lifted_points() {
    for (name, points) in hard_sets() {
        let points = &points[..points.len().min(120)];
        if Delaunay3::build(points).is_err() {
            continue;
        }
        let sets = [
            random_weights(points, 2.0, 1),
            random_weights(points, 100.0, 2),
            few_weights(points.len(), 3),
        ];
        for weights in sets {
            let regular = Regular3::build(points, &weights).unwrap();
            assert_eq!(regular.check(), Ok(()), "{name}");
            assert_complete(&regular);
            assert_lower_hull(&regular, name);
        }
    }
}

#[test]
fn the_order_of_weighted_points_does_not_show() {
    for (name, points) in hard_sets() {
        for weights in [
            random_weights(&points, 50.0, 4),
            few_weights(points.len(), 5),
        ] {
            let expected = Regular3::build(&points, &weights).unwrap();
            let mut order: Vec<usize> = (0..points.len()).collect();
            for seed in 0..3 {
                order.shuffle(&mut rng(seed));
                let points: Vec<DVec3> = order.iter().map(|&i| points[i]).collect();
                let weights: Vec<f64> = order.iter().map(|&i| weights[i]).collect();
                let regular = Regular3::build(&points, &weights).unwrap();
                assert_eq!(tets_by_place(&regular), tets_by_place(&expected), "{name}");
                assert_eq!(regular.hidden().len(), expected.hidden().len(), "{name}");
            }
        }
    }
}

#[test]
fn a_heavy_point_swallows_those_around_it() {
    let points = lattice([5, 5, 5]);
    let center = 62;
    assert_eq!(points[center], DVec3::splat(2.0));
    let mut weights = vec![0.0; 125];
    weights[center] = 100.0;
    let regular = Regular3::build(&points, &weights).unwrap();
    assert_eq!(regular.check(), Ok(()));
    assert_lower_hull(&regular, "heavy center");
    // All inner points but the center are hidden; the 98 of the surface are not.
    assert_eq!(regular.hidden().len(), 26);
    let spokes = regular.mesh().neighbors(VertexId::new(center)).count();
    assert_eq!(spokes, 98);
}

#[test]
fn the_heaviest_of_a_place_stands_for_all() {
    let mut points = lattice([2, 2, 2]);
    points.extend([DVec3::splat(0.5); 3]);
    let weights = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -2.0, 0.1, 0.1];
    let regular = Regular3::build(&points, &weights).unwrap();
    assert_eq!(regular.check(), Ok(()));
    let [light, heavy, equal] = [8, 9, 10].map(VertexId::new);
    assert!(regular.contains_vertex(heavy));
    assert_eq!(regular.duplicates().representative(light), Some(heavy));
    assert_eq!(regular.duplicates().representative(equal), Some(heavy));
}

#[test]
fn points_on_a_plane_have_their_planar_regular_triangulation() {
    let points = lattice([3, 3, 1]);
    let mut weights = [0.0; 9];
    weights[4] = -2.0;
    let Err(RegularError::Build(BuildError::Flat(flat))) = Regular3::build(&points, &weights)
    else {
        panic!("not flat")
    };
    assert_eq!(flat.extent(), Extent::Plane);
    let plane = flat.plane.unwrap();
    assert_eq!(plane.check(), Ok(()));
    let real = plane.faces().filter(|&f| !plane.is_ghost_face(f)).count();
    assert_eq!(real, 6);
    assert!(plane.outgoing(VertexId::new(4)).is_none());
}

#[test]
fn weights_and_counts_that_do_not_fit_are_refused() {
    let text = |points: &[DVec3], weights: &[f64]| {
        Regular3::build(points, weights).unwrap_err().to_string()
    };
    let corners = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z];
    insta::assert_snapshot!(text(&corners, &[0.0; 3]), @"4 points have 3 weights");
    insta::assert_snapshot!(text(&corners, &[0.0, 0.0, f64::NAN, 0.0]), @"point 2 has weight NaN, which is neither zero nor of magnitude 2^-284 to 2^402 (about 3.2e-86 to 1.0e121)");
    insta::assert_snapshot!(text(&corners, &[0.0, 1e200, 0.0, 0.0]), @"point 1 has weight 1e200, which is neither zero nor of magnitude 2^-284 to 2^402 (about 3.2e-86 to 1.0e121)");
    insta::assert_snapshot!(text(&[DVec3::NAN], &[0.0]), @"point 0 has x = NaN, which is neither zero nor of magnitude 2^-142 to 2^201 (about 1.8e-43 to 3.2e60)");
    insta::assert_snapshot!(text(&[], &[]), @"there are no points");
    insta::assert_snapshot!(text(&corners[..2], &[1.0, 2.0]), @"the 2 distinct points lie on one line, from v0 to v1");
}

#[test]
fn many_evenly_spread_points_with_weights() {
    let points = uniform(3000, 21);
    let weights = random_weights(&points, 300.0, 22);
    let regular = Regular3::build(&points, &weights).unwrap();
    assert_eq!(regular.check(), Ok(()));
    assert_complete(&regular);
    assert!(regular.hidden().len() > 50);
}

proptest! {
    #[test]
    fn any_weighted_cloud_is_a_lower_hull(points in cloud(24), seed in any::<u64>()) {
        for weights in [few_weights(points.len(), seed), random_weights(&points, 3.0, seed)] {
            match (Regular3::build(&points, &weights), Delaunay3::build(&points)) {
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
