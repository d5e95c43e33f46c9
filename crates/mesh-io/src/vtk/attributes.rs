//! Point and cell data: scalars, vectors and the like, and fields.

use super::name::decoded;
use super::numbers::{File, Statement};
use crate::error::ReadError;
use crate::numbers::Encoding;
use crate::vtu::number::{Number, Numbers};
use crate::vtu::piece::{Array, Section};

/// What data are about, and how many rows they have.
#[derive(Clone, Copy)]
pub(super) struct About {
    pub(super) section: Section,
    pub(super) rows: usize,
}

/// Reads the attribute that `keyword` begins, where it is one, and appends its arrays; answers whether it is.
pub(super) fn read_attribute(
    file: &mut File<'_>,
    keyword: &[u8],
    statement: &mut Statement<'_>,
    about: About,
    arrays: &mut Vec<Array>,
) -> Result<bool, ReadError> {
    let Some(Shape {
        name,
        number,
        components,
    }) = shape(file, keyword, statement)?
    else {
        return Ok(false);
    };
    if keyword == b"SCALARS" {
        // Says how the numbers are coloured; not every writer has it.
        file.optional("LOOKUP_TABLE");
    }
    let numbers = file.array(
        number,
        (about.rows, components),
        format_args!("data {name}"),
    )?;
    arrays.push(Array {
        section: about.section,
        name,
        components,
        numbers,
    });
    Ok(true)
}

/// What an attribute says of its numbers.
struct Shape {
    name: String,
    number: Number,
    components: usize,
}

fn shape(
    file: &File<'_>,
    keyword: &[u8],
    statement: &mut Statement<'_>,
) -> Result<Option<Shape>, ReadError> {
    let fixed = match keyword {
        b"SCALARS" | b"GLOBAL_IDS" | b"PEDIGREE_IDS" | b"EDGE_FLAGS" => 1,
        b"VECTORS" | b"NORMALS" => 3,
        b"TENSORS" => 9,
        b"TENSORS6" => 6,
        b"TEXTURE_COORDINATES" | b"COLOR_SCALARS" => 0,
        _ => return Ok(None),
    };
    let name = decoded(statement.due(file, "the name of data")?);
    let components = match keyword {
        b"TEXTURE_COORDINATES" | b"COLOR_SCALARS" => components(file, statement)?,
        _ => fixed,
    };
    let number = match (keyword, file.bytes.encoding) {
        // Colours are whole in binary and fractions in text.
        (b"COLOR_SCALARS", Encoding::Binary) => Number::U8,
        (b"COLOR_SCALARS", Encoding::Ascii) => Number::F64,
        _ => statement.number_type(file)?,
    };
    let components = match (keyword, statement.word()) {
        (b"SCALARS", Some(word)) => std::str::from_utf8(word)
            .ok()
            .and_then(|word| word.parse().ok())
            .filter(|&components| components > 0)
            .ok_or_else(|| statement.unexpected(file, COMPONENTS, word))?,
        _ => components,
    };
    Ok(Some(Shape {
        name,
        number,
        components,
    }))
}

const COMPONENTS: &str = "the number of components of data";

fn components(file: &File<'_>, statement: &mut Statement<'_>) -> Result<usize, ReadError> {
    match statement.number(file, COMPONENTS)? {
        0 => Err(statement.unexpected(file, COMPONENTS, b"0")),
        components => Ok(components),
    }
}

/// Reads the arrays of a field, the first line of which is `statement` behind its first word. They are about something, or passed over.
pub(super) fn read_field(
    file: &mut File<'_>,
    statement: &mut Statement<'_>,
    about: Option<About>,
    arrays: &mut Vec<Array>,
) -> Result<(), ReadError> {
    let _name = statement.due(file, "the name of a field")?;
    let count: usize = statement.number(file, "the number of arrays of a field")?;
    for index in 0..count {
        skip_metadata(file);
        let mut head = file.due(format_args!("array {index} of {count} of a field"))?;
        let name = decoded(head.due(file, "the name of data")?);
        let components: usize = head.number(file, COMPONENTS)?;
        let rows: usize = head.number(file, "the number of rows of data")?;
        let number = head.number_type(file)?;
        let numbers = file.array(number, (rows, components), format_args!("data {name}"))?;
        if let Some(about) = about
            && components > 0
        {
            arrays.push(Array {
                section: about.section,
                name,
                components,
                numbers,
            });
        }
    }
    Ok(())
}

/// Passes over a block of metadata, if there is one; it ends at a blank line.
pub(super) fn skip_metadata(file: &mut File<'_>) {
    while file.optional("METADATA").is_some() {
        while file.bytes.line().is_some_and(|line| !line.is_empty()) {}
    }
}

/// Passes over the colours of a table.
pub(super) fn skip_lookup_table(
    file: &mut File<'_>,
    statement: &mut Statement<'_>,
) -> Result<(), ReadError> {
    let _name = statement.due(file, "the name of a table")?;
    let colours: usize = statement.number(file, "the number of colours of a table")?;
    let number = match file.bytes.encoding {
        Encoding::Ascii => Number::F64,
        Encoding::Binary => Number::U8,
    };
    let _passed: Numbers = file.array(number, (colours, 4), format_args!("a table of colours"))?;
    Ok(())
}
