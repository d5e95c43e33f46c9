//! Lists of cells: `CELLS` of a grid, `VERTICES`, `LINES` and `POLYGONS` of polydata.

use super::numbers::{File, Statement};
use crate::error::{ReadError, ReadProblem};
use crate::vtu::number::Number;

/// The corners of all cells of a list, and where those of each end.
#[derive(Default)]
pub(super) struct CellList {
    pub(super) corners: Vec<i64>,
    pub(super) ends: Vec<i64>,
}

impl CellList {
    /// Reads a list, the first line of which is `statement` behind its first word; `name` is for messages.
    pub(super) fn read(
        file: &mut File<'_>,
        statement: &mut Statement<'_>,
        name: &str,
        has_offsets: bool,
    ) -> Result<Self, ReadError> {
        let count: usize = statement.number(file, "the number of cells")?;
        let size: usize = statement.number(file, "the number of integers of the cells")?;
        if has_offsets {
            Self::with_offsets(file, statement.start, name, (count, size))
        } else {
            Self::with_counts(file, statement.start, name, (count, size))
        }
    }

    /// Before version 5: the number of corners in front of those of each cell.
    fn with_counts(
        file: &mut File<'_>,
        start: usize,
        name: &str,
        (count, size): (usize, usize),
    ) -> Result<Self, ReadError> {
        let integers = file.integers(Number::I32, size, format_args!("{name}"))?;
        let mut list = Self::default();
        let mut rest = integers.as_slice();
        for index in 0..count {
            let cell = rest
                .split_first()
                .and_then(|(&corners, rest)| rest.split_at_checked(usize::try_from(corners).ok()?));
            let Some((corners, behind)) = cell else {
                let expected =
                    format!("the corners of cell {index} among the {size} integers of {name}");
                return Err(file
                    .bytes
                    .problem(start, ReadProblem::Truncated { expected }));
            };
            list.corners.extend(corners);
            list.ends.push(list.corners.len() as i64);
            rest = behind;
        }
        if rest.is_empty() {
            return Ok(list);
        }
        let problem = ReadProblem::Count {
            what: format!("integers of {name}"),
            claimed: size as u64,
            found: (size - rest.len()) as u64,
        };
        Err(file.bytes.problem(start, problem))
    }

    /// From version 5 on: where the corners of each cell begin and the last end, and the corners.
    fn with_offsets(
        file: &mut File<'_>,
        start: usize,
        name: &str,
        (offsets, corners): (usize, usize),
    ) -> Result<Self, ReadError> {
        let mut ends = Self::part(file, "OFFSETS", name, offsets)?;
        let corners = Self::part(file, "CONNECTIVITY", name, corners)?;
        if let Some(&first) = ends.first() {
            if first != 0 {
                let problem = ReadProblem::Expected {
                    expected: format!("0 as the first offset of {name}"),
                    found: first.to_string(),
                };
                return Err(file.bytes.problem(start, problem));
            }
            ends.remove(0);
        }
        // What would lie behind the corners of the last cell would become those of the next list.
        if ends.last().map_or(0, |&end| end) != corners.len() as i64 {
            let problem = ReadProblem::Count {
                what: format!("corners of {name}"),
                claimed: corners.len() as u64,
                found: ends.last().map_or(0, |&end| end.unsigned_abs()),
            };
            return Err(file.bytes.problem(start, problem));
        }
        Ok(Self { corners, ends })
    }

    fn part(
        file: &mut File<'_>,
        part: &str,
        name: &str,
        count: usize,
    ) -> Result<Vec<i64>, ReadError> {
        match file.optional(part) {
            Some(mut statement) => {
                let number = statement.number_type(file)?;
                file.integers(number, count, format_args!("{part} of {name}"))
            }
            // Some writers leave out what is empty.
            None if count == 0 => Ok(Vec::new()),
            None => {
                let expected = format!("{part} of {name}");
                let mut found = file.due(format_args!("{expected}"))?;
                let word = found.word().unwrap_or_default();
                Err(found.unexpected(file, &expected, word))
            }
        }
    }

    /// Appends another list behind this one.
    pub(super) fn append(&mut self, other: Self) {
        let before = self.corners.len() as i64;
        self.corners.extend(other.corners);
        let ends = other.ends.into_iter();
        self.ends.extend(ends.map(|end| end.saturating_add(before)));
    }
}
