//! `.node`: points.

use std::io::Write;

use super::rows::{Rows, attribute_count, check_number, has_markers, write_attributes};
use crate::error::{ReadError, ReadProblem, WriteError};
use crate::lines::{Line, Lines};
use crate::mesh::{DataArray, Mesh, MeshDefect};

/// The points of a `.node`, or of the first section of a `.poly`.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Nodes {
    /// Coordinates; `z = 0` in the plane.
    pub points: Vec<[f64; 3]>,
    /// Boundary markers, where the file has them.
    pub markers: Option<Vec<i32>>,
    /// Attributes, called `attribute 0` and so on.
    pub data: Vec<DataArray>,
    /// Coordinates per point in the file: 2, or 3 in a file of `TetGen`.
    pub dimension: usize,
    /// Number of the first point, 0 or 1: that from which other files count too.
    pub base: usize,
}

impl From<Nodes> for Mesh {
    fn from(nodes: Nodes) -> Self {
        Self {
            points: nodes.points,
            point_markers: nodes.markers,
            point_data: nodes.data,
            ..Self::default()
        }
    }
}

/// The points of a `.node`.
///
/// # Errors
/// Counts and numbers that do not hold, coordinates that are not finite; each with its line. O(file).
pub fn parse_node(bytes: &[u8]) -> Result<Nodes, ReadError> {
    let mut lines = Lines::new(bytes)?;
    let nodes = section(&mut lines)?;
    lines.end()?;
    Ok(nodes)
}

/// The points section: a header and a line for each point.
pub(crate) fn section(lines: &mut Lines<'_>) -> Result<Nodes, ReadError> {
    let mut header = lines.due(format_args!("the number of points"))?;
    let count = header.number(format_args!("the number of points"))?;
    let dimension = header.number(format_args!("the number of coordinates per point"))?;
    let attributes = header.number(format_args!("the number of attributes per point"))?;
    let mut rows = Rows::new(attributes, has_markers(&mut header, "point")?);
    header.end(format_args!("the counts of points"))?;
    if !(2..=3).contains(&dimension) {
        return Err(header.problem(ReadProblem::Unsupported(format!(
            "{dimension} coordinates per point"
        ))));
    }
    if u32::try_from(count).is_err() {
        return Err(header.problem(MeshDefect::TooManyPoints(count)));
    }
    let mut points = Vec::with_capacity(lines.room_for(count));
    let mut base = 1;
    for index in 0..count {
        let mut line = lines.due(format_args!("point {index} of {count}"))?;
        if index == 0 {
            base = first_number(&mut line)?;
        } else {
            check_number(&mut line, "point", index, base)?;
        }
        points.push(coordinates(&mut line, index, dimension)?);
        rows.read(&mut line, "point", index)?;
    }
    let (data, markers) = rows.finish();
    Ok(Nodes {
        points,
        markers,
        data,
        dimension,
        base,
    })
}

fn first_number(line: &mut Line<'_>) -> Result<usize, ReadError> {
    match line.word() {
        Some("0") => Ok(0),
        Some("1") => Ok(1),
        word => Err(line.unexpected(
            format_args!("0 or 1 as the number of the first point"),
            word.unwrap_or_default(),
        )),
    }
}

fn coordinates(line: &mut Line<'_>, index: usize, dimension: usize) -> Result<[f64; 3], ReadError> {
    if dimension == 3 {
        return line.coordinates("point", index);
    }
    let [x, y] = line.coordinates("point", index)?;
    Ok([x, y, 0.0])
}

/// Writes the points of a mesh, counted from 1: two coordinates each when every `z` is zero, else three. Data become attributes,
/// whose names the format does not keep.
///
/// # Errors
/// What [`Mesh::check`] answers.
pub fn write_node(out: &mut impl Write, mesh: &Mesh) -> Result<(), WriteError> {
    mesh.check()?;
    let flat = mesh.points.iter().all(|[_, _, z]| *z == 0.0);
    let (dimension, attributes) = (if flat { 2 } else { 3 }, attribute_count(&mesh.point_data));
    writeln!(
        out,
        "{} {dimension} {attributes} {}",
        mesh.points.len(),
        u8::from(mesh.point_markers.is_some())
    )?;
    for (index, [x, y, z]) in mesh.points.iter().enumerate() {
        write!(out, "{} {x:?} {y:?}", index + 1)?;
        if !flat {
            write!(out, " {z:?}")?;
        }
        write_attributes(out, &mesh.point_data, index)?;
        if let Some(marker) = mesh
            .point_markers
            .as_ref()
            .and_then(|markers| markers.get(index))
        {
            write!(out, " {marker}")?;
        }
        writeln!(out)?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn error(text: &str) -> String {
        parse_node(text.as_bytes()).unwrap_err().to_string()
    }

    #[test]
    fn attributes_and_markers_are_kept() {
        let nodes =
            parse_node(b"# two\n2 2 2 1\n0 1 2 0.5 inf 7 # first\n\n1 3 4 -1 0 -8\n").unwrap();
        assert_eq!((nodes.base, nodes.dimension), (0, 2));
        assert_eq!(nodes.points, [[1.0, 2.0, 0.0], [3.0, 4.0, 0.0]]);
        assert_eq!(nodes.markers, Some(vec![7, -8]));
        assert_eq!(
            nodes.data[1],
            DataArray::scalar("attribute 1", vec![f64::INFINITY, 0.0])
        );
    }

    #[test]
    fn errors_name_line_and_point() {
        insta::assert_snapshot!(error("1 4 0 0"), @"line 1: 4 coordinates per point is not supported");
        insta::assert_snapshot!(error("1 2 0 2"), @"line 1: expected 0 or 1 as the number of markers per point, found `2`");
        insta::assert_snapshot!(error("1 2 0 0\n2 0 0"), @"line 2: expected 0 or 1 as the number of the first point, found `2`");
        insta::assert_snapshot!(error("2 2 0 0\n1 0 0\n3 0 0"), @"line 3: expected 2 as the number of the point, found `3`");
        insta::assert_snapshot!(error("2 2 0 0\n1 0 0"), @"line 2: the file ends where point 1 of 2 should follow");
        insta::assert_snapshot!(error("1 2 0 0\n1 0 NaN"), @"line 2: point 0: y is NaN, which is not a finite number");
        insta::assert_snapshot!(error("1 2 9999999999 0\n1 0 0 5"), @"line 2: expected attribute 1 of point 0, found the end of the line");
        insta::assert_snapshot!(error("1 2 0 1\n1 0 0 1.5"), @"line 2: expected the marker of point 0, found `1.5`");
        insta::assert_snapshot!(error("1 2 0 0\n1 0 0 1"), @"line 2: expected nothing after point 0, found `1`");
        insta::assert_snapshot!(error("1 2 0 0\n1 0 0\n2 0 0"), @"line 3: expected the end of the file, found `2 0 0`");
    }

    #[test]
    fn attributes_that_no_point_has_cost_nothing() {
        assert_eq!(parse_node(b"0 2 9999999999 0").unwrap().data, []);
    }
}
