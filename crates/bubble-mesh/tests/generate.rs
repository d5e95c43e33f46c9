//! Meshes that are generated: valid, filled and bounded, whatever the form of the region.

mod regions;

use std::f64::consts::PI;
use std::ops::ControlFlow;

use bubble_mesh::paper::{Mesh, Params, Stop, generate};
use bubble_mesh::{Bubble, Domain, DomainError};
use delaunay_core::measure::triangle;
use delaunay_core::progress::{Progress, silent};
use delaunay_core::{BuildOptions, Outline, Subcomplex2, VertexId};
use glam::DVec2;
use proptest::prelude::*;
use regions::{circle, domain, element_area, even, square};

/// A disk whose boundary is unevenly spaced, with a round hole anywhere in it or without.
fn disk() -> impl Strategy<Value = Domain> {
    let steps = prop::collection::vec(0.3..1.0f64, 12..40);
    let hole = prop::option::of((0.0..0.4f64, 0.1..0.3f64, 8..24u32));
    (steps, hole).prop_map(|(steps, hole)| {
        let whole: f64 = steps.iter().sum();
        let turns = steps.iter().scan(0.0, |turn, step| {
            *turn += step / whole;
            Some(*turn)
        });
        let mut loops = vec![circle(DVec2::ZERO, 1.0, turns)];
        let hole = hole.map(|(x, radius, nodes)| circle(DVec2::new(x, 0.1), radius, even(nodes)));
        loops.extend(hole);
        domain(&loops)
    })
}

fn with_nodes(nodes: usize) -> Params {
    Params {
        nodes,
        ..Params::paper()
    }
}

fn mesh(domain: &Domain) -> Mesh {
    generate(domain, &Params::paper(), &mut silent)
}

fn area(region: &Subcomplex2) -> f64 {
    let areas = region.faces().map(|f| triangle::area(region.triangle(f)));
    areas.sum()
}

/// The ends of the boundary edges, in order.
fn boundary(region: &Subcomplex2) -> Vec<[VertexId; 2]> {
    let mesh = region.mesh();
    let ends = region.boundary().map(|h| [mesh.origin(h), mesh.target(h)]);
    let mut ends: Vec<_> = ends.collect();
    ends.sort_unstable();
    ends
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn bubbles_cover_the_region_when_it_is_filled(domain in disk()) {
        let mesh = mesh(&domain);
        prop_assert_eq!(mesh.stop(), Stop::Filled);
        prop_assert_eq!(mesh.region().check(), Ok(()));
        let covered = element_area(mesh.region(), mesh.bubbles());
        prop_assert!(covered >= domain.area() * (1.0 - 1e-12));
    }

    #[test]
    fn one_node_less_would_not_fill_the_region(domain in disk()) {
        let full = mesh(&domain);
        prop_assume!(full.bubbles().len() > domain.bubbles().len());
        let less = generate(&domain, &with_nodes(full.bubbles().len() - 1), &mut silent);
        prop_assert_eq!(less.stop(), Stop::OutOfNodes);
        let covered = element_area(less.region(), less.bubbles());
        prop_assert!(covered < domain.area() * (1.0 + 1e-12));
        prop_assert_eq!(less.bubbles(), &full.bubbles()[..less.bubbles().len()]);
    }

    #[test]
    fn bubbles_and_triangles_stay_within_the_bounds_of_the_boundary(domain in disk()) {
        let mesh = mesh(&domain);
        let (boundary, inner) = mesh.bubbles().split_at(mesh.boundary_nodes());
        let radii = boundary.iter().map(|bubble| bubble.radius);
        let (least, largest) = (radii.clone().fold(f64::MAX, f64::min), radii.fold(0.0, f64::max));
        for bubble in inner {
            prop_assert!(bubble.radius > least * (1.0 - 1e-12) && bubble.radius < largest * (1.0 + 1e-12));
        }
        let bound = domain.area() / (PI * least * least) + 2.0;
        let initial = domain.region().faces().count() as f64;
        prop_assert!(mesh.region().faces().count() as f64 <= bound.max(initial));
    }

    #[test]
    fn area_boundary_edges_and_boundary_nodes_stay(domain in disk()) {
        let mesh = mesh(&domain);
        prop_assert!((area(mesh.region()) / domain.area() - 1.0).abs() < 1e-12);
        prop_assert_eq!(boundary(mesh.region()), boundary(domain.region()));
        prop_assert_eq!(&mesh.bubbles()[..mesh.boundary_nodes()], domain.bubbles());
        for (bubble, point) in mesh.bubbles().iter().zip(mesh.region().points()) {
            prop_assert_eq!(bubble.center, *point);
        }
    }
}

#[test]
fn the_regions_of_the_paper_are_filled() {
    for (name, domain) in regions::of_the_paper() {
        let mesh = mesh(&domain);
        assert_eq!(mesh.stop(), Stop::Filled, "{name}");
        assert_eq!(mesh.region().check(), Ok(()), "{name}");
        assert_eq!(boundary(mesh.region()), boundary(domain.region()), "{name}");
        let covered = element_area(mesh.region(), mesh.bubbles());
        assert!(
            (1.0..1.01).contains(&(covered / domain.area())),
            "{name}: {covered}"
        );
    }
}

