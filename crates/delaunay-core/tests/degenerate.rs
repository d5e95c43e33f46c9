//! Hostile input: numbers that are none, floods of equal points, lines, absurd counts.

#![allow(clippy::unwrap_used)]

mod clouds;

use delaunay_core::progress::Progress;
use delaunay_core::{
    BuildError, ConvexPolygon, Delaunay2, Extent, InsertError, Inserted, RemoveError, VertexId,
};
use glam::DVec2;
use std::ops::ControlFlow;

fn flat(points: &[DVec2]) -> delaunay_core::Flat {
    match Delaunay2::build(points) {
        Err(BuildError::Flat(flat)) => *flat,
        other => panic!("not flat: {other:?}"),
    }
}

#[test]
fn a_bad_coordinate_names_its_point() {
    for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e300, 1e-300] {
        let mut points = clouds::uniform(100, 1);
        points[37].y = value;
        match Delaunay2::build(&points) {
            Err(BuildError::Coordinate(error)) => assert_eq!(error.index, 37),
            other => panic!("{value}: {other:?}"),
        }
    }
}

#[test]
fn questions_about_bad_coordinates_are_refused() {
    let mut delaunay = Delaunay2::build(&clouds::grid(3, 3)).unwrap();
    for bad in [
        DVec2::NAN,
        DVec2::new(0.0, f64::INFINITY),
        DVec2::splat(1e200),
    ] {
        assert!(delaunay.locate(bad).is_err());
        assert!(delaunay.nearest_vertex(bad).is_err());
        assert!(delaunay.cavity(bad).is_err());
        assert!(matches!(
            delaunay.insert(bad),
            Err(InsertError::Coordinate(_))
        ));
    }
    assert_eq!(delaunay.check(), Ok(()));
}

#[test]
fn no_points_one_place_and_a_line_are_told_apart() {
    assert_eq!(flat(&[]).extent(), Extent::Empty);
    let place = flat(&[DVec2::ONE; 3]);
    assert_eq!(place.extent(), Extent::Point);
    assert_eq!(place.vertices, [VertexId::new(0)]);
    assert_eq!(place.duplicates.len(), 2);
    let line = flat(&[[2.0, 2.0], [0.0, 0.0], [2.0, 2.0], [1.0, 1.0]].map(DVec2::from));
    assert_eq!(line.extent(), Extent::Line);
    assert_eq!(line.vertices, [1, 3, 0].map(VertexId::new));
    let pairs: Vec<_> = line.duplicates.iter().collect();
    assert_eq!(pairs, [(VertexId::new(2), VertexId::new(0))]);
}

#[test]
fn both_zeros_are_one_place() {
    let points = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [-0.0, 0.0], [0.0, -0.0]];
    let delaunay = Delaunay2::build(&points.map(DVec2::from)).unwrap();
    assert_eq!(delaunay.duplicates().len(), 2);
    assert!(flat(&[DVec2::ZERO, -DVec2::ZERO]).extent() == Extent::Point);
}

#[test]
fn a_million_equal_points_are_one_place() {
    let points = vec![DVec2::new(0.1, 0.2); 1_000_000];
    assert_eq!(flat(&points).duplicates.len(), 999_999);
    let mut points = points;
    points.extend([DVec2::ZERO, DVec2::X]);
    let delaunay = Delaunay2::build(&points).unwrap();
    assert_eq!(delaunay.vertex_count(), 3);
    assert_eq!(delaunay.duplicates().len(), 999_999);
    assert!(
        delaunay
            .duplicates()
            .iter()
            .all(|(_, v)| v == VertexId::new(0))
    );
}

#[test]
fn a_long_line_is_sorted_and_one_more_point_makes_a_fan() {
    let mut points: Vec<DVec2> = (0..100_000)
        .map(|i| DVec2::new(f64::from(i * 7 % 100_000), 1.0))
        .collect();
    let line = flat(&points);
    let x: Vec<f64> = line.vertices.iter().map(|v| points[v.index()].x).collect();
    assert!(x.is_sorted() && x.len() == 100_000);
    points.push(DVec2::new(0.0, 2.0));
    let delaunay = Delaunay2::build(&points).unwrap();
    assert_eq!(delaunay.faces().count(), 99_999);
    assert_eq!(delaunay.check(), Ok(()));
}

#[test]
fn a_dense_cluster_far_from_an_outlier_stays_fast() {
    let mut points = clouds::scaled(&clouds::uniform(100_000, 3), -60);
    points.push(DVec2::splat(1.0));
    let delaunay = Delaunay2::build(&points).unwrap();
    assert_eq!(delaunay.vertex_count(), 100_001);
}

