//! OBJ of Wavefront: vertices and faces as plain text.
//!
//! Read are the statements `v` and `f`. What says how faces look (textures, normals, groups, materials) and points and
//! lines (`p`, `l`) are passed over; what makes curved shapes is refused, as it would be missing.

use crate::cell::{Cell, Cells};
use crate::error::{ReadError, ReadProblem};
use crate::lines::{Line, Lines};
use crate::mesh::{Mesh, MeshDefect};

/// Statements that neither place a point nor make a face.
const PASSED_OVER: [&str; 18] = [
    "vt",
    "vn",
    "p",
    "l",
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

/// The points of an OBJ file, and its faces of 3 or 4 corners.
///
/// A face names points above it: from 1, or backwards from -1, the point just above it. What follows the three coordinates
/// of a point, a weight or a colour, is passed over.
///
/// # Errors
/// Faces of fewer than 3 or more than 4 corners, corners that do not exist, statements that are not known, numbers that are
/// none or not finite; each with its line. O(file).
pub fn parse(bytes: &[u8]) -> Result<Mesh, ReadError> {
    let mut lines = Lines::new(bytes)?;
    let mut points = Vec::new();
    let mut cells = Cells::new();
    while let Some(mut line) = lines.next() {
        match line.word() {
            Some("v") => points.push(point(&mut line, points.len())?),
            Some("f") => cells.push(face(&mut line, cells.len(), points.len())?),
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
            *corner = named_point(line, word, (index, count), points)?;
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

/// The point that a corner such as `7`, `7/1`, `7//3` or `-1/2/3` names.
fn named_point(
    line: &Line<'_>,
    word: &str,
    (face, corner): (usize, usize),
    points: usize,
) -> Result<u32, ReadError> {
    let name = word.split('/').next().unwrap_or_default();
    let Ok(found) = name.parse::<i64>() else {
        let expected = format_args!("corner {corner} of face {face}");
        return Err(line.unexpected(expected, word));
    };
    let there_are = i64::try_from(points).unwrap_or(i64::MAX);
    let index = match found {
        1.. => Some(found - 1),
        0 => None,
        _ => there_are.checked_add(found),
    };
    let index = index.filter(|index| (0..there_are).contains(index));
    let no_such = || {
        line.problem(ReadProblem::NoSuch {
            element: "face",
            index: face,
            names: "point",
            found,
        })
    };
    index
        .and_then(|index| u32::try_from(index).ok())
        .ok_or_else(no_such)
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
        let faces = "mtllib a.mtl\nvt 0 nan\nf 1 2 3 # three\nf -4//7 2/5 3/6/7 -1/\nl 1 2\n";
        let mesh = parse((POINTS.to_owned() + faces).as_bytes()).unwrap();
        let wanted = [Cell::Triangle([0, 1, 2]), Cell::Quad([0, 1, 2, 3])];
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
        insta::assert_snapshot!(face("surf 0 1 0 1 1 2"), @"line 6: expected a statement of OBJ with vertices or faces, found `surf`");
        insta::assert_snapshot!(error("v 0 0"), @"line 1: expected coordinate z of point 0, found the end of the line");
        insta::assert_snapshot!(error("v 0 nan 0"), @"line 1: point 0: y is NaN, which is not a finite number");
        insta::assert_snapshot!(error("f 1 2 3\nv 0 0 0"), @"line 1: face 0: there is no point 1");
    }
}
