//! `$NodeData` and `$ElementData`: named numbers about points and cells.

use super::POINT_MARKERS;
use super::parts::Parts;
use super::section::{decimal, end_section, quoted_text};
use super::tag_index::TagIndex;
use crate::error::{ReadError, ReadProblem};
use crate::mesh::{DataArray, Mesh};
use crate::numbers::{Encoding, Numbers};

/// Data that speaks of fewer elements than one in this many is refused, so that memory stays in proportion to the file.
const SPARSEST: usize = 16;

/// Reads a section, whose first line has been read. Elements it does not speak of get NaN.
pub(super) fn read_data(
    file: &mut Numbers<'_>,
    section: &str,
    parts: &mut Parts,
) -> Result<(), ReadError> {
    let start = file.at();
    let head = Head::read(file)?;
    let (rows, element) = match section {
        "NodeData" => (parts.mesh.points.len(), "node"),
        _ => (parts.mesh.cells.len(), "element"),
    };
    if head
        .rows
        .checked_mul(SPARSEST)
        .is_none_or(|reach| reach < rows)
    {
        return Err(file.problem(
            start,
            ReadProblem::Unsupported(format!("${section} that leaves most {element}s out")),
        ));
    }
    let mut values = vec![f64::NAN; rows * head.components];
    let elements;
    let index = match (element, &parts.nodes) {
        ("node", nodes) => nodes.as_ref(),
        _ => {
            // Only here, where there are rows to pay for it: a file may hold very many sections of node data.
            elements = TagIndex::of(&parts.cell_tags).ok();
            elements.as_ref()
        }
    };
    let Some(index) = index else {
        let problem = ReadProblem::Expected {
            expected: format!("{element}s before ${section}, each with a tag of its own"),
            found: format!("${section}"),
        };
        return Err(file.problem(start, problem));
    };
    for row in 0..head.rows {
        let position = read_tag(file, index, element, row)?;
        for k in 0..head.components {
            let value = file.real(format_args!("component {k} of row {row} in ${section}"))?;
            if let Some(slot) = values.get_mut(position * head.components + k) {
                *slot = value;
            }
        }
    }
    end_section(file, section)?;
    let array = DataArray {
        name: head.name,
        components: head.components,
        values,
    };
    match element {
        "node" => parts.mesh.point_data.push(array),
        _ => parts.mesh.cell_data.push(array),
    }
    Ok(())
}

/// What stands before the rows.
struct Head {
    name: String,
    components: usize,
    rows: usize,
}

impl Head {
    /// Everything here is decimal in every encoding.
    fn read(file: &mut Numbers<'_>) -> Result<Self, ReadError> {
        let mut name = String::new();
        for k in 0..decimal(file, "the number of string tags")? {
            let text: String = quoted_text(file, "a string tag in quotation marks")?;
            if k == 0_u64 {
                name = text;
            }
        }
        for _ in 0..decimal::<u64>(file, "the number of real tags")? {
            decimal::<f64>(file, "a real tag")?;
        }
        let start = file.at();
        let mut tags = [0; 3];
        let count: u64 = decimal(file, "the number of integer tags")?;
        for k in 0..count {
            let tag: usize = decimal(file, "an integer tag")?;
            if let Some(slot) = usize::try_from(k).ok().and_then(|k| tags.get_mut(k)) {
                *slot = tag;
            }
        }
        let [_time_step, components, rows] = tags;
        if count < 3 || !(1..=9).contains(&components) {
            let problem = ReadProblem::Expected {
                expected: "a time step, 1 to 9 components and a number of rows".into(),
                found: format!("{count} integer tags and {components} components"),
            };
            return Err(file.problem(start, problem));
        }
        if file.encoding == Encoding::Binary {
            file.end_line();
        }
        Ok(Self {
            name,
            components,
            rows,
        })
    }
}

fn read_tag(
    file: &mut Numbers<'_>,
    index: &TagIndex,
    element: &'static str,
    row: usize,
) -> Result<usize, ReadError> {
    file.skip_blanks_in_text();
    let start = file.at();
    let tag = file.int(format_args!("the tag of row {row}"))?;
    let position = u64::try_from(tag).ok().and_then(|tag| index.position(tag));
    position.map(|position| position as usize).ok_or_else(|| {
        let problem = ReadProblem::NoSuch {
            element: "row",
            index: row,
            names: element,
            found: tag.into(),
        };
        file.problem(start, problem)
    })
}

/// Node data of the name [`POINT_MARKERS`] becomes the point markers, if it consists of integers.
pub(super) fn with_point_markers(mut mesh: Mesh) -> Mesh {
    let is_marker = |array: &DataArray| array.name == POINT_MARKERS && array.components == 1;
    if let Some(found) = mesh.point_data.iter().position(is_marker) {
        let markers: Option<Vec<i32>> = mesh.point_data[found]
            .values
            .iter()
            .map(|&value| marker(value))
            .collect();
        if markers.is_some() {
            mesh.point_markers = markers;
            mesh.point_data.remove(found);
        }
    }
    mesh
}

fn marker(value: f64) -> Option<i32> {
    let marker = value as i32;
    (f64::from(marker) == value).then_some(marker)
}
