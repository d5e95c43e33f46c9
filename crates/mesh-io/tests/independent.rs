//! Written files, read back by other programs: meshio, VTK and gmsh, through `independent/read_back.py`.
//!
//! Python is the program that the variable `VIDE_PYTHON` names, else `python3`. Without it, or without meshio, the test says so and
//! passes; every other missing reader is one line of its output (`cargo test -- --nocapture`).

#![allow(clippy::unwrap_used, reason = "a test may panic")]
#![allow(
    clippy::print_stdout,
    clippy::print_stderr,
    reason = "what was skipped should be seen"
)]

mod some_blocks;

use mesh_io::{Cell, Cells, DataArray, Mesh, StructuredBlocks, write_blocks, write_mesh};
use serde_json::{Value, json};
use std::path::Path;
use std::process::Command;

#[test]
fn other_programs_read_what_is_written() {
    let Some(python) = python_with_meshio() else {
        eprintln!("skipped: no python3 with meshio (set VIDE_PYTHON to one)");
        return;
    };
    let folder = tempfile::tempdir().unwrap();
    let mut expected = Vec::new();
    for (file, mesh, without) in meshes() {
        let path = folder.path().join(file);
        write_mesh(&path, &mesh).unwrap();
        expected.push(description(file, &mesh, without));
    }
    for (file, blocks) in blocks() {
        let path = folder.path().join(file);
        std::fs::create_dir_all(path.parent().unwrap()).unwrap();
        write_blocks(&path, &blocks).unwrap();
        expected.push(description_of_blocks(file, &blocks));
    }
    write_binary_msh(folder.path(), &mut expected);
    write_other_spellings(folder.path(), &mut expected);
    let list = Value::Array(expected).to_string();
    std::fs::write(folder.path().join("expected.json"), list).unwrap();
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/independent/read_back.py");
    let run = Command::new(python)
        .arg(script)
        .arg(folder.path())
        .output()
        .unwrap();
    let report = String::from_utf8_lossy(&run.stdout);
    println!("{report}");
    assert!(
        run.status.success(),
        "{report}\n{}",
        String::from_utf8_lossy(&run.stderr)
    );
    assert!(report.contains("ok mixed.vtu with meshio"), "{report}");
    assert!(report.contains("ok cut/blockMeshDict by hand"), "{report}");
}

fn python_with_meshio() -> Option<String> {
    let python = std::env::var("VIDE_PYTHON").unwrap_or_else(|_| "python3".into());
    let found = Command::new(&python)
        .args(["-c", "import meshio"])
        .output()
        .ok()?;
    found.status.success().then_some(python)
}

