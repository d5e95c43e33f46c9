//! Legacy VTK: what is written is read bit for bit, other writers' spellings are read, and no file makes the reader panic.

use crate::meshes::mesh;
use crate::spoiled::{spoiled, spoils};
use mesh_io::{Cell, CellKind, Mesh, vtk};
use proptest::prelude::*;

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn what_is_written_is_read(mesh in mesh(&CellKind::ALL, false)) {
        let mut file = Vec::new();
        vtk::write(&mut file, &mesh).unwrap();
        prop_assert_eq!(format!("{:?}", vtk::parse(&file).unwrap()), format!("{mesh:?}"));
    }

    #[test]
    fn a_spoiled_file_gives_a_sound_mesh_or_an_error(
        mesh in mesh(&CellKind::ALL, false),
        spoils in spoils(),
        spelling in 0..5_usize,
    ) {
        let mut file = Vec::new();
        match spelling {
            0 => vtk::write(&mut file, &mesh).unwrap(),
            1 => file.extend(GRID.bytes()),
            2 => file.extend(POLYDATA.bytes()),
            3 => file.extend(binary(false)),
            _ => file.extend(binary(true)),
        }
        if let Ok(mesh) = vtk::parse(&spoiled(&file, &spoils)) {
            prop_assert_eq!(mesh.check(), Ok(()));
        }
    }
}

/// As VTK 9 writes it in ASCII, with metadata that it adds to every array.
const GRID: &str = "# vtk DataFile Version 5.1\nvtk output\nASCII\nDATASET UNSTRUCTURED_GRID\n\
    FIELD FieldData 1\nTIME 1 1 double\n0.5 \n\
    POINTS 5 float\n0 0 0 1 0 0 1 1 0 \n0 1 0 2 0 0 \n\
    METADATA\nINFORMATION 1\nNAME L2_NORM_RANGE LOCATION vtkDataArray\nDATA 2 0 2 \n\n\
    CELLS 3 7\nOFFSETS vtktypeint64\n0 4 7 \nCONNECTIVITY vtktypeint64\n0 1 2 3 1 4 2 \n\
    CELL_TYPES 2\n9\n7\n\n\
    CELL_DATA 2\nSCALARS marker int\nLOOKUP_TABLE default\n7 -8 \n\
    FIELD FieldData 1\narea%20of%20it 1 2 double\n1 0.5 \nMETADATA\nINFORMATION 0\n\n\
    POINT_DATA 5\nVECTORS flow double\n0 0 0 1 0 0 nan 0 0 1 1 1 2 2 2 \n\
    SCALARS q float 2\nLOOKUP_TABLE hot\n0 1 2 3 4 5 6 7 8 9 \nLOOKUP_TABLE hot 1\n0 0 0 1\n";

/// As old programs write it.
const POLYDATA: &str = "# vtk DataFile Version 2.0\n\nascii\ndataset polydata\n\
    POINTS 4 double\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n\
    VERTICES 1 2\n1 3\nLINES 1 3\n2 0 2\nPOLYGONS 2 9\n4 0 1 2 3\n3 0 1 2\n\
    CELL_DATA 4\nCOLOR_SCALARS colour 1\n0 0.25 0.5 1\nNORMALS n float\n0 0 1 0 0 1 0 0 1 0 0 1\n";

/// Two tetrahedra in big-endian binary, the cells in either form.
fn binary(with_offsets: bool) -> Vec<u8> {
    let version = if with_offsets { "5.1" } else { "3.0" };
    let mut file = format!("# vtk DataFile Version {version}\nbinary\nBINARY\nDATASET UNSTRUCTURED_GRID\nPOINTS 5 float\n").into_bytes();
    let points = [
        [0., 0., 0.],
        [1., 0., 0.],
        [0., 1., 0.],
        [0., 0., 1.],
        [1., 1., 1.],
    ];
    file.extend(
        points
            .as_flattened()
            .iter()
            .flat_map(|&x: &f32| x.to_be_bytes()),
    );
    let corners = [[0, 1, 2, 3], [1, 2, 3, 4]];
    if with_offsets {
        file.extend(b"\nCELLS 3 8\nOFFSETS vtktypeint64\n");
        file.extend([0_i64, 4, 8].iter().flat_map(|n| n.to_be_bytes()));
        file.extend(b"\nCONNECTIVITY vtktypeint64\n");
        file.extend(
            corners
                .as_flattened()
                .iter()
                .flat_map(|&n: &i64| n.to_be_bytes()),
        );
    } else {
        file.extend(b"\nCELLS 2 10\n");
        for cell in corners {
            file.extend(4_i32.to_be_bytes());
            file.extend(cell.iter().flat_map(|&n| (n as i32).to_be_bytes()));
        }
    }
    file.extend(b"\nCELL_TYPES 2\n\0\0\0\x0a\0\0\0\x0a\nPOINT_DATA 5\nSCALARS marker vtkIdType\nLOOKUP_TABLE default\n");
    file.extend((10..15_i32).flat_map(i32::to_be_bytes));
    file.extend(b"\nCOLOR_SCALARS colour 1\n\n\x0a\x20\xff\0\nFIELD FieldData 1\nt 1 5 unsigned_char\n\x01\x02\x03\x04\x05\n");
    file.extend(b"METADATA\nINFORMATION 0\n\n");
    file
}

