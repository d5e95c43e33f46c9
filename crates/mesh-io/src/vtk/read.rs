//! Reads a file statement by statement, into one piece like that of a VTU.

use super::attributes::{About, read_attribute, read_field, skip_lookup_table, skip_metadata};
use super::cells::CellList;
use super::numbers::{File, Statement};
use crate::error::{ReadError, ReadProblem};
use crate::mesh::{Mesh, MeshDefect, first_not_finite};
use crate::numbers::{Encoding, Numbers as Bytes, quoted};
use crate::vtu::budget::Budget;
use crate::vtu::number::{Number, Numbers};
use crate::vtu::piece::{Array, Piece, Section};

/// The mesh of a legacy VTK file; polydata in the order of VTK: vertices, lines, polygons.
///
/// # Errors
/// Statements out of place, other datasets, lists that end early or contradict each other, cells other than
/// [`CellKind`](crate::CellKind), numbers that are none or (of coordinates) not finite; each with its line (ASCII) or byte (binary): that
/// of the list, when an element of it is to blame. O(file).
pub fn parse(bytes: &[u8]) -> Result<Mesh, ReadError> {
    let mut file = File {
        bytes: Bytes::new(bytes, Encoding::Ascii),
        budget: Budget::of_file(bytes.len()),
    };
    let has_offsets = read_version(&mut file)? >= 5.0;
    // The title, which may be empty.
    file.bytes.line();
    let encoding = read_encoding(&mut file)?;
    file.bytes.encoding = encoding;
    let mut dataset = Dataset {
        has_offsets,
        is_polydata: is_polydata(&mut file)?,
        ..Dataset::default()
    };
    loop {
        skip_metadata(&mut file);
        let Some(mut statement) = file.statement() else {
            break;
        };
        dataset.read(&mut file, &mut statement)?;
    }
    dataset.finish(&file)
}

fn read_version(file: &mut File<'_>) -> Result<f64, ReadError> {
    const START: &str = "# vtk DataFile Version";
    let line = file.bytes.line().unwrap_or_default();
    let version = line
        .split_at_checked(START.len())
        .and_then(|(start, version)| {
            let version = std::str::from_utf8(version).ok()?.trim();
            let number: f64 = version.parse().ok()?;
            start
                .eq_ignore_ascii_case(START.as_bytes())
                .then_some(number)
        });
    match version {
        Some(version) if (1.0..6.0).contains(&version) => Ok(version),
        Some(version) => {
            let what = format!("version {version} of legacy VTK");
            Err(file.bytes.problem(0, ReadProblem::Unsupported(what)))
        }
        None => {
            let problem = ReadProblem::Expected {
                expected: format!("`{START}` and a number"),
                found: quoted(line),
            };
            Err(file.bytes.problem(0, problem))
        }
    }
}

fn read_encoding(file: &mut File<'_>) -> Result<Encoding, ReadError> {
    let expected = "ASCII or BINARY";
    let mut statement = file.due(format_args!("{expected}"))?;
    let word = statement.word().unwrap_or_default();
    match word.to_ascii_uppercase().as_slice() {
        b"ASCII" => Ok(Encoding::Ascii),
        b"BINARY" => Ok(Encoding::Binary),
        _ => Err(statement.unexpected(file, expected, word)),
    }
}

fn is_polydata(file: &mut File<'_>) -> Result<bool, ReadError> {
    let expected = "the word DATASET";
    let mut statement = file.due(format_args!("{expected}"))?;
    let word = statement.word().unwrap_or_default();
    if !word.eq_ignore_ascii_case(b"DATASET") {
        return Err(statement.unexpected(file, expected, word));
    }
    let kind = statement.due(file, "the kind of the dataset")?;
    match kind.to_ascii_uppercase().as_slice() {
        b"UNSTRUCTURED_GRID" => Ok(false),
        b"POLYDATA" => Ok(true),
        _ => {
            let what = format!("a VTK dataset {}", quoted(kind));
            let problem = ReadProblem::Unsupported(what);
            Err(file.bytes.problem(statement.start, problem))
        }
    }
}

/// What has been read so far.
#[derive(Default)]
struct Dataset {
    has_offsets: bool,
    is_polydata: bool,
    points: Option<usize>,
    /// The cells of a grid; vertices, lines and polygons of polydata.
    lists: [CellList; 3],
    types: Option<Vec<i64>>,
    /// Where the first list of cells begins.
    cells_start: usize,
    about: Option<About>,
    arrays: Vec<Array>,
}

