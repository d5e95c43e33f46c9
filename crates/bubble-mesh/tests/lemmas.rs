//! The equations of the paper, one by one.

use std::f64::consts::PI;

use bubble_mesh::paper::{moved, repulsion, resized};
use bubble_mesh::{
    Bubble, boundary_bubbles, boundary_node_area, boundary_node_radius, bubble_density, centroid,
    radius_ratio,
};
use delaunay_core::progress::silent;
use delaunay_core::{BuildOptions, Outline, Subcomplex2, VertexId};
use glam::DVec2;
use proptest::prelude::*;

fn point() -> impl Strategy<Value = DVec2> {
    prop::array::uniform2(-10.0..10.0f64).prop_map(DVec2::from)
}

fn bubble() -> impl Strategy<Value = Bubble> {
    (point(), 0.01..5.0f64).prop_map(|(center, radius)| Bubble { center, radius })
}

fn equilateral_area(side: f64) -> f64 {
    3f64.sqrt() / 4.0 * side * side
}

fn near(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-12 * a.abs().max(b.abs())
}

proptest! {
    #[test]
    fn a_boundary_bubble_is_as_large_as_the_mean_of_two_equilateral_triangles(
        l1 in 1e-3..1e3f64,
        l2 in 1e-3..1e3f64,
    ) {
        let mean = (equilateral_area(l1) + equilateral_area(l2)) / 2.0;
        prop_assert!(near(boundary_node_area(&[l1, l2]), mean));
        let radius = boundary_node_radius(&[l1, l2]);
        prop_assert!(near(PI * radius * radius, mean));
        prop_assert!(near(radius, (3f64.sqrt() / (8.0 * PI) * (l1 * l1 + l2 * l2)).sqrt()));
    }

    #[test]
    fn an_element_radius_is_the_reciprocal_interpolation_of_its_nodes(nodes in prop::array::uniform3(bubble())) {
        let e = centroid(nodes.map(|node| node.center));
        let reciprocals = nodes.map(|node| 1.0 / node.center.distance(e));
        prop_assume!(reciprocals.iter().all(|r| r.is_finite()));
        let weighted: f64 = nodes.iter().zip(reciprocals).map(|(node, r)| node.radius * r).sum();
        let element = Bubble::of_element(nodes);
        prop_assert!(near(element.radius, weighted / reciprocals.iter().sum::<f64>()));
        prop_assert_eq!(element.center, e);
    }

    #[test]
    fn an_element_radius_lies_between_those_of_its_nodes(nodes in prop::array::uniform3(bubble())) {
        let radii = nodes.map(|node| node.radius);
        let (small, large) = (radii.into_iter().fold(f64::MAX, f64::min), radii.into_iter().fold(0.0, f64::max));
        let radius = Bubble::of_element(nodes).radius;
        prop_assert!(small * (1.0 - 1e-15) <= radius && radius <= large * (1.0 + 1e-15));
    }

    #[test]
    fn the_order_of_the_nodes_does_not_matter([a, b, c] in prop::array::uniform3(bubble())) {
        let density = bubble_density([a, b, c]);
        for other in [[b, c, a], [c, b, a]] {
            prop_assert!((bubble_density(other) - density).abs() <= 1e-9 * density);
        }
    }

    #[test]
    fn density_does_not_depend_on_the_unit_of_length(nodes in prop::array::uniform3(bubble()), unit in 1e-6..1e6f64) {
        let scaled = nodes.map(|node| Bubble { center: node.center * unit, radius: node.radius * unit });
        let density = bubble_density(nodes);
        prop_assert!((bubble_density(scaled) - density).abs() <= 1e-6 * density);
    }

    #[test]
    fn a_force_pushes_apart_by_the_overlap(current in bubble(), nearby in bubble()) {
        let way = current.center - nearby.center;
        let overlap = current.radius + nearby.radius - way.length();
        let force = repulsion(current, nearby);
        prop_assert!((force.length() - overlap.max(0.0)).abs() < 1e-12);
        prop_assert!(force.dot(way) >= 0.0 && force.perp_dot(way).abs() < 1e-12);
        prop_assert_eq!(force, -repulsion(nearby, current));
    }

    #[test]
    fn a_new_radius_lies_between_those_of_the_bubbles_that_overlap(
        current in bubble(),
        nearby in prop::collection::vec(bubble(), 0..6),
    ) {
        let overlaps = |b: &&Bubble| current.radius + b.radius > current.center.distance(b.center);
        let radii: Vec<f64> = nearby.iter().filter(overlaps).map(|b| b.radius).collect();
        let radius = resized(current, nearby.iter().copied());
        match radii.is_empty() {
            true => prop_assert_eq!(radius, current.radius),
            false => {
                let least = radii.iter().copied().fold(f64::MAX, f64::min);
                let most = radii.iter().copied().fold(0.0, f64::max);
                prop_assert!(least * (1.0 - 1e-12) <= radius && radius <= most * (1.0 + 1e-12));
            }
        }
    }

    #[test]
    fn a_centroid_is_inside_its_triangle([a, b, c] in prop::array::uniform3(point())) {
        let turn = (b - a).perp_dot(c - a);
        prop_assume!(turn.abs() > 1e-3);
        let e = centroid([a, b, c]);
        for [p, q] in [[a, b], [b, c], [c, a]] {
            prop_assert!(((q - p).perp_dot(e - p) - turn / 3.0).abs() < 1e-9);
        }
    }

    #[test]
    fn the_radius_ratio_is_that_of_the_edge_lengths([a, b, c] in prop::array::uniform3(point())) {
        let [la, lb, lc] = [b.distance(c), c.distance(a), a.distance(b)];
        let by_lengths = (lc + lb - la) * (lc + la - lb) * (la + lb - lc) / (la * lb * lc);
        prop_assert!((radius_ratio([a, b, c]) - by_lengths).abs() < 1e-9);
    }
}