#[test]
fn a_grid_of_version_5_is_read_with_its_data() {
    let mesh = vtk::parse(GRID.as_bytes()).unwrap();
    assert_eq!(mesh.points[4], [2.0, 0.0, 0.0]);
    let cells = [Cell::Quad([0, 1, 2, 3]), Cell::Triangle([1, 4, 2])];
    assert!(mesh.cells.iter().eq(cells));
    assert_eq!(mesh.cell_markers, Some(vec![7, -8]));
    let names = |data: &[mesh_io::DataArray]| -> Vec<(String, usize)> {
        let named = data
            .iter()
            .map(|array| (array.name.clone(), array.components));
        named.collect()
    };
    assert_eq!(names(&mesh.cell_data), [("area of it".into(), 1)]);
    assert_eq!(
        names(&mesh.point_data),
        [("flow".into(), 3), ("q".into(), 2)]
    );
    assert_eq!(mesh.point_data[1].values[9], 9.0);
}

#[test]
fn polydata_are_vertices_segments_triangles_and_quads() {
    let mesh = vtk::parse(POLYDATA.as_bytes()).unwrap();
    let cells = [
        Cell::Vertex([3]),
        Cell::Segment([0, 2]),
        Cell::Quad([0, 1, 2, 3]),
        Cell::Triangle([0, 1, 2]),
    ];
    assert!(mesh.cells.iter().eq(cells));
    assert_eq!(mesh.cell_data[0].values, [0.0, 0.25, 0.5, 1.0]);
    let pentagon = POLYDATA.replace("POLYGONS 2 9\n4 0 1 2 3", "POLYGONS 2 10\n5 0 1 2 3 1");
    insta::assert_snapshot!(vtk::parse(pentagon.as_bytes()).unwrap_err(), @"line 14: cell 2 of VTK type 7 with 5 corners is not supported");
    let strips = POLYDATA.replace("POLYGONS", "TRIANGLE_STRIPS");
    insta::assert_snapshot!(vtk::parse(strips.as_bytes()).unwrap_err(), @"line 14: VTK polydata of triangle strips is not supported");
}

#[test]
fn binary_numbers_are_big_endian() {
    for with_offsets in [false, true] {
        let mesh = vtk::parse(&binary(with_offsets)).unwrap();
        assert_eq!(mesh.points[3], [0.0, 0.0, 1.0]);
        let cells = [
            Cell::Tetrahedron([0, 1, 2, 3]),
            Cell::Tetrahedron([1, 2, 3, 4]),
        ];
        assert!(mesh.cells.iter().eq(cells));
        assert_eq!(mesh.point_markers, Some(vec![10, 11, 12, 13, 14]));
        let values: Vec<_> = mesh
            .point_data
            .iter()
            .map(|array| array.values.clone())
            .collect();
        assert_eq!(
            values,
            [
                vec![10.0, 10.0, 32.0, 255.0, 0.0],
                vec![1.0, 2.0, 3.0, 4.0, 5.0]
            ]
        );
    }
    let file = binary(false);
    insta::assert_snapshot!(vtk::parse(&file[..120]).unwrap_err(), @"byte 82: the file ends where POINTS should follow");
}

#[test]
fn errors_name_line_and_element() {
    let change = |from: &str, to: &str| {
        assert!(GRID.contains(from), "{from}");
        let error = vtk::parse(GRID.replacen(from, to, 1).as_bytes()).unwrap_err();
        format!("{from} -> {to}: {error}").replace('\n', "|")
    };
    let messages = [
        change("# vtk", "# VTX"),
        change("Version 5.1", "Version 6.0"),
        change("ASCII", "TEXT"),
        change("UNSTRUCTURED_GRID", "RECTILINEAR_GRID"),
        change("POINTS 5", "POINTS many"),
        change("POINTS 5", "POINTS 99999999999"),
        change("POINTS 5", "POINTS 4000000000"),
        change("POINTS 5 float", "POINTS 5 bit"),
        change("1 1 0 \n", "1 inf 0 \n"),
        change("1 1 0 \n", "1 one 0 \n"),
        change("POINTS", "SPOTS"),
        change("CELLS 3 7", "CELLS 9223372036854775807 9223372036854775807"),
        change("OFFSETS", "OFFSET"),
        change("0 4 7", "1 4 7"),
        change("0 4 7", "0 8 7"),
        change("0 4 7", "0 4 6"),
        change("1 4 2 \n", "1 5 2 \n"),
        change("1 4 2 \n", "1 -4 2 \n"),
        change("CELL_TYPES 2\n9\n7", "CELL_TYPES 2\n9\n22"),
        change("CELL_TYPES 2\n9\n7", "CELL_TYPES 1\n9"),
        change("CELL_DATA 2", "CELL_DATA 3"),
        change("SCALARS marker int", "SCALARS marker string"),
        change("SCALARS marker int", "SCALARS marker int 0"),
        change("it 1 2 double", "it 18446744073709551615 2 double"),
        change("it 1 2 double", "it 1 1 double"),
        change("VECTORS flow", "VEKTORS flow"),
    ];
    insta::assert_snapshot!(messages.join("\n"));
}

#[test]
fn what_a_legacy_file_cannot_hold_is_refused() {
    let mut mesh = Mesh::new(vec![[0.0; 3]], <_>::default());
    mesh.point_data = vec![mesh_io::DataArray::scalar("", vec![1.0])];
    let written = vtk::write(&mut Vec::new(), &mesh);
    insta::assert_snapshot!(written.unwrap_err(), @"VTK cannot hold data without a name");
}
