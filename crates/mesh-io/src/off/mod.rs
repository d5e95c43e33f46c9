//! OFF: points and polygons as plain text.
//!
//! Colours, normals and texture coordinates of points (COFF, NOFF, STOFF) and colours of faces are passed over; points of other than
//! three coordinates (4OFF, nOFF) and binary files are refused.

mod header;

use std::io::Write;

use header::Header;

use crate::cell::{Cell, Cells};
use crate::error::{ReadError, ReadProblem, WriteError, WriteProblem};
use crate::format::Format;
use crate::lines::{Line, Lines};
use crate::mesh::Mesh;
use crate::outline::Outline;
use crate::planar_graph::PlanarGraph;
use crate::points::Coordinates;

/// The mesh of an OFF file: points, and faces of 1 to 4 corners. Colours after the corners of a face are passed over.
///
/// # Errors
/// Counts that do not hold, corners that do not exist, faces of more than 4 corners, numbers that are none or not finite; each with
/// its line. O(file).
pub fn parse(bytes: &[u8]) -> Result<Mesh, ReadError> {
    let (header, mut lines) = Header::read(bytes)?;
    let points = points(&mut lines, &header)?;
    let face_count = header.faces;
    let mut cells = Cells::new();
    for index in 0..face_count {
        let line = lines.due(format_args!("face {index} of {face_count}"))?;
        cells.push(face(line, index, points.len())?);
    }
    lines.end()?;
    Ok(Mesh::new(points, cells))
}

/// The outline of the faces of an OFF file at z = 0, which may have any number of corners: the edges that an odd number of faces
/// has, which is closed whatever the faces are. Faces of two corners are segments and stay.
///
/// Points at exactly one place are one; those without a segment are left out.
///
/// # Errors
/// Counts that do not hold, corners that do not exist, numbers that are none or not finite, each with its line; the first point
/// that is not at z = 0. O(file).
pub fn parse_outline(bytes: &[u8]) -> Result<PlanarGraph, ReadError> {
    let (header, mut lines) = Header::read(bytes)?;
    let points = points(&mut lines, &header)?;
    let face_count = header.faces;
    let places = Coordinates::Space(points).into_plane();
    let places = places.map_err(ReadProblem::from)?;
    let mut outline = Outline::default();
    let numbers: Vec<u32> = places
        .into_iter()
        .map(|place| outline.point(place))
        .collect::<Result<_, _>>()?;
    for index in 0..face_count {
        let line = lines.due(format_args!("face {index} of {face_count}"))?;
        let corners = polygon(line, index, numbers.len())?;
        let corners: Vec<u32> = corners.into_iter().map(|v| numbers[v as usize]).collect();
        match corners.as_slice() {
            &[a, b] => outline.segment([a, b], None),
            corners => outline.face(corners),
        }
    }
    lines.end()?;
    Ok(outline.into_graph())
}

fn points(lines: &mut Lines<'_>, header: &Header) -> Result<Vec<[f64; 3]>, ReadError> {
    let count = header.points;
    let mut points = Vec::with_capacity(lines.room_for(count));
    for index in 0..count {
        let mut line = lines.due(format_args!("point {index} of {count}"))?;
        points.push(line.coordinates("point", index)?);
        if !header.has_attributes {
            line.end(format_args!("the coordinates of point {index}"))?;
        }
    }
    Ok(points)
}

fn face(mut line: Line<'_>, index: usize, point_count: usize) -> Result<Cell, ReadError> {
    const MOST_CORNERS: usize = 4;
    let count: usize = line.number(format_args!("the number of corners of face {index}"))?;
    let mut corners = [0; MOST_CORNERS];
    for (number, corner) in corners.iter_mut().take(count).enumerate() {
        *corner = point_of(&mut line, number, index, point_count)?;
    }
    let [a, b, c, d] = corners;
    match count {
        1 => Ok(Cell::Vertex([a])),
        2 => Ok(Cell::Segment([a, b])),
        3 => Ok(Cell::Triangle([a, b, c])),
        4 => Ok(Cell::Quad([a, b, c, d])),
        _ => Err(line.problem(ReadProblem::Unsupported(format!(
            "face {index} with {count} corners"
        )))),
    }
}

/// The corners of a face, however many.
fn polygon(mut line: Line<'_>, index: usize, point_count: usize) -> Result<Vec<u32>, ReadError> {
    let count: usize = line.number(format_args!("the number of corners of face {index}"))?;
    let corners = 0..count;
    corners
        .map(|corner| point_of(&mut line, corner, index, point_count))
        .collect()
}

/// The point at a corner of a face.
fn point_of(
    line: &mut Line<'_>,
    corner: usize,
    face: usize,
    point_count: usize,
) -> Result<u32, ReadError> {
    let named: i64 = line.number(format_args!("corner {corner} of face {face}"))?;
    let point = u32::try_from(named).ok();
    point
        .filter(|&point| (point as usize) < point_count)
        .ok_or_else(|| {
            line.problem(ReadProblem::NoSuch {
                element: "face",
                index: face,
                names: "point",
                found: named,
            })
        })
}

