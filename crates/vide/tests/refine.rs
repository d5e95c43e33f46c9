//! `vide refine` from outside: a closed surface or tetrahedra in, better tetrahedra out.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

mod folder;

use std::collections::BTreeSet;

use folder::{Folder, text};
use serde_json::Value;
use vide::delaunay_core::measure::tetrahedron::{
    circumradius, dihedral_angles, radius_edge_ratio, signed_volume,
};
use vide::delaunay_core::measure::triangle::area;
use vide::glam::{DVec2, DVec3};
use vide::mesh_io::{Cell, CellKind, Mesh, read_mesh, write_mesh};

const CUBOCTAHEDRON: &[u8] = include_bytes!("../../../fixtures/data/cuboctahedron.off");

/// A tetrahedron with outward triangles.
const TETRAHEDRON: &str =
    "OFF\n4 4 0\n0 0 0\n4 0 0\n0 4 0\n0 0 4\n3 1 2 3\n3 2 0 3\n3 0 1 3\n3 2 1 0\n";

fn run(folder: &Folder, arguments: &str) -> String {
    let output = folder.vide(&arguments.split(' ').collect::<Vec<_>>());
    assert!(
        output.status.success(),
        "{arguments}: {}",
        text(&output.stderr)
    );
    text(&output.stdout)
}

fn read(folder: &Folder, name: &str) -> Mesh {
    read_mesh(&folder.path(name)).unwrap()
}

fn json(folder: &Folder, name: &str) -> Value {
    serde_json::from_slice(&std::fs::read(folder.path(name)).unwrap()).unwrap()
}

fn tetrahedra(mesh: &Mesh) -> Vec<[u32; 4]> {
    let corners = |cell| match cell {
        Cell::Tetrahedron(corners) => corners,
        cell => panic!("{cell:?} is no tetrahedron"),
    };
    mesh.cells.iter().map(corners).collect()
}

fn places(mesh: &Mesh, corners: [u32; 4]) -> [DVec3; 4] {
    corners.map(|i| DVec3::from(mesh.points[i as usize]))
}

/// The facets that only one tetrahedron has, by their places.
fn boundary(mesh: &Mesh) -> BTreeSet<[[u64; 3]; 3]> {
    let mut single = BTreeSet::new();
    for [a, b, c, d] in tetrahedra(mesh) {
        for facet in [[a, b, c], [a, b, d], [a, c, d], [b, c, d]] {
            let facet = triangle(mesh, facet);
            if !single.remove(&facet) {
                single.insert(facet);
            }
        }
    }
    single
}

fn triangle(mesh: &Mesh, corners: [u32; 3]) -> [[u64; 3]; 3] {
    let mut places = corners.map(|i| mesh.points[i as usize].map(|x| (x + 0.0).to_bits()));
    places.sort_unstable();
    places
}

fn surface(mesh: &Mesh) -> BTreeSet<[[u64; 3]; 3]> {
    let corners = mesh.cells.corners().chunks(3);
    corners
        .map(|c| triangle(mesh, [c[0], c[1], c[2]]))
        .collect()
}

/// The largest ratio in a file, all of whose tetrahedra are right-handed.
fn worst_ratio(mesh: &Mesh) -> f64 {
    let ratios = tetrahedra(mesh).into_iter().map(|corners| {
        let places = places(mesh, corners);
        assert!(signed_volume(places) > 0.0);
        radius_edge_ratio(places)
    });
    ratios.fold(0.0, f64::max)
}

const USA: &[u8] = include_bytes!("../../../fixtures/data/usa.poly");

#[test]
fn an_outline_becomes_triangles_of_good_ratio_within_the_same_segments() {
    let folder = Folder::with(&[("usa.poly", USA)]);
    let said = run(&folder, "refine usa.poly -o usa.vtu --report usa.json");
    assert!(said.contains("(given 229 and 231)"), "{said}");
    let mesh = read(&folder, "usa.vtu");
    // The edges of the outline have markers, so they are cells too.
    let count = |dimension| {
        let kinds = mesh.cells.kinds().iter();
        kinds.filter(|kind| kind.dimension() == dimension).count()
    };
    assert!(count(2) < 680 && count(1) == 231);
    let report = json(&folder, "usa.json");
    assert_eq!(
        (&report["dimension"], &report["elements"]),
        (&2.into(), &count(2).into())
    );
    assert_eq!(report["refinement"]["ratio"], 1.0);
    let left = &report["refinement"]["low"];
    assert!(left["count"].as_u64().unwrap() <= 4, "{left}");
    // What is written is read again, and needs no more points.
    let said = run(&folder, "refine usa.vtu -o again.vtu --candidate sink");
    assert!(!said.is_empty());
}