/// The outline with these loops of point numbers.
fn region(points: &[[f64; 2]], loops: &[&[usize]]) -> Subcomplex2 {
    let edges = loops.iter().flat_map(|nodes| {
        let next = nodes.iter().cycle().skip(1);
        nodes
            .iter()
            .zip(next)
            .map(|(&a, &b)| [a, b].map(VertexId::new))
    });
    let points = points.iter().copied().map(DVec2::from);
    let outline = Outline::new(points.collect(), edges.collect()).expect("closed loops");
    let region = outline.region(BuildOptions::default(), &mut silent);
    region.expect("loops that do not cross").subcomplex()
}

#[test]
fn an_equilateral_triangle_of_boundary_edges_has_density_one() {
    let corners = [[0.0, 0.0], [1.0, 0.0], [0.5, 0.75f64.sqrt()]];
    let nodes = boundary_bubbles(&region(&corners, &[&[0, 1, 2]]));
    assert!((nodes[0].radius - 0.3713).abs() < 5e-5);
    assert!(near(bubble_density([nodes[0], nodes[1], nodes[2]]), 1.0));
}

#[test]
fn every_boundary_node_sees_the_edge_before_and_the_edge_after() {
    let corners = [[0.0, 0.0], [3.0, 0.0], [3.0, 4.0]];
    for nodes in [[0, 1, 2], [2, 1, 0], [1, 2, 0]] {
        let bubbles = boundary_bubbles(&region(&corners, &[&nodes]));
        let radii: Vec<f64> = bubbles.iter().map(|b| b.radius).collect();
        let expected =
            [[3.0, 5.0], [3.0, 4.0], [4.0, 5.0]].map(|edges| boundary_node_radius(&edges));
        assert_eq!(radii, expected);
        assert!(
            bubbles
                .iter()
                .zip(corners)
                .all(|(b, corner)| b.center == DVec2::from(corner))
        );
    }
}

