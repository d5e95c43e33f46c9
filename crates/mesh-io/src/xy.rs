//! Points as plain text: one a line, coordinates between blanks or commas, `#` before comments.

use std::io::Write;

use crate::error::{ReadError, WriteError, WriteProblem};
use crate::format::Format;
use crate::lines::{Line, Lines};
use crate::mesh::{Axis, Mesh};

/// The points of an `.xy` (`N = 2`) or `.xyz` file (`N = 3`), one for each line that is not blank.
///
/// # Errors
/// A line with another number of coordinates, and whatever is not a finite number. O(file).
pub fn parse<const N: usize>(bytes: &[u8]) -> Result<Vec<[f64; N]>, ReadError> {
    let mut lines = Lines::new(bytes)?;
    let mut points = Vec::new();
    while let Some(line) = lines.next() {
        points.push(point(line, points.len())?);
    }
    Ok(points)
}

fn point<const N: usize>(mut line: Line<'_>, index: usize) -> Result<[f64; N], ReadError> {
    if !line.text.contains(',') {
        let point = line.coordinates("point", index)?;
        line.end(format_args!("the {N} coordinates of point {index}"))?;
        return Ok(point);
    }
    let mut point = [0.0; N];
    let mut fields = line.text.split(',').map(str::trim);
    for (coordinate, axis) in point.iter_mut().zip(Axis::ALL) {
        let field = fields.next().unwrap_or_default();
        let expected = format_args!("coordinate {axis} of point {index}");
        *coordinate = field
            .parse()
            .map_err(|_| line.unexpected(expected, field))?;
    }
    if let Some(field) = fields.next() {
        return Err(line.unexpected(
            format_args!("nothing after the {N} coordinates of point {index}"),
            field,
        ));
    }
    line.finite("point", index, &point)?;
    Ok(point)
}

/// Writes the points of a mesh without cells, so that reading gives the same bits. Markers and data are left out.
///
/// # Errors
/// [`WriteProblem::Unsupported`] when there are cells, or in `.xy` when a point has `z != 0`.
pub fn write(out: &mut impl Write, format: Format, mesh: &Mesh) -> Result<(), WriteError> {
    mesh.check()?;
    if !mesh.cells.is_empty() {
        let what = format!("the {} cells of the mesh", mesh.cells.len());
        return Err(WriteProblem::Unsupported { format, what }.into());
    }
    for (index, &[x, y, z]) in mesh.points.iter().enumerate() {
        match format {
            Format::Xyz => writeln!(out, "{x:?} {y:?} {z:?}")?,
            _ if z == 0.0 => writeln!(out, "{x:?} {y:?}")?,
            _ => {
                return Err(WriteProblem::Unsupported {
                    format,
                    what: format!("z = {z} of point {index}"),
                }
                .into());
            }
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn error(text: &str) -> String {
        parse::<2>(text.as_bytes()).unwrap_err().to_string()
    }

    #[test]
    fn blanks_commas_and_comments_are_understood() {
        let text = "\u{feff}# two points\n\n 1 2.5e0 # the first\r\n-3 ,\t4\n";
        assert_eq!(
            parse::<2>(text.as_bytes()).unwrap(),
            [[1.0, 2.5], [-3.0, 4.0]]
        );
        assert!(parse::<3>(b"# nothing").unwrap().is_empty());
    }

    #[test]
    fn errors_name_line_point_and_coordinate() {
        insta::assert_snapshot!(error("0 0\n1"), @"line 2: expected coordinate y of point 1, found the end of the line");
        insta::assert_snapshot!(error("0 0\n\n1 2 3"), @"line 3: expected nothing after the 2 coordinates of point 1, found `3`");
        insta::assert_snapshot!(error("1,2,3"), @"line 1: expected nothing after the 2 coordinates of point 0, found `3`");
        insta::assert_snapshot!(error("1,,3"), @"line 1: expected coordinate y of point 0, found ``");
        insta::assert_snapshot!(error("x y"), @"line 1: expected coordinate x of point 0, found `x`");
        insta::assert_snapshot!(error("0 nan"), @"line 1: point 0: y is NaN, which is not a finite number");
        insta::assert_snapshot!(error("1e999,0"), @"line 1: point 0: x is inf, which is not a finite number");
        insta::assert_snapshot!(parse::<2>(b"0 0\n1 \xff").unwrap_err(), @"byte 6: not text in UTF-8");
    }

    #[test]
    fn what_has_no_place_in_the_file_is_refused() {
        let mut out = Vec::new();
        let mesh = Mesh {
            points: vec![[0.0, 0.0, 1.0]],
            ..Mesh::default()
        };
        insta::assert_snapshot!(write(&mut out, Format::Xy, &mesh).unwrap_err(), @"xy text cannot hold z = 1 of point 0");
        assert!(write(&mut out, Format::Xyz, &mesh).is_ok());
    }
}
