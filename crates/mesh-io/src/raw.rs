//! Points as raw little-endian doubles, one point after the other: `NAME.2d.f64` and `NAME.3d.f64`.
//!
//! The file says nothing of itself; the dimension comes from its name or from the caller.

use std::io::Write;
use std::path::Path;

use crate::error::{ReadError, ReadProblem, WriteError};
use crate::mesh::first_not_finite;
use crate::points::{Coordinates, Dimension, Points, checked_weight};

/// Bytes of a double.
const WIDTH: usize = size_of::<f64>();

/// The dimension that the name of a file tells: that of `cloud.3d.f64` is [`Dimension::Space`].
#[must_use]
pub fn dimension_of(path: &Path) -> Option<Dimension> {
    let stem = path.file_stem().map(Path::new)?;
    let inner = stem.extension()?.to_str()?;
    match inner.to_ascii_lowercase().as_str() {
        "2d" => Some(Dimension::Plane),
        "3d" => Some(Dimension::Space),
        _ => None,
    }
}

/// The points of a file, with a weight behind the coordinates of each if `weighted`.
///
/// # Errors
/// [`ReadProblem::PartOfPoint`] when the bytes are no whole number of points, and whatever is not a finite number, with the byte
/// where it starts. O(file).
pub fn parse(bytes: &[u8], dimension: Dimension, weighted: bool) -> Result<Points, ReadError> {
    match (dimension, weighted) {
        (Dimension::Plane, false) => {
            let points = rows(bytes)?;
            check(&points)?;
            Ok(unweighted(Coordinates::Plane(points)))
        }
        (Dimension::Space, false) => {
            let points = rows(bytes)?;
            check(&points)?;
            Ok(unweighted(Coordinates::Space(points)))
        }
        (Dimension::Plane, true) => {
            let rows: Vec<[f64; 3]> = rows(bytes)?;
            let points = rows.iter().map(|&[x, y, _]| [x, y]).collect();
            weighted_by(Coordinates::Plane(points), &rows)
        }
        (Dimension::Space, true) => {
            let rows: Vec<[f64; 4]> = rows(bytes)?;
            let points = rows.iter().map(|&[x, y, z, _]| [x, y, z]).collect();
            weighted_by(Coordinates::Space(points), &rows)
        }
    }
}

/// Rows of `N` doubles each.
fn rows<const N: usize>(bytes: &[u8]) -> Result<Vec<[f64; N]>, ReadError> {
    let (words, rest) = bytes.as_chunks::<WIDTH>();
    let (rows, more) = words.as_chunks::<N>();
    if !(rest.is_empty() && more.is_empty()) {
        return Err(ReadProblem::PartOfPoint {
            bytes: bytes.len(),
            each: N * WIDTH,
        }
        .into());
    }
    Ok(rows.iter().map(|row| row.map(f64::from_le_bytes)).collect())
}

fn unweighted(coordinates: Coordinates) -> Points {
    Points {
        coordinates,
        weights: None,
    }
}

/// The points, and the last number of each row as its weight.
fn weighted_by<const N: usize>(
    coordinates: Coordinates,
    rows: &[[f64; N]],
) -> Result<Points, ReadError> {
    let mut weights = Vec::with_capacity(rows.len());
    for (index, row) in rows.iter().enumerate() {
        let (&weight, point) = row.split_last().unwrap_or((&0.0, &[]));
        check_point(index, point, N)?;
        let at = (index * N + N - 1) * WIDTH;
        weights.push(checked_weight(index, weight).map_err(|what| ReadError::at_byte(at, what))?);
    }
    Ok(Points {
        coordinates,
        weights: Some(weights),
    })
}

fn check<const N: usize>(points: &[[f64; N]]) -> Result<(), ReadError> {
    let mut indexed = points.iter().enumerate();
    indexed.try_for_each(|(index, point)| check_point(index, point, N))
}

/// Refuses coordinates that are infinite or NaN, at the byte where they start.
fn check_point(index: usize, point: &[f64], row_length: usize) -> Result<(), ReadError> {
    let Some((axis, value)) = first_not_finite(point) else {
        return Ok(());
    };
    let problem = ReadProblem::NotFinite {
        element: "point",
        index,
        axis,
        value,
    };
    let at = (index * row_length + axis as usize) * WIDTH;
    Err(ReadError::at_byte(at, problem))
}

/// Writes points, and the weight of each behind its coordinates where there are weights, so that reading gives the same bits.
///
/// # Errors
/// What the stream answers.
pub fn write(out: &mut impl Write, points: &Points) -> Result<(), WriteError> {
    let mut weights = points.weights.iter().flatten();
    let mut row = |point: &[f64]| {
        let numbers = point.iter().chain(weights.next());
        numbers
            .map(|number| number.to_le_bytes())
            .try_for_each(|bytes| out.write_all(&bytes))
    };
    match &points.coordinates {
        Coordinates::Plane(points) => points.iter().try_for_each(|point| row(point))?,
        Coordinates::Space(points) => points.iter().try_for_each(|point| row(point))?,
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn bytes(numbers: &[f64]) -> Vec<u8> {
        numbers.iter().copied().flat_map(f64::to_le_bytes).collect()
    }

    #[test]
    fn a_name_tells_the_dimension() {
        let dimension = |name: &str| dimension_of(Path::new(name));
        assert_eq!(dimension("a/b.2d.f64"), Some(Dimension::Plane));
        assert_eq!(dimension("b.c.3D.f64"), Some(Dimension::Space));
        let none = ["b.f64", "b.4d.f64", "2d.f64", "a.2d/b.f64", ".f64"];
        assert!(none.iter().all(|name| dimension(name).is_none()));
    }

    #[test]
    fn the_same_numbers_are_points_of_the_plane_of_space_or_weighted() {
        let numbers = bytes(&[1.0, 2.0, 3.0, 4.0, 5.0, 6.0]);
        let parse = |dimension, weighted| parse(&numbers, dimension, weighted).unwrap();
        assert_eq!(parse(Dimension::Plane, false).len(), 3);
        assert_eq!(parse(Dimension::Space, false).len(), 2);
        let weighted = parse(Dimension::Plane, true);
        let plane = Coordinates::Plane(vec![[1.0, 2.0], [4.0, 5.0]]);
        assert_eq!(
            (weighted.coordinates, weighted.weights),
            (plane, Some(vec![3.0, 6.0]))
        );
    }

    #[test]
    fn errors_name_byte_and_point() {
        let error = |bytes: &[u8], weighted| parse(bytes, Dimension::Space, weighted).unwrap_err();
        insta::assert_snapshot!(error(&[0; 50], false), @"50 bytes are no whole number of points of 24 bytes each");
        insta::assert_snapshot!(error(&[0; 48], true), @"48 bytes are no whole number of points of 32 bytes each");
        let nan = bytes(&[0.0, 1.0, 2.0, 3.0, f64::NAN, 5.0, 6.0, f64::INFINITY]);
        insta::assert_snapshot!(error(&nan[..48], false), @"byte 32: point 1: y is NaN, which is not a finite number");
        insta::assert_snapshot!(error(&nan, true), @"byte 32: point 1: x is NaN, which is not a finite number");
        insta::assert_snapshot!(
            error(&bytes(&[0.0, 0.0, 0.0, -f64::INFINITY]), true),
            @"byte 24: point 0: the weight is -inf, which is not a finite number"
        );
    }
}
