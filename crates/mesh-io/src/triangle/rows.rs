//! What follows the numbers proper on every line: attributes and a marker.

use std::io::{self, Write};

use crate::error::ReadError;
use crate::lines::Line;
use crate::mesh::DataArray;

/// Attributes and markers of the elements of one section, gathered line by line.
pub(crate) struct Rows {
    attributes: usize,
    values: Vec<f64>,
    markers: Option<Vec<i32>>,
}

impl Rows {
    pub(crate) fn new(attributes: usize, has_markers: bool) -> Self {
        Self {
            attributes,
            values: Vec::new(),
            markers: has_markers.then(Vec::new),
        }
    }

    /// Reads the rest of an element's line.
    pub(crate) fn read(
        &mut self,
        line: &mut Line<'_>,
        element: &str,
        index: usize,
    ) -> Result<(), ReadError> {
        for attribute in 0..self.attributes {
            self.values
                .push(line.number(format_args!("attribute {attribute} of {element} {index}"))?);
        }
        if let Some(markers) = &mut self.markers {
            markers.push(line.number(format_args!("the marker of {element} {index}"))?);
        }
        line.end(format_args!("{element} {index}"))
    }

    /// One array per attribute, called `attribute 0` and so on, and the markers.
    pub(crate) fn finish(self) -> (Vec<DataArray>, Option<Vec<i32>>) {
        // Without rows, the number of attributes is a claim that nothing backs.
        let attributes = self.attributes.min(self.values.len());
        let array = |attribute: usize| {
            let values = self
                .values
                .iter()
                .skip(attribute)
                .step_by(self.attributes)
                .copied()
                .collect();
            DataArray::scalar(format!("attribute {attribute}"), values)
        };
        ((0..attributes).map(array).collect(), self.markers)
    }
}

/// Refuses a count of markers other than 0 and 1.
pub(crate) fn has_markers(line: &mut Line<'_>, element: &str) -> Result<bool, ReadError> {
    // A header that stops before the number has no markers.
    match line.word() {
        None | Some("0") => Ok(false),
        Some("1") => Ok(true),
        Some(word) => Err(line.unexpected(
            format_args!("0 or 1 as the number of markers per {element}"),
            word,
        )),
    }
}

/// Refuses an element whose number is not the next.
pub(crate) fn check_number(
    line: &mut Line<'_>,
    element: &str,
    index: usize,
    base: usize,
) -> Result<(), ReadError> {
    let expected = index.saturating_add(base);
    match line.word() {
        Some(word) if word.parse() == Ok(expected) => Ok(()),
        word => Err(line.unexpected(
            format_args!("{expected} as the number of the {element}"),
            word.unwrap_or_default(),
        )),
    }
}

/// Reads the number of a point and answers its index.
pub(crate) fn point_index(
    line: &mut Line<'_>,
    (element, index): (&'static str, usize),
    end: usize,
    (base, points): (usize, usize),
) -> Result<u32, ReadError> {
    let named: i64 = line.number(format_args!("point {end} of {element} {index}"))?;
    let point = usize::try_from(named)
        .ok()
        .and_then(|named| named.checked_sub(base))
        .filter(|&point| point < points);
    point
        .and_then(|point| u32::try_from(point).ok())
        .ok_or_else(|| {
            line.problem(crate::error::ReadProblem::NoSuch {
                element,
                index,
                names: "point",
                found: named,
            })
        })
}

/// Number of attributes that hold these arrays.
pub(crate) fn attribute_count(arrays: &[DataArray]) -> usize {
    arrays.iter().map(|array| array.components).sum()
}

/// Writes the attributes of one element.
pub(crate) fn write_attributes(
    out: &mut impl Write,
    arrays: &[DataArray],
    row: usize,
) -> io::Result<()> {
    for array in arrays {
        for value in array
            .values
            .iter()
            .skip(row * array.components)
            .take(array.components)
        {
            write!(out, " {value:?}")?;
        }
    }
    Ok(())
}

/// Writes the marker of one element, where there are some, and ends the line.
pub(crate) fn write_marker(
    out: &mut impl Write,
    markers: Option<&[i32]>,
    index: usize,
) -> io::Result<()> {
    match markers.and_then(|markers| markers.get(index)) {
        Some(marker) => writeln!(out, " {marker}"),
        None => writeln!(out),
    }
}
