//! OBJ of Wavefront: vertices and faces as plain text.
//!
//! Read are the statements `v`, `f` and `l`. What says how faces look (textures, normals, groups, materials) and single points
//! (`p`) are passed over; what makes curved shapes is refused, as it would be missing.

use std::io::Write;

use crate::cell::{Cell, Cells};
use crate::error::{ReadError, ReadProblem, WriteError};
use crate::format::Format;
use crate::lines::{Line, Lines};
use crate::mesh::{Mesh, MeshDefect};
use crate::write_as::unsupported;

/// Statements that neither place a point nor make a face.
const PASSED_OVER: [&str; 17] = [
    "vt",
    "vn",
    "p",
    "g",
    "o",
    "s",
    "mg",
    "usemtl",
    "mtllib",
    "usemap",
    "maplib",
    "bevel",
    "lod",
    "c_interp",
    "d_interp",
    "shadow_obj",
    "trace_obj",
];

/// The points of an OBJ file, its faces of 3 or 4 corners, and its lines as segments, a line through n points as n - 1 of them.
///
/// A face or a line names points above it: from 1, or backwards from -1, the point just above it. What follows the three coordinates
/// of a point, a weight or a colour, is passed over.
///
/// # Errors
/// Faces of fewer than 3 or more than 4 corners, lines through fewer than 2 points, corners that do not exist, statements that are not known, numbers that are
/// none or not finite; each with its line. O(file).
pub fn parse(bytes: &[u8]) -> Result<Mesh, ReadError> {
    let mut lines = Lines::new(bytes)?;
    let mut points = Vec::new();
    let mut cells = Cells::new();
    let mut faces = 0;
    let mut polylines = 0;
    while let Some(mut line) = lines.next() {
        match line.word() {
            Some("v") => points.push(point(&mut line, points.len())?),
            Some("f") => {
                cells.push(face(&mut line, faces, points.len())?);
                faces += 1;
            }
            Some("l") => {
                polyline(&mut line, polylines, points.len(), &mut cells)?;
                polylines += 1;
            }
            Some(word) if PASSED_OVER.contains(&word) => {}
            word => {
                let expected = format_args!("a statement of OBJ with vertices or faces");
                return Err(line.unexpected(expected, word.unwrap_or_default()));
            }
        }
    }
    Ok(Mesh::new(points, cells))
}

fn point(line: &mut Line<'_>, index: usize) -> Result<[f64; 3], ReadError> {
    if u32::try_from(index).is_err() {
        return Err(line.problem(MeshDefect::TooManyPoints(index + 1)));
    }
    line.coordinates("point", index)
}

fn face(line: &mut Line<'_>, index: usize, points: usize) -> Result<Cell, ReadError> {
    const MOST_CORNERS: usize = 4;
    let mut corners = [0; MOST_CORNERS];
    let mut count = 0;
    while let Some(word) = line.word() {
        if let Some(corner) = corners.get_mut(count) {
            *corner = named_point(line, word, ("face", index, count), points)?;
        }
        count += 1;
    }
    let [a, b, c, d] = corners;
    match count {
        3 => Ok(Cell::Triangle([a, b, c])),
        4 => Ok(Cell::Quad([a, b, c, d])),
        _ => Err(line.problem(ReadProblem::Unsupported(format!(
            "face {index} with {count} corners"
        )))),
    }
}

/// Appends the segments of a line through two or more points.
fn polyline(
    line: &mut Line<'_>,
    index: usize,
    points: usize,
    cells: &mut Cells,
) -> Result<(), ReadError> {
    let mut last = None;
    let mut count = 0;
    while let Some(word) = line.word() {
        let point = named_point(line, word, ("line", index, count), points)?;
        if let Some(last) = last.replace(point) {
            cells.push(Cell::Segment([last, point]));
        }
        count += 1;
    }
    if count < 2 {
        let what = format!("line {index} through {count} points");
        return Err(line.problem(ReadProblem::Unsupported(what)));
    }
    Ok(())
}

