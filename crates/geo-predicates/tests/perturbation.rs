//! Ties broken by symbolic perturbation: brute force finds exactly one triangulation, the same
//! for every order and numbering.
#![allow(clippy::unwrap_used)]

use geo_predicates::filter::{Filter3, Relative2, Relative3, raised_inside};
use geo_predicates::{
    DVec2, DVec3, Lexicographic2, Lexicographic3, Sign, WeightedPoint2, WeightedPoint3,
    cocircular_inside, in_circle, in_circle_perturbed, in_circle_perturbed_by, in_sphere_perturbed,
    in_sphere_perturbed_by, orient2d, orient3d, power_circle_perturbed, power_sphere_perturbed,
};
use proptest::prelude::*;

/// All counterclockwise triangles whose circle holds no other point.
fn empty_triangles(points: &[DVec2], inside: impl Fn([usize; 4]) -> bool) -> Vec<[usize; 3]> {
    let n = points.len();
    let mut triangles = Vec::new();
    for a in 0..n {
        for b in a + 1..n {
            for c in b + 1..n {
                let corners = match orient2d(points[a], points[b], points[c]) {
                    Sign::Positive => [a, b, c],
                    Sign::Negative => [a, c, b],
                    Sign::Zero => continue,
                };
                let [i, j, k] = corners;
                if (0..n).all(|d| corners.contains(&d) || !inside([i, j, k, d])) {
                    triangles.push(corners);
                }
            }
        }
    }
    triangles
}

/// All right-handed tetrahedra whose sphere holds no other point.
fn empty_tetrahedra(points: &[DVec3], inside: impl Fn([usize; 5]) -> bool) -> Vec<[usize; 4]> {
    let n = points.len();
    let mut tetrahedra = Vec::new();
    for a in 0..n {
        for b in a + 1..n {
            for c in b + 1..n {
                for d in c + 1..n {
                    let corners = match orient3d(points[a], points[b], points[c], points[d]) {
                        Sign::Positive => [a, b, c, d],
                        Sign::Negative => [b, a, c, d],
                        Sign::Zero => continue,
                    };
                    let [i, j, k, l] = corners;
                    if (0..n).all(|e| corners.contains(&e) || !inside([i, j, k, l, e])) {
                        tetrahedra.push(corners);
                    }
                }
            }
        }
    }
    tetrahedra
}

/// Doubled area of a triangle, exact on a lattice.
fn area(points: &[DVec2], [a, b, c]: [usize; 3]) -> f64 {
    (points[b] - points[a]).perp_dot(points[c] - points[a])
}

/// Sixfold volume of a tetrahedron, exact on a lattice.
fn volume(points: &[DVec3], [a, b, c, d]: [usize; 4]) -> f64 {
    let [u, v, w] = [b, c, d].map(|corner| points[corner] - points[a]);
    u.cross(v).dot(w)
}

/// A scrambled number per point, all different.
fn scrambled(index: usize) -> u64 {
    (index as u64 + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15)
}

fn lattice2(width: i32, height: i32) -> Vec<DVec2> {
    (0..width * height)
        .map(|i| DVec2::new(f64::from(i % width), f64::from(i / width)))
        .collect()
}

fn lattice3(width: i32, depth: i32, height: i32) -> Vec<DVec3> {
    let point = |i: i32| [i % width, i / width % depth, i / (width * depth)].map(f64::from);
    (0..width * depth * height)
        .map(|i| DVec3::from_array(point(i)))
        .collect()
}

/// Twelve lattice points on one circle.
fn ring() -> Vec<DVec2> {
    let quarter = [[5, 0], [4, 3], [3, 4], [0, 5], [-3, 4], [-4, 3]];
    quarter
        .iter()
        .flat_map(|&[x, y]| [[x, y], [-x, -y]])
        .map(|[x, y]| DVec2::new(f64::from(x), f64::from(y)))
        .collect()
}

#[test]
fn a_lattice_has_one_triangulation_for_every_key() {
    let points = lattice2(4, 3);
    let by_place = empty_triangles(&points, |corners| {
        let [a, b, c, d] = corners.map(|i| points[i]);
        in_circle_perturbed(a, b, c, d)
    });
    let by_id = empty_triangles(&points, |ids| {
        in_circle_perturbed_by(ids.map(|i| points[i]), ids)
    });
    let by_scrambled_id = empty_triangles(&points, |ids| {
        in_circle_perturbed_by(ids.map(|i| points[i]), ids.map(scrambled))
    });
    for triangles in [&by_place, &by_id, &by_scrambled_id] {
        assert_eq!(triangles.len(), 12);
        assert_eq!(
            triangles.iter().map(|&t| area(&points, t)).sum::<f64>(),
            12.0
        );
    }
    assert_ne!(by_place, by_scrambled_id);
}

