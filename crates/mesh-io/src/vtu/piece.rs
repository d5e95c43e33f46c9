//! A piece of a VTU: named arrays, and the points and cells they make.

use super::number::Numbers;
use super::{MARKER, turn_wedge, vtk_type};
use crate::cell::{Cell, CellKind};
use crate::error::ReadProblem;
use crate::lines::quoted;
use crate::mesh::{DataArray, Mesh};

/// The element an array belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Section {
    PointData,
    CellData,
    Points,
    Cells,
}

pub(crate) struct Array {
    pub(crate) section: Section,
    pub(crate) name: String,
    pub(crate) components: usize,
    pub(crate) numbers: Numbers,
}

pub(crate) struct Piece {
    pub(crate) line: usize,
    pub(crate) points: usize,
    pub(crate) cells: usize,
    pub(crate) arrays: Vec<Array>,
}

impl Piece {
    /// Adds points, cells, markers and data behind those of the pieces before.
    pub(crate) fn append_to(mut self, mesh: &mut Mesh) -> Result<(), ReadProblem> {
        let first_point = mesh.points.len();
        let first_cell = mesh.cells.len();
        self.append_points(mesh)?;
        self.append_cells(mesh, first_point)?;
        let mut of_points = Joining {
            elements: self.points,
            before: first_point,
            next: 0,
            markers: &mut mesh.point_markers,
            fields: &mut mesh.point_data,
        };
        let mut of_cells = Joining {
            elements: self.cells,
            before: first_cell,
            next: 0,
            markers: &mut mesh.cell_markers,
            fields: &mut mesh.cell_data,
        };
        for array in self.arrays {
            match array.section {
                Section::PointData => of_points.append(array)?,
                Section::CellData => of_cells.append(array)?,
                Section::Points | Section::Cells => {}
            }
        }
        Ok(())
    }

    fn take(&mut self, section: Section, name: Option<&str>) -> Option<Numbers> {
        let fits =
            |array: &Array| array.section == section && name.is_none_or(|name| array.name == name);
        let index = self.arrays.iter().position(fits)?;
        Some(self.arrays.remove(index).numbers)
    }

    fn append_points(&mut self, mesh: &mut Mesh) -> Result<(), ReadProblem> {
        let coordinates = self
            .take(Section::Points, None)
            .map(Numbers::into_reals)
            .unwrap_or_default();
        if coordinates.len() != self.points.saturating_mul(3) {
            let expected = self.points.saturating_mul(3);
            return Err(count_differs("coordinates", expected, coordinates.len()));
        }
        mesh.points.extend(
            coordinates
                .chunks_exact(3)
                .map(|point| [point[0], point[1], point[2]]),
        );
        Ok(())
    }

    fn append_cells(&mut self, mesh: &mut Mesh, first_point: usize) -> Result<(), ReadProblem> {
        let corners = self.integers("connectivity")?;
        let ends = self.integers("offsets")?;
        let types = self.integers("types")?;
        for (name, list) in [("offsets", &ends), ("types", &types)] {
            if list.len() != self.cells {
                return Err(count_differs(name, self.cells, list.len()));
            }
        }
        let mut start = 0_usize;
        let mut cell_corners = Vec::new();
        for (index, (&end, &vtk)) in ends.iter().zip(&types).enumerate() {
            let end = usize::try_from(end)
                .ok()
                .filter(|&end| end >= start && end <= corners.len());
            let Some(end) = end else {
                return Err(unexpected(
                    &format!("an ascending offset for cell {index}"),
                    &ends[index].to_string(),
                ));
            };
            cell_corners.clear();
            for &corner in &corners[start..end] {
                cell_corners.push(self.corner(index, corner, first_point)?);
            }
            push_cell(mesh, index, vtk, &mut cell_corners)?;
            start = end;
        }
        Ok(())
    }

    fn corner(&self, index: usize, corner: i64, first_point: usize) -> Result<u32, ReadProblem> {
        let within = usize::try_from(corner)
            .ok()
            .filter(|&corner| corner < self.points);
        within
            .and_then(|corner| u32::try_from(corner + first_point).ok())
            .ok_or(ReadProblem::NoSuch {
                element: "cell",
                index,
                names: "point",
                found: corner,
            })
    }