#[test]
fn a_node_where_loops_touch_sees_all_its_edges() {
    // Edges of 3 and 1 to the right, of 2 and 2 to the left: √3/4 of (9 + 1 + 4 + 4) / 4.
    let points = [[0.0, 0.0], [3.0, 0.0], [0.0, 1.0], [-2.0, 0.0], [0.0, -2.0]];
    let bubbles = boundary_bubbles(&region(&points, &[&[0, 1, 2], &[0, 3, 4]]));
    assert!(near(bubbles[0].area(), 3f64.sqrt() / 4.0 * 4.5));
    assert!(near(
        bubbles[3].area(),
        3f64.sqrt() / 4.0 * (4.0 + 8.0) / 2.0
    ));
}

#[test]
fn equations_1_to_5_by_hand() {
    // l1 = 1, l2 = 2: (√3/4 + √3) / 2.
    assert!(near(
        boundary_node_area(&[1.0, 2.0]),
        1.082_531_754_730_548_3
    ));
    assert!(near(
        boundary_node_radius(&[1.0, 2.0]),
        0.587_009_846_287_624
    ));
    // The centroid (1, 1) of (0, 0), (3, 0), (0, 3): distances √2, √5, √5, so the weights of radii 1, 2, 3 are
    // 0.7071, 0.4472, 0.4472.
    let nodes = [([0.0, 0.0], 1.0), ([3.0, 0.0], 2.0), ([0.0, 3.0], 3.0)];
    let nodes = nodes.map(|(center, radius)| Bubble {
        center: center.into(),
        radius,
    });
    let element = Bubble::of_element(nodes);
    let expected =
        (1.0 / 2f64.sqrt() + 5.0 / 5f64.sqrt()) / (1.0 / 2f64.sqrt() + 2.0 / 5f64.sqrt());
    assert_eq!(element.center, DVec2::ONE);
    assert!(near(element.radius, expected) && (expected - 1.837_722).abs() < 1e-6);
    assert!(near(bubble_density(nodes), PI * expected * expected / 4.5));
}

#[test]
fn equations_7_to_9_by_hand() {
    let bubble = |x: f64, y: f64, radius| Bubble {
        center: DVec2::new(x, y),
        radius,
    };
    let current = bubble(0.0, 0.0, 1.0);
    // Distances 1.5, 1.25 and 5, overlaps 0.5, 0.25 and none.
    let nearby = [
        bubble(1.5, 0.0, 1.0),
        bubble(-0.75, -1.0, 0.5),
        bubble(3.0, 4.0, 4.0),
    ];
    let forces = nearby.map(|other| repulsion(current, other));
    assert!(forces[0].abs_diff_eq(DVec2::new(-0.5, 0.0), 1e-15));
    assert!(forces[1].abs_diff_eq(DVec2::new(0.15, 0.2), 1e-15));
    assert_eq!(forces[2], DVec2::ZERO);
    assert!(moved(current, nearby, 0.1).abs_diff_eq(DVec2::new(-0.035, 0.02), 1e-15));
    // (1/1.5 + 0.5/1.25) / (1/1.5 + 1/1.25)
    assert!(near(resized(current, nearby), 16.0 / 22.0));
    assert_eq!(resized(current, [nearby[2]]), 1.0);
    // Bubbles in one place have no direction and no weight.
    assert_eq!(repulsion(current, current), DVec2::ZERO);
    assert_eq!(resized(current, [bubble(0.0, 0.0, 7.0)]), 1.0);
}

#[test]
fn degenerate_elements_have_a_radius_and_no_room() {
    let node = |x: f64, radius| Bubble {
        center: DVec2::new(x, 0.0),
        radius,
    };
    let one_place = [node(1.0, 1.0), node(1.0, 2.0), node(1.0, 6.0)];
    assert_eq!(Bubble::of_element(one_place).radius, 3.0);
    assert_eq!(bubble_density(one_place), f64::INFINITY);
    let centroid_in_a_node = [node(0.0, 1.0), node(-1.0, 5.0), node(1.0, 7.0)];
    assert_eq!(Bubble::of_element(centroid_in_a_node).radius, 1.0);
    assert_eq!(bubble_density(centroid_in_a_node), f64::INFINITY);
}
