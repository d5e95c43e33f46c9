//! The files of `TetGen`: what is written is read bit for bit, no file makes a reader panic, and a path tells the plane from space.

use crate::meshes::{coordinate, mesh};
use crate::spoiled::{spoiled, spoils};
use mesh_io::tetgen::{parse_poly, parse_smesh, write_poly};
use mesh_io::triangle::Nodes;
use mesh_io::{CellKind, Facet, PiecewiseComplex, ReadError, ReadProblem, SolidRegion};
use mesh_io::{read_mesh, read_piecewise_complex, read_planar_graph, write_piecewise_complex};
use proptest::prelude::*;

fn none_beside() -> Result<Nodes, ReadError> {
    Err(ReadProblem::UnknownFormat.into())
}

fn place() -> impl Strategy<Value = [f64; 3]> {
    prop::array::uniform3(coordinate())
}

fn complexes() -> impl Strategy<Value = PiecewiseComplex> {
    mesh(&[CellKind::Vertex], false).prop_flat_map(|mesh| {
        let corners = prop::collection::vec(0..mesh.points.len() as u32, 1..7);
        let polygons = prop::collection::vec(corners, 0..3);
        let holes = || prop::collection::vec(place(), 0..3);
        let facet = (polygons, holes()).prop_map(|(polygons, holes)| Facet { polygons, holes });
        let marked = prop::collection::vec((facet, any::<i32>()), 0..5);
        let region = (place(), coordinate(), prop::option::of(0.0..1e9)).prop_map(
            |(seed, attribute, max_volume)| SolidRegion {
                seed,
                attribute,
                max_volume,
            },
        );
        let regions = prop::collection::vec(region, 0..3);
        (marked, any::<bool>(), holes(), regions).prop_map(
            move |(marked, has_markers, holes, regions)| {
                let (facets, markers) = marked.into_iter().unzip();
                PiecewiseComplex {
                    points: mesh.points.clone(),
                    point_markers: mesh.point_markers.clone(),
                    point_data: Vec::new(),
                    facets,
                    facet_markers: has_markers.then_some(markers),
                    holes,
                    regions,
                }
            },
        )
    })
}

/// A `.smesh` of the first polygon of every facet that has one.
fn smesh(complex: &PiecewiseComplex) -> String {
    let mut file = Vec::new();
    let points = PiecewiseComplex {
        points: complex.points.clone(),
        ..PiecewiseComplex::default()
    };
    write_poly(&mut file, &points).unwrap();
    let text = String::from_utf8(file).unwrap();
    let polygons: Vec<_> = complex
        .facets
        .iter()
        .filter_map(|facet| facet.polygons.first())
        .collect();
    let facet = |corners: &&Vec<u32>| {
        let corners: String = corners
            .iter()
            .map(|corner| format!(" {}", corner + 1))
            .collect();
        format!("{}{corners} 7\n", corners.split_ascii_whitespace().count())
    };
    let facets: String = polygons.iter().map(facet).collect();
    text.replace(
        "\n0 0\n0\n",
        &format!("\n{} 1\n{facets}0\n", polygons.len()),
    )
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn poly_keeps_everything(complex in complexes(), spoils in spoils()) {
        let mut file = Vec::new();
        write_poly(&mut file, &complex).unwrap();
        let read = parse_poly(&file, none_beside).unwrap();
        prop_assert_eq!(format!("{read:?}"), format!("{complex:?}"));
        for read in [parse_poly(&spoiled(&file, &spoils), none_beside), parse_smesh(&file, none_beside)] {
            prop_assert_eq!(read.unwrap_or_default().check(), Ok(()));
        }
    }

    #[test]
    fn smesh_keeps_polygons(complex in complexes(), spoils in spoils()) {
        let file = smesh(&complex);
        let read = parse_smesh(file.as_bytes(), none_beside).unwrap();
        let first = |facet: &Facet| facet.polygons.first().cloned();
        let kept: Vec<_> = complex.facets.iter().filter_map(first).collect();
        prop_assert_eq!(read.facets.iter().filter_map(first).collect::<Vec<_>>(), kept);
        let read = parse_smesh(&spoiled(file.as_bytes(), &spoils), none_beside);
        prop_assert_eq!(read.unwrap_or_default().check(), Ok(()));
    }
}

#[test]
fn a_poly_says_by_its_header_whether_it_is_of_the_plane_or_of_space() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.poly");
    let said = |error: &dyn std::fmt::Display| {
        let message = error.to_string();
        message.replace(&format!("{}/", folder.path().display()), "")
    };
    let triangle = Facet {
        polygons: vec![vec![0, 1, 2]],
        holes: Vec::new(),
    };
    let mut complex = PiecewiseComplex {
        points: vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 2.0]],
        facets: vec![triangle],
        facet_markers: Some(vec![3]),
        ..PiecewiseComplex::default()
    };
    write_piecewise_complex(&path, &complex).unwrap();
    assert_eq!(read_piecewise_complex(&path).unwrap(), complex);
    let mesh = read_mesh(&path).unwrap();
    assert_eq!(mesh.cells.corners(), [0, 1, 2]);
    assert_eq!(mesh.cell_markers, Some(vec![3]));
    insta::assert_snapshot!(said(&read_planar_graph(&path).unwrap_err()), @"a.poly: a .poly with points of space is not supported");

    complex.facets[0].polygons[0].push(0);
    write_piecewise_complex(&path, &complex).unwrap();
    insta::assert_snapshot!(said(&read_mesh(&path).unwrap_err()), @"a.poly: facet 0 is no triangle: it has 4 corners");

    std::fs::write(&path, "2 2 0 0\n1 0 0\n2 1 0\n1 0\n1 1 2\n0\n").unwrap();
    assert_eq!(read_mesh(&path).unwrap().cells.corners(), [0, 1]);
    insta::assert_snapshot!(said(&read_piecewise_complex(&path).unwrap_err()), @"a.poly: a complex with points of the plane is not supported");
    let smesh = folder.path().join("a.smesh");
    insta::assert_snapshot!(said(&write_piecewise_complex(&smesh, &complex).unwrap_err()), @"a.smesh: TetGen .smesh cannot hold a piecewise linear complex");
}
