//! Reading version 2 in ASCII, where nodes and elements stand in single lists and elements carry their tags themselves.

use super::element_type::cell_kind;
use super::nodes::Nodes;
use super::parts::{Parts, unsupported_type};
use super::section::end_section;
use crate::error::{ReadError, ReadProblem};
use crate::numbers::Numbers;

/// Reads `$Nodes`, whose first line has been read.
pub(super) fn read_nodes(file: &mut Numbers<'_>) -> Result<Nodes, ReadError> {
    let count = file.size(format_args!("the number of nodes"))?;
    let mut nodes = Nodes::with_room(file, count);
    for _ in 0..count {
        let index = nodes.points.len();
        let tag = file.size(format_args!("the tag of node {index}"))?;
        nodes.push(tag, Nodes::read_point(file, index)?);
    }
    end_section(file, "Nodes")?;
    Ok(nodes)
}

/// Reads `$Elements`, whose first line has been read. The first tag of an element is its physical tag, 0 for none.
pub(super) fn read_elements(file: &mut Numbers<'_>, parts: &mut Parts) -> Result<(), ReadError> {
    let count = file.size(format_args!("the number of elements"))?;
    for _ in 0..count {
        let index = parts.cell_tags.len();
        let tag = file.size(format_args!("the tag of element {index}"))?;
        file.skip_blanks();
        let start = file.at();
        let number = file.int(format_args!("the type of element {index}"))?;
        let kind = cell_kind(number).ok_or_else(|| unsupported_type(file, start, number))?;
        let marker = read_tags(file, index)?;
        parts.read_cell(file, kind, tag, Some(marker).filter(|&marker| marker != 0))?;
    }
    end_section(file, "Elements")
}

fn read_tags(file: &mut Numbers<'_>, index: usize) -> Result<i32, ReadError> {
    let count = file.size(format_args!("the number of tags of element {index}"))?;
    let mut marker = 0;
    for k in 0..count {
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
    Ok(marker)
}
