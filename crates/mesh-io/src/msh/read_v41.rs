//! Reading version 4.1, in ASCII or binary, where elements stand in blocks of one kind on one entity.

use super::element_type::cell_kind;
use super::parts::{Parts, unsupported_type};
use super::section::end_section;
use crate::error::{ReadError, ReadProblem};
use crate::numbers::Numbers;

/// Reads `$Elements`, whose first line has been read.
pub(super) fn read_elements(file: &mut Numbers<'_>, parts: &mut Parts) -> Result<(), ReadError> {
    let start = file.at();
    let before = parts.cell_tags.len();
    let blocks = file.size(format_args!("the number of blocks in $Elements"))?;
    let claimed = file.size(format_args!("the number of elements"))?;
    file.size(format_args!("the smallest element tag"))?;
    file.size(format_args!("the greatest element tag"))?;
    for block in 0..blocks {
        read_block(file, parts, block)?;
    }
    let found = (parts.cell_tags.len() - before) as u64;
    if claimed != found {
        return Err(file.problem(
            start,
            ReadProblem::Count {
                what: "elements".into(),
                claimed,
                found,
            },
        ));
    }
    end_section(file, "Elements")
}

fn read_block(file: &mut Numbers<'_>, parts: &mut Parts, block: u64) -> Result<(), ReadError> {
    let dimension = file.int(format_args!("the dimension of element block {block}"))?;
    let entity = file.int(format_args!("the entity of element block {block}"))?;
    file.skip_blanks_in_text();
    let start = file.at();
    let number = file.int(format_args!("the element type of block {block}"))?;
    let kind = cell_kind(number).ok_or_else(|| unsupported_type(file, start, number))?;
    let count = file.size(format_args!("the number of elements in block {block}"))?;
    let marker = parts.physical.marker(dimension, entity);
    for _ in 0..count {
        let index = parts.cell_tags.len();
        let tag = file.size(format_args!("the tag of element {index}"))?;
        parts.read_cell(file, kind, tag, marker, Numbers::size)?;
    }
    Ok(())
}