#[test]
fn cocircular_points_have_one_triangulation_for_every_key() {
    let points = ring();
    let ids = |key: fn(usize) -> u64| {
        empty_triangles(&points, |ids| {
            in_circle_perturbed_by(ids.map(|i| points[i]), ids.map(key))
        })
    };
    let place = empty_triangles(&points, |corners| {
        let [a, b, c, d] = corners.map(|i| points[i]);
        in_circle_perturbed(a, b, c, d)
    });
    for triangles in [ids(|i| i as u64), ids(scrambled), place] {
        assert_eq!(triangles.len(), 10);
        let covered = triangles.iter().map(|&t| area(&points, t)).sum::<f64>();
        assert_eq!(covered, hull_area(&points));
    }
}

/// Doubled area of the convex polygon of points round the origin.
fn hull_area(points: &[DVec2]) -> f64 {
    let mut points = points.to_vec();
    points.sort_by(|p, q| p.y.atan2(p.x).total_cmp(&q.y.atan2(q.x)));
    (0..points.len())
        .map(|i| points[i].perp_dot(points[(i + 1) % points.len()]))
        .sum()
}

#[test]
fn the_corners_of_a_cube_have_one_tetrahedralization_for_every_key() {
    let points = lattice3(2, 2, 2);
    let by_place = empty_tetrahedra(&points, |corners| {
        let [a, b, c, d, e] = corners.map(|i| points[i]);
        in_sphere_perturbed(a, b, c, d, e)
    });
    assert_eq!(
        by_place.len(),
        6,
        "the lexicographic key gives six tetrahedra round a diagonal"
    );
    assert_eq!(
        by_place.iter().map(|&t| volume(&points, t)).sum::<f64>(),
        6.0
    );
    for factor in 1..30 {
        let key = |i: usize| scrambled(i).rotate_left(factor);
        let found = empty_tetrahedra(&points, |ids| {
            in_sphere_perturbed_by(ids.map(|i| points[i]), ids.map(key))
        });
        assert!(found.len() == 5 || found.len() == 6, "{}", found.len());
        assert_eq!(found.iter().map(|&t| volume(&points, t)).sum::<f64>(), 6.0);
    }
}

#[test]
fn a_lattice_of_cubes_is_covered_exactly() {
    let points = lattice3(3, 3, 2);
    let found = empty_tetrahedra(&points, |corners| {
        let [a, b, c, d, e] = corners.map(|i| points[i]);
        in_sphere_perturbed(a, b, c, d, e)
    });
    assert_eq!(found.len(), 24);
    assert_eq!(found.iter().map(|&t| volume(&points, t)).sum::<f64>(), 24.0);
}

#[test]
fn equal_weights_break_ties_as_no_weights_do() {
    let points = lattice2(3, 3);
    let plain = empty_triangles(&points, |corners| {
        let [a, b, c, d] = corners.map(|i| points[i]);
        in_circle_perturbed(a, b, c, d)
    });
    let weighted = empty_triangles(&points, |corners| {
        let [a, b, c, d] = corners.map(|i| WeightedPoint2 {
            point: points[i],
            weight: 0.5,
        });
        power_circle_perturbed(a, b, c, d)
    });
    assert_eq!(plain, weighted);
    let points = lattice3(2, 2, 2);
    let plain = empty_tetrahedra(&points, |corners| {
        let [a, b, c, d, e] = corners.map(|i| points[i]);
        in_sphere_perturbed(a, b, c, d, e)
    });
    let weighted = empty_tetrahedra(&points, |corners| {
        let [a, b, c, d, e] = corners.map(|i| WeightedPoint3 {
            point: points[i],
            weight: 0.5,
        });
        power_sphere_perturbed(a, b, c, d, e)
    });
    assert_eq!(plain, weighted);
}

#[test]
fn points_with_equal_power_have_one_regular_triangulation() {
    let points = lattice2(4, 3);
    // With weight |p|^2 all lifted points are at height 0: nothing but ties.
    let found = empty_triangles(&points, |corners| {
        let [a, b, c, d] = corners.map(|i| WeightedPoint2 {
            point: points[i],
            weight: points[i].length_squared(),
        });
        power_circle_perturbed(a, b, c, d)
    });
    assert_eq!(found.iter().map(|&t| area(&points, t)).sum::<f64>(), 12.0);
}

#[test]
fn a_query_that_repeats_a_corner_is_outside() {
    let corners = [DVec2::ZERO, DVec2::X, DVec2::ONE];
    for d in corners {
        let [a, b, c] = corners;
        assert!(!in_circle_perturbed(a, b, c, d));
    }
    let corners = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z];
    for e in corners {
        let [a, b, c, d] = corners;
        assert!(!in_sphere_perturbed(a, b, c, d, e));
    }
}

#[test]
fn degenerate_corners_have_nothing_inside() {
    let line = [0.0, 1.0, 2.0, 3.0].map(|x| DVec2::new(x, x));
    assert!(!in_circle_perturbed(line[0], line[1], line[2], line[3]));
    let [a, b, c, d] = line.map(|p| p.extend(0.0));
    assert!(!in_sphere_perturbed(a, b, c, d, DVec3::new(4.0, 0.0, 0.0)));
}