#[test]
fn a_square_is_meshed_with_as_many_triangles_as_its_edges_ask_for_however_it_lies() {
    // An equilateral triangle on an edge of length 1/20 has the area √3/1600: 924 of them.
    for angle in [0.0, 0.1, 0.3, 1.0] {
        let mesh = mesh(&domain(&[square(20, angle)]));
        let triangles = mesh.region().faces().count();
        assert!((850..1000).contains(&triangles), "{angle}: {triangles}");
        assert_eq!(mesh.region().boundary().count(), 80);
    }
}

#[test]
fn the_order_of_the_nodes_does_not_matter() {
    let points_of = |domain: &Domain| {
        let mesh = mesh(domain);
        let mut points: Vec<[f64; 2]> =
            mesh.region().points().iter().map(DVec2::to_array).collect();
        points.sort_unstable_by(|p, q| p.partial_cmp(q).unwrap());
        points
    };
    let nodes = circle(DVec2::new(0.3, 0.2), 1.0, even(37));
    let turned: Vec<DVec2> = nodes[5..]
        .iter()
        .chain(&nodes[..5])
        .rev()
        .copied()
        .collect();
    let [given, turned] = [nodes, turned].map(|nodes| points_of(&domain(&[nodes])));
    assert_eq!(given.len(), turned.len());
    // Centroids round differently with the corner that comes first.
    let differ = |(p, q): (&[f64; 2], &[f64; 2])| DVec2::from(*p).distance(DVec2::from(*q));
    assert!(given.iter().zip(&turned).map(differ).fold(0.0, f64::max) < 1e-9);
}

#[test]
fn parts_that_touch_at_a_node_are_both_filled() {
    let mesh = mesh(&regions::of_outline(&regions::touching_squares()));
    assert_eq!((mesh.stop(), mesh.region().check()), (Stop::Filled, Ok(())));
    let right_side = mesh.region().points().iter().filter(|p| p.x > 0.0).count();
    let left_side = mesh.region().points().iter().filter(|p| p.x < 0.0).count();
    assert!(right_side > 100 && right_side.abs_diff(left_side) < 8);
}

#[test]
fn a_report_that_breaks_leaves_a_mesh() {
    let domain = domain(&[square(100, 0.0)]);
    let stop_at = |nodes: usize| {
        move |progress: Progress| match progress.done >= nodes {
            true => ControlFlow::Break(()),
            false => ControlFlow::Continue(()),
        }
    };
    for (nodes, boundary_and_nodes) in [(0, 400), (4096, 4496)] {
        let mesh = generate(&domain, &Params::paper(), &mut stop_at(nodes));
        assert_eq!(mesh.stop(), Stop::Cancelled);
        assert_eq!(mesh.bubbles().len(), boundary_and_nodes);
        assert_eq!(mesh.region().check(), Ok(()));
    }
}

#[test]
fn a_budget_below_the_boundary_leaves_the_boundary_mesh() {
    let mesh = generate(&domain(&[square(5, 0.0)]), &with_nodes(0), &mut silent);
    assert_eq!((mesh.stop(), mesh.bubbles().len()), (Stop::OutOfNodes, 20));
}

#[test]
fn a_region_at_the_limit_of_resolution_stops_growing() {
    // Edges of a few units in the last place: no centroid can be told from its corners.
    let ulp = f64::EPSILON;
    let corners = [[1.0, 1.0], [1.0 + ulp, 1.0], [1.0, 1.0 + ulp]].map(DVec2::from);
    let mesh = mesh(&domain(&[corners.to_vec()]));
    assert_eq!((mesh.stop(), mesh.bubbles().len()), (Stop::OutOfRoom, 3));
    let radius = |bubble: &Bubble| bubble.radius > 0.0;
    assert!(mesh.bubbles().iter().all(radius));
}

#[test]
fn what_bounds_no_region_is_refused_by_the_element() {
    let refusal = |outline: &Outline| -> DomainError {
        Domain::new(outline, BuildOptions::default(), &mut silent).unwrap_err()
    };
    let bow_tie = [[0.0, 0.0], [1.0, 1.0], [1.0, 0.0], [0.0, 1.0]].map(DVec2::from);
    let bow_tie = regions::outline(&[bow_tie.to_vec()]);
    insta::assert_snapshot!(refusal(&bow_tie), @"segments 0 and 2 of the outline cross");

    let points = [[0.0, 0.0], [4.0, 0.0], [0.0, 4.0], [1.0, 1.0]].map(DVec2::from);
    let segments = [[0, 1], [1, 2], [2, 0]].map(|ends| ends.map(VertexId::new));
    let dotted = Outline::with_interior(points.to_vec(), segments.to_vec()).unwrap();
    insta::assert_snapshot!(refusal(&dotted), @"v3 is the end of no segment, so nothing says how large its bubble is");

    let line = [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0]].map(DVec2::from);
    let line = regions::outline(&[line.to_vec()]);
    insta::assert_snapshot!(refusal(&line), @"the 3 distinct points lie on one line, from v0 to v2");
}