#[test]
fn a_surface_becomes_tetrahedra_of_good_ratio_within_the_same_triangles() {
    let folder = Folder::with(&[("a.off", CUBOCTAHEDRON)]);
    let outputs = "-o a.vtu -o a.msh -o a.node --report a.json";
    let said = run(&folder, &format!("refine a.off {outputs}"));
    let mesh = read(&folder, "a.vtu");
    assert!(worst_ratio(&mesh) <= 2.0);
    let given = read(&folder, "a.off");
    assert_eq!(boundary(&mesh), surface(&given));
    assert_eq!(mesh.points[..given.points.len()], given.points);
    for name in ["a.msh", "a.ele"] {
        let other = read(&folder, name);
        assert_eq!(
            (&other.points, &other.cells),
            (&mesh.points, &mesh.cells),
            "{name}"
        );
    }
    let report = json(&folder, "a.json");
    assert_eq!(report["dimension"], 3);
    assert_eq!(report["elements"], mesh.cells.len());
    assert_eq!(report["vertices"], mesh.points.len());
    assert_eq!(report["stop"], "all_good");
    let refinement = &report["refinement"];
    assert_eq!(
        (&refinement["candidate"], &refinement["coarsen"]),
        (&"economical".into(), &"removal".into())
    );
    assert_eq!(refinement["given_vertices"], given.points.len());
    assert_eq!(refinement["given_elements"], 14_658);
    let count = |name: &str| refinement["points"][name].as_u64().unwrap() as usize;
    let added = count("inserted") - count("removed");
    assert_eq!(mesh.points.len(), given.points.len() + added);
    assert!(count("tested") >= count("inserted") + count("encroaching"));
    assert_eq!(refinement["low"]["count"], 0);
    let separation = &refinement["separation"];
    assert!(separation["vertex_bound"].as_f64().unwrap() > mesh.points.len() as f64);
    assert!(separation["given"].as_f64() >= separation["reached"].as_f64());
    let ratio = &report["quality"]["tetrahedron.radius_edge_ratio"];
    assert!(ratio["max"].as_f64().unwrap() <= 2.0);
    for stage in ["read", "triangulate", "refine", "measure", "write"] {
        assert!(report["seconds"][stage].is_f64(), "{stage}");
    }
    assert!(
        said.contains("no tetrahedron above the ratio 2\n"),
        "{said}"
    );
    assert!(said.contains("tetrahedron.min_dihedral"), "{said}");
}

#[test]
fn elements_are_no_larger_than_the_size_asked_for() {
    let folder = Folder::with(&[("a.off", CUBOCTAHEDRON)]);
    let said = run(
        &folder,
        "refine a.off -o a.vtu --size 0.25 --report a.json --threads 2",
    );
    assert!(
        said.contains("no tetrahedron above the ratio 2 or the size 0.25\n"),
        "{said}"
    );
    let mesh = read(&folder, "a.vtu");
    let radii = tetrahedra(&mesh).into_iter();
    let radii = radii.map(|corners| circumradius(places(&mesh, corners)));
    assert!(radii.fold(0.0, f64::max) <= 0.25 * 6.0_f64.sqrt() / 4.0 + 1e-12);
    assert!(worst_ratio(&mesh) <= 2.0);
    let report = json(&folder, "a.json");
    assert_eq!(report["refinement"]["size"], 0.25);
    assert_eq!(report["refinement"]["low"]["too_large"], 0);
    run(&folder, "refine a.off -o plain.vtu --report plain.json");
    assert!(read(&folder, "plain.vtu").cells.len() < mesh.cells.len());
    assert_eq!(
        json(&folder, "plain.json")["refinement"]["size"],
        Value::Null
    );
}