#[test]
fn negative_zero_is_zero_as_a_key() {
    let keys = [DVec2::new(-0.0, 1.0), DVec2::new(0.0, 1.0)].map(Lexicographic2);
    assert_eq!(keys[0], keys[1]);
    assert!(Lexicographic2(DVec2::new(0.0, -1.0)) < Lexicographic2(DVec2::new(-0.0, -0.0)));
    assert!(Lexicographic3(DVec3::new(1.0, 0.0, -1.0)) < Lexicographic3(DVec3::X));
}

/// Five distinct points of a cubic lattice with `side` steps along each axis.
fn lattice_points(side: u16) -> impl Strategy<Value = [DVec3; 5]> {
    let coordinate = 0..=side;
    let point = (coordinate.clone(), coordinate.clone(), coordinate);
    prop::collection::hash_set(point, 5).prop_map(|points| {
        let mut points = points.into_iter();
        std::array::from_fn(|_| {
            let (x, y, z) = points.next().unwrap();
            DVec3::new(f64::from(x), f64::from(y), f64::from(z))
        })
    })
}

/// The ghost is never decided for.
#[test]
fn the_exact_filter_leaves_open_what_is_not_a_number() {
    let corners = [DVec3::X, DVec3::Y, DVec3::Z, DVec3::NAN];
    let seen = corners.map(|v| Relative3::new(v, DVec3::ZERO));
    let filter = Filter3::for_points(&corners[..3]);
    assert_eq!(filter.in_exact_sphere(seen.each_ref()), None);
}

proptest! {
    /// On one circle, in the order `a`, `p`, `b`, `apex`.
    #[test]
    fn the_diagonal_rule_agrees_with_the_perturbed_circle(
        start in 0usize..12, steps in [1usize..4, 1..4, 1..4], keys in Just([0u64, 1, 2, 3]).prop_shuffle(),
    ) {
        let mut points = ring();
        points.sort_by(|p, q| p.y.atan2(p.x).total_cmp(&q.y.atan2(q.x)));
        let mut index = start;
        let mut next = |step: usize| {
            index += step;
            points[index % points.len()]
        };
        let (a, p, b, apex) = (next(0), next(steps[0]), next(steps[1]), next(steps[2]));
        prop_assert_eq!(in_circle(a, b, apex, p), Sign::Zero);
        prop_assert_eq!(orient2d(a, b, apex), Sign::Positive);
        let [ka, kb, kc, kp] = keys;
        prop_assert_eq!(
            cocircular_inside(ka, kb, kc, kp),
            in_circle_perturbed_by([a, b, apex, p], keys)
        );
        prop_assert_eq!(
            cocircular_inside(Lexicographic2(a), Lexicographic2(b), Lexicographic2(apex), Lexicographic2(p)),
            in_circle_perturbed(a, b, apex, p)
        );
        let [a_seen, b_seen, apex_seen] = [a, b, apex].map(|v| Relative2::new(v, p));
        prop_assert_eq!(
            raised_inside(&a_seen, &b_seen, &apex_seen),
            in_circle_perturbed(a, b, apex, p)
        );
    }

    /// Wherever the doubles are exact: in small lattices, where most answers are ties, and at the limit of the filter.
    #[test]
    fn the_exact_filter_agrees_with_the_perturbed_sphere(
        points in prop_oneof![lattice_points(2), lattice_points(3), lattice_points(6), lattice_points(659)],
        unit in prop_oneof![Just(1.0), Just(2f64.powi(-60)), Just(2f64.powi(90))],
    ) {
        let points = points.map(|p| p * unit);
        let [a, b, c, d, e] = points;
        let corners = match orient3d(a, b, c, d) {
            Sign::Positive => [a, b, c, d],
            Sign::Negative => [b, a, c, d],
            Sign::Zero => return Ok(()),
        };
        let filter = Filter3::for_points(&points);
        let seen = corners.map(|v| Relative3::new(v, e));
        let [a, b, c, d] = corners;
        prop_assert_eq!(
            filter.in_exact_sphere(seen.each_ref()),
            Some(in_sphere_perturbed(a, b, c, d, e))
        );
        prop_assert_eq!(Filter3::GENERAL.in_exact_sphere(seen.each_ref()), None);
    }

    #[test]
    fn swapping_two_corners_negates_the_answer(points in prop::collection::hash_set((0i8..4, 0i8..4), 4)) {
        let points: Vec<DVec2> = points.iter().map(|&(x, y)| DVec2::new(f64::from(x), f64::from(y))).collect();
        let [a, b, c, d] = points[..] else { unreachable!() };
        prop_assume!(orient2d(a, b, c) != Sign::Zero);
        prop_assert_eq!(in_circle_perturbed(a, b, c, d), !in_circle_perturbed(b, a, c, d));
        prop_assert_eq!(in_circle_perturbed(a, b, c, d), in_circle_perturbed(b, c, a, d));
    }
}
