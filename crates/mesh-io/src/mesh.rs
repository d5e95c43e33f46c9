//! An unstructured mesh as files hold it: points, cells, markers and data.

use crate::cell::Cells;

/// Points, cells between them, and what is known about both. A planar mesh has `z = 0` everywhere.
///
/// The fields are plain; [`Mesh::check`] names the first that contradicts another. Every reader answers a mesh that passes, and
/// every writer refuses one that does not.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// Coordinates of every point.
    pub points: Vec<[f64; 3]>,
    /// Cells, in a stable order.
    pub cells: Cells,
    /// One marker per point (boundary number), where known.
    pub point_markers: Option<Vec<i32>>,
    /// One marker per cell (region or block number), where known.
    pub cell_markers: Option<Vec<i32>>,
    /// Named numbers, one row per point.
    pub point_data: Vec<DataArray>,
    /// Named numbers, one row per cell.
    pub cell_data: Vec<DataArray>,
}

/// Named numbers about points or cells; unlike coordinates, they may be infinite or NaN.
#[derive(Clone, Debug, PartialEq)]
pub struct DataArray {
    /// What the numbers are.
    pub name: String,
    /// Numbers per element, at least 1.
    pub components: usize,
    /// Row after row, `components` numbers each.
    pub values: Vec<f64>,
}

impl DataArray {
    /// One number per element.
    pub fn scalar(name: impl Into<String>, values: Vec<f64>) -> Self {
        Self {
            name: name.into(),
            components: 1,
            values,
        }
    }
}

/// The first contradiction in a [`Mesh`].
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum MeshDefect {
    /// There are more points than 32-bit indices.
    #[error("{0} points are more than 32-bit indices can name")]
    TooManyPoints(usize),
    /// A coordinate is infinite or NaN.
    #[error("point {point}: {axis} is {value}, which is not a finite number")]
    NotFinite {
        /// Index of the point.
        point: usize,
        /// Which coordinate.
        axis: Axis,
        /// The offending value.
        value: f64,
    },
    /// A cell names a point that does not exist.
    #[error("cell {cell}: corner {corner} is point {point}, but there are {points} points")]
    NoSuchPoint {
        /// Index of the cell.
        cell: usize,
        /// Which corner of it, from 0.
        corner: usize,
        /// The index found there.
        point: u32,
        /// Number of points.
        points: usize,
    },
    /// Markers or data have another length than what they describe.
    #[error("{what}: {found} values for {expected}")]
    Length {
        /// Which list.
        what: String,
        /// How many values it should have.
        expected: usize,
        /// How many it has.
        found: usize,
    },
}

/// A coordinate axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "three letters")]
pub enum Axis {
    X,
    Y,
    Z,
}

impl Axis {
    /// The axes in the order of coordinates.
    pub const ALL: [Self; 3] = [Self::X, Self::Y, Self::Z];
}

impl std::fmt::Display for Axis {
    fn fmt(&self, out: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        out.write_str(match self {
            Self::X => "x",
            Self::Y => "y",
            Self::Z => "z",
        })
    }
}

/// The first coordinate that is not finite.
pub(crate) fn first_not_finite(point: &[f64]) -> Option<(Axis, f64)> {
    Axis::ALL
        .into_iter()
        .zip(point.iter().copied())
        .find(|(_, value)| !value.is_finite())
}

impl Mesh {
    /// A mesh of points and cells alone.
    #[must_use]
    pub fn new(points: Vec<[f64; 3]>, cells: Cells) -> Self {
        Self {
            points,
            cells,
            ..Self::default()
        }
    }

    /// Whether the fields agree with each other. O(size of the mesh).
    ///
    /// # Errors
    /// The first contradiction.
    pub fn check(&self) -> Result<(), MeshDefect> {
        check_points(&self.points)?;
        self.check_corners()?;
        check_markers(
            "point markers",
            self.point_markers.as_deref(),
            self.points.len(),
        )?;
        check_markers(
            "cell markers",
            self.cell_markers.as_deref(),
            self.cells.len(),
        )?;
        check_data("point data", &self.point_data, self.points.len())?;
        check_data("cell data", &self.cell_data, self.cells.len())
    }

    fn check_corners(&self) -> Result<(), MeshDefect> {
        let points = self.points.len();
        for (cell, found) in self.cells.iter().enumerate() {
            for (corner, &point) in found.corners().iter().enumerate() {
                if point as usize >= points {
                    return Err(MeshDefect::NoSuchPoint {
                        cell,
                        corner,
                        point,
                        points,
                    });
                }
            }
        }
        Ok(())
    }
}

/// Whether indices of 32 bits can name all points, and all are finite.
pub(crate) fn check_points(points: &[[f64; 3]]) -> Result<(), MeshDefect> {
    if u32::try_from(points.len()).is_err() {
        return Err(MeshDefect::TooManyPoints(points.len()));
    }
    check_finite(points)
}

pub(crate) fn check_finite(points: &[[f64; 3]]) -> Result<(), MeshDefect> {
    for (point, coordinates) in points.iter().enumerate() {
        if let Some((axis, value)) = first_not_finite(coordinates) {
            return Err(MeshDefect::NotFinite { point, axis, value });
        }
    }
    Ok(())
}

pub(crate) fn check_markers(
    what: &str,
    markers: Option<&[i32]>,
    expected: usize,
) -> Result<(), MeshDefect> {
    markers.map_or(Ok(()), |markers| {
        check_length(what, markers.len(), Some(expected), expected)
    })
}

pub(crate) fn check_data(what: &str, arrays: &[DataArray], rows: usize) -> Result<(), MeshDefect> {
    arrays.iter().try_for_each(|array| {
        // An array without components can describe nothing, not even no rows.
        let expected = (array.components > 0)
            .then(|| rows.checked_mul(array.components))
            .flatten();
        check_length(
            &format!("{what} `{}`", array.name),
            array.values.len(),
            expected,
            rows,
        )
    })
}

fn check_length(
    what: &str,
    found: usize,
    expected: Option<usize>,
    rows: usize,
) -> Result<(), MeshDefect> {
    if expected == Some(found) {
        return Ok(());
    }
    Err(MeshDefect::Length {
        what: what.to_owned(),
        expected: expected.unwrap_or(rows),
        found,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cell::Cell;

    fn triangle() -> Mesh {
        Mesh::new(
            vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
            Cells::from_iter([Cell::Triangle([0, 1, 2])]),
        )
    }

    #[test]
    fn a_sound_mesh_passes() {
        assert_eq!(triangle().check(), Ok(()));
        assert_eq!(Mesh::default().check(), Ok(()));
    }

    #[test]
    fn each_contradiction_is_named() {
        let mut mesh = triangle();
        mesh.points[1][2] = f64::NAN;
        insta::assert_snapshot!(mesh.check().unwrap_err(), @"point 1: z is NaN, which is not a finite number");

        let mut mesh = triangle();
        mesh.points.pop();
        insta::assert_snapshot!(mesh.check().unwrap_err(), @"cell 0: corner 2 is point 2, but there are 2 points");

        let mut mesh = triangle();
        mesh.cell_markers = Some(vec![1, 2]);
        insta::assert_snapshot!(mesh.check().unwrap_err(), @"cell markers: 2 values for 1");

        let mut mesh = triangle();
        mesh.point_data.push(DataArray {
            name: "flow".into(),
            components: 2,
            values: vec![0.0; 3],
        });
        insta::assert_snapshot!(mesh.check().unwrap_err(), @"point data `flow`: 3 values for 6");
    }
}
