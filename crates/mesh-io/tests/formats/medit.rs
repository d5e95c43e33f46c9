//! Medit: what is written is read bit for bit, and no file makes the reader panic.

use crate::meshes::mesh;
use crate::spoiled::{spoiled, spoils};
use mesh_io::{Cell, CellKind, Mesh, medit};
use proptest::prelude::*;

const CELLS: &[CellKind] = CellKind::ALL.split_at(1).1;
const FACES: &[CellKind] = &[CellKind::Segment, CellKind::Triangle, CellKind::Quad];

/// What comes back: cells kind by kind, markers that say something, no data.
fn kept(mesh: &Mesh) -> Mesh {
    let markers = mesh.cell_markers.clone();
    let markers = markers.unwrap_or_else(|| vec![0; mesh.cells.len()]);
    let mut cells: Vec<(Cell, i32)> = mesh.cells.iter().zip(markers).collect();
    cells.sort_by_key(|(cell, _)| cell.kind());
    let (cells, markers): (Vec<Cell>, Vec<i32>) = cells.into_iter().unzip();
    let saying = |markers: &Vec<i32>| markers.iter().any(|&marker| marker != 0);
    Mesh {
        point_markers: mesh.point_markers.clone().filter(saying),
        cell_markers: Some(markers).filter(saying),
        ..Mesh::new(mesh.points.clone(), cells.into_iter().collect())
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn what_is_written_is_read(
        mesh in prop_oneof![mesh(CELLS, false), mesh(FACES, true)],
        spoils in spoils(),
    ) {
        let mut file = Vec::new();
        medit::write(&mut file, &mesh).unwrap();
        // A planar file has no place for the sign of z = -0.0.
        prop_assert_eq!(medit::parse(&file).unwrap(), kept(&mesh));
        prop_assert_eq!(medit::parse(&spoiled(&file, &spoils)).unwrap_or_default().check(), Ok(()));
    }

    #[test]
    fn words_behind_a_header_never_panic(
        words in prop::collection::vec(prop::sample::select(&WORDS[..]), 0..30),
    ) {
        let file = format!("MeshVersionFormatted 1 Dimension 3 {}", words.join(" "));
        prop_assert_eq!(medit::parse(file.as_bytes()).unwrap_or_default().check(), Ok(()));
    }
}

const WORDS: [&str; 14] = [
    "Vertices",
    "Edges",
    "Triangles",
    "Hexaedra",
    "Normals",
    "Corners",
    "Unheard",
    "End",
    "\n",
    "0",
    "1",
    "2",
    "-1",
    "18446744073709551615",
];
