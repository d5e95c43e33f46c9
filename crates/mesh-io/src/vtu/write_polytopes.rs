//! Writes polygons or polyhedra as a VTU.

use std::io::Write;

use super::array::{Array, Values, Width};
use super::write::{check_names, data, write_sections};
use crate::error::WriteError;
use crate::mesh::{MeshDefect, check_data, check_finite};
use crate::polytopes::Polytopes;

/// VTK's number of a polygon.
const POLYGON: u8 = 7;

/// VTK's number of a polyhedron.
const POLYHEDRON: u8 = 42;

/// Writes polygons or polyhedra with their data, for ParaView and its kin; [`parse`](super::parse) does not read them. O(corners),
/// copying nothing.
///
/// # Errors
/// A corner that is not finite, more corners than 32 bits can number, data of another length than the cells, a name with a control
/// character, and what the stream answers.
pub fn write_polytopes(out: &mut impl Write, cells: &Polytopes) -> Result<(), WriteError> {
    let (points, count) = (cells.points().len(), cells.len());
    if u32::try_from(points).is_err() {
        return Err(MeshDefect::TooManyPoints(points).into());
    }
    check_finite(cells.points())?;
    check_data("cell data", &cells.data, count)?;
    check_names(&cells.data)?;
    let sections = [
        ("PointData", Vec::new()),
        ("CellData", data(&cells.data, None)),
        (
            "Points",
            vec![array("Points", 3, Values::Points(cells.points()))],
        ),
        ("Cells", topology(cells)),
    ];
    write_sections(out, (points, count), sections)
}

fn topology(cells: &Polytopes) -> Vec<Array<'_>> {
    let (points, count) = (cells.points().len(), cells.len());
    let is_polyhedra = !cells.face_ends().is_empty();
    let width = Width::for_numbers_to(points.max(cells.faces().len()));
    let kind = if is_polyhedra { POLYHEDRON } else { POLYGON };
    let mut arrays = vec![
        array("connectivity", 1, Values::Counted(points, width)),
        array("offsets", 1, Values::Positions(cells.ends(), width)),
        array("types", 1, Values::Type(kind, count)),
    ];
    if is_polyhedra {
        let face_ends = Values::Positions(cells.face_ends(), width);
        arrays.push(array("faces", 1, Values::Indices(cells.faces(), width)));
        arrays.push(array("faceoffsets", 1, face_ends));
    }
    arrays
}

const fn array<'a>(name: &'a str, components: usize, values: Values<'a>) -> Array<'a> {
    Array {
        name,
        components,
        values,
    }
}
