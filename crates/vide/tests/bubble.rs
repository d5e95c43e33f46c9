//! `vide bubble` from outside: an outline in, graded triangles out.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

mod folder;

use std::collections::BTreeMap;

use folder::{Folder, text};
use serde_json::Value;
use vide::bubble_mesh::radius_ratio;
use vide::glam::DVec2;
use vide::mesh_io::{Cell, Mesh, read_mesh};

const REGION: &[u8] = include_bytes!("../../../fixtures/data/region_square_hole.poly");

fn run(folder: &Folder, arguments: &str) -> String {
    let output = folder.vide(&arguments.split(' ').collect::<Vec<_>>());
    assert!(
        output.status.success(),
        "{arguments}: {}",
        text(&output.stderr)
    );
    text(&output.stdout)
}

fn triangles(mesh: &Mesh) -> Vec<[DVec2; 3]> {
    let place = |v: u32| {
        let [x, y, _] = mesh.points[v as usize];
        DVec2::new(x, y)
    };
    let triangles = mesh.cells.iter().filter_map(|cell| match cell {
        Cell::Triangle(corners) => Some(corners.map(place)),
        Cell::Segment(_) => None,
        cell => panic!("{cell:?} is neither a triangle nor an edge of the boundary"),
    });
    triangles.collect()
}

fn area(mesh: &Mesh) -> f64 {
    let doubled = triangles(mesh).into_iter();
    let doubled = doubled.map(|[a, b, c]| (b - a).perp_dot(c - a));
    doubled.sum::<f64>() / 2.0
}

fn least_ratio(mesh: &Mesh) -> f64 {
    let ratios = triangles(mesh).into_iter().map(radius_ratio);
    ratios.fold(1.0, f64::min)
}

#[test]
fn an_outline_becomes_triangles_a_picture_and_a_report() {
    let folder = Folder::with(&[("region.poly", REGION)]);
    let said = run(
        &folder,
        "bubble region.poly -o out.vtu -o out.off --svg out.svg --report out.json",
    );
    let mesh = read_mesh(&folder.path("out.vtu")).unwrap();
    assert!(least_ratio(&mesh) > 0.9);
    assert_eq!(
        triangles(&mesh).len(),
        triangles(&read_mesh(&folder.path("out.off")).unwrap()).len()
    );
    let report: Value =
        serde_json::from_slice(&std::fs::read(folder.path("out.json")).unwrap()).unwrap();
    assert_eq!(report["elements"], triangles(&mesh).len());
    assert_eq!(report["bubbles"]["boundary_nodes"], 80);
    assert_eq!(report["bubbles"]["poor"]["count"], 0);
    assert_eq!(report["stop"], "finished");
    let first = said.lines().next().unwrap();
    insta::assert_snapshot!(first, @"376 nodes, 80 of them on the outline, and 672 triangles, none below a radius ratio of 0.7");
    assert!(
        std::fs::read_to_string(folder.path("out.svg"))
            .unwrap()
            .contains("radius ratio")
    );
}

#[test]
fn the_paper_a_size_and_trials_make_other_meshes_of_the_same_region() {
    let folder = Folder::with(&[("region.poly", REGION)]);
    let mesh = |options: &str| {
        run(
            &folder,
            &format!("bubble region.poly -o out.vtu -q{options}"),
        );
        read_mesh(&folder.path("out.vtu")).unwrap()
    };
    let plain = mesh("");
    for (options, coarser) in [
        (" --paper", true),
        (" --paper --iterations 3", true),
        (" --size 0.05", false),
        (" --scale 0.5", false),
        (" --scale 1.5", true),
    ] {
        let other = mesh(options);
        assert!(
            (area(&other) / area(&plain) - 1.0).abs() < 1e-12,
            "{options}"
        );
        assert_eq!(
            triangles(&other).len() < triangles(&plain).len(),
            coarser,
            "{options}"
        );
    }
    assert!(least_ratio(&mesh(" --trials 200")) > 0.9);
}