/// Files, what they hold, and the readers that cannot read this.
fn meshes() -> Vec<(&'static str, Mesh, &'static [&'static str])> {
    let planar = |cells: &[Cell]| mesh(&square_points(), cells);
    let triangles = [
        Cell::Triangle([0, 1, 4]),
        Cell::Triangle([1, 2, 5]),
        Cell::Triangle([0, 4, 3]),
    ];
    let segments = [
        Cell::Segment([0, 1]),
        Cell::Segment([1, 2]),
        Cell::Segment([2, 0]),
    ];
    let tetrahedra = [
        Cell::Tetrahedron([0, 1, 3, 4]),
        Cell::Tetrahedron([1, 2, 3, 5]),
    ];
    vec![
        ("mixed.vtu", mesh(&cube_points(), &every_kind()), &[]),
        ("mixed.msh", mesh(&cube_points(), &every_kind()), &[]),
        ("mixed.vtk", mesh(&cube_points(), &every_kind()), &[]),
        // In order of dimension and kind, as the file has them.
        ("ordered.mesh", mesh(&cube_points(), &medit_kinds()), &[]),
        ("triangles.mesh", planar(&triangles), &[]),
        ("triangles.off", planar(&triangles), &[]),
        ("triangles.ply", planar(&triangles), &[]),
        ("triangles.obj", planar(&triangles), &[]),
        ("triangles.stl", mesh(&corners_apart(), &APART), &[]),
        // The reader of meshio is for the files of TetGen, in space.
        ("triangles.ele", planar(&triangles), &["with_meshio"]),
        ("tetrahedra.vtu", mesh(&cube_points(), &tetrahedra), &[]),
        ("segments.poly", planar(&segments), &[]),
        ("points.xy", mesh(&square_points(), &[]), &[]),
        ("points.xyz", mesh(&cube_points(), &[]), &[]),
        ("empty.vtu", Mesh::default(), &["with_meshio"]),
    ]
}

fn blocks() -> [(&'static str, StructuredBlocks); 7] {
    let mut lifted = some_blocks::annulus(4, 3);
    lifted.blocks[2].points[5][2] = 0.25;
    [
        ("annulus.p3d", some_blocks::annulus(6, 4)),
        ("annulus.p3b", some_blocks::annulus(6, 4)),
        ("lifted.p3d", lifted.clone()),
        ("lifted.p3b", lifted),
        ("annulus/blockMeshDict", some_blocks::annulus(6, 4)),
        ("strip/blockMeshDict", some_blocks::strip(5, 3)),
        // Two blocks whose curves have the same ends, so that they are cut.
        ("cut/blockMeshDict", some_blocks::ring()),
    ]
}

fn description_of_blocks(file: &str, blocks: &StructuredBlocks) -> Value {
    let block = |block: &mesh_io::StructuredBlock| json!({ "ni": block.ni, "nj": block.nj, "points": block.points });
    json!({ "file": file, "blocks": blocks.blocks.iter().map(block).collect::<Vec<_>>() })
}

fn write_binary_msh(folder: &Path, expected: &mut Vec<Value>) {
    let mesh = mesh(&cube_points(), &every_kind());
    let mut file = std::fs::File::create(folder.join("binary.msh")).unwrap();
    mesh_io::msh::write(&mut file, &mesh, &[], mesh_io::Encoding::Binary).unwrap();
    expected.push(description("binary.msh", &mesh, &[]));
}

/// What [`write_mesh`] does not choose: MSH 2.2, and STL and PLY in text.
fn write_other_spellings(folder: &Path, expected: &mut Vec<Value>) {
    let mixed = mesh(&cube_points(), &every_kind());
    // Of several kinds of cells the reader of meshio takes no data, and no kind twice.
    let mut ordered = mesh(&cube_points(), &medit_kinds());
    ordered.cell_data.clear();
    let versions: [(_, _, &[_]); 2] = [
        ("version2.msh", mixed, &["with_meshio"]),
        ("ordered2.msh", ordered, &[]),
    ];
    for (name, mesh, without) in versions {
        let mut file = std::fs::File::create(folder.join(name)).unwrap();
        mesh_io::msh::write_v2(&mut file, &mesh, &[]).unwrap();
        expected.push(description(name, &mesh, without));
    }
    let apart = mesh(&corners_apart(), &APART);
    let mut file = std::fs::File::create(folder.join("text.stl")).unwrap();
    mesh_io::stl::write(&mut file, &apart, mesh_io::Encoding::Ascii).unwrap();
    expected.push(description("text.stl", &apart, &[]));
    let mut file = std::fs::File::create(folder.join("text.ply")).unwrap();
    mesh_io::ply::write(&mut file, &apart, mesh_io::Encoding::Ascii).unwrap();
    expected.push(description("text.ply", &apart, &[]));
}

fn description(file: &str, mesh: &Mesh, without: &[&str]) -> Value {
    let cells = mesh
        .cells
        .iter()
        .map(|cell| json!([cell.kind().name(), cell.corners()]));
    json!({
        "file": file,
        "points": mesh.points,
        "cells": cells.collect::<Vec<_>>(),
        "markers": mesh.cell_markers,
        "not": without,
    })
}

/// Points with coordinates that only the shortest or the exact spelling brings back, cells, and data.
fn mesh(points: &[[f64; 3]], cells: &[Cell]) -> Mesh {
    let values = |count: usize| (0..count).map(|index| 0.1 * index as f64).collect();
    Mesh {
        points: points.into(),
        cells: Cells::from_iter(cells.iter().copied()),
        point_markers: None,
        cell_markers: (!cells.is_empty()).then(|| (1..=cells.len() as i32).collect()),
        point_data: vec![DataArray::scalar("height", values(points.len()))],
        cell_data: vec![DataArray::scalar("quality", values(cells.len()))],
    }
}

fn square_points() -> Vec<[f64; 3]> {
    vec![
        [0.0, 0.0, 0.0],
        [0.1, 0.0, 0.0],
        [0.1 + 0.2, 1e-300, 0.0],
        [0.0, 1.0 / 3.0, 0.0],
        [0.1, 0.3, 0.0],
        [2.0, -1e22, 0.0],
    ]
}

fn cube_points() -> Vec<[f64; 3]> {
    let corner = |index: u32| {
        [index & 1, index >> 1 & 1, index >> 2].map(|bit| f64::from(bit) * 0.1 + 1.0 / 3.0)
    };
    (0..8).map(corner).collect()
}

/// Corners of two triangles, in floats and none of them shared, so that no reader numbers them anew.
fn corners_apart() -> Vec<[f64; 3]> {
    let corner = |k: i32| [0.5 * f64::from(k), f64::from(k * k), f64::from(k % 2)];
    (0..6).map(corner).collect()
}

const APART: [Cell; 2] = [Cell::Triangle([0, 1, 2]), Cell::Triangle([3, 4, 5])];

/// The kinds that every reader of Medit knows, in the order of a file.
fn medit_kinds() -> Vec<Cell> {
    vec![
        Cell::Segment([0, 1]),
        Cell::Triangle([0, 1, 3]),
        Cell::Triangle([0, 3, 2]),
        Cell::Quad([0, 1, 3, 2]),
        Cell::Tetrahedron([0, 1, 2, 4]),
        Cell::Hexahedron([0, 1, 3, 2, 4, 5, 7, 6]),
    ]
}

/// One cell of each kind, and a second triangle out of order.
fn every_kind() -> Vec<Cell> {
    vec![
        Cell::Triangle([0, 1, 3]),
        Cell::Hexahedron([0, 1, 3, 2, 4, 5, 7, 6]),
        Cell::Vertex([6]),
        Cell::Segment([0, 1]),
        Cell::Quad([0, 1, 3, 2]),
        Cell::Tetrahedron([0, 1, 2, 4]),
        Cell::Pyramid([0, 1, 3, 2, 7]),
        Cell::Wedge([0, 1, 2, 4, 5, 6]),
        Cell::Triangle([0, 3, 2]),
    ]
}
