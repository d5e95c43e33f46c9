//! Points as plain text: one a line, coordinates (and perhaps a weight) between blanks or commas, `#` before comments.

use std::fmt::Arguments;
use std::io::Write;
use std::str::Split;

use crate::error::{ReadError, WriteError, WriteProblem};
use crate::format::Format;
use crate::lines::{Line, Lines};
use crate::mesh::{Axis, Mesh};
use crate::points::checked_weight;

/// The points of an `.xy` (`N = 2`) or `.xyz` file (`N = 3`), one for each line that is not blank.
///
/// # Errors
/// A line with another number of coordinates, and whatever is not a finite number. O(file).
pub fn parse<const N: usize>(bytes: &[u8]) -> Result<Vec<[f64; N]>, ReadError> {
    let mut lines = Lines::new(bytes)?;
    let mut points = Vec::new();
    while let Some(line) = lines.next() {
        let (mut row, index) = (Row::of(line), points.len());
        points.push(row.coordinates(index)?);
        row.end(format_args!("the {N} coordinates of point {index}"))?;
    }
    Ok(points)
}

/// As [`parse`], with a weight in a further column.
///
/// # Errors
/// As [`parse`], and a weight that is missing or not a finite number. O(file).
pub fn parse_weighted<const N: usize>(
    bytes: &[u8],
) -> Result<(Vec<[f64; N]>, Vec<f64>), ReadError> {
    let mut lines = Lines::new(bytes)?;
    let (mut points, mut weights) = (Vec::new(), Vec::new());
    while let Some(line) = lines.next() {
        let (mut row, index) = (Row::of(line), points.len());
        points.push(row.coordinates(index)?);
        let weight = row.number(format_args!("the weight of point {index}"))?;
        weights.push(checked_weight(index, weight).map_err(|problem| row.line.problem(problem))?);
        row.end(format_args!("the weight of point {index}"))?;
    }
    Ok((points, weights))
}

/// The numbers of one line, between blanks or between commas.
struct Row<'a> {
    line: Line<'a>,
    commas: Option<Split<'a, char>>,
}

impl<'a> Row<'a> {
    fn of(line: Line<'a>) -> Self {
        let commas = line.text.contains(',').then(|| line.text.split(','));
        Self { line, commas }
    }

    fn coordinates<const N: usize>(&mut self, index: usize) -> Result<[f64; N], ReadError> {
        let mut point = [0.0; N];
        for (coordinate, axis) in point.iter_mut().zip(Axis::ALL) {
            *coordinate = self.number(format_args!("coordinate {axis} of point {index}"))?;
        }
        self.line.finite("point", index, &point)?;
        Ok(point)
    }

    fn number(&mut self, expected: Arguments<'_>) -> Result<f64, ReadError> {
        let Some(fields) = &mut self.commas else {
            return self.line.number(expected);
        };
        let field = fields.next().unwrap_or_default().trim_ascii();
        let number = field.parse();
        number.map_err(|_| self.line.unexpected(expected, field))
    }

    /// Refuses a number that nothing asked for.
    fn end(&mut self, after: Arguments<'_>) -> Result<(), ReadError> {
        let Some(fields) = &mut self.commas else {
            return self.line.end(after);
        };
        let found = fields.next().map(str::trim_ascii);
        found.map_or(Ok(()), |field| {
            Err(self
                .line
                .unexpected(format_args!("nothing after {after}"), field))
        })
    }
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
    fn a_further_column_is_the_weight() {
        let text = b"0 1 0.5\n2,3,-4 # by commas\n";
        assert_eq!(
            parse_weighted::<2>(text).unwrap(),
            (vec![[0.0, 1.0], [2.0, 3.0]], vec![0.5, -4.0])
        );
        let error = |text: &str| parse_weighted::<2>(text.as_bytes()).unwrap_err();
        insta::assert_snapshot!(error("0 0 1\n0 0"), @"line 2: expected the weight of point 1, found the end of the line");
        insta::assert_snapshot!(error("0,0"), @"line 1: expected the weight of point 0, found ``");
        insta::assert_snapshot!(error("0 0 inf"), @"line 1: point 0: the weight is inf, which is not a finite number");
        insta::assert_snapshot!(error("0 0 1 2"), @"line 1: expected nothing after the weight of point 0, found `2`");
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
