//! Reads a VTU: the XML into arrays per piece, the arrays into one mesh.

use std::borrow::Cow;

use quick_xml::events::{BytesStart, Event};
use quick_xml::{Reader, escape};

use super::appended::{Appended, split_appended};
use super::base64_runs;
use super::budget::Budget;
use super::number::{Number, Numbers, from_bytes, from_text};
use super::packed::{Layout, unpack};
use super::piece::{Array, Piece, Section, unexpected};
use crate::error::{ReadError, ReadProblem};
use crate::lines::quoted;
use crate::mesh::Mesh;

/// The mesh of a VTU; several pieces are joined one after the other.
///
/// Data of any number type become `f64`. Time and memory are O(file): what zlib unpacks, and what several arrays share, is bounded by
/// 64 bytes for every byte of the file and 64 MiB besides.
///
/// # Errors
/// What is not XML, not an unstructured grid, truncated, inconsistent, or holds cells other than [`CellKind`](crate::CellKind), and
/// [`ReadProblem::TooLarge`] beyond that bound; with the line of the array or of the piece.
pub fn parse(bytes: &[u8]) -> Result<Mesh, ReadError> {
    let (xml, appended) = split_appended(bytes);
    let xml = std::str::from_utf8(xml)
        .map_err(|error| ReadError::at_byte(error.valid_up_to(), ReadProblem::NotText))?;
    let pieces = Document {
        xml,
        appended: Appended::find(appended),
        layout: None,
        pieces: Vec::new(),
        budget: Budget::of_file(bytes.len()),
        line: 1,
        counted: 0,
    }
    .read()?;
    let mut mesh = Mesh::default();
    for piece in pieces {
        let line = piece.line;
        piece
            .append_to(&mut mesh)
            .map_err(|fault| ReadError::at_line(line, fault))?;
    }
    mesh.check()?;
    Ok(mesh)
}

/// What is known while the XML is walked.
struct Document<'a> {
    xml: &'a str,
    appended: Option<Appended<'a>>,
    layout: Option<Layout>,
    budget: Budget,
    pieces: Vec<Piece>,
    /// The line at `counted` bytes: counting on from there keeps the whole walk linear.
    line: usize,
    counted: usize,
}

impl<'a> Document<'a> {
    fn read(mut self) -> Result<Vec<Piece>, ReadError> {
        let mut reader = Reader::from_str(self.xml);
        let mut section = None;
        loop {
            let position = reader.buffer_position() as usize;
            let event = reader.read_event();
            let line = self.line_of(position);
            let event = event.map_err(|error| {
                ReadError::at_line(line, ReadProblem::Syntax(error.to_string()))
            })?;
            let outcome = match event {
                Event::Eof => break,
                Event::Start(tag) if tag.name().as_ref() == "DataArray" => {
                    self.array(&mut reader, &tag, section, false)
                }
                Event::Empty(tag) if tag.name().as_ref() == "DataArray" => {
                    self.array(&mut reader, &tag, section, true)
                }
                Event::Start(tag) | Event::Empty(tag) => self.open(&tag, &mut section, line),
                _ => Ok(()),
            };
            outcome.map_err(|fault| ReadError::at_line(line, fault))?;
        }
        if self.pieces.is_empty() {
            return Err(ReadError::from(ReadProblem::Truncated {
                expected: "a <Piece>".into(),
            }));
        }
        Ok(self.pieces)
    }

    /// The line of a position that is no less than the one before.
    fn line_of(&mut self, position: usize) -> usize {
        let passed = self.xml.as_bytes().get(self.counted..position);
        let passed = passed.unwrap_or_default();
        // The event begins after the white space that the reader skips or hands out as text.
        self.line += passed.iter().filter(|&&byte| byte == b'\n').count();
        self.counted = position.max(self.counted);
        self.line
    }

    fn open(
        &mut self,
        tag: &BytesStart,
        section: &mut Option<Section>,
        line: usize,
    ) -> Result<(), ReadProblem> {
        match tag.name().as_ref() {
            "VTKFile" => self.layout = Some(layout(tag)?),
            "Piece" => self.pieces.push(Piece {
                line,
                points: count(tag, "NumberOfPoints")?,
                cells: count(tag, "NumberOfCells")?,
                arrays: Vec::new(),
            }),
            "PointData" => *section = Some(Section::PointData),
            "CellData" => *section = Some(Section::CellData),
            "Points" => *section = Some(Section::Points),
            "Cells" => *section = Some(Section::Cells),
            "FieldData" => *section = None,
            _ => {}
        }
        Ok(())
    }

