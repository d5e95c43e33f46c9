//! `vide delaunay` from outside: points of every format in, triangles and tetrahedra out.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

mod folder;

use folder::{Folder, text};
use serde_json::Value;
use vide::mesh_io::{CellKind, Coordinates, Mesh, Points, raw, read_mesh, write_mesh};

/// A crooked cloud, some of it twice.
fn cloud() -> Vec<[f64; 3]> {
    let place = |i: u32| {
        let [a, b, c] = [i * 7 % 31, i * 11 % 29, i * 13 % 23].map(f64::from);
        [a / 4.0, b / 8.0 + a * a / 64.0, c / 16.0]
    };
    (0..60).chain(10..15).map(place).collect()
}

fn planar(points: &[[f64; 3]]) -> Vec<[f64; 2]> {
    points.iter().map(|&[x, y, _]| [x, y]).collect()
}

fn lines<const N: usize>(points: &[[f64; N]]) -> Vec<u8> {
    let line = |point: &[f64; N]| point.map(|x| format!("{x:?}")).join(" ") + "\n";
    points.iter().map(line).collect::<String>().into()
}

fn raw_file(coordinates: Coordinates) -> Vec<u8> {
    let mut file = Vec::new();
    let points = Points {
        coordinates,
        weights: None,
    };
    raw::write(&mut file, &points).unwrap();
    file
}

/// A binary PLY; with `N = 2` without the property z.
fn ply<const N: usize>(points: &[[f64; N]], big_endian: bool) -> Vec<u8> {
    let order = if big_endian { "big" } else { "little" };
    let mut file = format!(
        "ply\nformat binary_{order}_endian 1.0\nelement vertex {}\n",
        points.len()
    );
    for axis in ["x", "y", "z"].iter().take(N) {
        file += &format!("property double {axis}\n");
    }
    let mut file = (file + "property uchar red\nend_header\n").into_bytes();
    for point in points {
        for x in point {
            file.extend(if big_endian {
                x.to_be_bytes()
            } else {
                x.to_le_bytes()
            });
        }
        file.push(7);
    }
    file
}

/// Writes the points in the formats of meshes too.
fn with_meshes(folder: &Folder, points: &[[f64; 3]], names: &[&str]) {
    let mesh = Mesh {
        points: points.to_vec(),
        ..Mesh::default()
    };
    for name in names {
        write_mesh(&folder.path(name), &mesh).unwrap();
    }
}

fn run(folder: &Folder, arguments: &str) -> String {
    let output = folder.vide(&arguments.split(' ').collect::<Vec<_>>());
    assert!(
        output.status.success(),
        "{arguments}: {}",
        text(&output.stderr)
    );
    text(&output.stdout)
}

#[test]
fn points_become_triangles_and_quality_reads_them_back() {
    let folder = Folder::with(&[("points.xy", "0 0\n1 0\n1 1\n0 1\n0.5 0.5\n0.5 0.5\n")]);
    let said = run(&folder, "delaunay points.xy -o a.vtu -o a.ele");
    let first = said.lines().next();
    assert_eq!(
        first,
        Some("4 triangles, 5 vertices, 4 on the hull, 1 duplicates")
    );
    for name in ["a.vtu", "a.ele"] {
        let said = run(&folder, &format!("quality {name} --worst 2"));
        assert!(said.starts_with("4 cells, 6 vertices"), "{said}");
        let worst = "worst triangle.min_angle: 0 (45.0000), 1 (45.0000)";
        assert!(said.contains(worst), "{said}");
    }
}

#[test]
fn the_same_points_of_space_in_every_format_give_the_same_bytes() {
    let cloud = cloud();
    let raw = raw_file(Coordinates::Space(cloud.clone()));
    let folder = Folder::with(&[
        ("a.xyz", lines(&cloud)),
        ("a.3d.f64", raw.clone()),
        ("plain.f64", raw),
        ("little.ply", ply(&cloud, false)),
        ("big.ply", ply(&cloud, true)),
    ]);
    with_meshes(&folder, &cloud, &["a.node", "a.off", "a.vtu", "a.msh"]);
    run(&folder, "delaunay a.xyz -o expected.vtu");
    let expected = std::fs::read(folder.path("expected.vtu")).unwrap();
    let names = [
        "a.3d.f64",
        "plain.f64",
        "little.ply",
        "big.ply",
        "a.node",
        "a.off",
        "a.vtu",
        "a.msh",
    ];
    for name in names {
        run(
            &folder,
            &format!("delaunay {name} --dim 3 -o out.vtu --quiet"),
        );
        assert!(
            std::fs::read(folder.path("out.vtu")).unwrap() == expected,
            "{name}"
        );
    }
}

