//! Measures of shape depend on shape alone: not on place, direction, size or the order of the corners.

use delaunay_core::measure::{facet, quad, tetrahedron, triangle};
use glam::{DAffine2, DAffine3, DQuat, DVec2, DVec3};
use proptest::prelude::*;

/// Relative error that rounding the moved coordinates may cause, for elements that are not thin.
const TOLERANCE: f64 = 1e-9;

fn agree(a: f64, b: f64) -> bool {
    a == b || (a - b).abs() <= TOLERANCE * (1.0 + a.abs().max(b.abs()))
}

fn plane_point() -> impl Strategy<Value = DVec2> {
    prop::array::uniform2(-1.0..1.0f64).prop_map(DVec2::from)
}

fn space_point() -> impl Strategy<Value = DVec3> {
    prop::array::uniform3(-1.0..1.0f64).prop_map(DVec3::from)
}

fn not_thin_triangle() -> impl Strategy<Value = [DVec2; 3]> {
    prop::array::uniform3(plane_point()).prop_filter("thin", |&t| triangle::radius_ratio(t) > 1e-3)
}

fn not_thin_tetrahedron() -> impl Strategy<Value = [DVec3; 4]> {
    prop::array::uniform4(space_point())
        .prop_filter("thin", |&t| tetrahedron::inradius_quality(t) > 1e-3)
}

/// A similarity of the plane that keeps orientation.
fn plane_motion() -> impl Strategy<Value = DAffine2> {
    (0.0..6.3f64, 1e-3..1e3f64, plane_point()).prop_map(|(angle, scale, shift)| {
        DAffine2::from_scale_angle_translation(DVec2::splat(scale), angle, scale * shift)
    })
}

/// A similarity of space that keeps orientation.
fn space_motion() -> impl Strategy<Value = DAffine3> {
    (
        prop::array::uniform4(0.1..1.0f64),
        1e-3..1e3f64,
        space_point(),
    )
        .prop_map(|(q, scale, shift)| {
            let rotation = DQuat::from_array(q).normalize();
            DAffine3::from_scale_rotation_translation(DVec3::splat(scale), rotation, scale * shift)
        })
}

