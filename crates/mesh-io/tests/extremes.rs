//! Coordinates at the ends of what a double can be, and text as other systems write it, through files of every format.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

use std::fs;
use std::path::Path;

use mesh_io::{Cell, Connection, write_blocks, write_mesh};
use mesh_io::{Mesh, StructuredBlock, StructuredBlocks, read_blocks, read_circles, read_mesh};

/// Largest and smallest, normal and not, both zeros, the ends of the range of exact predicates, and digits to the last.
const EXTREMES: [f64; 16] = [
    f64::MAX,
    f64::MIN,
    f64::MIN_POSITIVE,
    5e-324,
    -5e-324,
    1e-308,
    0.0,
    -0.0,
    3_213_876_088_517_980_551_083_924_184_682_325_205_044_405_987_565_585_670_602_752.0, // 2^201
    1.793_662_034_335_766e-43,                                                           // 2^-142
    0.1,
    1.0 / 3.0,
    1.0 + f64::EPSILON,
    1.0 - f64::EPSILON / 2.0,
    1e22,
    123_456_789.123_456_78,
];

/// Every extreme once as each coordinate, never on one axis alone.
fn points() -> Vec<[f64; 3]> {
    let at = |k: usize| EXTREMES[k % EXTREMES.len()];
    (0..EXTREMES.len())
        .map(|k| [at(k), at(k + 5), at(k + 11)])
        .collect()
}

fn bits(points: &[[f64; 3]]) -> Vec<[u64; 3]> {
    points.iter().map(|point| point.map(f64::to_bits)).collect()
}

#[test]
fn every_mesh_format_keeps_the_bits_of_coordinates() {
    let folder = tempfile::tempdir().unwrap();
    let triangles = Mesh::new(points(), [Cell::Triangle([0, 1, 15])].into_iter().collect());
    let alone = Mesh::new(points(), <_>::default());
    for (name, mesh) in [
        ("a.vtu", &triangles),
        ("a.msh", &triangles),
        ("a.vtk", &triangles),
        ("a.mesh", &triangles),
        ("a.off", &triangles),
        ("a.ply", &triangles),
        ("a.obj", &triangles),
        ("a.ele", &triangles),
        ("b.node", &alone),
        ("b.xyz", &alone),
    ] {
        let path = folder.path().join(name);
        write_mesh(&path, mesh).unwrap();
        let read = read_mesh(&path).unwrap();
        assert_eq!(bits(&read.points), bits(&mesh.points), "{name}");
        assert_eq!(read.cells, mesh.cells, "{name}");
    }
}

#[test]
fn plot3d_keeps_the_bits_of_coordinates() {
    let folder = tempfile::tempdir().unwrap();
    let block = StructuredBlock {
        name: "all # of\tthem".into(),
        ni: 4,
        nj: 4,
        points: points(),
        sides: std::array::from_fn(|side| Connection::Patch(format!("side {side}"))),
    };
    for name in ["a.p3d", "a.p3b"] {
        let path = folder.path().join(name);
        let blocks = StructuredBlocks {
            blocks: vec![block.clone()],
        };
        write_blocks(&path, &blocks).unwrap();
        let read = read_blocks(&path).unwrap();
        assert_eq!(bits(&read.blocks[0].points), bits(&block.points), "{name}");
        assert_eq!(read, blocks, "{name}");
    }
}

/// Writes `text` as other systems would, and asks that it reads as the same.
fn reads_alike<T: PartialEq + std::fmt::Debug>(path: &Path, mark: &str, read: impl Fn(&Path) -> T) {
    let expected = read(path);
    let text = fs::read_to_string(path).unwrap();
    fs::write(path, format!("{mark}{}", text.replace('\n', "\r\n"))).unwrap();
    assert_eq!(read(path), expected, "{}", path.display());
}

#[test]
fn lines_may_end_as_on_other_systems_and_start_with_a_mark_of_byte_order() {
    const MARK: &str = "\u{feff}";
    let folder = tempfile::tempdir().unwrap();
    let mesh = Mesh::new(points(), [Cell::Triangle([0, 1, 15])].into_iter().collect());
    for (name, mark) in [
        ("a.vtu", MARK),
        ("a.off", MARK),
        ("a.obj", MARK),
        ("a.mesh", MARK),
        ("a.ele", MARK),
        ("a.msh", ""),
        ("a.vtk", ""),
    ] {
        let path = folder.path().join(name);
        write_mesh(&path, &mesh).unwrap();
        reads_alike(&path, mark, |path| read_mesh(path).unwrap());
    }
    let path = folder.path().join("circles.toml");
    let circles = "[domain]\nkind = \"periodic\"\nperiod = [1.0, 2.0]\n[[hole]]\ncentre = [0.5, 0.5]\nradius = 0.1\n";
    fs::write(&path, circles).unwrap();
    reads_alike(&path, MARK, |path| read_circles(path).unwrap());
}

#[test]
fn elements_of_other_points_are_refused_with_file_and_line() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.ele");
    fs::write(
        folder.path().join("a.node"),
        "3 2 0 0\n1 0 0\n2 1 0\n3 0 1\n",
    )
    .unwrap();
    let message = |elements: &str| {
        fs::write(&path, elements).unwrap();
        let message = read_mesh(&path).unwrap_err().to_string();
        message.replace(&format!("{}/", folder.path().display()), "")
    };
    insta::assert_snapshot!(message("1 3 0\n1 1 2 4\n"), @"a.ele:2: element 0: there is no point 4");
    insta::assert_snapshot!(message("1 3 0\n1 0 1 2\n"), @"a.ele:2: element 0: there is no point 0");
    insta::assert_snapshot!(message("1 3 0\n1 -1 1 2\n"), @"a.ele:2: element 0: there is no point -1");
    insta::assert_snapshot!(message("1 3 0\n0 1 2 3\n"), @"a.ele:2: expected 1 as the number of the element, found `0`");
    fs::remove_file(folder.path().join("a.node")).unwrap();
    assert!(message("1 3 0\n1 1 2 3\n").starts_with("a.node: "));
}