/// Writes points and faces, so that reading gives the same bits. Markers and data are left out.
///
/// # Errors
/// [`WriteProblem::Unsupported`] when there are cells with a volume.
pub fn write(out: &mut impl Write, mesh: &Mesh) -> Result<(), WriteError> {
    mesh.check()?;
    for (index, kind) in mesh.cells.kinds().iter().enumerate() {
        if kind.dimension() > 2 {
            let what = format!("cell {index}, a {}", kind.name());
            return Err(WriteProblem::Unsupported {
                format: Format::Off,
                what,
            }
            .into());
        }
    }
    writeln!(out, "OFF\n{} {} 0", mesh.points.len(), mesh.cells.len())?;
    for [x, y, z] in &mesh.points {
        writeln!(out, "{x:?} {y:?} {z:?}")?;
    }
    for cell in mesh.cells.iter() {
        write!(out, "{}", cell.corners().len())?;
        for corner in cell.corners() {
            write!(out, " {corner}")?;
        }
        writeln!(out)?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn error(text: &str) -> String {
        parse(text.as_bytes()).unwrap_err().to_string()
    }

    #[test]
    fn counts_may_follow_the_word_and_colours_are_passed_over() {
        let mesh =
            parse(b"OFF 3 1 3 # a triangle\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 255 0 0\n").unwrap();
        assert_eq!(mesh.cells.iter().next(), Some(Cell::Triangle([0, 1, 2])));
        assert_eq!(mesh.points[1], [1.0, 0.0, 0.0]);
    }

    #[test]
    fn errors_name_line_and_element() {
        insta::assert_snapshot!(error(""), @"line 1: the file ends where the word OFF should follow");
        insta::assert_snapshot!(error("COFF\n"), @"line 1: the file ends where the numbers of points, faces and edges should follow");
        insta::assert_snapshot!(error("OFF\n2 -1 0"), @"line 2: expected the number of faces, found `-1`");
        insta::assert_snapshot!(error("OFF\n5000000000 0 0"), @"line 2: 5000000000 points are more than 32-bit indices can name");
        insta::assert_snapshot!(error("OFF\n4000000000 0 0\n0 0 0\n"), @"line 3: the file ends where point 1 of 4000000000 should follow");
        insta::assert_snapshot!(error("OFF\n1 1 0\n0 0 0\n2 0 1"), @"line 4: face 0: there is no point 1");
        insta::assert_snapshot!(error("OFF\n1 1 0\n0 0 0\n2 0 -1"), @"line 4: face 0: there is no point -1");
        insta::assert_snapshot!(error("OFF\n1 1 0\n0 0 0\n5 0 0 0 0 0"), @"line 4: face 0 with 5 corners is not supported");
        insta::assert_snapshot!(error("OFF\n1 0 0\n0 -inf 0"), @"line 3: point 0: y is -inf, which is not a finite number");
        insta::assert_snapshot!(error("OFF\n0 0 0\n0 0 0"), @"line 3: expected the end of the file, found `0 0 0`");
    }

    #[test]
    fn the_outline_of_polygons_is_what_an_odd_number_of_them_has() {
        // A pentagon and a triangle with a common side, a loose segment, a point of no face.
        let text = "OFF\n8 3 0\n0 0 0\n2 0 0\n3 1 0\n2 2 0\n0 2 0\n4 2 0\n1 1 0\n9 9 0\n\
            5 0 1 2 3 4\n3 2 5 3\n2 6 0 255 0 0\n";
        let graph = parse_outline(text.as_bytes()).unwrap();
        assert_eq!(graph.points.len(), 7);
        let mut segments: Vec<[u32; 2]> = graph
            .segments
            .iter()
            .map(|&[a, b]| [a.min(b), a.max(b)])
            .collect();
        segments.sort_unstable();
        assert_eq!(
            segments,
            [[0, 1], [0, 4], [0, 6], [1, 2], [2, 5], [3, 4], [3, 5]]
        );
        let error = |text: &str| parse_outline(text.as_bytes()).unwrap_err();
        insta::assert_snapshot!(error("OFF\n1 1 0\n0 0 0\n9 0 0"), @"line 4: expected corner 2 of face 0, found the end of the line");
        insta::assert_snapshot!(error("OFF\n1 1 0\n0 0 0\n3 0 0 7"), @"line 4: face 0: there is no point 7");
        insta::assert_snapshot!(error("OFF\n1 0 0\n0 0 2\n"), @"point 0 lies at z = 2, points of the plane are needed");
    }

    #[test]
    fn volumes_are_refused() {
        let cells = Cells::from_iter([Cell::Tetrahedron([0; 4])]);
        let written = write(&mut Vec::new(), &Mesh::new(vec![[0.0; 3]], cells));
        insta::assert_snapshot!(written.unwrap_err(), @"OFF cannot hold cell 0, a tetrahedron");
    }
}