#[test]
fn regions_side_by_side_and_crossings_are_meshed_to_one_mesh() {
    let folder = Folder::with::<&str>(&[]);
    let write = |name: &str, text: &str| std::fs::write(folder.path(name), text).unwrap();
    // Two squares with a common side, and a seed that says so; a loose segment in one of them.
    let regions = "8 2 0 0\n0 0 0\n1 1 0\n2 2 0\n3 2 1\n4 1 1\n5 0 1\n6 0.3 0.5\n7 0.7 0.6\n\
        8 0\n0 0 1\n1 1 2\n2 2 3\n3 3 4\n4 4 5\n5 5 0\n6 1 4\n7 6 7\n0\n1\n0 0.1 0.1 5\n";
    write("regions.poly", regions);
    run(&folder, "bubble regions.poly -o out.vtu --scale 0.3");
    assert!((area(&read_mesh(&folder.path("out.vtu")).unwrap()) - 2.0).abs() < 1e-12);
    // A bow tie.
    write(
        "bow.poly",
        "4 2 0 0\n0 0 0\n1 2 2\n2 2 0\n3 0 2\n4 0\n0 0 1\n1 1 2\n2 2 3\n3 3 0\n0\n",
    );
    run(
        &folder,
        "bubble bow.poly -o out.vtu --crossings divide --scale 0.3",
    );
    assert!((area(&read_mesh(&folder.path("out.vtu")).unwrap()) - 2.0).abs() < 1e-12);
    // Triangles at z = 0 have an outline too.
    run(&folder, "bubble out.vtu -o again.vtu");
    assert!((area(&read_mesh(&folder.path("again.vtu")).unwrap()) - 2.0).abs() < 1e-12);
}

/// Two squares with a common side, the right one with a hole; markers for points, segments and both regions.
const MARKED: &str = "10 2 0 1\n0 0 0 1\n1 1 0 2\n2 2 0 3\n3 2 1 4\n4 1 1 5\n5 0 1 6\n\
    6 1.4 0.4 7\n7 1.6 0.4 8\n8 1.6 0.6 9\n9 1.4 0.6 10\n\
    11 1\n0 0 1 10\n1 1 2 10\n2 2 3 20\n3 3 4 30\n4 4 5 30\n5 5 0 40\n6 1 4 50\n\
    7 6 7 60\n8 7 8 60\n9 8 9 60\n10 9 6 60\n1\n0 1.5 0.5\n2\n0 0.1 0.5 7\n1 1.1 0.5 -3\n";

/// Total length by marker of the edges, total area by marker of the triangles.
fn measures(mesh: &Mesh) -> BTreeMap<i32, f64> {
    let place = |v: u32| DVec2::new(mesh.points[v as usize][0], mesh.points[v as usize][1]);
    let mut sums = BTreeMap::new();
    for (cell, &marker) in mesh.cells.iter().zip(mesh.cell_markers.as_ref().unwrap()) {
        *sums.entry(marker).or_insert(0.0) += match cell {
            Cell::Segment([a, b]) => place(a).distance(place(b)),
            Cell::Triangle(corners) => {
                let [a, b, c] = corners.map(place);
                (b - a).perp_dot(c - a) / 2.0
            }
            cell => panic!("{cell:?}"),
        };
    }
    sums
}