#[test]
fn the_same_points_of_the_plane_in_every_format_give_the_same_bytes() {
    let flat: Vec<[f64; 3]> = cloud().iter().map(|&[x, y, _]| [x, y, 0.0]).collect();
    let points = planar(&flat);
    let raw = raw_file(Coordinates::Plane(points.clone()));
    let folder = Folder::with(&[
        ("a.xy", lines(&points)),
        ("flat.xyz", lines(&flat)),
        ("a.2d.f64", raw),
        ("a.ply", ply(&points, false)),
        ("flat.ply", ply(&flat, true)),
    ]);
    with_meshes(&folder, &flat, &["a.node", "a.off", "a.vtu", "a.msh"]);
    run(&folder, "delaunay a.xy -o expected.vtu");
    let expected = std::fs::read(folder.path("expected.vtu")).unwrap();
    let names = [
        "flat.xyz", "a.2d.f64", "a.ply", "flat.ply", "a.node", "a.off", "a.vtu", "a.msh",
    ];
    for name in names {
        run(&folder, &format!("delaunay {name} -o out.vtu --quiet"));
        assert!(
            std::fs::read(folder.path("out.vtu")).unwrap() == expected,
            "{name}"
        );
    }
}

#[test]
fn every_output_holds_the_same_cells() {
    let folder = Folder::with(&[("a.xyz", lines(&cloud()))]);
    run(
        &folder,
        "delaunay a.xyz -o a.vtu -o a.msh -o a.ele --report a.json",
    );
    let read = |name: &str| read_mesh(&folder.path(name)).unwrap();
    let mesh = read("a.vtu");
    assert!(
        mesh.cells
            .kinds()
            .iter()
            .all(|&kind| kind == CellKind::Tetrahedron)
    );
    for name in ["a.msh", "a.ele"] {
        assert_eq!(read(name).cells, mesh.cells, "{name}");
        assert_eq!(read(name).points, mesh.points, "{name}");
    }
    let report: Value =
        serde_json::from_slice(&std::fs::read(folder.path("a.json")).unwrap()).unwrap();
    assert_eq!(report["dimension"], 3);
    assert_eq!(report["elements"], mesh.cells.len());
    assert_eq!(
        (&report["vertices"], &report["duplicates"]),
        (&60.into(), &5.into())
    );
    // Euler: a triangulated sphere of v vertices has 2 v - 4 sides.
    let [vertices, sides] =
        ["hull_vertices", "hull_sides"].map(|name| report[name].as_u64().unwrap());
    assert_eq!(sides, 2 * vertices - 4);
    for stage in ["read", "triangulate", "measure", "write"] {
        assert!(report["seconds"][stage].is_f64(), "{stage}");
    }
    assert!(
        report["quality"]["tetrahedron.radius_ratio"]["min"]
            .as_f64()
            .unwrap()
            > 0.0
    );
}

#[test]
fn voronoi_cells_are_written_beside_the_triangulation() {
    let flat: Vec<[f64; 2]> = planar(&cloud());
    let folder = Folder::with(&[("a.xyz", lines(&cloud())), ("b.xy", lines(&flat))]);
    for (points, kind, sites) in [("a.xyz", 42, 60), ("b.xy", 7, 60)] {
        for threads in ["1", "2"] {
            let outputs = format!("-o c.msh --voronoi {threads}.vtu --threads {threads}");
            run(&folder, &format!("delaunay {points} {outputs}"));
        }
        let bytes = |name: &str| std::fs::read_to_string(folder.path(name)).unwrap();
        assert_eq!(bytes("1.vtu"), bytes("2.vtu"));
        assert!(bytes("1.vtu").contains(&format!("NumberOfCells=\"{sites}\"")));
        // Cells of any number of corners are not read back.
        let error = folder.error(&["quality", "1.vtu"]);
        assert!(error.contains(&format!("type {kind}")), "{error}");
    }
}

/// The points of a file with a weight for each.
fn weighted(points: &[[f64; 3]], weight: impl Fn(usize) -> f64) -> Vec<[f64; 4]> {
    let rows = points.iter().enumerate();
    rows.map(|(i, &[x, y, z])| [x, y, z, weight(i)]).collect()
}

#[test]
fn equal_weights_change_nothing_and_small_ones_hide_points() {
    let cloud = cloud();
    let flat: Vec<[f64; 3]> = cloud.iter().map(|&[x, y, _]| [x, y, 2.5]).collect();
    let folder = Folder::with(&[
        ("a.xyz", lines(&cloud)),
        ("a.xy", lines(&planar(&cloud))),
        ("equal.xyz", lines(&weighted(&cloud, |_| 2.5))),
        ("equal.xy", lines(&flat)),
        (
            "light.xyz",
            lines(&weighted(&cloud, |i| if i % 4 == 0 { -1e3 } else { 0.0 })),
        ),
    ]);
    for name in ["xyz", "xy"] {
        run(&folder, &format!("delaunay a.{name} -o a.vtu"));
        run(
            &folder,
            &format!("delaunay equal.{name} --weighted -o b.vtu"),
        );
        let bytes = |name: &str| std::fs::read(folder.path(name)).unwrap();
        assert!(bytes("a.vtu") == bytes("b.vtu"), "{name}");
    }
    let said = run(
        &folder,
        "delaunay light.xyz --weighted -o c.vtu --report c.json",
    );
    let report: Value =
        serde_json::from_slice(&std::fs::read(folder.path("c.json")).unwrap()).unwrap();
    let hidden = report["hidden"].as_u64().unwrap();
    assert!(
        hidden > 0 && said.contains(&format!("{hidden} hidden")),
        "{said}"
    );
    assert_eq!(report["vertices"].as_u64().unwrap() + hidden, 60);
}

