//! The Voronoi diagram against its definition.

#![allow(clippy::unwrap_used)]

mod clouds;

use delaunay_core::{ConvexPolygon, Delaunay2, VertexId, VoronoiEdge};
use glam::DVec2;
use proptest::prelude::*;

fn window(low: f64, high: f64) -> ConvexPolygon {
    ConvexPolygon::rectangle(DVec2::splat(low), DVec2::splat(high)).unwrap()
}

/// The smallest square window around the points, half as large again.
fn window_around(points: &[DVec2]) -> ConvexPolygon {
    let low = points.iter().copied().reduce(DVec2::min).unwrap();
    let high = points.iter().copied().reduce(DVec2::max).unwrap();
    let margin = DVec2::splat((high - low).max_element() / 2.0);
    ConvexPolygon::rectangle(low - margin, high + margin).unwrap()
}

#[test]
fn cells_tile_the_window() {
    for (name, points) in clouds::hard_cases() {
        let delaunay = Delaunay2::build(&points).unwrap();
        let window = window_around(&points);
        let cells = delaunay
            .vertices()
            .map(|v| delaunay.voronoi().cell(v, &window));
        let sum: f64 = cells.map(|cell| cell.area()).sum();
        assert!(
            (sum / window.area() - 1.0).abs() < 1e-11,
            "{name}: {sum} {}",
            window.area()
        );
    }
}

#[test]
fn a_convex_window_that_misses_some_vertices_is_tiled_too() {
    let delaunay = Delaunay2::build(&clouds::uniform(300, 8)).unwrap();
    let corners = [[0.2, 0.1], [0.7, 0.2], [1.4, 0.6], [0.5, 0.9]].map(DVec2::from);
    let window = ConvexPolygon::new(corners.to_vec()).unwrap();
    let cells = delaunay
        .vertices()
        .map(|v| delaunay.voronoi().cell(v, &window));
    let sum: f64 = cells.map(|cell| cell.area()).sum();
    assert!((sum / window.area() - 1.0).abs() < 1e-12, "{sum}");
}

#[test]
fn the_corners_of_a_cell_are_nearest_to_its_vertex() {
    let points = clouds::uniform(200, 6);
    let delaunay = Delaunay2::build(&points).unwrap();
    for v in delaunay.vertices() {
        let cell = delaunay.voronoi().cell(v, &window(-0.5, 1.5));
        let centroid = cell.centroid().unwrap();
        assert_eq!(delaunay.nearest_vertex(centroid), Ok(v));
        for &corner in cell.corners() {
            let least = points
                .iter()
                .map(|p| p.distance(corner))
                .fold(f64::MAX, f64::min);
            assert!((delaunay.point(v).distance(corner) - least).abs() < 1e-12);
        }
    }
}

#[test]
fn what_is_no_vertex_has_no_cell() {
    let mut points = clouds::grid(3, 3);
    points.push(points[0]);
    let delaunay = Delaunay2::build(&points).unwrap();
    for v in [VertexId::GHOST, VertexId::new(9), VertexId::new(77)] {
        assert!(delaunay.voronoi().cell(v, &window(0.0, 1.0)).is_empty());
    }
}

#[test]
fn edges_join_the_centers_of_the_faces_and_rays_leave_the_hull() {
    let delaunay = Delaunay2::build(&clouds::uniform(100, 2)).unwrap();
    let (mesh, voronoi) = (delaunay.mesh(), delaunay.voronoi());
    let mut rays = 0;
    for (h, edge) in voronoi.edges() {
        let [a, b] = [mesh.origin(h), mesh.target(h)].map(|v| delaunay.point(v));
        let equidistant = |p: DVec2| {
            let (far, near) = (p.distance(a), p.distance(b));
            (far - near).abs() <= 1e-12 * far.max(1.0)
        };
        match edge {
            VoronoiEdge::Segment { from, to } => {
                assert!(equidistant(from) && equidistant(to));
                // The edge crosses from right to left.
                assert!((b - a).perp_dot(to - from) >= 0.0);
            }
            VoronoiEdge::Ray { from, direction } => {
                rays += 1;
                assert!(equidistant(from) && equidistant(from + direction));
                let apex = delaunay.point(mesh.apex(h));
                assert!(direction.dot(apex - a) < 0.0);
            }
        }
    }
    assert_eq!(rays, delaunay.hull().count());
    assert_eq!(
        voronoi.edges().count(),
        mesh.half_edges().count() / 2 - rays
    );
}

/// Cutting once took quadratic time, 40 seconds for a cell of 100,000 edges.
#[test]
fn the_cell_of_a_focus_is_bounded_by_a_parabola() {
    let count = 100_001;
    let mut points: Vec<DVec2> = (0..count)
        .map(|i| {
            DVec2::new(
                10.0 * (2.0 * f64::from(i) / f64::from(count - 1) - 1.0),
                -1.0,
            )
        })
        .collect();
    points.push(DVec2::Y);
    let delaunay = Delaunay2::build(&points).unwrap();
    let focus = VertexId::new(points.len() - 1);
    let cell = delaunay.voronoi().cell(focus, &window(-4.0, 4.0));
    // Above y = x^2 / 4 and below y = 4.
    assert!((cell.area() - 64.0 / 3.0).abs() < 1e-6, "{}", cell.area());
    assert!(cell.corners().len() > 39_000);
}

#[test]
fn huge_circumcircles_leave_cells_finite() {
    let points: Vec<DVec2> = (0..50)
        .map(|i| DVec2::new(f64::from(i), f64::from(i * i) * f64::EPSILON))
        .collect();
    let delaunay = Delaunay2::build(&points).unwrap();
    let window = ConvexPolygon::rectangle(DVec2::splat(-10.0), DVec2::splat(60.0)).unwrap();
    for v in delaunay.vertices() {
        let cell = delaunay.voronoi().cell(v, &window);
        assert!(cell.corners().iter().all(|corner| corner.is_finite()));
        assert!(cell.area() > 0.0);
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn cells_of_any_cloud_tile_the_window(points in clouds::cloud(30)) {
        let Ok(delaunay) = Delaunay2::build(&points) else { return Ok(()) };
        let window = window(-5.0, 5.0);
        let cells = delaunay.vertices().map(|v| delaunay.voronoi().cell(v, &window));
        let sum: f64 = cells.map(|cell| cell.area()).sum();
        prop_assert!((sum - 100.0).abs() < 1e-9, "{}", sum);
    }
}
