//! Files of points in every format: what is written is read bit for bit, and no file makes a reader panic or ask for much memory.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

mod ply_files;
mod spoiled;

use std::path::Path;

use mesh_io::{
    Coordinates, DataArray, Dimension, Mesh, Points, PointsWanted, ReadError, read_points,
};
use mesh_io::{ply, raw, triangle, vtu, xy};
use ply_files::{PLY_KINDS, ply_file};
use proptest::prelude::*;
use spoiled::{spoiled, spoils};

/// A number of any sign and size, often one that repeats.
fn number() -> impl Strategy<Value = f64> {
    prop_oneof![
        -1e3..1e3,
        any::<f64>().prop_filter("finite", |x| x.is_finite()),
        prop::sample::select(&[0.0, -0.0, 1.0, 0.1, f64::MIN_POSITIVE, f64::MAX][..]),
    ]
}

fn points() -> impl Strategy<Value = Points> {
    let rows = prop::collection::vec([number(), number(), number(), number()], 0..20);
    (rows, any::<bool>(), any::<bool>()).prop_map(|(rows, planar, weighted)| Points {
        coordinates: if planar {
            Coordinates::Plane(rows.iter().map(|&[x, y, ..]| [x, y]).collect())
        } else {
            Coordinates::Space(rows.iter().map(|&[x, y, z, _]| [x, y, z]).collect())
        },
        weights: weighted.then(|| rows.iter().map(|row| row[3]).collect()),
    })
}

/// The numbers of each point, its weight last.
fn rows(points: &Points) -> Vec<Vec<f64>> {
    let mut rows: Vec<Vec<f64>> = match &points.coordinates {
        Coordinates::Plane(points) => points.iter().map(|point| point.to_vec()).collect(),
        Coordinates::Space(points) => points.iter().map(|point| point.to_vec()).collect(),
    };
    for (row, weight) in rows.iter_mut().zip(points.weights.iter().flatten()) {
        row.push(*weight);
    }
    rows
}

fn text(points: &Points, separator: &str) -> Vec<u8> {
    let line = |row: &Vec<f64>| {
        let words: Vec<String> = row.iter().map(|number| format!("{number:?}")).collect();
        words.join(separator) + "\n"
    };
    rows(points).iter().map(line).collect::<String>().into()
}

fn node(points: &Points) -> Vec<u8> {
    let mut mesh = Mesh {
        points: points.coordinates.clone().into_space(),
        ..Mesh::default()
    };
    if let Some(weights) = &points.weights {
        mesh.point_data = vec![DataArray::scalar("weight", weights.clone())];
    }
    let mut file = Vec::new();
    triangle::write_node(&mut file, &mesh).unwrap();
    file
}

/// Tells `-0.0` from `0.0`, which `==` does not.
fn bits(points: &Points) -> String {
    format!("{points:?}")
}

/// The rows that both `xy::parse` and `xy::parse_weighted` answer.
fn parse_text(file: &[u8], of: &Points) -> Result<Points, ReadError> {
    let alone = |coordinates| Points {
        coordinates,
        weights: None,
    };
    match (of.dimension(), of.weights.is_some()) {
        (Dimension::Plane, false) => xy::parse(file).map(Coordinates::Plane).map(alone),
        (Dimension::Space, false) => xy::parse(file).map(Coordinates::Space).map(alone),
        (Dimension::Plane, true) => xy::parse_weighted(file).map(|(points, weights)| Points {
            coordinates: Coordinates::Plane(points),
            weights: Some(weights),
        }),
        (Dimension::Space, true) => xy::parse_weighted(file).map(|(points, weights)| Points {
            coordinates: Coordinates::Space(points),
            weights: Some(weights),
        }),
    }
}

fn is_sound(points: &Points) -> bool {
    let finite = rows(points)
        .iter()
        .flatten()
        .all(|number| number.is_finite());
    let weights = points.weights.as_ref();
    finite && weights.is_none_or(|weights| weights.len() == points.len())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn text_keeps_points_and_weights(points in points(), spoils in spoils()) {
        for separator in [" ", "\t", ", "] {
            let file = text(&points, separator);
            prop_assert_eq!(bits(&parse_text(&file, &points).unwrap()), bits(&points));
            if let Ok(read) = parse_text(&spoiled(&file, &spoils), &points) {
                prop_assert!(is_sound(&read));
            }
        }
    }

    #[test]
    fn raw_numbers_keep_points_and_weights(points in points(), spoils in spoils()) {
        let mut file = Vec::new();
        raw::write(&mut file, &points).unwrap();
        let parse = |file: &[u8]| raw::parse(file, points.dimension(), points.weights.is_some());
        prop_assert_eq!(bits(&parse(&file).unwrap()), bits(&points));
        if let Ok(read) = parse(&spoiled(&file, &spoils)) {
            prop_assert!(is_sound(&read));
        }
    }

    #[test]
    fn spoiled_faces_are_refused_or_sound(spoils in spoils(), big_endian: bool) {
        let order = if big_endian { "big" } else { "little" };
        let mut file = format!(
            "ply\nformat binary_{order}_endian 1.0\nelement vertex 3\nproperty char x\nproperty char y\n\
             element face 2\nproperty list uchar uchar vertex_indices\nend_header\n"
        ).into_bytes();
        file.extend([0, 0, 1, 0, 0, 1, 3, 0, 1, 2, 2, 2, 0]);
        prop_assert_eq!(ply::parse_mesh(&file).unwrap().cells.len(), 2);
        if let Ok(mesh) = ply::parse_mesh(&spoiled(&file, &spoils)) {
            prop_assert_eq!(mesh.check(), Ok(()));
        }
    }

    #[test]
    fn ply_keeps_points_and_weights(points in points(), spoils in spoils()) {
        for kind in PLY_KINDS {
            let file = ply_file(kind, points.dimension(), points.weights.is_some(), &rows(&points));
            let read = ply::parse(&file, points.weights.is_some()).unwrap();
            prop_assert_eq!(bits(&read), bits(&points));
            if let Ok(read) = ply::parse(&spoiled(&file, &spoils), points.weights.is_some()) {
                prop_assert!(is_sound(&read));
            }
        }
    }
}

