//! STL, OBJ and PLY: what is written is read bit for bit, and no file makes a reader panic.

use crate::meshes::mesh;
use crate::spoiled::{spoiled, spoils};
use crate::written::{bits, file};
use mesh_io::{Cell, CellKind, Encoding, Mesh, obj, ply, read_mesh, stl, write_mesh};
use proptest::prelude::*;

const SURFACE: &[CellKind] = &[CellKind::Segment, CellKind::Triangle, CellKind::Quad];
const ENCODINGS: [Encoding; 2] = [Encoding::Ascii, Encoding::Binary];

fn corners_of(mesh: &Mesh) -> Vec<[f64; 3]> {
    let corners = mesh.cells.corners().iter();
    corners
        .map(|&corner| mesh.points[corner as usize])
        .collect()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn obj_keeps_points_and_cells(mesh in mesh(SURFACE, false), spoils in spoils()) {
        let file = file(|out| obj::write(out, &mesh));
        let kept = Mesh::new(mesh.points, mesh.cells);
        prop_assert_eq!(bits(&obj::parse(&file).unwrap()), bits(&kept));
        prop_assert_eq!(obj::parse(&spoiled(&file, &spoils)).unwrap_or_default().check(), Ok(()));
    }

    #[test]
    fn ply_keeps_points_and_cells(mesh in mesh(SURFACE, false), spoils in spoils()) {
        let (edges, faces): (Vec<Cell>, Vec<Cell>) =
            mesh.cells.iter().partition(|cell| cell.kind() == CellKind::Segment);
        let kept = Mesh::new(mesh.points.clone(), faces.into_iter().chain(edges).collect());
        for encoding in ENCODINGS {
            let file = file(|out| ply::write(out, &mesh, encoding));
            prop_assert_eq!(bits(&ply::parse_mesh(&file).unwrap()), bits(&kept));
            prop_assert_eq!(ply::parse_mesh(&spoiled(&file, &spoils)).unwrap_or_default().check(), Ok(()));
        }
    }

    #[test]
    fn stl_keeps_the_places_of_corners(mut mesh in mesh(&[CellKind::Triangle], false), spoils in spoils()) {
        let read = stl::parse(&file(|out| stl::write(out, &mesh, Encoding::Ascii))).unwrap();
        prop_assert_eq!(corners_of(&read), corners_of(&mesh));
        for coordinate in mesh.points.as_flattened_mut() {
            let float = *coordinate as f32;
            *coordinate = if float.is_finite() { float.into() } else { 1.0 };
        }
        let file = file(|out| stl::write(out, &mesh, Encoding::Binary));
        prop_assert_eq!(corners_of(&stl::parse(&file).unwrap()), corners_of(&mesh));
        prop_assert_eq!(stl::parse(&spoiled(&file, &spoils)).unwrap_or_default().check(), Ok(()));
    }
}

#[test]
fn a_path_names_the_format_and_binary_is_preferred() {
    let folder = tempfile::tempdir().unwrap();
    let points = vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.5]];
    let mesh = Mesh::new(points, [Cell::Triangle([0, 1, 2])].into_iter().collect());
    for (name, length) in [("a.stl", Some(84 + 50)), ("a.ply", None), ("a.obj", None)] {
        let path = folder.path().join(name);
        write_mesh(&path, &mesh).unwrap();
        assert_eq!(read_mesh(&path).unwrap(), mesh, "{name}");
        let bytes = std::fs::read(&path).unwrap();
        assert!(length.is_none_or(|length| bytes.len() == length));
    }
}