#[test]
fn markers_of_points_segments_and_regions_come_out_again() {
    let folder = Folder::with(&[("in.poly", MARKED)]);
    let expected = [
        (-3, 0.96),
        (7, 1.0),
        (10, 2.0),
        (20, 1.0),
        (30, 2.0),
        (40, 1.0),
        (50, 1.0),
        (60, 0.8),
    ];
    for command in [
        "bubble in.poly --size 0.1",
        "bubble in.poly --paper",
        "bubble in.poly --boundary slide --scale 0.3",
        "bubble in.poly --boundary resample --size 0.1",
        "refine in.poly",
        "refine in.poly --boundary split --size 0.2",
    ] {
        run(
            &folder,
            &format!("{command} -o out.vtu -o out.msh -o out.ele -q"),
        );
        for file in ["out.vtu", "out.msh"] {
            let mesh = read_mesh(&folder.path(file)).unwrap();
            let found = measures(&mesh);
            assert_eq!(found.len(), expected.len(), "{command}: {found:?}");
            for (marker, size) in expected {
                assert!(
                    (found[&marker] / size - 1.0).abs() < 1e-9,
                    "{command}: {marker}: {found:?}"
                );
            }
        }
        let mesh = read_mesh(&folder.path("out.ele")).unwrap();
        assert!(
            mesh.cells
                .iter()
                .all(|cell| matches!(cell, Cell::Triangle(_)))
        );
        if !command.contains("resample") {
            let markers = mesh.point_markers.unwrap();
            assert_eq!(markers[..10], [1, 2, 3, 4, 5, 6, 7, 8, 9, 10]);
            assert!(markers[10..].iter().all(|&marker| marker == 0));
        }
    }
}

#[test]
fn regions_that_are_none_are_named() {
    let with = |regions: &str| {
        let text = MARKED.replace("2\n0 0.1 0.5 7\n1 1.1 0.5 -3\n", regions);
        let folder = Folder::with(&[("in.poly", text.as_str())]);
        folder.error(&["bubble", "in.poly", "-o", "out.vtu"])
    };
    let errors = [
        with("1\n0 1.5 0.5 7\n"),
        with("2\n0 0.1 0.5 7\n1 0.2 0.5 8\n"),
        with("1\n0 1 0.5 7\n"),
    ];
    insta::assert_snapshot!(errors.concat());
}

#[test]
fn nodes_of_the_outline_stay_slide_or_are_placed_anew() {
    let folder = Folder::with(&[("region.poly", REGION)]);
    let mesh = |options: &str| {
        let command = format!("bubble region.poly -o out.vtu --report out.json{options}");
        run(&folder, &command);
        let report = std::fs::read(folder.path("out.json")).unwrap();
        let report: Value = serde_json::from_slice(&report).unwrap();
        let mesh = read_mesh(&folder.path("out.vtu")).unwrap();
        (mesh, report["bubbles"]["boundary_nodes"].as_u64().unwrap())
    };
    let (fixed, given) = mesh("");
    let (slid, same) = mesh(" --boundary slide");
    assert_eq!((given, same), (80, 80));
    assert!(fixed.points[..80] != slid.points[..80]);
    let corners = |mesh: &Mesh| {
        mesh.points
            .iter()
            .filter(|p| fixed.points[..80].contains(p))
            .count()
    };
    assert!(corners(&slid) >= 4);
    let (anew, more) = mesh(" --boundary resample --grade 0.1");
    assert!(
        more > 80 && least_ratio(&anew) > 0.85,
        "{more} {}",
        least_ratio(&anew)
    );
    let (finer, _) = mesh(" --grade 0.05");
    assert!(triangles(&finer).len() > triangles(&fixed).len());
    for mesh in [&slid, &anew] {
        assert!((area(mesh) / area(&fixed) - 1.0).abs() < 1e-3);
    }
}

#[test]
fn sizes_that_change_steeply_are_warned_of() {
    // A side of one edge opposite one of many.
    let mut points = "0 0 0\n1 1 0\n".to_owned();
    for i in 0..=20 {
        points += &format!("{} {} 0.3\n", i + 2, 1.0 - f64::from(i) / 20.0);
    }
    let segments: String = (0..23)
        .map(|i| format!("{i} {i} {}\n", (i + 1) % 23))
        .collect();
    let text = format!("23 2 0 0\n{points}23 0\n{segments}0\n");
    let folder = Folder::with(&[("steep.poly", text.as_str())]);
    let said = run(&folder, "bubble steep.poly -o out.vtu --report out.json");
    let said: Vec<&str> = said.lines().take(2).collect();
    insta::assert_snapshot!(said.join("\n"));
    let said = run(&folder, "bubble steep.poly -o out.vtu --boundary resample");
    insta::assert_snapshot!(said.lines().next().unwrap());
}