    fn array(
        &mut self,
        reader: &mut Reader<&'a [u8]>,
        tag: &BytesStart,
        section: Option<Section>,
        empty: bool,
    ) -> Result<(), ReadProblem> {
        let text = if empty {
            Cow::Borrowed("")
        } else {
            text_inside(reader)?
        };
        let (Some(section), Some(layout), Some(piece)) =
            (section, self.layout, self.pieces.last_mut())
        else {
            return Ok(());
        };
        let type_name = attribute(tag, "type")?.unwrap_or_default();
        let Some(number) = Number::from_name(&type_name) else {
            // Strings and the like are data we have no place for.
            return Ok(());
        };
        let numbers = match attribute(tag, "format")?.as_deref() {
            Some("ascii") => from_text(number, &text)?,
            Some("binary") => {
                let packed = base64_runs::decode(text.as_bytes())?;
                numbers(number, layout, &packed, &mut self.budget)?
            }
            Some("appended") => {
                let offset = count(tag, "offset")?;
                let packed = Appended::at(self.appended, layout, offset, &mut self.budget)?;
                numbers(number, layout, &packed, &mut self.budget)?
            }
            other => {
                return Err(unexpected(
                    "a format ascii, binary or appended",
                    other.unwrap_or_default(),
                ));
            }
        };
        let components = match attribute(tag, "NumberOfComponents")? {
            Some(_) => count(tag, "NumberOfComponents")?.max(1),
            None => 1,
        };
        let name = attribute(tag, "Name")?.unwrap_or_default();
        piece.arrays.push(Array {
            section,
            name,
            components,
            numbers,
        });
        Ok(())
    }
}

/// The numbers packed in some bytes.
fn numbers(
    number: Number,
    layout: Layout,
    packed: &[u8],
    budget: &mut Budget,
) -> Result<Numbers, ReadProblem> {
    let bytes = unpack(layout, packed, budget)?;
    from_bytes(number, layout.big_endian, &bytes, budget)
}

/// The text up to the end tag of the element just opened; elements inside it (information keys) are skipped.
fn text_inside<'a>(reader: &mut Reader<&'a [u8]>) -> Result<Cow<'a, str>, ReadProblem> {
    let mut text = Cow::Borrowed("");
    let mut depth = 0_usize;
    loop {
        match reader
            .read_event()
            .map_err(|error| ReadProblem::Syntax(error.to_string()))?
        {
            Event::Text(part) if depth == 0 => text += part.into_inner(),
            Event::CData(part) if depth == 0 => text += part.into_inner(),
            Event::GeneralRef(name) if depth == 0 => {
                return Err(unexpected("a number", &format!("&{};", &*name)));
            }
            Event::Start(_) => depth += 1,
            Event::End(_) if depth == 0 => return Ok(text),
            Event::End(_) => depth -= 1,
            Event::Eof => {
                return Err(ReadProblem::Truncated {
                    expected: "</DataArray>".into(),
                });
            }
            _ => {}
        }
    }
}

fn attribute(tag: &BytesStart, name: &str) -> Result<Option<String>, ReadProblem> {
    let found = tag
        .try_get_attribute(name)
        .map_err(|error| ReadProblem::Syntax(error.to_string()))?;
    let Some(found) = found else { return Ok(None) };
    let value =
        escape::unescape(&found.value).map_err(|error| ReadProblem::Syntax(error.to_string()))?;
    Ok(Some(value.into_owned()))
}

fn count(tag: &BytesStart, name: &str) -> Result<usize, ReadProblem> {
    let value = attribute(tag, name)?.unwrap_or_default();
    value
        .trim()
        .parse()
        .map_err(|_| unexpected(&format!("a count for {name}"), &value))
}

fn layout(tag: &BytesStart) -> Result<Layout, ReadProblem> {
    let kind = attribute(tag, "type")?.unwrap_or_default();
    if kind != "UnstructuredGrid" {
        return Err(unexpected("a VTKFile of type UnstructuredGrid", &kind));
    }
    let compressed = match attribute(tag, "compressor")?.as_deref() {
        None | Some("") => false,
        Some("vtkZLibDataCompressor") => true,
        Some(other) => {
            return Err(ReadProblem::Unsupported(format!(
                "compression by {}",
                quoted(other)
            )));
        }
    };
    Ok(Layout {
        big_endian: attribute(tag, "byte_order")?.as_deref() == Some("BigEndian"),
        wide_header: attribute(tag, "header_type")?.as_deref() == Some("UInt64"),
        compressed,
    })
}