#[test]
fn what_is_too_large_for_a_coarse_boundary_is_counted_and_listed() {
    let folder = Folder::with(&[("a.off", TETRAHEDRON)]);
    let said = run(&folder, "refine a.off -o a.vtu --size 1 --report a.json");
    assert!(said.contains("above the ratio 2 or the size 1: "), "{said}");
    let low = &json(&folder, "a.json")["refinement"]["low"];
    assert_eq!(low["too_large"], low["count"]);
    assert!(low["reasons"]["boundary_triangle"].as_u64().unwrap() > 0);
    assert!(low["worst"][0]["size"].as_f64().unwrap() > 1.0);
}

/// Squares of side 1 at these distances to the right, ten edges to a side.
fn squares(at: &[f64], regions: &str) -> String {
    let (mut points, mut segments) = (String::new(), String::new());
    for (square, x) in at.iter().enumerate() {
        for i in 0..40 {
            let (side, t) = (i / 10, f64::from(i % 10) / 10.0);
            let place = [[t, 0.0], [1.0, t], [1.0 - t, 1.0], [0.0, 1.0 - t]][side as usize];
            let first = 40 * square + 1;
            let [here, next] = [i, (i + 1) % 40].map(|i| first + i as usize);
            points += &format!("{here} {} {}\n", place[0] + x, place[1]);
            segments += &format!("{here} {here} {next}\n");
        }
    }
    let count = 40 * at.len();
    format!("{count} 2 0 0\n{points}{count} 0\n{segments}0\n{regions}")
}

#[test]
fn regions_of_an_outline_have_no_larger_triangles_than_their_limits() {
    let fine = "2\n1 0.5 0.5 1 0.006\n2 3.5 0.5 2\n";
    let folder = Folder::with(&[
        ("fine.poly", squares(&[0.0, 3.0], fine)),
        ("plain.poly", squares(&[0.0, 3.0], "")),
        ("outside.poly", squares(&[0.0], "1\n1 2 0.5 1 0.1\n")),
    ]);
    let counts = |arguments: &str| {
        run(&folder, &format!("refine {arguments} -o out.vtu"));
        let mesh = read(&folder, "out.vtu");
        let mut counts = [0, 0];
        for cell in mesh.cells.iter() {
            let corners = cell.corners().iter().map(|&i| mesh.points[i as usize]);
            let corners: Vec<DVec2> = corners.map(|[x, y, _]| DVec2::new(x, y)).collect();
            let right = corners[0].x > 2.0;
            counts[usize::from(right)] += 1;
            let area = area([corners[0], corners[1], corners[2]]);
            assert!(right || !arguments.contains("fine") || area <= 0.006);
        }
        counts
    };
    let [left, right] = counts("plain.poly");
    let [fine, plain] = counts("fine.poly");
    assert!(
        2 * fine > 3 * left && 10 * plain < 11 * right,
        "{fine} {left}, {plain} {right}"
    );
    let [_, small] = counts("fine.poly --size 0.11");
    assert!(2 * small > 3 * plain, "{small} {plain}");
    let error = folder.error(&["refine", "outside.poly", "-o", "out.vtu"]);
    assert!(
        error.contains("outside.poly: region 0 at (2, 0.5) is outside"),
        "{error}"
    );
}

#[test]
fn what_was_refined_can_be_refined_again() {
    let folder = Folder::with(&[("a.off", CUBOCTAHEDRON)]);
    run(&folder, "refine a.off -o a.vtu -o a.node --quiet");
    for again in ["a.vtu", "a.ele", "a.node"] {
        run(&folder, &format!("refine {again} -o b.vtu --report b.json"));
        assert!(read(&folder, "b.vtu") == read(&folder, "a.vtu"), "{again}");
        assert_eq!(
            json(&folder, "b.json")["refinement"]["points"]["inserted"],
            0
        );
    }
    let said = run(&folder, "refine a.vtu -o c.vtu --ratio 1.5");
    let [before, after] = ["a.vtu", "c.vtu"].map(|name| read(&folder, name));
    assert!(after.points.len() > before.points.len(), "{said}");
    assert_eq!(after.points[..before.points.len()], before.points);
    assert_eq!(boundary(&after), boundary(&before));
}

