//! MSH end to end: what is written comes back, spoiled files are refused without a panic, and errors say what and where.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

mod spoiled;

use mesh_io::msh::{MshFile, PhysicalName, parse, write, write_v2};
use mesh_io::{Cell, CellKind, Cells, DataArray, Encoding, Mesh};
use proptest::prelude::*;
use spoiled::{spoiled, spoils};

fn written(mesh: &Mesh, names: &[PhysicalName], encoding: Encoding) -> Vec<u8> {
    let mut file = Vec::new();
    write(&mut file, mesh, names, encoding).unwrap();
    file
}

fn coordinate() -> impl Strategy<Value = f64> {
    prop_oneof![
        Just(0.0),
        -1.0..1.0,
        any::<f64>().prop_filter("finite", |value| value.is_finite())
    ]
}

fn cells(points: usize) -> impl Strategy<Value = Cells> {
    let corners = prop::array::uniform8(0..points as u32);
    let cell = (prop::sample::select(&CellKind::ALL), corners)
        .prop_map(|(kind, corners)| Cell::new(kind, &corners[..kind.corner_count()]).unwrap());
    prop::collection::vec(cell, 0..12).prop_map(Cells::from_iter)
}

fn data(name: &'static str, rows: usize) -> impl Strategy<Value = Vec<DataArray>> {
    let array = prop::sample::select(vec![1, 3, 9]).prop_flat_map(move |components| {
        prop::collection::vec(coordinate(), components * rows).prop_map(move |values| DataArray {
            name: name.into(),
            components,
            values,
        })
    });
    prop::collection::vec(array, 0..3)
}

fn meshes() -> impl Strategy<Value = Mesh> {
    prop::collection::vec(prop::array::uniform3(coordinate()), 1..12).prop_flat_map(|points| {
        let count = points.len();
        (
            cells(count),
            prop::option::of(prop::collection::vec(any::<i32>(), count)),
        )
            .prop_flat_map(move |(cells, point_markers)| {
                let (points, rows) = (points.clone(), cells.len());
                let markers = prop::option::of(prop::collection::vec(
                    prop_oneof![0..4, any::<i32>()],
                    rows.max(1),
                ))
                .prop_map(move |markers| markers.filter(|_| rows > 0));
                (markers, data("a value", count), data("q", rows)).prop_map(
                    move |(cell_markers, point_data, cell_data)| Mesh {
                        point_markers: point_markers.clone(),
                        cell_markers,
                        point_data,
                        cell_data,
                        ..Mesh::new(points.clone(), cells.clone())
                    },
                )
            })
    })
}

proptest! {
    #[test]
    fn every_mesh_comes_back_from_both_encodings(mesh in meshes()) {
        let names = [PhysicalName { dimension: 2, marker: 3, name: "the fluid".into() }];
        for encoding in [Encoding::Ascii, Encoding::Binary] {
            let back = parse(&written(&mesh, &names, encoding)).unwrap();
            prop_assert_eq!(&back, &MshFile { mesh: mesh.clone(), names: names.to_vec() });
        }
    }

    #[test]
    fn every_mesh_comes_back_from_version_2(mesh in meshes(), spoils in spoils()) {
        let names = [PhysicalName { dimension: 2, marker: 3, name: "the fluid".into() }];
        let mut file = Vec::new();
        write_v2(&mut file, &mesh, &names).unwrap();
        let mut kept = mesh.clone();
        kept.cell_markers = kept.cell_markers.filter(|markers| markers.iter().any(|&marker| marker != 0));
        prop_assert_eq!(&parse(&file).unwrap(), &MshFile { mesh: kept.clone(), names: names.to_vec() });
        let binary = binary_v2(&mesh);
        kept.point_markers = None;
        kept.point_data = Vec::new();
        kept.cell_data = Vec::new();
        prop_assert_eq!(&parse(&binary).unwrap().mesh, &kept);
        for file in [file, binary] {
            if let Ok(MshFile { mesh, .. }) = parse(&spoiled(&file, &spoils)) {
                prop_assert_eq!(mesh.check(), Ok(()));
            }
        }
    }

    #[test]
    fn spoiled_files_never_panic(mesh in meshes(), spoils in spoils()) {
        for encoding in [Encoding::Ascii, Encoding::Binary] {
            if let Ok(MshFile { mesh, .. }) = parse(&spoiled(&written(&mesh, &[], encoding), &spoils)) {
                prop_assert_eq!(mesh.check(), Ok(()));
            }
        }
    }

    #[test]
    fn bytes_behind_a_header_never_panic(bytes in prop::collection::vec(any::<u8>(), 0..200)) {
        for section in ["Entities", "Nodes", "Elements", "NodeData", "PhysicalNames"] {
            let mut file = b"$MeshFormat\n4.1 1 8\n\x01\0\0\0\n$EndMeshFormat\n$".to_vec();
            file.extend_from_slice(section.as_bytes());
            file.push(b'\n');
            file.extend_from_slice(&bytes);
            prop_assert!(parse(&file).is_err());
        }
    }
}