#[test]
fn removing_what_is_no_vertex_is_refused() {
    let mut points = clouds::grid(3, 3);
    points.push(points[4]);
    let mut delaunay = Delaunay2::build(&points).unwrap();
    for vertex in [
        VertexId::GHOST,
        VertexId::new(9),
        VertexId::new(10),
        VertexId::new(1 << 31),
    ] {
        assert_eq!(
            delaunay.remove(vertex),
            Err(RemoveError::NoSuchVertex { vertex })
        );
    }
    let center = VertexId::new(4);
    assert_eq!(delaunay.remove(center), Ok(()));
    assert_eq!(delaunay.duplicates().len(), 0);
    assert_eq!(
        delaunay.remove(center),
        Err(RemoveError::NoSuchVertex { vertex: center })
    );
}

/// Each removal once passed over all duplicates.
#[test]
fn removing_many_vertices_that_have_duplicates_takes_no_quadratic_time() {
    let points = clouds::uniform(100_000, 8);
    let mut delaunay = Delaunay2::build(&[points.clone(), points].concat()).unwrap();
    for v in (0..99_000).map(VertexId::new) {
        assert_eq!(delaunay.remove(v), Ok(()));
    }
    assert_eq!(delaunay.duplicates().len(), 1000);
    assert_eq!(delaunay.check(), Ok(()));
}

#[test]
fn the_last_vertex_off_a_line_cannot_be_removed() {
    let mut delaunay = Delaunay2::build(&clouds::line_and_one(5)).unwrap();
    let vertex = VertexId::new(5);
    assert_eq!(
        delaunay.remove(vertex),
        Err(RemoveError::RestIsFlat { vertex })
    );
    assert_eq!(delaunay.check(), Ok(()));
    for v in 0..3 {
        assert_eq!(delaunay.remove(VertexId::new(v)), Ok(()));
        assert_eq!(delaunay.check(), Ok(()));
    }
    for vertex in [3, 4, 5].map(VertexId::new) {
        assert_eq!(
            delaunay.remove(vertex),
            Err(RemoveError::RestIsFlat { vertex })
        );
    }
}

#[test]
fn the_hub_of_a_large_wheel_comes_and_goes() {
    let spokes = 20_000;
    let mut points: Vec<DVec2> = (0..spokes)
        .map(|i| DVec2::from_angle(f64::from(i) / f64::from(spokes) * std::f64::consts::TAU))
        .collect();
    points.push(DVec2::ZERO);
    let mut delaunay = Delaunay2::build(&points).unwrap();
    let hub = VertexId::new(spokes as usize);
    let before = delaunay.mesh().canonical();
    assert_eq!(delaunay.mesh().neighbors(hub).count(), spokes as usize);
    let window = ConvexPolygon::rectangle(DVec2::splat(-1.0), DVec2::splat(1.0)).unwrap();
    let cell = delaunay.voronoi().cell(hub, &window);
    assert!((cell.area() - 0.25 * std::f64::consts::PI).abs() < 1e-7);
    assert_eq!(delaunay.remove(hub), Ok(()));
    assert_eq!(delaunay.check(), Ok(()));
    assert_eq!(delaunay.insert(DVec2::ZERO).map(Inserted::vertex), Ok(hub));
    assert!(delaunay.mesh().canonical() == before);
}

#[test]
fn a_build_reports_all_its_steps_and_stops_when_told() {
    let points = clouds::uniform(20_000, 9);
    let mut reports = Vec::new();
    let mut listen = |progress: Progress| {
        reports.push(progress);
        ControlFlow::Continue(())
    };
    assert!(Delaunay2::build_with(&points, &mut listen).is_ok());
    assert!(reports.is_sorted_by(|a, b| a.done < b.done) && reports.len() == 5);
    let mut stop = |progress: Progress| match progress.done {
        0 => ControlFlow::Continue(()),
        _ => ControlFlow::Break(()),
    };
    match Delaunay2::build_with(&points, &mut stop) {
        Err(BuildError::Cancelled(cancelled)) => assert_eq!(cancelled.done, 4096),
        other => panic!("{:?}", other.map(|_| ())),
    }
}

/// The ghost of the patch once passed for vertex 0 of the link when the hole was inside the hull.
#[test]
fn a_hole_whose_link_is_all_of_its_hull_is_filled_on_the_inside() {
    let points = [[1.0, 1.0], [4.0, 2.0], [2.0, 1.0], [0.0, 0.0], [0.0, 1.0]].map(DVec2::from);
    let mut delaunay = Delaunay2::build(&points).unwrap();
    assert_eq!(delaunay.remove(VertexId::new(0)), Ok(()));
    assert_eq!(delaunay.check(), Ok(()));
    assert_eq!(delaunay.faces().count(), 2);
}
