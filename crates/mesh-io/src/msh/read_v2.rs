//! Reading version 2, where nodes and elements stand in single lists and elements carry their tags themselves.
//!
//! In binary the counts of the lists are decimal on a line of their own, tags are integers of 4 bytes, and elements stand in blocks of
//! one type.

use std::fmt::Arguments;

use super::element_type::cell_kind;
use super::nodes::Nodes;
use super::parts::{Parts, unsupported_type};
use super::section::{decimal, end_section};
use crate::cell::CellKind;
use crate::error::{ReadError, ReadProblem};
use crate::numbers::{Encoding, Numbers};

/// Reads `$Nodes`, whose first line has been read.
pub(super) fn read_nodes(file: &mut Numbers<'_>) -> Result<Nodes, ReadError> {
    let count = read_count(file, "the number of nodes")?;
    let mut nodes = Nodes::with_room(file, count);
    for _ in 0..count {
        let index = nodes.points.len();
        let tag = read_tag(file, format_args!("the tag of node {index}"))?;
        nodes.push(tag, Nodes::read_point(file, index)?);
    }
    end_section(file, "Nodes")?;
    Ok(nodes)
}

/// Reads `$Elements`, whose first line has been read. The first tag of an element is its physical tag, 0 for none.
pub(super) fn read_elements(file: &mut Numbers<'_>, parts: &mut Parts) -> Result<(), ReadError> {
    let count = read_count(file, "the number of elements")?;
    match file.encoding {
        Encoding::Ascii => (0..count).try_for_each(|_| read_element(file, parts))?,
        Encoding::Binary => {
            let mut left = count;
            while left > 0 {
                left -= read_block(file, parts, left)?;
            }
        }
    }
    end_section(file, "Elements")
}

/// An element that says itself what it is.
fn read_element(file: &mut Numbers<'_>, parts: &mut Parts) -> Result<(), ReadError> {
    let index = parts.cell_tags.len();
    let tag = read_tag(file, format_args!("the tag of element {index}"))?;
    let kind = read_kind(file, index)?;
    let tags = read_tag(file, format_args!("the number of tags of element {index}"))?;
    let marker = read_marker(file, index, tags)?;
    parts.read_cell(file, kind, tag, marker, read_tag)
}

/// Elements behind a header that says what they are; answers how many, 1 to `left`.
fn read_block(file: &mut Numbers<'_>, parts: &mut Parts, left: u64) -> Result<u64, ReadError> {
    let first = parts.cell_tags.len();
    let kind = read_kind(file, first)?;
    let start = file.at();
    let count = read_tag(file, format_args!("how many elements follow {first}"))?;
    let tags = read_tag(file, format_args!("the number of tags of element {first}"))?;
    if !(1..=left).contains(&count) {
        let problem = ReadProblem::Expected {
            expected: format!("1 to {left} elements in the block of element {first}"),
            found: count.to_string(),
        };
        return Err(file.problem(start, problem));
    }
    for _ in 0..count {
        let index = parts.cell_tags.len();
        let tag = read_tag(file, format_args!("the tag of element {index}"))?;
        let marker = read_marker(file, index, tags)?;
        parts.read_cell(file, kind, tag, marker, read_tag)?;
    }
    Ok(count)
}

fn read_kind(file: &mut Numbers<'_>, index: usize) -> Result<CellKind, ReadError> {
    file.skip_blanks_in_text();
    let start = file.at();
    let number = file.int(format_args!("the type of element {index}"))?;
    cell_kind(number).ok_or_else(|| unsupported_type(file, start, number))
}

/// The marker among so many tags; `None` where there is none.
fn read_marker(file: &mut Numbers<'_>, index: usize, tags: u64) -> Result<Option<i32>, ReadError> {
    let mut marker = 0;
    for k in 0..tags {
        let tag = file.int(format_args!("tag {k} of element {index}"))?;
        match k {
            0 => marker = tag,
            // Physical, elementary, and then the number of partitions.
            2 if tag > 1 => {
                let problem = ReadProblem::Unsupported("a partitioned MSH mesh".into());
                return Err(file.problem(file.at(), problem));
            }
            _ => {}
        }
    }
    Ok(Some(marker).filter(|&marker| marker != 0))
}

/// The length of a list, which is decimal in every encoding.
fn read_count(file: &mut Numbers<'_>, expected: &str) -> Result<u64, ReadError> {
    let count = decimal(file, expected)?;
    if file.encoding == Encoding::Binary {
        file.end_line();
    }
    Ok(count)
}

/// A tag or a count that is not negative.
fn read_tag(file: &mut Numbers<'_>, expected: Arguments<'_>) -> Result<u64, ReadError> {
    if file.encoding == Encoding::Ascii {
        return file.size(expected);
    }
    let start = file.at();
    let tag = file.int(expected)?;
    u64::try_from(tag).map_err(|_| {
        let problem = ReadProblem::Expected {
            expected: expected.to_string(),
            found: tag.to_string(),
        };
        file.problem(start, problem)
    })
}
