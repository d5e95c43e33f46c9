//! The quality of any plain mesh, by the measures of its kinds of cells.

use delaunay_core::measure::{Statistics, facet, quad, tetrahedron};
use glam::{DVec2, DVec3};
use mesh_io::{Cell, CellKind, Mesh};
use rayon::prelude::*;

/// Whether small or large values of a measure are bad.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Worst {
    /// Small values are bad.
    Smallest,
    /// Large values are bad.
    Largest,
}

/// A measure over all cells of one kind; ids are positions in the mesh's list of cells.
#[derive(Clone, Debug)]
pub struct Measured {
    /// Kind of cell and measure, such as `triangle.radius_ratio`.
    pub name: String,
    /// Which end is bad.
    pub worst: Worst,
    /// The statistics.
    pub statistics: Statistics<usize>,
}

impl Measured {
    /// The worst `count` cells with their values, worst first.
    #[must_use]
    pub fn worst_cells(&self, count: usize) -> Vec<(usize, f64)> {
        match self.worst {
            Worst::Smallest => self.statistics.smallest(count).collect(),
            Worst::Largest => self.statistics.largest(count).collect(),
        }
    }
}

/// Every measure of every triangle, quad and tetrahedron of a mesh, by name; other cells are not
/// measured.
///
/// A quad in space is measured in the plane through its middle, seen from the side on which its
/// corners turn counterclockwise. O(n log n), on the threads of the current pool; what comes out does not depend on
/// their number.
#[must_use]
pub fn measure_mesh(mesh: &Mesh) -> Vec<Measured> {
    let pieces = pieces(mesh).into_par_iter();
    into_measured(pieces.map(Piece::measured).collect())
}

/// Every measure of quads of the plane, by name; ids are positions in the iteration.
#[must_use]
pub fn measure_quads(quads: impl IntoIterator<Item = [DVec2; 4]>) -> Vec<Measured> {
    let mut columns = Columns::default();
    for (id, corners) in quads.into_iter().enumerate() {
        columns.quad(id, corners);
    }
    into_measured(vec![columns])
}

/// The measures of quads, in the order of [`Columns::quads`].
const OF_QUADS: [(&str, Worst); 3] = [
    ("quad.max_angle", Worst::Largest),
    ("quad.min_angle", Worst::Smallest),
    ("quad.scaled_jacobian", Worst::Smallest),
];

const OF_TETRAHEDRA: [(&str, Worst); 5] = [
    ("tetrahedron.inradius_quality", Worst::Smallest),
    ("tetrahedron.max_dihedral", Worst::Largest),
    ("tetrahedron.min_dihedral", Worst::Smallest),
    ("tetrahedron.radius_edge_ratio", Worst::Largest),
    ("tetrahedron.radius_ratio", Worst::Smallest),
];

const OF_TRIANGLES: [(&str, Worst); 4] = [
    ("triangle.max_angle", Worst::Largest),
    ("triangle.min_angle", Worst::Smallest),
    ("triangle.radius_edge_ratio", Worst::Largest),
    ("triangle.radius_ratio", Worst::Smallest),
];

/// The values of one measure, each with the id of its cell.
type Column = Vec<(usize, f64)>;

/// The values of every measure over some of the cells.
#[derive(Default)]
struct Columns {
    quads: [Column; OF_QUADS.len()],
    tetrahedra: [Column; OF_TETRAHEDRA.len()],
    triangles: [Column; OF_TRIANGLES.len()],
}

impl Columns {
    fn triangle(&mut self, id: usize, corners: [DVec3; 3]) {
        let angles = facet::angles(corners);
        let values = [
            largest(&angles),
            smallest(&angles),
            facet::radius_edge_ratio(corners),
            facet::radius_ratio(corners),
        ];
        push_row(&mut self.triangles, id, values);
    }

    fn quad(&mut self, id: usize, corners: [DVec2; 4]) {
        let angles = quad::corner_angles(corners);
        let jacobian = quad::scaled_jacobian(corners);
        let values = [largest(&angles), smallest(&angles), jacobian];
        push_row(&mut self.quads, id, values);
    }

    fn tetrahedron(&mut self, id: usize, corners: [DVec3; 4]) {
        let dihedrals = tetrahedron::dihedral_angles(corners);
        let values = [
            tetrahedron::inradius_quality(corners),
            largest(&dihedrals),
            smallest(&dihedrals),
            tetrahedron::radius_edge_ratio(corners),
            tetrahedron::radius_ratio(corners),
        ];
        push_row(&mut self.tetrahedra, id, values);
    }

    /// All columns, in the order of their names.
    fn into_all(self) -> impl Iterator<Item = Column> {
        let of_faces = self.quads.into_iter();
        of_faces.chain(self.tetrahedra).chain(self.triangles)
    }
}

fn push_row<const N: usize>(columns: &mut [Column; N], id: usize, values: [f64; N]) {
    for (column, value) in columns.iter_mut().zip(values) {
        column.push((id, value));
    }
}

fn smallest(values: &[f64]) -> f64 {
    values.iter().copied().fold(f64::INFINITY, f64::min)
}

fn largest(values: &[f64]) -> f64 {
    values.iter().copied().fold(f64::NEG_INFINITY, f64::max)
}

/// Consecutive cells of a mesh.
struct Piece<'a> {
    points: &'a [[f64; 3]],
    first: usize,
    kinds: &'a [CellKind],
    corners: &'a [u32],
}

