//! The last sections of a `.poly`: a point in every hole and in every region, in the plane or in space.

use crate::error::ReadError;
use crate::lines::{Line, Lines};

/// What stands on the line of a region.
#[derive(Clone, Copy)]
pub(crate) struct RegionSeed<const N: usize> {
    pub(crate) place: [f64; N],
    pub(crate) attribute: f64,
    /// Largest size of an element, where it is bounded.
    pub(crate) bound: Option<f64>,
}

/// A section of points, each inside a hole.
pub(crate) fn holes<const N: usize>(lines: &mut Lines<'_>) -> Result<Vec<[f64; N]>, ReadError> {
    let mut header = lines.due(format_args!("the number of holes"))?;
    let count = header.number(format_args!("the number of holes"))?;
    header.end(format_args!("the number of holes"))?;
    let mut holes = Vec::with_capacity(lines.room_for(count));
    for index in 0..count {
        let mut line = lines.due(format_args!("hole {index} of {count}"))?;
        holes.push(hole(&mut line, index)?);
    }
    Ok(holes)
}

/// The line of a hole.
pub(crate) fn hole<const N: usize>(
    line: &mut Line<'_>,
    index: usize,
) -> Result<[f64; N], ReadError> {
    skip_number(line, "hole", index)?;
    let hole = line.coordinates("hole", index)?;
    line.end(format_args!("hole {index}"))?;
    Ok(hole)
}

/// The last section, which may be left out; elements are bounded in `size`, area or volume.
pub(crate) fn regions<const N: usize>(
    lines: &mut Lines<'_>,
    size: &str,
) -> Result<Vec<RegionSeed<N>>, ReadError> {
    let Some(mut header) = lines.next() else {
        return Ok(Vec::new());
    };
    let count = header.number(format_args!("the number of regions"))?;
    header.end(format_args!("the number of regions"))?;
    let mut regions = Vec::with_capacity(lines.room_for(count));
    for index in 0..count {
        let mut line = lines.due(format_args!("region {index} of {count}"))?;
        skip_number(&mut line, "region", index)?;
        let place = line.coordinates("region", index)?;
        let attribute = line.number(format_args!("the attribute of region {index}"))?;
        let bound = bound(&mut line, size, index)?;
        line.end(format_args!("region {index}"))?;
        regions.push(RegionSeed {
            place,
            attribute,
            bound,
        });
    }
    Ok(regions)
}

fn bound(line: &mut Line<'_>, size: &str, index: usize) -> Result<Option<f64>, ReadError> {
    let Some(word) = line.word() else {
        return Ok(None);
    };
    match word.parse::<f64>() {
        Ok(bound) if bound.is_finite() => Ok((bound >= 0.0).then_some(bound)),
        _ => Err(line.unexpected(format_args!("the largest {size} of region {index}"), word)),
    }
}

/// Holes and regions are numbered, but nothing names them, and files count them from either end.
fn skip_number(line: &mut Line<'_>, element: &str, index: usize) -> Result<(), ReadError> {
    let _number: i64 = line.number(format_args!("the number of {element} {index}"))?;
    Ok(())
}