#[test]
fn every_method_is_named_in_the_report_and_threads_change_nothing() {
    let folder = Folder::with(&[("a.off", CUBOCTAHEDRON)]);
    for (options, names) in [
        ("--candidate sink", ["sink", "incremental", ""]),
        (
            "--candidate circumcenter --schedule block",
            ["circumcenter", "block", ""],
        ),
        (
            "--candidate sink --schedule parallel",
            ["sink", "parallel", ""],
        ),
        ("--coarsen none", ["economical", "", "none"]),
    ] {
        let arguments = format!("refine a.off {options} --report a.json");
        run(&folder, &format!("{arguments} -o 1.vtu --threads 1"));
        let report = json(&folder, "a.json");
        let name = |key: &str| report["refinement"][key].as_str().unwrap_or_default();
        assert_eq!(["candidate", "schedule", "coarsen"].map(name), names);
        if options.contains("parallel") {
            run(&folder, &format!("{arguments} -o 2.vtu --threads 2"));
            let bytes = |name: &str| std::fs::read(folder.path(name)).unwrap();
            assert!(bytes("1.vtu") == bytes("2.vtu"), "{options}");
        }
    }
}

#[test]
fn what_is_left_is_listed_with_its_cells() {
    let folder = Folder::with(&[("a.off", CUBOCTAHEDRON)]);
    let said = run(
        &folder,
        "refine a.off -o a.vtu --max-vertices 50 --report a.json",
    );
    assert!(said.contains("; no more vertices may be added"), "{said}");
    let (mesh, report) = (read(&folder, "a.vtu"), json(&folder, "a.json"));
    assert_eq!(mesh.points.len(), 3750 + 50);
    assert_eq!(report["stop"], "out_of_vertices");
    let low = &report["refinement"]["low"];
    let reasons: u64 = low["reasons"]
        .as_object()
        .unwrap()
        .values()
        .map(|n| n.as_u64().unwrap())
        .sum();
    assert_eq!(low["count"], reasons);
    let worst = low["worst"].as_array().unwrap();
    assert_eq!(worst.len(), 20);
    let all = tetrahedra(&mesh);
    for listed in worst {
        let corners = all[listed["element"].as_u64().unwrap() as usize];
        let ratio = radius_edge_ratio(places(&mesh, corners));
        assert!((ratio / listed["ratio"].as_f64().unwrap() - 1.0).abs() < 1e-9);
    }
}

#[test]
fn the_same_surface_in_every_format_gives_the_same_tetrahedra() {
    let folder = Folder::with(&[("a.off", TETRAHEDRON)]);
    let mesh = read(&folder, "a.off");
    for name in ["a.vtu", "a.msh"] {
        write_mesh(&folder.path(name), &mesh).unwrap();
    }
    let points = "0 0 0\n4 0 0\n0 4 0\n0 0 4\n";
    let header = "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n\
                  element face 4\nproperty list uchar int vertex_indices\nend_header\n";
    let faces = TETRAHEDRON.split_once("0 0 4\n").unwrap().1;
    std::fs::write(folder.path("a.ply"), format!("{header}{points}{faces}")).unwrap();
    let vertices: String = points.lines().map(|line| format!("v {line}\n")).collect();
    std::fs::write(
        folder.path("a.obj"),
        format!("{vertices}f 2 3 4\nf 3 1 4\nf 1 2 4\nf 3 2 1\n"),
    )
    .unwrap();
    let facet = |cell: Cell| {
        let corners = cell.corners().iter().map(|&i| mesh.points[i as usize]);
        let corners: String = corners
            .map(|[x, y, z]| format!("vertex {x} {y} {z}\n"))
            .collect();
        format!("facet normal 0 0 0\nouter loop\n{corners}endloop\nendfacet\n")
    };
    let facets: String = mesh.cells.iter().map(facet).collect();
    std::fs::write(
        folder.path("a.stl"),
        format!("solid a\n{facets}endsolid a\n"),
    )
    .unwrap();
    for name in ["a.off", "a.vtu", "a.msh", "a.ply", "a.obj", "a.stl"] {
        run(&folder, &format!("refine {name} -o out.vtu --quiet"));
        let refined = read(&folder, "out.vtu");
        assert_eq!(refined.cells.kinds(), [CellKind::Tetrahedron], "{name}");
        assert_eq!(boundary(&refined), surface(&mesh), "{name}");
    }
}

