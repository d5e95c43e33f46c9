//! OFF, xy, xyz, Triangle's files and circles: what is written is read bit for bit, and no file makes a reader panic.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

mod meshes;
mod spoiled;
mod written;

use mesh_io::triangle::{parse_ele, parse_node, parse_poly, write_ele, write_node, write_poly};
use mesh_io::{CellKind, CirclesDomain, Format, Frame, Hole, Mesh, PlanarGraph, Region};
use mesh_io::{circles_toml, obj, off, stl, xy};
use meshes::{coordinate, mesh};
use proptest::prelude::*;
use spoiled::{spoiled, spoils};
use written::{bits, file};

const FACES: &[CellKind] = CellKind::ALL.split_at(4).0;

fn points_alone(mesh: &Mesh) -> Mesh {
    Mesh {
        points: mesh.points.clone(),
        ..Mesh::default()
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn off_keeps_points_and_faces(mesh in mesh(FACES, false), spoils in spoils()) {
        let file = file(|out| off::write(out, &mesh));
        let kept = Mesh::new(mesh.points, mesh.cells);
        prop_assert_eq!(bits(&off::parse(&file).unwrap()), bits(&kept));
        let coloured = [b"C", &file[..]].concat();
        prop_assert_eq!(bits(&off::parse(&coloured).unwrap()), bits(&kept));
        for file in [file, coloured] {
            prop_assert_eq!(off::parse(&spoiled(&file, &spoils)).unwrap_or_default().check(), Ok(()));
        }
    }

    #[test]
    fn stl_and_obj_keep_triangles(mesh in mesh(&[CellKind::Triangle], false), spoils in spoils()) {
        let corners: Vec<[f64; 3]> = mesh.cells.corners().iter().map(|&i| mesh.points[i as usize]).collect();
        let solid = stl_text(&corners);
        let read = stl::parse(solid.as_bytes()).unwrap();
        let places: Vec<[f64; 3]> = read.cells.corners().iter().map(|&i| read.points[i as usize]).collect();
        prop_assert_eq!(places, corners.clone());
        let object = obj_text(&mesh);
        prop_assert_eq!(bits(&obj::parse(object.as_bytes()).unwrap()), bits(&Mesh::new(mesh.points, mesh.cells)));
        for read in [
            stl::parse(&spoiled(solid.as_bytes(), &spoils)),
            stl::parse(&spoiled(&stl_binary(&corners), &spoils)),
            obj::parse(&spoiled(object.as_bytes(), &spoils)),
        ] {
            prop_assert_eq!(read.unwrap_or_default().check(), Ok(()));
        }
    }

    #[test]
    fn xy_and_xyz_keep_points(mesh in mesh(FACES, true), z in coordinate(), spoils in spoils()) {
        let mut points = points_alone(&mesh);
        let planar = file(|out| xy::write(out, Format::Xy, &points));
        let read = xy::parse::<2>(&planar).unwrap();
        prop_assert_eq!(bits(&Mesh::new(read.iter().map(|&[x, y]| [x, y, 0.0]).collect(), <_>::default())), bits(&points));
        points.points[0][2] = z;
        let spatial = file(|out| xy::write(out, Format::Xyz, &points));
        prop_assert_eq!(bits(&Mesh::new(xy::parse(&spatial).unwrap(), <_>::default())), bits(&points));
        for read in [xy::parse::<3>(&spoiled(&spatial, &spoils)), xy::parse::<3>(&spoiled(&planar, &spoils))] {
            let mesh = Mesh { points: read.unwrap_or_default(), ..Mesh::default() };
            prop_assert_eq!(mesh.check(), Ok(()));
        }
    }

    #[test]
    fn node_and_ele_keep_all_but_names(
        mesh in prop_oneof![mesh(&[CellKind::Triangle], true), mesh(&[CellKind::Tetrahedron], false)],
        spoils in spoils(),
    ) {
        let node = file(|out| write_node(out, &mesh));
        let ele = file(|out| write_ele(out, &mesh));
        let read = parse_ele(&ele, parse_node(&node).unwrap()).unwrap();
        // A planar file has no place for the sign of z = -0.0.
        prop_assert_eq!(&read.points, &mesh.points);
        prop_assert_eq!((&read.cells, &read.point_markers), (&mesh.cells, &mesh.point_markers));
        let attributes: Vec<_> = read.point_data.iter().map(|array| array.values.clone()).collect();
        for (row, vector) in mesh.point_data[0].values.chunks(3).enumerate() {
            prop_assert!(attributes.iter().map(|values| values[row]).eq(vector.iter().copied()));
        }
        let markers = mesh.cell_markers.map(|markers| markers.into_iter().map(f64::from).collect());
        let quality = (!mesh.cells.is_empty()).then(|| mesh.cell_data[0].values.clone());
        let expected: Vec<Vec<f64>> = markers.into_iter().chain(quality).collect();
        prop_assert_eq!(read.cell_data.into_iter().map(|array| array.values).collect::<Vec<_>>(), expected);

        let nodes = parse_node(&spoiled(&node, &spoils)).or_else(|_| parse_node(&node)).unwrap();
        if let Ok(mesh) = parse_ele(&spoiled(&ele, &spoils), nodes) {
            prop_assert_eq!(mesh.check(), Ok(()));
        }
    }

    #[test]
    fn poly_keeps_everything(graph in planar_graph(), spoils in spoils()) {
        let file = file(|out| write_poly(out, &graph));
        prop_assert_eq!(format!("{:?}", parse_poly(&file, none_beside).unwrap()), format!("{graph:?}"));
        if let Ok(graph) = parse_poly(&spoiled(&file, &spoils), none_beside) {
            prop_assert_eq!(graph.as_mesh().check(), Ok(()));
        }
    }

    #[test]
    fn circles_keep_everything_but_lines(domain in circles(), spoils in spoils()) {
        let file = file(|out| circles_toml::write(out, &domain));
        let mut read = circles_toml::parse(&file).unwrap();
        let lines: Vec<_> = read.holes.iter_mut().map(|hole| hole.line.take()).collect();
        prop_assert!(lines.is_sorted() && lines.iter().all(Option::is_some));
        prop_assert_eq!(format!("{read:?}"), format!("{domain:?}"));
        // Any numbers are fine here, so all that can be asked of a spoiled file is an answer.
        let _ = circles_toml::parse(&spoiled(&file, &spoils));
    }
}

/// Three corners after the other.
fn stl_text(corners: &[[f64; 3]]) -> String {
    let vertex = |[x, y, z]: &[f64; 3]| format!("vertex {x:?} {y:?} {z:?}\n");
    let facet = |corners: &[[f64; 3]]| {
        let vertices: String = corners.iter().map(vertex).collect();
        format!("facet normal 0 0 0\nouter loop\n{vertices}endloop\nendfacet\n")
    };
    let facets: String = corners.chunks(3).map(facet).collect();
    format!("solid\n{facets}endsolid\n")
}

fn stl_binary(corners: &[[f64; 3]]) -> Vec<u8> {
    let mut file = vec![0; 80];
    file.extend((corners.len() as u32 / 3).to_le_bytes());
    for triangle in corners.chunks(3) {
        file.extend([0; 12]);
        let numbers = triangle.as_flattened().iter();
        file.extend(numbers.flat_map(|&x| (x as f32).to_le_bytes()));
        file.extend([0; 2]);
    }
    file
}

fn obj_text(mesh: &Mesh) -> String {
    let points = mesh.points.iter();
    let points: String = points
        .map(|[x, y, z]| format!("v {x:?} {y:?} {z:?}\n"))
        .collect();
    let faces = mesh.cells.corners().chunks(3);
    let face = |corners: &[u32]| {
        let [a, b, c] = [0, 1, 2].map(|i| corners[i] + 1);
        format!("f {a} {b}/1 {c}//2\n")
    };
    points + &faces.map(face).collect::<String>()
}

fn none_beside() -> Result<mesh_io::triangle::Nodes, mesh_io::ReadError> {
    Err(mesh_io::ReadProblem::UnknownFormat.into())
}

fn pair() -> impl Strategy<Value = [f64; 2]> {
    prop::array::uniform2(coordinate())
}

fn planar_graph() -> impl Strategy<Value = PlanarGraph> {
    let region = (pair(), coordinate(), prop::option::of(0.0..1e9)).prop_map(
        |(seed, attribute, max_area)| Region {
            seed,
            attribute,
            max_area,
        },
    );
    let holes_and_regions = (
        prop::collection::vec(pair(), 0..3),
        prop::collection::vec(region, 0..3),
    );
    (mesh(&[CellKind::Segment], true), holes_and_regions).prop_map(|(mesh, (holes, regions))| {
        PlanarGraph {
            points: mesh.points.iter().map(|&[x, y, _]| [x, y]).collect(),
            point_markers: mesh.point_markers,
            point_data: Vec::new(),
            segments: mesh
                .cells
                .corners()
                .chunks(2)
                .map(|ends| [ends[0], ends[1]])
                .collect(),
            segment_markers: mesh.cell_markers,
            polygons: None,
            holes,
            regions,
        }
    })
}

fn circles() -> impl Strategy<Value = CirclesDomain> {
    let frame = prop_oneof![
        (pair(), any::<f64>()).prop_map(|(centre, radius)| Frame::Circle { centre, radius }),
        pair().prop_map(|period| Frame::Periodic { period }),
    ];
    let hole = (pair(), any::<f64>(), prop::option::of(any::<String>())).prop_map(
        |(centre, radius, kind)| Hole {
            centre,
            radius,
            kind,
            line: None,
        },
    );
    (frame, prop::collection::vec(hole, 0..4))
        .prop_map(|(frame, holes)| CirclesDomain { frame, holes })
}
