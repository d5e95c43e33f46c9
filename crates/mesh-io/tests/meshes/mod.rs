//! Random meshes to write and read back.

use mesh_io::{Cell, CellKind, Cells, DataArray, Mesh};
use proptest::prelude::*;

/// Finite doubles of every magnitude.
pub(crate) fn coordinate() -> impl Strategy<Value = f64> {
    use prop::num::f64::{NEGATIVE, NORMAL, POSITIVE, SUBNORMAL, ZERO};
    prop_oneof![-1.0..1.0, NORMAL | SUBNORMAL | ZERO | POSITIVE | NEGATIVE]
}

/// A mesh of cells of `kinds` with random markers and data, planar or not.
pub(crate) fn mesh(kinds: &'static [CellKind], planar: bool) -> impl Strategy<Value = Mesh> {
    let point = [coordinate(), coordinate(), coordinate()];
    let points = prop::collection::vec(point, 1..12);
    points.prop_flat_map(move |mut points| {
        if planar {
            points.iter_mut().for_each(|point| point[2] = 0.0);
        }
        let count = points.len() as u32;
        let cell = (prop::sample::select(kinds), prop::array::uniform8(0..count)).prop_map(
            |(kind, corners)| {
                Cell::new(kind, &corners[..kind.corner_count()])
                    .expect("as many as the kind asks for")
            },
        );
        (Just(points), prop::collection::vec(cell, 0..8)).prop_flat_map(with_data)
    })
}

fn with_data((points, cells): (Vec<[f64; 3]>, Vec<Cell>)) -> impl Strategy<Value = Mesh> {
    let (np, nc) = (points.len(), cells.len());
    let markers = |n| prop::option::of(prop::collection::vec(0..100_i32, n));
    let values = |n| prop::collection::vec(coordinate(), n);
    (markers(np), markers(nc), values(3 * np), values(nc)).prop_map(
        move |(point_markers, cell_markers, vectors, scalars)| Mesh {
            points: points.clone(),
            cells: Cells::from_iter(cells.clone()),
            // Without cells there is nothing that could tell no markers from none.
            cell_markers: cell_markers.filter(|_| nc > 0),
            point_markers,
            point_data: vec![DataArray {
                name: "velocity <&>".into(),
                components: 3,
                values: vectors,
            }],
            cell_data: vec![DataArray::scalar("quality", scalars)],
        },
    )
}