#[test]
fn the_result_does_not_depend_on_the_number_of_threads() {
    let grid = |i: u32| [i % 10, i / 10 % 10, i / 100].map(f64::from);
    let grid: Vec<_> = (0..1000).map(grid).collect();
    let folder = Folder::with(&[
        ("grid.xyz", lines(&grid)),
        ("cloud.xyz", lines(&cloud())),
        ("plane.xy", lines(&planar(&grid))),
    ]);
    for name in ["grid.xyz", "cloud.xyz", "plane.xy"] {
        for threads in ["1", "2", "3"] {
            run(
                &folder,
                &format!("delaunay {name} -o {threads}.vtu --threads {threads}"),
            );
        }
        let bytes = |name: &str| std::fs::read(folder.path(name)).unwrap();
        assert!(
            bytes("1.vtu") == bytes("2.vtu") && bytes("1.vtu") == bytes("3.vtu"),
            "{name}"
        );
    }
}

#[test]
fn what_makes_no_sense_is_said_in_one_line_with_file_place_and_element() {
    let big_count = "ply\nformat ascii 1.0\nelement vertex 1000000000000000000\nproperty int x\nproperty int y\nend_header\n0 0\n";
    let folder = Folder::with(&[
        ("none.xyz", ""),
        ("one.xyz", "1 2 3\n1 2 3\n"),
        ("line.xyz", "0 0 0\n1 1 1\n2 2 2\n"),
        ("slanted.xyz", "0 0 0\n1 0 1\n0 1 0\n1 1 1\n"),
        ("flat.xyz", "0 0 0\n1 0 0\n0 1 0\n1 1 0\n"),
        ("plane.xy", "0 0\n1 0\n0 1\n"),
        ("space.xyz", "0 0 0\n1 0 0\n0 1 0\n0 0 1\n"),
        ("two.xyz", "0 0 0\n1 0\n"),
        ("nan.xyz", "0 0 0\n0 0 nan\n"),
        ("huge.xyz", "0 0 0\n1 0 0\n0 1 0\n0 0 1e300\n"),
        ("count.node", "1000000000000000000 3 0 0\n1 0 0 0\n"),
        ("count.off", "OFF\n4000000000 0 0\n0 0 0\n"),
        ("count.ply", big_count),
        ("word.ply", "PLY\n"),
        ("odd.3d.f64", "0123456789"),
        ("which.f64", "0123456701234567"),
        ("weights.xyz", "0 0 0 1\n1 0 0 1\n0 1 0 1\n1 1 0 1\n"),
        ("heavy.xy", "0 0 1\n1 0 1e300\n0 1 1\n"),
        ("a.node", "3 2 0 0\n1 0 0\n2 1 0\n3 0 1\n"),
    ]);
    let errors = [
        "none.xyz -o a.vtu",
        "one.xyz -o a.vtu",
        "line.xyz -o a.vtu",
        "slanted.xyz -o a.vtu",
        "flat.xyz --dim 3 -o a.vtu",
        "plane.xy --dim 3 -o a.vtu",
        "space.xyz --dim 2 -o a.vtu",
        "space.xyz -o a.off",
        "two.xyz -o a.vtu",
        "nan.xyz -o a.vtu",
        "huge.xyz -o a.vtu",
        "count.node -o a.vtu",
        "count.off -o a.vtu",
        "count.ply -o a.vtu",
        "word.ply -o a.vtu",
        "odd.3d.f64 -o a.vtu",
        "which.f64 -o a.vtu",
        "a.node -o a.ele",
        "a.node -o b.ele --report b.node",
        "plane.xy -o a.svg",
        "plane.xy --weighted -o a.vtu",
        "flat.xyz --weighted -o a.vtu",
        "a.node --weighted -o b.vtu",
        "weights.xyz --weighted --dim 3 -o a.vtu",
        "heavy.xy --weighted -o a.vtu",
        "plane.xy -o a.vtu --voronoi a.msh",
        "plane.xy -o a.vtu --voronoi ./a.vtu",
    ];
    let said = errors.map(|arguments| {
        let words = format!("delaunay {arguments}");
        let error = folder.error(&words.split(' ').collect::<Vec<_>>());
        format!("$ vide {words}\n{error}")
    });
    insta::assert_snapshot!(said.concat());
}

#[test]
fn outputs_appear_together_or_not_at_all() {
    let space = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n";
    let folder = Folder::with(&[("space.xyz", space), ("a.vtu", "mine")]);
    // The device is full, which shows only when `a.vtu` is whole.
    std::os::unix::fs::symlink("/dev/full", folder.path("c.msh")).unwrap();
    folder.error(&["delaunay", "space.xyz", "-o", "a.vtu", "-o", "c.msh"]);
    assert_eq!(std::fs::read(folder.path("a.vtu")).unwrap(), b"mine");
    run(&folder, "delaunay space.xyz -o b.ele -o b.node");
    assert!(folder.path("b.ele").exists() && folder.path("b.node").exists());
}