#[test]
fn what_makes_no_sense_is_said_in_one_line_with_file_place_and_element() {
    let with = |from: &str, to: &str| TETRAHEDRON.replacen(from, to, 1);
    let two_tets = |second: &str| format!("2 4 0\n1 1 2 3 4\n2 {second}\n");
    let nodes = "5 3 0 0\n1 0 0 0\n2 4 0 0\n3 0 4 0\n4 0 0 4\n5 4 4 4\n";
    let through = "OFF\n8 8 0\n0 0 0\n4 0 0\n0 4 0\n0 0 4\n1 1 -1\n5 1 -1\n1 5 -1\n1 1 0.5\n\
                   3 1 2 3\n3 2 0 3\n3 0 1 3\n3 2 1 0\n3 5 6 7\n3 6 4 7\n3 4 5 7\n3 6 5 4\n";
    let sparse = "OFF\n8 8 0\n-9 -9 0\n9 -9 0\n0 9 0\n0 0 9\n0 0 -0.1\n1 0 -1\n0 1 -1\n-1 -1 -1\n\
                  3 1 2 3\n3 2 0 3\n3 0 1 3\n3 2 1 0\n3 5 6 7\n3 6 4 7\n3 4 5 7\n3 6 5 4\n";
    let folder = Folder::with(&[
        ("good.off", TETRAHEDRON.to_owned()),
        ("open.off", with("4 4 0", "4 3 0").replace("3 2 1 0\n", "")),
        ("through.off", through.to_owned()),
        (
            "twice.off",
            with("4 4 0", "5 4 0").replace("3 1 2 3", "4 0 0\n3 4 2 3"),
        ),
        (
            "unused.off",
            with("4 4 0", "5 4 0").replace("0 0 4\n3", "0 0 4\n1 1 1\n3"),
        ),
        ("quad.off", with("3 1 2 3", "4 1 2 3 0")),
        (
            "open.poly",
            "3 2 0 0\n1 0 0\n2 1 0\n3 0 1\n2 0\n1 1 2\n2 2 3\n0\n".to_owned(),
        ),
        (
            "crossing.poly",
            "4 2 0 0\n1 0 0\n2 1 1\n3 1 0\n4 0 1\n4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n".to_owned(),
        ),
        ("points.xyz", "0 0 0\n1 2 3\n".to_owned()),
        (
            "bad.stl",
            "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 x\n".to_owned(),
        ),
        ("bad.obj", "v 0 0 0\nf 1 2 3\n".to_owned()),
        ("inverted.node", nodes.to_owned()),
        (
            "inverted.ele",
            "3 4 0\n1 1 2 3 4\n2 2 3 4 5\n3 5 2 3 1\n".to_owned(),
        ),
        ("overlap.node", nodes.to_owned()),
        ("overlap.ele", two_tets("1 2 3 5")),
        ("flat.node", nodes.replace("4 4 4", "2 2 0")),
        ("flat.ele", two_tets("1 2 3 5")),
        ("place.node", nodes.replace("4 4 4", "4 0 0")),
        ("place.ele", two_tets("2 3 4 5")),
        ("spare.node", nodes.to_owned()),
        ("spare.ele", "1 4 0\n1 1 2 3 4\n".to_owned()),
        ("alone.node", nodes.to_owned()),
        ("sparse.off", sparse.to_owned()),
    ]);
    let errors = [
        "good.off -o out.vtu --ratio 0.99",
        "good.off -o out.vtu --ratio nan",
        "good.off -o out.off",
        "spare.ele -o spare.node",
        "good.off -o out.vtu --report out.vtu",
        "spare.node -o out.vtu --report spare.ele",
        "missing.off -o out.vtu",
        "open.off -o out.vtu",
        "through.off -o out.vtu",
        "sparse.off -o out.vtu",
        "twice.off -o out.vtu",
        "unused.off -o out.vtu",
        "quad.off -o out.vtu",
        "open.poly -o out.vtu",
        "crossing.poly -o out.vtu",
        "points.xyz -o out.vtu",
        "bad.stl -o out.vtu",
        "bad.obj -o out.vtu",
        "inverted.ele -o out.vtu",
        "overlap.node -o out.vtu",
        "flat.ele -o out.vtu",
        "place.ele -o out.vtu",
        "spare.ele -o out.vtu",
        "alone.node -o out.vtu",
    ];
    let said = errors.map(|arguments| {
        let words = format!("refine {arguments}");
        let error = folder.error(&words.split(' ').collect::<Vec<_>>());
        format!("$ vide {words}\n{error}")
    });
    insta::assert_snapshot!(said.concat());
}