proptest! {
    #[test]
    fn triangles_keep_their_measures_when_moved(t in not_thin_triangle(), motion in plane_motion()) {
        let moved = t.map(|p| motion.transform_point2(p));
        prop_assert!(agree(triangle::radius_ratio(t), triangle::radius_ratio(moved)));
        prop_assert!(agree(triangle::radius_edge_ratio(t), triangle::radius_edge_ratio(moved)));
        for (angle, same) in triangle::angles(t).into_iter().zip(triangle::angles(moved)) {
            prop_assert!(agree(angle, same));
        }
    }

    #[test]
    fn the_order_of_a_triangles_corners_changes_no_measure([a, b, c] in not_thin_triangle()) {
        for other in [[b, c, a], [c, a, b], [a, c, b], [c, b, a], [b, a, c]] {
            prop_assert!(agree(triangle::radius_ratio([a, b, c]), triangle::radius_ratio(other)));
            prop_assert!(agree(triangle::radius_edge_ratio([a, b, c]), triangle::radius_edge_ratio(other)));
            prop_assert!(agree(triangle::signed_area([a, b, c]).abs(), triangle::signed_area(other).abs()));
        }
        prop_assert_eq!(triangle::signed_area([a, b, c]), -triangle::signed_area([b, a, c]));
    }

    #[test]
    fn angles_of_a_triangle_add_up_and_the_least_gives_r_over_l(t in not_thin_triangle()) {
        let angles = triangle::angles(t);
        prop_assert!(agree(angles.iter().sum(), 180.0));
        let smallest = angles.into_iter().fold(f64::INFINITY, f64::min);
        prop_assert!(agree(triangle::radius_edge_ratio(t), 0.5 / smallest.to_radians().sin()));
    }

    #[test]
    fn ratios_of_any_triangle_stay_in_their_range(t in prop::array::uniform3(plane_point())) {
        prop_assert!((0.0..=1.0).contains(&triangle::radius_ratio(t)));
        prop_assert!(triangle::radius_edge_ratio(t) >= 0.577);
    }

    #[test]
    fn facets_keep_their_measures_when_moved(
        [a, b, c, _] in not_thin_tetrahedron(),
        motion in space_motion(),
    ) {
        let (t, moved) = ([a, b, c], [a, b, c].map(|p| motion.transform_point3(p)));
        prop_assert!(agree(facet::radius_ratio(t), facet::radius_ratio(moved)));
        prop_assert!(agree(facet::radius_edge_ratio(t), facet::radius_edge_ratio(moved)));
    }

    #[test]
    fn tetrahedra_keep_their_measures_when_moved(t in not_thin_tetrahedron(), motion in space_motion()) {
        let moved = t.map(|p| motion.transform_point3(p));
        prop_assert!(agree(tetrahedron::radius_ratio(t), tetrahedron::radius_ratio(moved)));
        prop_assert!(agree(tetrahedron::inradius_quality(t), tetrahedron::inradius_quality(moved)));
        prop_assert!(agree(tetrahedron::radius_edge_ratio(t), tetrahedron::radius_edge_ratio(moved)));
        for (angle, same) in tetrahedron::dihedral_angles(t).into_iter().zip(tetrahedron::dihedral_angles(moved)) {
            prop_assert!(agree(angle, same));
        }
    }

    #[test]
    fn the_order_of_a_tetrahedrons_corners_changes_no_measure([a, b, c, d] in not_thin_tetrahedron()) {
        let t = [a, b, c, d];
        for other in [[b, c, d, a], [d, c, b, a], [b, a, c, d], [a, c, d, b]] {
            prop_assert!(agree(tetrahedron::radius_ratio(t), tetrahedron::radius_ratio(other)));
            prop_assert!(agree(tetrahedron::inradius_quality(t), tetrahedron::inradius_quality(other)));
            prop_assert!(agree(tetrahedron::signed_volume(t).abs(), tetrahedron::signed_volume(other).abs()));
        }
        prop_assert!(agree(tetrahedron::signed_volume(t), -tetrahedron::signed_volume([b, a, c, d])));
    }

    #[test]
    fn ratios_of_any_tetrahedron_stay_in_their_range(t in prop::array::uniform4(space_point())) {
        prop_assert!((0.0..=1.0).contains(&tetrahedron::radius_ratio(t)));
        prop_assert!((0.0..=1.0).contains(&tetrahedron::inradius_quality(t)));
        prop_assert!(tetrahedron::radius_edge_ratio(t) >= 0.612);
        prop_assert!(tetrahedron::dihedral_angles(t).iter().all(|angle| (0.0..=180.0).contains(angle)));
    }

    #[test]
    fn quads_keep_their_measures_when_moved(q in prop::array::uniform4(plane_point()), motion in plane_motion()) {
        prop_assume!(q.iter().zip(q.iter().cycle().skip(1)).all(|(a, b)| a.distance(*b) > 1e-2));
        let moved = q.map(|p| motion.transform_point2(p));
        prop_assert!(agree(quad::scaled_jacobian(q), quad::scaled_jacobian(moved)));
        for (angle, same) in quad::corner_angles(q).into_iter().zip(quad::corner_angles(moved)) {
            // 0° and 360° are neighbours.
            prop_assert!(agree((angle - same).abs() % 360.0, 0.0) || agree((angle - same).abs(), 360.0));
        }
    }

    #[test]
    fn the_sine_of_the_worst_corner_is_the_scaled_jacobian(q in prop::array::uniform4(plane_point())) {
        let sine = |angle: f64| angle.to_radians().sin();
        let least = quad::corner_angles(q).into_iter().map(sine).fold(f64::INFINITY, f64::min);
        prop_assert!(agree(quad::scaled_jacobian(q), least));
    }
}