fn in_folder(files: &[(&str, &[u8])], read: impl Fn(&Path)) {
    let folder = tempfile::tempdir().unwrap();
    for (name, bytes) in files {
        std::fs::write(folder.path().join(name), bytes).unwrap();
    }
    read(folder.path());
}

#[test]
fn every_format_gives_the_same_points_by_its_name() {
    let space = Points {
        coordinates: Coordinates::Space(vec![[0.0, 0.5, 1.0], [2.0, -3.0, 0.25]]),
        weights: Some(vec![0.125, 4.0]),
    };
    let mut raw_file = Vec::new();
    raw::write(&mut raw_file, &space).unwrap();
    let mut vtu_file = Vec::new();
    let mesh = Mesh {
        points: space.coordinates.clone().into_space(),
        point_data: vec![DataArray::scalar("weight", vec![0.125, 4.0])],
        ..Mesh::default()
    };
    vtu::write(&mut vtu_file, &mesh).unwrap();
    let ply = ply_file(PLY_KINDS[0], Dimension::Space, true, &rows(&space));
    let files: [(&str, &[u8]); 6] = [
        ("a.xyz", &text(&space, " ")),
        ("a.node", &node(&space)),
        ("a.ply", &ply),
        ("a.3d.f64", &raw_file),
        ("plain.f64", &raw_file),
        ("a.vtu", &vtu_file),
    ];
    let wanted = PointsWanted {
        dimension: Some(Dimension::Space),
        weights: true,
    };
    in_folder(&files, |folder| {
        for (name, _) in &files {
            let read = read_points(&folder.join(name), wanted).unwrap();
            assert_eq!(read, space, "{name}");
        }
    });
}

#[test]
fn weights_that_are_not_there_and_dimensions_that_nobody_tells_are_errors() {
    let files: [(&str, &[u8]); 6] = [
        ("a.off", b"OFF\n1 0 0\n0 0 0\n"),
        ("a.node", b"1 2 0 0\n1 0 0\n"),
        ("inf.node", b"1 2 1 0\n1 0 0 inf\n"),
        ("a.ply", b"ply\nformat ascii 1.0\nelement vertex 1\nproperty int x\nproperty int y\nend_header\n0 0\n"),
        ("a.f64", &[0; 16]),
        ("a.svg", b""),
    ];
    let wanted = PointsWanted {
        dimension: None,
        weights: true,
    };
    in_folder(&files, |folder| {
        let errors = files.map(|(name, _)| {
            let error = read_points(&folder.join(name), wanted)
                .unwrap_err()
                .to_string();
            error.replace(&format!("{}/", folder.display()), "")
        });
        insta::assert_snapshot!(errors.join("\n"));
    });
}

#[test]
fn hostile_ply_files_are_refused_with_their_place() {
    let ascii = |rest: &str| format!("ply\nformat ascii 1.0\n{rest}").into_bytes();
    let little = |rest: &str, body: &[u8]| {
        let header = format!("ply\nformat binary_little_endian 1.0\n{rest}end_header\n");
        [header.as_bytes(), body].concat()
    };
    let xy = "property double x\nproperty double y\n";
    let files = [
        ascii(&format!(
            "element vertex 1000000000000000000\n{xy}end_header\n0 0\n"
        )),
        ascii(&format!(
            "element vertex 99999999999999999999\n{xy}end_header\n"
        )),
        ascii(&format!("element vertex 2\n{xy}end_header\n0 0\n1 x\n")),
        ascii(&format!("element vertex 1\n{xy}end_header\n0 nan\n")),
        ascii(&format!("element vertex 1\n{xy}end_header\n0 0\n1 1\n")),
        ascii(&format!(
            "element vertex 0\n{xy}element vertex 0\n{xy}end_header\n"
        )),
        ascii("element vertex 1\nproperty int x\nend_header\n0\n"),
        ascii(
            "element vertex 1\nproperty int x\nproperty int y\nproperty int x\nend_header\n0 0 0\n",
        ),
        ascii("element vertex 1\nproperty list uchar int x\nproperty int y\nend_header\n1 0 0\n"),
        ascii("element face 1000000000000000000\nend_header\n"),
        ascii(&format!(
            "element vertex 1\n{xy}element face 1\nproperty list int int i\nend_header\n0 0\n-3 1\n"
        )),
        ascii(&format!(
            "element vertex 1\n{xy}element face 1\nproperty list int int i\nend_header\n0 0\n1e300 1\n"
        )),
        little(
            &format!("element vertex 1000000000000000000\n{xy}"),
            &[0; 24],
        ),
        little(&format!("element vertex 1\n{xy}"), &[0xff; 16]),
        little(&format!("element vertex 1\n{xy}"), &[0; 17]),
        little(
            &format!("element face 1\nproperty list uint double i\nelement vertex 1\n{xy}"),
            &[0xff; 40],
        ),
        little(
            &format!(
                "element face 1000000000000000000\nproperty list uchar uchar i\nelement vertex 1\n{xy}"
            ),
            &[0; 40],
        ),
    ];
    let said = files.map(|file| ply::parse(&file, false).unwrap_err().to_string());
    insta::assert_snapshot!(said.join("\n"));
}
