//! The equations of the paper, one by one.

use std::f64::consts::PI;

use bubble_mesh::{
    BoundaryError, Bubble, boundary_bubbles, boundary_node_area, boundary_node_radius,
    bubble_density, centroid, radius_ratio,
};
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
        prop_assert!(near(boundary_node_area(l1, l2), mean));
        let radius = boundary_node_radius(l1, l2);
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

#[test]
fn an_equilateral_triangle_of_boundary_edges_has_density_one() {
    let corners = [[0.0, 0.0], [1.0, 0.0], [0.5, 0.75f64.sqrt()]].map(DVec2::from);
    let nodes = boundary_bubbles(&corners).unwrap();
    assert!((nodes[0].radius - 0.3713).abs() < 5e-5);
    assert!(near(bubble_density([nodes[0], nodes[1], nodes[2]]), 1.0));
}

#[test]
fn every_boundary_node_sees_the_edge_before_and_the_edge_after() {
    let corners = [[0.0, 0.0], [3.0, 0.0], [3.0, 4.0]].map(DVec2::from);
    let radii: Vec<f64> = boundary_bubbles(&corners)
        .unwrap()
        .iter()
        .map(|b| b.radius)
        .collect();
    let expected =
        [(5.0, 3.0), (3.0, 4.0), (4.0, 5.0)].map(|(l1, l2)| boundary_node_radius(l1, l2));
    assert_eq!(radii, expected);
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

#[test]
fn what_is_no_boundary_is_refused_by_the_node() {
    let refusal = |nodes: &[[f64; 2]]| -> BoundaryError {
        let nodes: Vec<DVec2> = nodes.iter().copied().map(DVec2::from).collect();
        boundary_bubbles(&nodes).unwrap_err()
    };
    insta::assert_snapshot!(refusal(&[]), @"0 nodes do not make a closed boundary");
    insta::assert_snapshot!(
        refusal(&[[0.0, 0.0], [1.0, 0.0], [1.0, 0.0], [0.0, 1.0]]),
        @"boundary node 1 and the next one are in the same place"
    );
    insta::assert_snapshot!(
        refusal(&[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [0.0, 0.0]]),
        @"boundary node 3 and the next one are in the same place"
    );
    insta::assert_snapshot!(
        refusal(&[[0.0, 0.0], [1.0, f64::NAN], [0.0, 1.0]]),
        @"point 1 has y = NaN, which is neither zero nor of magnitude 2^-142 to 2^201 (about 1.8e-43 to 3.2e60)"
    );
}
