//! The quality of any plain mesh, by the measures of its kinds of cells.

use std::collections::BTreeMap;

use delaunay_core::measure::{Statistics, facet, quad, tetrahedron};
use glam::{DVec2, DVec3};
use mesh_io::{Cell, Mesh};

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
/// corners turn counterclockwise. O(n log n).
#[must_use]
pub fn measure_mesh(mesh: &Mesh) -> Vec<Measured> {
    let mut values = Values::default();
    let point = |corner: u32| DVec3::from(mesh.points[corner as usize]);
    for (id, cell) in mesh.cells.iter().enumerate() {
        match cell {
            Cell::Triangle(corners) => values.triangle(id, corners.map(point)),
            Cell::Quad(corners) => values.quad(id, flattened(corners.map(point))),
            Cell::Tetrahedron(corners) => values.tetrahedron(id, corners.map(point)),
            _ => {}
        }
    }
    values.into_measured()
}

/// Every measure of quads of the plane, by name; ids are positions in the iteration.
#[must_use]
pub fn measure_quads(quads: impl IntoIterator<Item = [DVec2; 4]>) -> Vec<Measured> {
    let mut values = Values::default();
    for (id, corners) in quads.into_iter().enumerate() {
        values.quad(id, corners);
    }
    values.into_measured()
}

/// Values of each measure, collected cell by cell.
#[derive(Default)]
struct Values(BTreeMap<&'static str, ValuesOf>);

/// The values of one measure, each with the id of its cell.
struct ValuesOf {
    worst: Worst,
    values: Vec<(usize, f64)>,
}

impl Values {
    fn triangle(&mut self, id: usize, corners: [DVec3; 3]) {
        self.angles(
            id,
            "triangle.min_angle",
            "triangle.max_angle",
            &facet::angles(corners),
        );
        self.push(
            id,
            "triangle.radius_edge_ratio",
            Worst::Largest,
            facet::radius_edge_ratio(corners),
        );
        self.push(
            id,
            "triangle.radius_ratio",
            Worst::Smallest,
            facet::radius_ratio(corners),
        );
    }

    fn quad(&mut self, id: usize, corners: [DVec2; 4]) {
        self.angles(
            id,
            "quad.min_angle",
            "quad.max_angle",
            &quad::corner_angles(corners),
        );
        self.push(
            id,
            "quad.scaled_jacobian",
            Worst::Smallest,
            quad::scaled_jacobian(corners),
        );
    }

    fn tetrahedron(&mut self, id: usize, corners: [DVec3; 4]) {
        let dihedrals = tetrahedron::dihedral_angles(corners);
        self.angles(
            id,
            "tetrahedron.min_dihedral",
            "tetrahedron.max_dihedral",
            &dihedrals,
        );
        self.push(
            id,
            "tetrahedron.radius_edge_ratio",
            Worst::Largest,
            tetrahedron::radius_edge_ratio(corners),
        );
        self.push(
            id,
            "tetrahedron.radius_ratio",
            Worst::Smallest,
            tetrahedron::radius_ratio(corners),
        );
        self.push(
            id,
            "tetrahedron.inradius_quality",
            Worst::Smallest,
            tetrahedron::inradius_quality(corners),
        );
    }

    fn angles(&mut self, id: usize, min: &'static str, max: &'static str, angles: &[f64]) {
        self.push(
            id,
            min,
            Worst::Smallest,
            angles.iter().copied().fold(f64::INFINITY, f64::min),
        );
        self.push(
            id,
            max,
            Worst::Largest,
            angles.iter().copied().fold(f64::NEG_INFINITY, f64::max),
        );
    }

    fn push(&mut self, id: usize, name: &'static str, worst: Worst, value: f64) {
        let none = || ValuesOf {
            worst,
            values: Vec::new(),
        };
        let entry = self.0.entry(name).or_insert_with(none);
        entry.values.push((id, value));
    }

    fn into_measured(self) -> Vec<Measured> {
        let measures = self.0.into_iter();
        let measured = measures.filter_map(|(name, ValuesOf { worst, values })| {
            Some(Measured {
                name: name.to_owned(),
                worst,
                statistics: Statistics::of(values)?,
            })
        });
        measured.collect()
    }
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