impl Dataset {
    fn read(
        &mut self,
        file: &mut File<'_>,
        statement: &mut Statement<'_>,
    ) -> Result<(), ReadError> {
        let word = statement.word().unwrap_or_default();
        let keyword = word.to_ascii_uppercase();
        match (keyword.as_slice(), self.is_polydata) {
            (b"POINTS", _) if self.points.is_none() => self.read_points(file, statement),
            (b"CELLS", false) | (b"VERTICES", true) => self.read_list(file, statement, 0, word),
            (b"LINES", true) => self.read_list(file, statement, 1, word),
            (b"POLYGONS", true) => self.read_list(file, statement, 2, word),
            (b"CELL_TYPES", false) => {
                let count = statement.number(file, "the number of cells")?;
                self.types = Some(file.integers(Number::I32, count, format_args!("CELL_TYPES"))?);
                Ok(())
            }
            (b"POINT_DATA", _) => {
                let rows = self.points.unwrap_or(0);
                self.read_about(file, statement, Section::PointData, rows)
            }
            (b"CELL_DATA", _) => {
                let rows = self.lists.iter().map(|list| list.ends.len()).sum();
                self.read_about(file, statement, Section::CellData, rows)
            }
            (b"FIELD", _) => read_field(file, statement, self.about, &mut self.arrays),
            (b"LOOKUP_TABLE", _) => skip_lookup_table(file, statement),
            (b"TRIANGLE_STRIPS", true) => {
                let problem = ReadProblem::Unsupported("VTK polydata of triangle strips".into());
                Err(file.bytes.problem(statement.start, problem))
            }
            (keyword, _) => {
                if let Some(about) = self.about
                    && read_attribute(file, keyword, statement, about, &mut self.arrays)?
                {
                    return Ok(());
                }
                Err(statement.unexpected(file, "a statement of a legacy VTK file", word))
            }
        }
    }

    fn read_points(
        &mut self,
        file: &mut File<'_>,
        statement: &mut Statement<'_>,
    ) -> Result<(), ReadError> {
        let count = statement.number(file, "the number of points")?;
        let problem = |problem: ReadProblem| file.bytes.problem(statement.start, problem);
        if u32::try_from(count).is_err() {
            return Err(problem(MeshDefect::TooManyPoints(count).into()));
        }
        let number = statement.number_type(file)?;
        let numbers = file.array(number, (count, 3), format_args!("POINTS"))?;
        let coordinates = numbers.into_reals();
        let (points, _) = coordinates.as_chunks::<3>();
        for (index, point) in points.iter().enumerate() {
            if let Some((axis, value)) = first_not_finite(point) {
                let problem = ReadProblem::NotFinite {
                    element: "point",
                    index,
                    axis,
                    value,
                };
                return Err(file.bytes.problem(statement.start, problem));
            }
        }
        self.points = Some(count);
        self.arrays.push(Array {
            section: Section::Points,
            name: String::new(),
            components: 3,
            numbers: Numbers::Reals(coordinates),
        });
        Ok(())
    }

    fn read_list(
        &mut self,
        file: &mut File<'_>,
        statement: &mut Statement<'_>,
        place: usize,
        name: &[u8],
    ) -> Result<(), ReadError> {
        let list = self
            .lists
            .get_mut(place)
            .filter(|list| list.ends.is_empty());
        let Some(list) = list else {
            return Err(statement.unexpected(file, "every list of cells once", name));
        };
        let name = String::from_utf8_lossy(name);
        *list = CellList::read(file, statement, &name, self.has_offsets)?;
        self.cells_start = statement.start;
        Ok(())
    }

    fn read_about(
        &mut self,
        file: &File<'_>,
        statement: &mut Statement<'_>,
        section: Section,
        rows: usize,
    ) -> Result<(), ReadError> {
        let claimed: usize = statement.number(file, "the number of rows of data")?;
        if claimed != rows {
            let what = match section {
                Section::PointData => "points",
                _ => "cells",
            };
            let problem = ReadProblem::Count {
                what: format!("rows of data about {what}"),
                claimed: claimed as u64,
                found: rows as u64,
            };
            return Err(file.bytes.problem(statement.start, problem));
        }
        self.about = Some(About { section, rows });
        Ok(())
    }

    fn finish(mut self, file: &File<'_>) -> Result<Mesh, ReadError> {
        let Some(points) = self.points else {
            return Err(file.truncated(format_args!("POINTS")));
        };
        let types = self.types.take().unwrap_or_else(|| self.polydata_types());
        let mut all = CellList::default();
        for list in self.lists {
            all.append(list);
        }
        let cells = all.ends.len();
        for (name, values) in [
            ("connectivity", all.corners),
            ("offsets", all.ends),
            ("types", types),
        ] {
            self.arrays.push(Array {
                section: Section::Cells,
                name: name.into(),
                components: 1,
                numbers: Numbers::Integers(values),
            });
        }
        let piece = Piece {
            line: 0,
            points,
            cells,
            arrays: self.arrays,
        };
        let mut mesh = Mesh::default();
        let appended = piece.append_to(&mut mesh);
        appended.map_err(|problem| file.bytes.problem(self.cells_start, problem))?;
        mesh.check()?;
        Ok(mesh)
    }

    /// VTK's numbers of a vertex, a line and a polygon, as often as there are some.
    fn polydata_types(&self) -> Vec<i64> {
        if !self.is_polydata {
            return Vec::new();
        }
        let typed = [1, 3, 7].into_iter().zip(&self.lists);
        let types = typed.flat_map(|(number, list)| std::iter::repeat_n(number, list.ends.len()));
        types.collect()
    }
}