#[test]
fn what_makes_no_sense_is_said_in_one_line_and_nothing_is_written() {
    let folder = Folder::with::<&str>(&[]);
    let write = |name: &str, text: &str| std::fs::write(folder.path(name), text).unwrap();
    let poly = |points: &str, segments: &str, holes: &str| format!("{points}{segments}{holes}");
    let square = "4 2 0 0\n0 0 0\n1 2 0\n2 2 2\n3 0 2\n";
    let closed = "4 0\n0 0 1\n1 1 2\n2 2 3\n3 3 0\n";
    write("good.poly", &poly(square, closed, "0\n"));
    write(
        "open.poly",
        &poly(square, "3 0\n0 0 1\n1 1 2\n2 2 3\n", "0\n"),
    );
    write(
        "bow.poly",
        &poly("4 2 0 0\n0 0 0\n1 2 2\n2 2 0\n3 0 2\n", closed, "0\n"),
    );
    write("hole.poly", &poly(square, closed, "1\n0 9 9\n"));
    write("all.poly", &poly(square, closed, "1\n0 1 1\n"));
    write(
        "twice.poly",
        &poly(
            "5 2 0 0\n0 0 0\n1 2 0\n2 2 2\n3 0 2\n4 2 0\n",
            closed,
            "0\n",
        ),
    );
    write(
        "inside.poly",
        &poly(
            "5 2 0 0\n0 0 0\n1 2 0\n2 2 2\n3 0 2\n4 1 1\n",
            closed,
            "0\n",
        ),
    );
    write(
        "outside.poly",
        &poly(
            "5 2 0 0\n0 0 0\n1 2 0\n2 2 2\n3 0 2\n4 9 9\n",
            closed,
            "0\n",
        ),
    );
    write(
        "length.poly",
        &poly(square, "5 0\n0 0 1\n1 1 2\n2 2 3\n3 3 0\n4 2 2\n", "0\n"),
    );
    write(
        "nan.poly",
        &poly("4 2 0 0\n0 0 0\n1 nan 0\n2 2 2\n3 0 2\n", closed, "0\n"),
    );
    write(
        "flat.poly",
        &poly(
            "3 2 0 0\n0 0 0\n1 2 0\n2 4 0\n",
            "3 0\n0 0 1\n1 1 2\n2 2 0\n",
            "0\n",
        ),
    );
    let mut said = String::new();
    for arguments in [
        "bubble open.poly -o out.vtu",
        "bubble bow.poly -o out.vtu",
        "bubble hole.poly -o out.vtu",
        "bubble all.poly -o out.vtu",
        "bubble twice.poly -o out.vtu",
        "bubble inside.poly -o out.vtu",
        "bubble outside.poly -o out.vtu",
        "bubble length.poly -o out.vtu",
        "bubble nan.poly -o out.vtu",
        "bubble flat.poly -o out.vtu",
        "bubble missing.poly -o out.vtu",
        "bubble good.poly -o out.p3d",
        "bubble good.poly -o good.poly",
    ] {
        let error = folder.error(&arguments.split(' ').collect::<Vec<_>>());
        said += &format!("$ vide {arguments}\n{error}");
    }
    insta::assert_snapshot!(said);
    for usage in [
        "--size 0",
        "--size nan",
        "--scale -1",
        "--paper --size 1",
        "--iterations 5",
        "--paper --boundary slide",
        "--paper --grade 0.1",
        "--crossings divide --boundary resample",
        "--grade 0",
        "--crease 200",
    ] {
        let arguments = format!("bubble good.poly -o out.vtu {usage}");
        let output = folder.vide(&arguments.split(' ').collect::<Vec<_>>());
        assert_eq!(output.status.code(), Some(2), "{arguments}");
    }
}