/// The cells in pieces that are worth a thread's while.
fn pieces(mesh: &Mesh) -> Vec<Piece<'_>> {
    const CELLS: usize = 1 << 15;
    let mut rest = mesh.cells.corners();
    let mut pieces = Vec::new();
    for (index, kinds) in mesh.cells.kinds().chunks(CELLS).enumerate() {
        let count = kinds.iter().map(|kind| kind.corner_count()).sum();
        let (corners, after) = rest.split_at(count);
        rest = after;
        pieces.push(Piece {
            points: &mesh.points,
            first: index * CELLS,
            kinds,
            corners,
        });
    }
    pieces
}

impl Piece<'_> {
    fn measured(self) -> Columns {
        let mut columns = Columns::default();
        let point = |corner: u32| DVec3::from(self.points[corner as usize]);
        let mut rest = self.corners;
        for (id, &kind) in (self.first..).zip(self.kinds) {
            let (corners, after) = rest.split_at(kind.corner_count());
            rest = after;
            match Cell::new(kind, corners) {
                Some(Cell::Triangle(corners)) => columns.triangle(id, corners.map(point)),
                Some(Cell::Quad(corners)) => columns.quad(id, flattened(corners.map(point))),
                Some(Cell::Tetrahedron(corners)) => columns.tetrahedron(id, corners.map(point)),
                _ => {}
            }
        }
        columns
    }
}

/// The statistics of every measure that has values.
fn into_measured(pieces: Vec<Columns>) -> Vec<Measured> {
    let measures: Vec<_> = [&OF_QUADS[..], &OF_TETRAHEDRA, &OF_TRIANGLES].concat();
    let mut columns: Vec<Vec<Column>> = measures.iter().map(|_| Vec::new()).collect();
    for piece in pieces {
        let parts = columns.iter_mut().zip(piece.into_all());
        parts.for_each(|(column, part)| column.push(part));
    }
    let measured = measures.into_par_iter().zip(columns);
    measured
        .filter_map(|((name, worst), column)| {
            Some(Measured {
                name: name.to_owned(),
                worst,
                statistics: Statistics::of(column.into_iter().flatten())?,
            })
        })
        .collect()
}

/// A quad of space in coordinates of its own plane; one in the plane z = 0 keeps its coordinates,
/// so its orientation shows.
fn flattened(corners: [DVec3; 4]) -> [DVec2; 4] {
    if corners.iter().all(|corner| corner.z == 0.0) {
        return corners.map(DVec3::truncate);
    }
    let normal = (corners[2] - corners[0])
        .cross(corners[3] - corners[1])
        .normalize_or(DVec3::Z);
    let (u, v) = normal.any_orthonormal_pair();
    corners.map(|corner| DVec2::new(u.dot(corner - corners[0]), v.dot(corner - corners[0])))
}

#[cfg(test)]
mod tests {
    use super::*;
    use mesh_io::Cells;

    fn of(points: &[[f64; 3]], cell: Cell) -> Vec<Measured> {
        let mut cells = Cells::default();
        cells.push(cell);
        measure_mesh(&Mesh::new(points.to_vec(), cells))
    }

    fn value(measured: &[Measured], name: &str) -> f64 {
        measured
            .iter()
            .find(|measured| measured.name == name)
            .unwrap()
            .statistics
            .min()
    }

    #[test]
    fn a_square_is_best_in_any_plane_of_space() {
        let flat = [
            [0.0, 0.0, 0.0],
            [1.0, 0.0, 0.0],
            [1.0, 1.0, 0.0],
            [0.0, 1.0, 0.0],
        ];
        let upright = flat.map(|[x, y, _]| [1.0, x, y]);
        for points in [flat, upright] {
            let measured = of(&points, Cell::Quad([0, 1, 2, 3]));
            assert!((value(&measured, "quad.scaled_jacobian") - 1.0).abs() < 1e-15);
            assert!((value(&measured, "quad.max_angle") - 90.0).abs() < 1e-12);
        }
    }

    #[test]
    fn cells_of_all_kinds_and_pieces_are_measured_once() {
        let points: Vec<[f64; 3]> = (0..8)
            .map(|i| [i & 1, i >> 1 & 1, i >> 2].map(f64::from))
            .collect();
        let round = [
            Cell::Triangle([0, 1, 2]),
            Cell::Hexahedron([0, 1, 3, 2, 4, 5, 7, 6]),
            Cell::Tetrahedron([0, 1, 2, 4]),
            Cell::Quad([0, 1, 3, 2]),
        ];
        let cells: Cells = round.into_iter().cycle().take(4 << 15).collect();
        let measured = measure_mesh(&Mesh::new(points, cells));
        assert_eq!(measured.len(), 12);
        assert!(
            measured
                .iter()
                .all(|measure| measure.statistics.count() == 1 << 15)
        );
        let last = measured
            .last()
            .unwrap()
            .statistics
            .smallest(usize::MAX)
            .last();
        assert_eq!(last.map(|(id, _)| id), Some((4 << 15) - 4));
        assert!(measured.is_sorted_by_key(|measure| measure.name.clone()));
    }

    #[test]
    fn the_regular_tetrahedron_is_best() {
        let points = [
            [1.0, 1.0, 1.0],
            [-1.0, -1.0, 1.0],
            [-1.0, 1.0, -1.0],
            [1.0, -1.0, -1.0],
        ];
        let measured = of(&points, Cell::Tetrahedron([0, 1, 2, 3]));
        for name in ["tetrahedron.radius_ratio", "tetrahedron.inradius_quality"] {
            assert!((value(&measured, name) - 1.0).abs() < 1e-12);
        }
    }
}