/// Points, cells and markers in version 2.2 in binary, as its manual describes it, a block for every run of one kind.
fn binary_v2(mesh: &Mesh) -> Vec<u8> {
    let mut file = b"$MeshFormat\n2.2 1 8\n\x01\0\0\0\n$EndMeshFormat\n".to_vec();
    file.extend(format!("$Nodes\n{}\n", mesh.points.len()).bytes());
    for (tag, point) in (1..).zip(&mesh.points) {
        file.extend(i32::to_le_bytes(tag));
        file.extend(point.iter().flat_map(|coordinate| coordinate.to_le_bytes()));
    }
    file.extend(format!("\n$EndNodes\n$Elements\n{}\n", mesh.cells.len()).bytes());
    let cells: Vec<Cell> = mesh.cells.iter().collect();
    let mut tag = 0;
    for run in cells.chunk_by(|a, b| a.kind() == b.kind()) {
        let gmsh_type = match run[0].kind() {
            CellKind::Segment => 1,
            CellKind::Triangle => 2,
            CellKind::Quad => 3,
            CellKind::Tetrahedron => 4,
            CellKind::Hexahedron => 5,
            CellKind::Wedge => 6,
            CellKind::Pyramid => 7,
            CellKind::Vertex => 15,
        };
        file.extend(
            [gmsh_type, run.len() as i32, 2]
                .map(i32::to_le_bytes)
                .as_flattened(),
        );
        for cell in run {
            let marker = mesh
                .cell_markers
                .as_ref()
                .map_or(0, |markers| markers[tag as usize]);
            tag += 1;
            file.extend([tag, marker, 1].map(i32::to_le_bytes).as_flattened());
            let corners = cell.corners().iter();
            file.extend(corners.flat_map(|&corner| (corner as i32 + 1).to_le_bytes()));
        }
    }
    file.extend(b"\n$EndElements\n");
    file
}

fn quads() -> Mesh {
    let points = vec![
        [0.0; 3],
        [1.0, 0.0, 0.0],
        [1.0, 1.0, 0.0],
        [0.0, 1.0, 0.0],
        [2.0, 0.0, 0.0],
    ];
    let cells = [
        Cell::Quad([0, 1, 2, 3]),
        Cell::Segment([0, 1]),
        Cell::Triangle([1, 4, 2]),
    ];
    Mesh {
        cell_markers: Some(vec![9, 7, 0]),
        ..Mesh::new(points, Cells::from_iter(cells))
    }
}

#[test]
fn a_small_file_reads_as_the_manual_says() {
    let names = [PhysicalName {
        dimension: 1,
        marker: 7,
        name: "bottom".into(),
    }];
    insta::assert_snapshot!(String::from_utf8(written(&quads(), &names, Encoding::Ascii)).unwrap());
}

const VERSION_2: &str = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Comments\nanything $Here\n$EndComments\n\
    $PhysicalNames\n1\n2 9 \"fluid zone\"\n$EndPhysicalNames\n\
    $Nodes\n4\n1 0 0 0\n5 1 0 0\n3 1 1 0\n4 0 1 0\n$EndNodes\n\
    $Elements\n2\n2 2 2 9 1 1 3 4\n1 2 2 0 1 1 5 3\n$EndElements\n";

#[test]
fn version_2_is_read_and_cells_are_sorted_by_tag() {
    let MshFile { mesh, names } = parse(VERSION_2.as_bytes()).unwrap();
    assert_eq!(
        mesh.points,
        [[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]]
    );
    assert!(
        mesh.cells
            .iter()
            .eq([Cell::Triangle([0, 1, 2]), Cell::Triangle([0, 2, 3])])
    );
    assert_eq!(mesh.cell_markers, Some(vec![0, 9]));
    assert_eq!(
        names,
        [PhysicalName {
            dimension: 2,
            marker: 9,
            name: "fluid zone".into()
        }]
    );
}

