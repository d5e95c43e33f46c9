//! One mesh in all the ways that VTK 9.7 writes it.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

use mesh_io::{Cell, DataArray, vtu};

const FILES: [(&str, &[u8]); 7] = [
    ("ascii", include_bytes!("data/vtu/ascii.vtu")),
    ("inline", include_bytes!("data/vtu/inline.vtu")),
    ("inline, zlib", include_bytes!("data/vtu/inline_zlib.vtu")),
    ("appended raw", include_bytes!("data/vtu/appended_raw.vtu")),
    (
        "appended raw, zlib",
        include_bytes!("data/vtu/appended_raw_zlib.vtu"),
    ),
    (
        "appended base64, big endian",
        include_bytes!("data/vtu/appended_base64.vtu"),
    ),
    (
        "appended base64, zlib",
        include_bytes!("data/vtu/appended_base64_zlib.vtu"),
    ),
];

#[test]
fn every_way_that_vtk_writes_gives_the_same_mesh() {
    for (way, bytes) in FILES {
        let mesh = vtu::parse(bytes).unwrap_or_else(|error| panic!("{way}: {error}"));
        assert_eq!(mesh.points[4], [0.5, 0.5, 1.0], "{way}");
        let cells = [
            Cell::Triangle([0, 1, 4]),
            Cell::Quad([0, 1, 2, 3]),
            Cell::Pyramid([0, 1, 2, 3, 4]),
            Cell::Vertex([4]),
        ];
        assert!(mesh.cells.iter().eq(cells), "{way}");
        assert_eq!(mesh.cell_markers, Some(vec![7, -8, 9, 10]), "{way}");
        let values = (0..5)
            .flat_map(|i| [f64::from(i) + 0.5, -f64::from(i)])
            .collect();
        assert_eq!(
            mesh.point_data,
            [DataArray {
                name: "flow".into(),
                components: 2,
                values
            }],
            "{way}"
        );
    }
}

/// Once every element counted its line from the start of the file, which took minutes here.
#[test]
fn a_million_elements_are_read_in_linear_time() {
    let file = [
        b"<VTKFile type=\"UnstructuredGrid\">".as_slice(),
        &b"<a/>\n".repeat(1_000_000),
    ]
    .concat();
    let error = vtu::parse(&file).unwrap_err();
    assert_eq!(
        error.to_string(),
        "the file ends where a <Piece> should follow"
    );
}