    fn integers(&mut self, name: &str) -> Result<Vec<i64>, ReadProblem> {
        match self.take(Section::Cells, Some(name)) {
            Some(Numbers::Integers(values)) => Ok(values),
            Some(Numbers::Reals(values)) if values.is_empty() => Ok(Vec::new()),
            Some(Numbers::Reals(_)) => Err(unexpected(
                &format!("integers as {name}"),
                "floating-point numbers",
            )),
            None if self.cells == 0 => Ok(Vec::new()),
            None => Err(ReadProblem::Truncated {
                expected: format!("the array `{name}`"),
            }),
        }
    }
}

fn push_cell(
    mesh: &mut Mesh,
    index: usize,
    vtk: i64,
    corners: &mut [u32],
) -> Result<(), ReadProblem> {
    let kind = match (vtk, corners.len()) {
        // Pixels and voxels count row by row instead of round the cell.
        (8, 4) => {
            corners.swap(2, 3);
            Some(CellKind::Quad)
        }
        (11, 8) => {
            corners.swap(2, 3);
            corners.swap(6, 7);
            Some(CellKind::Hexahedron)
        }
        (13, 6) => {
            turn_wedge(corners);
            Some(CellKind::Wedge)
        }
        // Polygons.
        (7, 3) => Some(CellKind::Triangle),
        (7, 4) => Some(CellKind::Quad),
        _ => CellKind::ALL
            .into_iter()
            .find(|&kind| i64::from(vtk_type(kind)) == vtk),
    };
    let Some(kind) = kind else {
        let what = format!(
            "cell {index} of VTK type {vtk} with {} corners",
            corners.len()
        );
        return Err(ReadProblem::Unsupported(what));
    };
    let Some(cell) = Cell::new(kind, corners) else {
        let what = format!("corners of cell {index}, a {}", kind.name());
        return Err(count_differs(&what, kind.corner_count(), corners.len()));
    };
    mesh.cells.push(cell);
    Ok(())
}

fn count_differs(what: &str, claimed: usize, found: usize) -> ReadProblem {
    ReadProblem::Count {
        what: what.into(),
        claimed: claimed as u64,
        found: found as u64,
    }
}

/// Data of one piece on their way behind those of the pieces before, which must be the same arrays in the same order.
struct Joining<'a> {
    /// Points or cells of this piece.
    elements: usize,
    /// Points or cells of the pieces before.
    before: usize,
    /// Which of `fields` comes next.
    next: usize,
    markers: &'a mut Option<Vec<i32>>,
    fields: &'a mut Vec<DataArray>,
}

impl Joining<'_> {
    fn append(&mut self, array: Array) -> Result<(), ReadProblem> {
        let found = array.numbers.len();
        let expected = self.elements.saturating_mul(array.components);
        if found != expected {
            let what = format!("values of {}", quoted(&array.name));
            return Err(count_differs(&what, expected, found));
        }
        match self.as_markers(&array) {
            Some(values) => self.markers.get_or_insert_default().extend(values),
            None => self.append_field(array)?,
        }
        Ok(())
    }

    /// The numbers of an array that holds markers.
    fn as_markers(&self, array: &Array) -> Option<Vec<i32>> {
        let Numbers::Integers(values) = &array.numbers else {
            return None;
        };
        let known = self.markers.as_ref().map_or(0, Vec::len);
        if array.name != MARKER || array.components != 1 || known != self.before {
            return None;
        }
        let values = values.iter().map(|&value| i32::try_from(value).ok());
        values.collect()
    }

    fn append_field(&mut self, array: Array) -> Result<(), ReadProblem> {
        let Array {
            name,
            components,
            numbers,
            ..
        } = array;
        let values = numbers.into_reals();
        match self.fields.get_mut(self.next) {
            Some(field) if field.name == name && field.components == components => {
                field.values.extend(values);
            }
            None if self.before == 0 => self.fields.push(DataArray {
                name,
                components,
                values,
            }),
            _ => return Err(unexpected("the data arrays of the piece before", &name)),
        }
        self.next += 1;
        Ok(())
    }
}

pub(crate) fn unexpected(expected: &str, found: &str) -> ReadProblem {
    ReadProblem::Expected {
        expected: expected.into(),
        found: quoted(found),
    }
}