#[test]
fn errors_name_the_element_and_its_line() {
    let file = String::from_utf8(written(&quads(), &[], Encoding::Ascii)).unwrap();
    let error = |from: &str, to: &str| {
        assert!(file.contains(from), "{from}");
        parse(file.replacen(from, to, 1).as_bytes())
            .unwrap_err()
            .to_string()
    };
    let errors = [
        error("4.1 0 8", "4.0 0 8"),
        error("4.1 0 8", "2.2 1 8"),
        error("4.1 0 8", "4.1 0 4"),
        error("4.1 0 8", "4.1 7 8"),
        error("$MeshFormat", "$Nodes"),
        error("$EndEntities", "$EndNodes"),
        error("1 5 1 5", "1 6 1 5"),
        error("1 5 1 5", "2 5 1 5"),
        error("2.0 0.0 0.0", "2.0 nan 0.0"),
        error("2.0 0.0 0.0", "2.0 O.0 0.0"),
        error("3 2 5 3", "3 2 6 3"),
        error("\n5\n0.0", "\n4\n0.0"),
        error("2 3 3 1", "2 3 9 1"),
        error("2 3 3 1", "2 3 3 3"),
        error("$Nodes", "$Noodles"),
        error("$Entities", "$PartitionedEntities"),
    ];
    insta::assert_snapshot!(errors.join("\n"));
}

#[test]
fn a_huge_count_is_an_error_at_once() {
    let file = b"$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n1 999999999999 1 999999999999\n2 1 0 999999999999\n1\n";
    insta::assert_snapshot!(parse(file).unwrap_err(), @"line 8: the file ends where the tag of node 1 in block 0 should follow");
}

#[test]
fn what_msh_cannot_hold_is_refused() {
    let refused = |mesh: &Mesh, name: &str| {
        let names = [PhysicalName {
            dimension: 1,
            marker: 7,
            name: name.into(),
        }];
        write(&mut Vec::new(), mesh, &names, Encoding::Ascii)
            .unwrap_err()
            .to_string()
    };
    let mut mesh = quads();
    let name = refused(&mesh, "a\"b");
    mesh.point_data.push(DataArray {
        name: "flow".into(),
        components: 2,
        values: vec![0.0; 10],
    });
    let components = refused(&mesh, "");
    mesh.points[2][1] = f64::INFINITY;
    insta::assert_snapshot!([name, components, refused(&mesh, "")].join("\n"));
}

#[test]
fn version_2_is_written_as_its_manual_says_and_refused_in_binary_with_the_byte() {
    let mut file = Vec::new();
    write_v2(&mut file, &quads(), &[]).unwrap();
    insta::assert_snapshot!(String::from_utf8(file).unwrap(), @r"
    $MeshFormat
    2.2 0 8
    $EndMeshFormat
    $Nodes
    5
    1 0.0 0.0 0.0
    2 1.0 0.0 0.0
    3 1.0 1.0 0.0
    4 0.0 1.0 0.0
    5 2.0 0.0 0.0
    $EndNodes
    $Elements
    3
    1 3 2 9 3 1 2 3 4
    2 1 2 7 1 1 2
    3 2 2 0 2 2 5 3
    $EndElements
    ");
    let file = binary_v2(&quads());
    let error = |at: usize, bytes: [u8; 4]| {
        let mut file = file.clone();
        file[at..at + 4].copy_from_slice(&bytes);
        parse(&file).unwrap_err().to_string()
    };
    let elements = file
        .windows(9)
        .position(|window| window == b"$Elements")
        .unwrap()
        + 12;
    let errors = [
        error(elements, [9, 0, 0, 0]),
        error(elements + 4, [4, 0, 0, 0]),
        error(elements + 4, [0, 0, 0, 0]),
        error(elements + 4, [0xff; 4]),
        error(elements + 8, [0xff, 0xff, 0xff, 0x7f]),
        error(elements + 24, [6, 0, 0, 0]),
    ];
    insta::assert_snapshot!(errors.join("\n"), @r"
    byte 212: MSH element type 9 is not supported
    byte 216: expected 1 to 3 elements in the block of element 0, found 4
    byte 216: expected 1 to 3 elements in the block of element 0, found 0
    byte 216: expected how many elements follow 0, found -1
    byte 332: the file ends where tag 26 of element 0 should follow
    byte 236: element 0: there is no node 6
    ");
}

/// A reader that indexes the elements anew for every section would need minutes here.
#[test]
fn many_sections_of_node_data_take_no_more_than_linear_time() {
    let mut file =
        String::from("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n1\n1 0 0 0\n$EndNodes\n");
    let count = 50_000;
    file += &format!("$Elements\n{count}\n");
    for tag in (1..=count).rev() {
        file += &format!("{tag} 15 0 1\n");
    }
    file += "$EndElements\n";
    file += &"$NodeData\n1\n\"f\"\n0\n3\n0 1 1\n1 2.5\n$EndNodeData\n".repeat(20_000);
    let start = std::time::Instant::now();
    let mesh = parse(file.as_bytes()).unwrap().mesh;
    assert!(start.elapsed().as_secs() < 10);
    assert_eq!((mesh.cells.len(), mesh.point_data.len()), (count, 20_000));
}
