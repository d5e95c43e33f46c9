//! Reads a VTU: the XML into arrays per piece, the arrays into one mesh.

use quick_xml::events::{BytesStart, Event};
use quick_xml::{Reader, escape};

use super::array::{Layout, Number, Numbers, appended_run, from_base64, from_bytes, from_text};
use super::{MARKER, vtk_type};
use crate::cell::{Cell, CellKind};
use crate::error::{ReadError, ReadProblem};
use crate::lines::quoted;
use crate::mesh::{DataArray, Mesh};

/// The mesh of a VTU; several pieces are joined one after the other.
///
/// Data of any number type become `f64`. O(file), or O(what zlib unpacks from it) if compressed.
///
/// # Errors
/// What is not XML, not an unstructured grid, truncated, inconsistent, or holds cells other than [`CellKind`]; with the line of the
/// array or of the piece.
pub fn parse(bytes: &[u8]) -> Result<Mesh, ReadError> {
    let (xml, appended) = split_appended(bytes);
    let xml = std::str::from_utf8(xml)
        .map_err(|error| ReadError::at_byte(error.valid_up_to(), ReadProblem::NotText))?;
    let pieces = Document {
        xml,
        appended,
        layout: None,
        pieces: Vec::new(),
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

/// Everything up to `<AppendedData`, and what follows it.
fn split_appended(bytes: &[u8]) -> (&[u8], &[u8]) {
    const TAG: &[u8] = b"<AppendedData";
    match bytes.windows(TAG.len()).position(|window| window == TAG) {
        Some(start) => bytes.split_at(start),
        None => (bytes, &[]),
    }
}

/// The element an array belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Section {
    PointData,
    CellData,
    Points,
    Cells,
}

struct Array {
    section: Section,
    name: String,
    components: usize,
    numbers: Numbers,
}

struct Piece {
    line: usize,
    points: usize,
    cells: usize,
    arrays: Vec<Array>,
}

/// What is known while the XML is walked.
struct Document<'a> {
    xml: &'a str,
    appended: &'a [u8],
    layout: Option<Layout>,
    pieces: Vec<Piece>,
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

    fn line_of(&self, position: usize) -> usize {
        let before = self.xml.as_bytes().get(..position).unwrap_or_default();
        // The event begins after the white space that the reader skips or hands out as text.
        1 + before.iter().filter(|&&byte| byte == b'\n').count()
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
            String::new()
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
            Some("binary") => from_base64(number, layout, text.as_bytes())?,
            Some("appended") => {
                from_appended(number, layout, self.appended, count(tag, "offset")?)?
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

/// The text up to the end tag of the element just opened; elements inside it (information keys) are skipped.
fn text_inside(reader: &mut Reader<&[u8]>) -> Result<String, ReadProblem> {
    let mut text = String::new();
    let mut depth = 0_usize;
    loop {
        match reader
            .read_event()
            .map_err(|error| ReadProblem::Syntax(error.to_string()))?
        {
            Event::Text(part) if depth == 0 => text.push_str(&part),
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

/// The array at `offset` behind the underscore of the appended data.
fn from_appended(
    number: Number,
    layout: Layout,
    appended: &[u8],
    offset: usize,
) -> Result<Numbers, ReadProblem> {
    let missing = || ReadProblem::Truncated {
        expected: "appended data".into(),
    };
    let tag_end = appended
        .iter()
        .position(|&byte| byte == b'>')
        .ok_or_else(missing)?;
    let (tag, content) = appended.split_at(tag_end);
    let underscore = content
        .iter()
        .position(|&byte| byte == b'_')
        .ok_or_else(missing)?;
    let data = content
        .get(underscore + 1..)
        .and_then(|data| data.get(offset..))
        .ok_or_else(missing)?;
    if tag.windows(3).any(|window| window == b"raw") {
        from_bytes(number, layout, data)
    } else {
        from_base64_prefix(number, layout, data)
    }
}

/// An appended array in base64, which ends where its header says rather than where the text does.
fn from_base64_prefix(number: Number, layout: Layout, data: &[u8]) -> Result<Numbers, ReadProblem> {
    from_base64(number, layout, appended_run(layout, data)?)
}

fn unexpected(expected: &str, found: &str) -> ReadProblem {
    ReadProblem::Expected {
        expected: expected.into(),
        found: quoted(found),
    }
}

impl Piece {
    fn append_to(mut self, mesh: &mut Mesh) -> Result<(), ReadProblem> {
        let first_point = mesh.points.len();
        let first_cell = mesh.cells.len();
        self.append_points(mesh)?;
        self.append_cells(mesh, first_point)?;
        for array in self.arrays {
            match array.section {
                Section::PointData => {
                    append_data(
                        array,
                        self.points,
                        first_point,
                        &mut mesh.point_markers,
                        &mut mesh.point_data,
                    )?;
                }
                Section::CellData => {
                    append_data(
                        array,
                        self.cells,
                        first_cell,
                        &mut mesh.cell_markers,
                        &mut mesh.cell_data,
                    )?;
                }
                Section::Points | Section::Cells => {}
            }
        }
        Ok(())
    }

    fn take(&mut self, section: Section, name: Option<&str>) -> Option<Numbers> {
        let fits =
            |array: &Array| array.section == section && name.is_none_or(|name| array.name == name);
        let index = self.arrays.iter().position(fits)?;
        Some(self.arrays.swap_remove(index).numbers)
    }

    fn append_points(&mut self, mesh: &mut Mesh) -> Result<(), ReadProblem> {
        let coordinates = self
            .take(Section::Points, None)
            .map(Numbers::into_reals)
            .unwrap_or_default();
        if coordinates.len() != self.points.saturating_mul(3) {
            let expected = self.points.saturating_mul(3);
            return Err(count_differs("coordinates", expected, coordinates.len()));
        }
        mesh.points.extend(
            coordinates
                .chunks_exact(3)
                .map(|point| [point[0], point[1], point[2]]),
        );
        Ok(())
    }

    fn append_cells(&mut self, mesh: &mut Mesh, first_point: usize) -> Result<(), ReadProblem> {
        let corners = self.integers("connectivity")?;
        let ends = self.integers("offsets")?;
        let types = self.integers("types")?;
        for (name, list) in [("offsets", &ends), ("types", &types)] {
            if list.len() != self.cells {
                return Err(count_differs(name, self.cells, list.len()));
            }
        }
        let mut start = 0_usize;
        let mut cell_corners = Vec::new();
        for (index, (&end, &vtk)) in ends.iter().zip(&types).enumerate() {
            let end = usize::try_from(end)
                .ok()
                .filter(|&end| end >= start && end <= corners.len());
            let Some(end) = end else {
                return Err(unexpected(
                    &format!("an ascending offset for cell {index}"),
                    &ends[index].to_string(),
                ));
            };
            cell_corners.clear();
            for &corner in &corners[start..end] {
                cell_corners.push(self.corner(index, corner, first_point)?);
            }
            push_cell(mesh, index, vtk, &mut cell_corners)?;
            start = end;
        }
        Ok(())
    }

    fn corner(&self, index: usize, corner: i64, first_point: usize) -> Result<u32, ReadProblem> {
        let within = usize::try_from(corner)
            .ok()
            .filter(|&corner| corner < self.points);
        within
            .and_then(|corner| u32::try_from(corner + first_point).ok())
            .ok_or(ReadProblem::NoSuch {
                element: "cell",
                index,
                names: "point",
                found: corner,
            })
    }

    fn integers(&mut self, name: &str) -> Result<Vec<i64>, ReadProblem> {
        match self.take(Section::Cells, Some(name)) {
            Some(Numbers::Integers(values)) => Ok(values),
            Some(Numbers::Reals(values)) if values.is_empty() => Ok(Vec::new()),
            Some(Numbers::Reals(_)) => Err(unexpected(
                &format!("integers as {name}"),
                "floating-point numbers",
            )),
            None if self.cells == 0 => Ok(Vec::new()),
            None => Err(ReadProblem::Truncated {
                expected: format!("the array `{name}`"),
            }),
        }
    }
}

fn push_cell(
    mesh: &mut Mesh,
    index: usize,
    vtk: i64,
    corners: &mut [u32],
) -> Result<(), ReadProblem> {
    let kind = match (vtk, corners.len()) {
        // Pixels and voxels count row by row instead of round the cell.
        (8, 4) => {
            corners.swap(2, 3);
            Some(CellKind::Quad)
        }
        (11, 8) => {
            corners.swap(2, 3);
            corners.swap(6, 7);
            Some(CellKind::Hexahedron)
        }
        // Polygons.
        (7, 3) => Some(CellKind::Triangle),
        (7, 4) => Some(CellKind::Quad),
        _ => CellKind::ALL
            .into_iter()
            .find(|&kind| i64::from(vtk_type(kind)) == vtk),
    };
    let Some(kind) = kind else {
        let what = format!(
            "cell {index} of VTK type {vtk} with {} corners",
            corners.len()
        );
        return Err(ReadProblem::Unsupported(what));
    };
    let Some(cell) = Cell::new(kind, corners) else {
        let what = format!("corners of cell {index}, a {}", kind.name());
        return Err(count_differs(&what, kind.corner_count(), corners.len()));
    };
    mesh.cells.push(cell);
    Ok(())
}

fn count_differs(what: &str, claimed: usize, found: usize) -> ReadProblem {
    ReadProblem::Count {
        what: what.into(),
        claimed: claimed as u64,
        found: found as u64,
    }
}

/// Joins data of one piece to those of the pieces before, which must have had the same.
fn append_data(
    array: Array,
    elements: usize,
    before: usize,
    markers: &mut Option<Vec<i32>>,
    fields: &mut Vec<DataArray>,
) -> Result<(), ReadProblem> {
    let Array {
        name,
        components,
        numbers,
        ..
    } = array;
    let found = match &numbers {
        Numbers::Integers(values) => values.len(),
        Numbers::Reals(values) => values.len(),
    };
    let expected = elements.saturating_mul(components);
    if found != expected {
        return Err(count_differs(
            &format!("values of {}", quoted(&name)),
            expected,
            found,
        ));
    }
    if let (MARKER, 1, Numbers::Integers(values)) = (name.as_str(), components, &numbers)
        && markers.as_ref().map_or(0, Vec::len) == before
        && let Ok(values) = values
            .iter()
            .map(|&value| i32::try_from(value))
            .collect::<Result<Vec<_>, _>>()
    {
        markers.get_or_insert_default().extend(values);
        return Ok(());
    }
    let values = numbers.into_reals();
    match fields.iter_mut().find(|field| field.name == name) {
        Some(field) if field.components == components => field.values.extend(values),
        _ => fields.push(DataArray {
            name,
            components,
            values,
        }),
    }
    Ok(())
}