/// Coordinates of any finite size, many of them equal.
fn wild() -> impl Strategy<Value = f64> {
    prop_oneof![
        prop::num::f64::NORMAL | prop::num::f64::SUBNORMAL | prop::num::f64::ZERO,
        prop::sample::select(vec![
            0.0,
            -0.0,
            1.0,
            -1.0,
            1e-300,
            f64::MAX,
            f64::MIN,
            5e-324
        ]),
        -1.0..1.0f64,
    ]
}

proptest! {
    #[test]
    fn no_measure_of_finite_corners_is_nan(c in prop::array::uniform12(wild())) {
        let plane = [[c[0], c[1]], [c[2], c[3]], [c[4], c[5]], [c[6], c[7]]].map(DVec2::from);
        let space = [[c[0], c[1], c[2]], [c[3], c[4], c[5]], [c[6], c[7], c[8]], [c[9], c[10], c[11]]]
            .map(DVec3::from);
        let [a, b, c, _] = plane;
        let t = [a, b, c];
        let numbers = [
            &[triangle::signed_area(t), triangle::area(t), triangle::circumradius(t)][..],
            &[triangle::inradius(t), triangle::shortest_edge(t), triangle::longest_edge(t)],
            &[triangle::radius_edge_ratio(t), triangle::radius_ratio(t)],
            &triangle::circumcenter(t).to_array(),
            &triangle::angles(t),
            &[quad::signed_area(plane), quad::scaled_jacobian(plane)],
            &quad::corner_angles(plane),
            &[tetrahedron::signed_volume(space), tetrahedron::circumradius(space)],
            &[tetrahedron::inradius(space), tetrahedron::shortest_edge(space)],
            &[tetrahedron::longest_edge(space), tetrahedron::radius_edge_ratio(space)],
            &[tetrahedron::inradius_quality(space), tetrahedron::radius_ratio(space)],
            &tetrahedron::dihedral_angles(space),
        ]
        .concat();
        prop_assert!(!numbers.iter().any(|number| number.is_nan()), "{:?}", numbers);
        let [a, b, c, _] = space;
        let t = [a, b, c];
        let numbers = [
            &[facet::area(t), facet::circumradius(t), facet::inradius(t)][..],
            &[facet::shortest_edge(t), facet::longest_edge(t)],
            &[facet::radius_edge_ratio(t), facet::radius_ratio(t)],
            &facet::angles(t),
        ]
        .concat();
        prop_assert!(!numbers.iter().any(|number| number.is_nan()), "{:?}", numbers);
    }

    #[test]
    fn the_circumcenter_has_the_same_distance_to_every_corner(t in not_thin_triangle()) {
        let (center, radius) = (triangle::circumcenter(t), triangle::circumradius(t));
        for corner in t {
            prop_assert!(agree(center.distance(corner), radius));
        }
    }

    #[test]
    fn a_facet_lying_in_a_coordinate_plane_measures_like_the_triangle(t in not_thin_triangle()) {
        let lifted = t.map(|p| DVec3::new(3.0, p.x, p.y));
        prop_assert!(agree(facet::area(lifted), triangle::area(t)));
        prop_assert!(agree(facet::circumradius(lifted), triangle::circumradius(t)));
        prop_assert!(agree(facet::inradius(lifted), triangle::inradius(t)));
        prop_assert!(agree(facet::radius_edge_ratio(lifted), triangle::radius_edge_ratio(t)));
        prop_assert!(agree(facet::radius_ratio(lifted), triangle::radius_ratio(t)));
        for (angle, same) in facet::angles(lifted).into_iter().zip(triangle::angles(t)) {
            prop_assert!(agree(angle, same));
        }
    }

    #[test]
    fn a_quad_is_the_two_triangles_on_either_side_of_a_diagonal(
        [a, b, c, d] in prop::array::uniform4(plane_point()),
    ) {
        let halves = triangle::signed_area([a, b, c]) + triangle::signed_area([a, c, d]);
        prop_assert!(agree(quad::signed_area([a, b, c, d]), halves));
    }
}
