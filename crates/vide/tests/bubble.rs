//! `vide bubble` from outside: an outline in, graded triangles out.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

mod folder;

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
    let triangles = mesh.cells.iter().map(|cell| match cell {
        Cell::Triangle(corners) => corners.map(place),
        cell => panic!("{cell:?} is no triangle"),
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
    ] {
        let arguments = format!("bubble good.poly -o out.vtu {usage}");
        let output = folder.vide(&arguments.split(' ').collect::<Vec<_>>());
        assert_eq!(output.status.code(), Some(2), "{arguments}");
    }
}
