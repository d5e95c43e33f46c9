//! VTU: what is written is read, other writers' spellings are read, and no file makes the reader panic.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

mod meshes;
mod spoiled;

use mesh_io::{CellKind, DataArray, Mesh, vtu};
use meshes::mesh;
use proptest::prelude::*;
use spoiled::{spoiled, spoils};

fn written(mesh: &Mesh) -> Vec<u8> {
    let mut out = Vec::new();
    vtu::write(&mut out, mesh).expect("a sound mesh");
    out
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn what_is_written_is_read(mesh in mesh(&CellKind::ALL, false)) {
        prop_assert_eq!(vtu::parse(&written(&mesh)).unwrap(), mesh);
    }

    #[test]
    fn a_spoiled_file_gives_a_sound_mesh_or_an_error(
        mesh in mesh(&CellKind::ALL, false),
        spoils in spoils(),
        spelling in 0..4_usize,
    ) {
        let file = if spelling == 0 { written(&mesh) } else { SPELLINGS[spelling - 1].1.to_vec() };
        if let Ok(mesh) = vtu::parse(&spoiled(&file, &spoils)) {
            prop_assert_eq!(mesh.check(), Ok(()));
        }
    }
}

/// One triangle as other programs write it; made by meshio and VTK.
const SPELLINGS: [(&str, &[u8]); 3] = [
    (
        "inline, zlib, 32-bit header",
        include_bytes!("vtu/meshio_zlib.vtu"),
    ),
    (
        "appended, raw, 64-bit header",
        include_bytes!("vtu/vtk_appended_raw.vtu"),
    ),
    (
        "appended, base64, zlib",
        include_bytes!("vtu/vtk_appended_base64_zlib.vtu"),
    ),
];

#[test]
fn files_of_other_writers_are_read() {
    for (spelling, file) in SPELLINGS {
        let mesh = vtu::parse(file).unwrap_or_else(|error| panic!("{spelling}: {error}"));
        assert_eq!(
            mesh.points,
            [
                [0.0, 0.0, 0.0],
                [1.0, 0.0, 0.0],
                [0.5, 0.75, 0.0],
                [1.5, 0.75, 0.0]
            ],
            "{spelling}"
        );
        assert_eq!(mesh.cells.corners(), [0, 1, 2, 1, 3, 2], "{spelling}");
        assert_eq!(mesh.cell_data[0].values, [0.25, 0.5], "{spelling}");
        assert_eq!(
            mesh.cell_markers.as_deref(),
            Some(&[7, -8][..]),
            "{spelling}"
        );
    }
}

const ASCII: &str = r#"<VTKFile type="UnstructuredGrid" byte_order="LittleEndian">
<UnstructuredGrid>
<Piece NumberOfPoints="3" NumberOfCells="1">
<Points>
<DataArray type="Float64" NumberOfComponents="3" format="ascii">0 0 0 1 0 0 0 1 0</DataArray>
</Points>
<Cells>
<DataArray type="Int32" Name="connectivity" format="ascii">0 1 2</DataArray>
<DataArray type="Int32" Name="offsets" format="ascii">3</DataArray>
<DataArray type="UInt8" Name="types" format="ascii">5</DataArray>
</Cells>
</Piece>
</UnstructuredGrid>
</VTKFile>"#;

#[test]
fn pieces_are_joined() {
    let start = ASCII.find("<Piece").unwrap();
    let end = ASCII.find("</UnstructuredGrid>").unwrap();
    let twice = [&ASCII[..end], &ASCII[start..end], &ASCII[end..]].concat();
    assert_eq!(
        vtu::parse(twice.as_bytes()).unwrap().cells.corners(),
        [0, 1, 2, 3, 4, 5]
    );
}

#[test]
fn errors_name_line_element_and_number() {
    let change = |from: &str, to: &str| {
        assert!(ASCII.contains(from), "{from}");
        let error = vtu::parse(ASCII.replace(from, to).as_bytes()).unwrap_err();
        format!("{from} -> {to}: {error}")
    };
    let messages = [
        change("0 1 2<", "0 1 3<"),
        change("0 1 2<", "0 -1 2<"),
        change("0 1 2<", "0 1 2.5<"),
        change("0 1 2<", "0 1<"),
        change(">3<", ">4<"),
        change(">3<", ">2<"),
        change(">5<", ">22<"),
        change(">5<", "><"),
        change("0 1 0<", "0 1 NaN<"),
        change("0 1 0<", "0 1<"),
        change("0 1 0<", "0 one 0<"),
        change("NumberOfPoints=\"3\"", "NumberOfPoints=\"99999999999\""),
        change("NumberOfCells=\"1\"", "NumberOfCells=\"many\""),
        change("\"UnstructuredGrid\"", "\"PolyData\""),
        change("<VTKFile", "<VTKFile compressor=\"vtkLZ4DataCompressor\""),
        change("</Points>", "</Pints>"),
        change("<Piece", "<Peace"),
        change("format=\"ascii\">0 1 2<", "format=\"binary\">@@@@<"),
        change("format=\"ascii\">0 1 2<", "format=\"binary\">//////////8=<"),
        change(
            "format=\"ascii\">0 1 2<",
            "format=\"appended\" offset=\"0\"><",
        ),
    ];
    insta::assert_snapshot!(messages.join("\n"));
}

#[test]
fn data_keep_their_order() {
    let mut mesh = vtu::parse(ASCII.as_bytes()).unwrap();
    mesh.point_data = ["a", "c", "b", "a"]
        .map(|name| DataArray::scalar(name, vec![0.0; 3]))
        .into();
    assert_eq!(vtu::parse(&written(&mesh)).unwrap(), mesh);
}

#[test]
fn pieces_with_other_data_are_refused() {
    let data = |name: &str| {
        let array = format!(
            "<DataArray type=\"Float64\" Name=\"{name}\" format=\"ascii\">1 2 3</DataArray>"
        );
        format!("<PointData>{array}</PointData><Points>")
    };
    let start = ASCII.find("<Piece").unwrap();
    let end = ASCII.find("</UnstructuredGrid>").unwrap();
    let piece = |name: &str| ASCII[start..end].replace("<Points>", &data(name));
    let file = |names: [&str; 2]| {
        [
            &ASCII[..start],
            &piece(names[0]),
            &piece(names[1]),
            &ASCII[end..],
        ]
        .concat()
    };
    assert_eq!(
        vtu::parse(file(["a", "a"]).as_bytes()).unwrap().point_data[0].values,
        [1., 2., 3., 1., 2., 3.]
    );
    insta::assert_snapshot!(
        vtu::parse(file(["a", "b"]).as_bytes()).unwrap_err(),
        @"line 13: expected the data arrays of the piece before, found `b`"
    );
}