#[test]
fn options_of_another_method_are_wrong_usage() {
    let folder = Folder::with(&[("good.off", TETRAHEDRON)]);
    let said = [
        "--schedule block",
        "--candidate sink --coarsen removal",
        "--candidate sink --schedule sideways",
        "--max-vertices -1",
        "--size 0",
        "--size inf",
        "--size long",
    ]
    .map(|options| {
        let words = format!("refine good.off -o out.vtu {options}");
        let output = folder.vide(&words.split(' ').collect::<Vec<_>>());
        assert_eq!(output.status.code(), Some(2), "{options}");
        assert!(!folder.path("out.vtu").exists());
        format!("$ vide {words}\n{}", text(&output.stderr))
    });
    insta::assert_snapshot!(said.concat());
}

#[test]
fn a_boundary_that_may_be_divided_leaves_nothing_of_low_quality() {
    let folder = Folder::with(&[
        ("usa.poly", USA),
        ("tetrahedron.off", TETRAHEDRON.as_bytes()),
    ]);
    let said = run(
        &folder,
        "refine usa.poly -o usa.vtu --boundary split --report usa.json",
    );
    assert!(said.contains("on the boundary"), "{said}");
    let report = json(&folder, "usa.json");
    assert_eq!(report["stop"], "all_good");
    assert_eq!(report["refinement"]["boundary"], "split");
    assert!(
        report["refinement"]["points"]["on_boundary"]
            .as_u64()
            .unwrap()
            > 0
    );

    run(
        &folder,
        "refine tetrahedron.off -o fine.vtu --boundary split --size 0.7 --report fine.json",
    );
    let fine = read(&folder, "fine.vtu");
    assert!(worst_ratio(&fine) <= 2.0 + 1e-9);
    let volume: f64 = tetrahedra(&fine)
        .into_iter()
        .map(|corners| signed_volume(places(&fine, corners)))
        .sum();
    assert!((volume - 64.0 / 6.0).abs() < 1e-9);
    assert_eq!(json(&folder, "fine.json")["stop"], "all_good");
}

#[test]
fn a_crease_angle_needs_a_boundary_that_may_be_divided() {
    let folder = Folder::with(&[("usa.poly", USA)]);
    for options in [
        "--crease 30",
        "--boundary split --crease 200",
        "--boundary split --crease nan",
    ] {
        let arguments = format!("refine usa.poly -o usa.vtu {options}");
        let output = folder.vide(&arguments.split(' ').collect::<Vec<_>>());
        assert_eq!(output.status.code(), Some(2), "{}", text(&output.stderr));
        assert!(text(&output.stderr).contains("crease"));
        assert!(!folder.path("usa.vtu").exists());
    }
}

#[test]
fn slivers_are_taken_away_after_refinement() {
    let folder = Folder::with(&[("cuboctahedron.off", CUBOCTAHEDRON), ("usa.poly", USA)]);
    let said = run(
        &folder,
        "refine cuboctahedron.off -o fine.vtu --min-dihedral 20 --report fine.json",
    );
    assert!(said.contains("improved: dihedral angles 20."), "{said}");
    let fine = read(&folder, "fine.vtu");
    let smallest = tetrahedra(&fine).into_iter().map(|corners| {
        let angles = dihedral_angles(places(&fine, corners));
        angles.into_iter().fold(180.0, f64::min)
    });
    assert!(smallest.fold(180.0, f64::min) > 19.99);
    let report = json(&folder, "fine.json");
    assert_eq!(report["elements"], fine.cells.len());
    assert_eq!(report["improvement"]["left"], 0);
    assert_eq!(
        boundary(&fine),
        surface(&read(&folder, "cuboctahedron.off"))
    );
    for (input, angle, status) in [("cuboctahedron.off", "71", 2), ("usa.poly", "20", 1)] {
        let arguments = format!("refine {input} -o no.vtu --min-dihedral {angle}");
        let output = folder.vide(&arguments.split(' ').collect::<Vec<_>>());
        assert_eq!(
            output.status.code(),
            Some(status),
            "{}",
            text(&output.stderr)
        );
        assert!(!folder.path("no.vtu").exists());
    }
}
