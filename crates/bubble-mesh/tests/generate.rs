//! Meshes of convex regions: valid, filled and bounded, and what is refused.

use std::f64::consts::PI;
use std::ops::ControlFlow;

use bubble_mesh::{Bubble, Domain, DomainError, Mesh, Params, Stop, generate};
use delaunay_core::VertexId;
use delaunay_core::measure::triangle;
use delaunay_core::progress::silent;
use glam::DVec2;
use proptest::prelude::*;

/// Nodes of the unit circle, unevenly spaced.
fn circle() -> impl Strategy<Value = Vec<DVec2>> {
    prop::collection::vec(0.1..1.0f64, 5..40).prop_map(|steps| {
        let turn: f64 = steps.iter().sum();
        let angles = steps.iter().scan(0.0, |angle, step| {
            *angle += step * 2.0 * PI / turn;
            Some(*angle)
        });
        angles.map(DVec2::from_angle).collect()
    })
}

/// A square with `count` edges on each side.
fn square(count: u32) -> Vec<DVec2> {
    let side = |i: u32| f64::from(i) / f64::from(count);
    let bottom = (0..count).map(move |i| DVec2::new(side(i), 0.0));
    let right = (0..count).map(move |i| DVec2::new(1.0, side(i)));
    let top = (0..count).map(move |i| DVec2::new(side(count - i), 1.0));
    let left = (0..count).map(move |i| DVec2::new(0.0, side(count - i)));
    bottom.chain(right).chain(top).chain(left).collect()
}

fn mesh(nodes: &[DVec2], params: &Params) -> Mesh {
    generate(
        Domain::convex(nodes).expect("a convex boundary"),
        params,
        &mut silent,
    )
}

fn element_area(mesh: &Mesh) -> f64 {
    let corners = |f| {
        mesh.delaunay
            .mesh()
            .face_vertices(f)
            .map(|v| mesh.bubbles[v.index()])
    };
    mesh.delaunay
        .faces()
        .map(|f| Bubble::of_element(corners(f)).area())
        .sum()
}

fn area(mesh: &Mesh) -> f64 {
    mesh.delaunay
        .faces()
        .map(|f| triangle::area(mesh.delaunay.triangle(f)))
        .sum()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn bubbles_cover_the_region_when_it_is_filled(nodes in circle()) {
        let mesh = mesh(&nodes, &Params::default());
        prop_assert_eq!(mesh.stop, Stop::Filled);
        prop_assert_eq!(mesh.delaunay.check(), Ok(()));
        prop_assert!(element_area(&mesh) >= area(&mesh) * (1.0 - 1e-9));
    }

    #[test]
    fn one_node_less_would_not_fill_the_region(nodes in circle()) {
        let full = mesh(&nodes, &Params::default());
        prop_assume!(full.bubbles.len() > nodes.len());
        let less = mesh(&nodes, &Params { nodes: full.bubbles.len() - 1 });
        prop_assert_eq!(less.stop, Stop::OutOfNodes);
        prop_assert!(element_area(&less) < area(&less) * (1.0 + 1e-9));
        prop_assert_eq!(&less.bubbles[..], &full.bubbles[..less.bubbles.len()]);
    }

    #[test]
    fn bubbles_and_triangles_stay_within_the_bounds_of_the_boundary(nodes in circle()) {
        let mesh = mesh(&nodes, &Params::default());
        let (boundary, inner) = mesh.bubbles.split_at(nodes.len());
        let radii = boundary.iter().map(|bubble| bubble.radius);
        let (least, largest) = (radii.clone().fold(f64::MAX, f64::min), radii.fold(0.0, f64::max));
        for bubble in inner {
            prop_assert!(bubble.radius > least * (1.0 - 1e-12) && bubble.radius < largest * (1.0 + 1e-12));
        }
        let bound = area(&mesh) / (PI * least * least) + 2.0;
        prop_assert!(mesh.delaunay.faces().count() as f64 <= bound.max(nodes.len() as f64));
    }

    #[test]
    fn boundary_edges_stay_and_nodes_keep_their_ids(nodes in circle()) {
        let mesh = mesh(&nodes, &Params::default());
        let hull: Vec<usize> = mesh.delaunay.hull_vertices().map(VertexId::index).collect();
        prop_assert_eq!(hull.len(), nodes.len());
        prop_assert_eq!(&mesh.delaunay.points()[..nodes.len()], &nodes[..]);
        for (bubble, point) in mesh.bubbles.iter().zip(mesh.delaunay.points()) {
            prop_assert_eq!(bubble.center, *point);
        }
    }
}

#[test]
fn a_square_in_either_sense_is_meshed_with_as_many_triangles_as_its_edges_ask_for() {
    for turn in [false, true] {
        let mut nodes = square(20);
        if turn {
            nodes.reverse();
        }
        let mesh = mesh(&nodes, &Params::default());
        // An equilateral triangle on an edge of length 1/20 has the area √3/1600: 924 of them.
        let triangles = mesh.delaunay.faces().count();
        assert!((850..1000).contains(&triangles), "{triangles}");
        assert_eq!(mesh.delaunay.hull().count(), 80);
    }
}

#[test]
fn a_report_that_breaks_leaves_the_boundary_mesh() {
    let domain = Domain::convex(&square(5)).unwrap();
    let mesh = generate(domain, &Params::default(), &mut |_| ControlFlow::Break(()));
    assert_eq!((mesh.stop, mesh.bubbles.len()), (Stop::Cancelled, 20));
}

#[test]
fn a_budget_below_the_boundary_leaves_the_boundary_mesh() {
    let mesh = mesh(&square(5), &Params { nodes: 0 });
    assert_eq!((mesh.stop, mesh.bubbles.len()), (Stop::OutOfNodes, 20));
}

#[test]
fn what_is_not_convex_is_refused_with_the_node() {
    let refusal = |nodes: &[[f64; 2]]| -> DomainError {
        let nodes: Vec<DVec2> = nodes.iter().copied().map(DVec2::from).collect();
        Domain::convex(&nodes).unwrap_err()
    };
    let dart = refusal(&[[0.0, 0.0], [4.0, 0.0], [1.0, 1.0], [0.0, 4.0]]);
    insta::assert_snapshot!(dart, @"the boundary is not convex at node 2, or crosses itself there");
    let bow_tie = refusal(&[[0.0, 0.0], [1.0, 1.0], [1.0, 0.0], [0.0, 1.0]]);
    insta::assert_snapshot!(bow_tie, @"the boundary is not convex at node 0, or crosses itself there");
    let twice = refusal(&[
        [0.0, 0.0],
        [1.0, 0.0],
        [0.0, 1.0],
        [0.0, 0.0],
        [1.0, 0.0],
        [0.0, 1.0],
    ]);
    insta::assert_snapshot!(twice, @"the boundary is not convex at node 3, or crosses itself there");
    let line = refusal(&[[0.0, 0.0], [1.0, 0.0], [2.0, 0.0]]);
    insta::assert_snapshot!(line, @"the 3 distinct points lie on one line, from v0 to v2");
    insta::assert_snapshot!(refusal(&[[0.0, 0.0]]), @"1 nodes do not make a closed boundary");
}
