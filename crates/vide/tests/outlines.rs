//! Outlines in every kind of file, meshed and refined from outside.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

mod folder;

use folder::{Folder, text};
use vide::glam::DVec2;
use vide::mesh_io::{Cell, read_mesh};

/// A square of 4 with a square hole of 2 and an island of 1 in it; a square of 1 beside it.
const GEOJSON: &str = r#"{"type": "FeatureCollection", "features": [
  {"type": "Feature", "properties": {"name": "land", "marker": 3}, "geometry": {"type": "MultiPolygon", "coordinates": [
    [[[0, 0], [4, 0], [4, 4], [0, 4], [0, 0]], [[1, 1], [1, 3], [3, 3], [3, 1], [1, 1]]],
    [[[1.5, 1.5], [2.5, 1.5], [2.5, 2.5], [1.5, 2.5], [1.5, 1.5]]]]}},
  {"type": "Feature", "properties": null, "geometry": {"type": "Polygon", "coordinates": [
    [[5, 0, 7], [6, 0, 7], [6, 1, 7], [5, 1, 7], [5, 0, 7]]]}}]}"#;

/// A disk of radius 10 without a rectangle of 6 by 4, moved and turned.
const SVG: &str = r#"<?xml version="1.0"?>
<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 100 100">
  <defs><circle r="99"/></defs>
  <g transform="translate(50 50) rotate(30)">
    <path d="M -10 0 A 10 10 0 0 1 10 0 A 10 10 0 0 1 -10 0 Z"/>
    <rect x="-3" y="-2" width="6" height="4"/>
  </g>
</svg>"#;

/// A pentagon and a triangle on one of its sides.
const OFF: &str = "OFF\n6 2 0\n0 0 0\n2 0 0\n3 1 0\n2 2 0\n0 2 0\n4 2 0\n5 0 1 2 3 4\n3 2 5 3\n";

fn area(folder: &Folder, command: &str) -> f64 {
    let output = folder.vide(&command.split(' ').collect::<Vec<_>>());
    assert!(
        output.status.success(),
        "{command}: {}",
        text(&output.stderr)
    );
    let mesh = read_mesh(&folder.path("out.vtu")).unwrap();
    let place = |v: u32| DVec2::new(mesh.points[v as usize][0], mesh.points[v as usize][1]);
    let areas = mesh.cells.iter().filter_map(|cell| match cell {
        Cell::Triangle(corners) => {
            let [a, b, c] = corners.map(place);
            Some((b - a).perp_dot(c - a) / 2.0)
        }
        _ => None,
    });
    areas.sum()
}

#[test]
fn every_kind_of_outline_is_meshed_and_refined() {
    let folder = Folder::with(&[
        ("land.geojson", GEOJSON),
        ("land.json", GEOJSON),
        ("disk.svg", SVG),
        ("polygons.off", OFF),
    ]);
    let disk = std::f64::consts::PI * 100.0 - 24.0;
    for (file, size, expected, within) in [
        ("land.geojson", 0.4, 14.0, 1e-12),
        ("land.json", 0.4, 14.0, 1e-12),
        ("disk.svg", 2.0, disk, 0.01),
        ("polygons.off", 0.4, 6.0, 1e-12),
    ] {
        for command in [
            "bubble",
            "bubble --boundary resample",
            "refine",
            "refine --boundary split",
        ] {
            let (first, rest) = command.split_once(' ').unwrap_or((command, ""));
            let mut arguments = format!("{first} {file} -o out.vtu -q --size {size}");
            if !rest.is_empty() {
                arguments += &format!(" {rest}");
            }
            let found = area(&folder, &arguments);
            assert!(
                (found / expected - 1.0).abs() < within,
                "{arguments}: {found}"
            );
        }
    }
}

#[test]
fn a_mesh_without_its_inside_is_an_outline() {
    let folder = Folder::with(&[("polygons.off", OFF)]);
    let first = area(&folder, "bubble polygons.off -o out.vtu -q --size 0.3");
    std::fs::rename(folder.path("out.vtu"), folder.path("in.vtu")).unwrap();
    let again = area(&folder, "bubble in.vtu -o out.vtu -q --size 0.3");
    assert!((first / again - 1.0).abs() < 1e-12);
}