/// The point that a corner such as `7`, `7/1`, `7//3` or `-1/2/3` names.
fn named_point(
    line: &Line<'_>,
    word: &str,
    (element, index, corner): (&'static str, usize, usize),
    points: usize,
) -> Result<u32, ReadError> {
    let name = word.split('/').next().unwrap_or_default();
    let Ok(found) = name.parse::<i64>() else {
        let expected = format_args!("corner {corner} of {element} {index}");
        return Err(line.unexpected(expected, word));
    };
    let there_are = i64::try_from(points).unwrap_or(i64::MAX);
    let named = match found {
        1.. => Some(found - 1),
        0 => None,
        _ => there_are.checked_add(found),
    };
    let named = named.filter(|named| (0..there_are).contains(named));
    let no_such = || {
        line.problem(ReadProblem::NoSuch {
            element,
            index,
            names: "point",
            found,
        })
    };
    named
        .and_then(|named| u32::try_from(named).ok())
        .ok_or_else(no_such)
}

/// Writes points, and triangles, quads and segments as faces and lines, so that reading gives the same bits. Markers and data are
/// left out. O(mesh).
///
/// # Errors
/// [`WriteProblem::Unsupported`](crate::WriteProblem::Unsupported) when there are other cells.
pub fn write(out: &mut impl Write, mesh: &Mesh) -> Result<(), WriteError> {
    mesh.check()?;
    for [x, y, z] in &mesh.points {
        writeln!(out, "v {x:?} {y:?} {z:?}")?;
    }
    for (index, cell) in mesh.cells.iter().enumerate() {
        let statement: &[u8] = match cell {
            Cell::Segment(_) => b"l",
            Cell::Triangle(_) | Cell::Quad(_) => b"f",
            _ => {
                let what = format!("cell {index}, a {}", cell.kind().name());
                return Err(unsupported(Format::Obj, &what));
            }
        };
        out.write_all(statement)?;
        for &corner in cell.corners() {
            write!(out, " {}", u64::from(corner) + 1)?;
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

    const POINTS: &str = "v 0 0 0\nv 1 0 0 1.0\nv 0 1 0 0.5 0.5 0.5\nv 0 0 1\n";

    #[test]
    fn corners_are_named_forwards_backwards_and_with_texture_and_normal() {
        let faces = "mtllib a.mtl\nvt 0 nan\nf 1 2 3 # three\nf -4//7 2/5 3/6/7 -1/\nl 1 2/7 -1\n";
        let mesh = parse((POINTS.to_owned() + faces).as_bytes()).unwrap();
        let wanted = [
            Cell::Triangle([0, 1, 2]),
            Cell::Quad([0, 1, 2, 3]),
            Cell::Segment([0, 1]),
            Cell::Segment([1, 3]),
        ];
        assert!(mesh.cells.iter().eq(wanted));
        assert_eq!(mesh.points[2], [0.0, 1.0, 0.0]);
        assert_eq!(parse(b"").unwrap(), Mesh::default());
    }

    #[test]
    fn errors_name_line_and_element() {
        let face = |face: &str| error(&format!("{POINTS}\n{face}"));
        insta::assert_snapshot!(face("f 1 2 5"), @"line 6: face 0: there is no point 5");
        insta::assert_snapshot!(face("f 1 2 0"), @"line 6: face 0: there is no point 0");
        insta::assert_snapshot!(face("f 1 2 -5"), @"line 6: face 0: there is no point -5");
        insta::assert_snapshot!(face("f 1 2 -9223372036854775808"), @"line 6: face 0: there is no point -9223372036854775808");
        insta::assert_snapshot!(face("f 1 2 9223372036854775808"), @"line 6: expected corner 2 of face 0, found `9223372036854775808`");
        insta::assert_snapshot!(face("f 1 2 /3"), @"line 6: expected corner 2 of face 0, found `/3`");
        insta::assert_snapshot!(face("f 1 2"), @"line 6: face 0 with 2 corners is not supported");
        insta::assert_snapshot!(face("f 1 2 3 4 1"), @"line 6: face 0 with 5 corners is not supported");
        insta::assert_snapshot!(face("l 1"), @"line 6: line 0 through 1 points is not supported");
        insta::assert_snapshot!(face("l 1 2 9"), @"line 6: line 0: there is no point 9");
        insta::assert_snapshot!(face("surf 0 1 0 1 1 2"), @"line 6: expected a statement of OBJ with vertices or faces, found `surf`");
        insta::assert_snapshot!(error("v 0 0"), @"line 1: expected coordinate z of point 0, found the end of the line");
        insta::assert_snapshot!(error("v 0 nan 0"), @"line 1: point 0: y is NaN, which is not a finite number");
        insta::assert_snapshot!(error("f 1 2 3\nv 0 0 0"), @"line 1: face 0: there is no point 1");
    }

    #[test]
    fn what_is_no_face_and_no_line_is_not_written() {
        let cells = Cells::from_iter([Cell::Segment([0; 2]), Cell::Vertex([0])]);
        let written = write(&mut Vec::new(), &Mesh::new(vec![[0.0; 3]], cells));
        insta::assert_snapshot!(written.unwrap_err(), @"OBJ cannot hold cell 1, a vertex");
    }
}
