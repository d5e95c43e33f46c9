//! Arrays of numbers, and the lines between them.

use std::fmt::Arguments;
use std::str::FromStr;

use crate::error::{ReadError, ReadProblem};
use crate::numbers::{Encoding, Numbers as Bytes, quoted};
use crate::vtu::budget::Budget;
use crate::vtu::number::{Number, Numbers, from_bytes};

/// What has not been read yet.
pub(super) struct File<'a> {
    pub(super) bytes: Bytes<'a>,
    pub(super) budget: Budget,
}

impl<'a> File<'a> {
    /// The words of the next line that is not blank; `None` at the end of the file.
    pub(super) fn statement(&mut self) -> Option<Statement<'a>> {
        self.bytes.skip_blanks();
        let start = self.bytes.at();
        let text = self.bytes.line()?;
        Some(Statement { start, rest: text })
    }

    /// The next line, which should say this.
    pub(super) fn due(&mut self, expected: Arguments<'_>) -> Result<Statement<'a>, ReadError> {
        let statement = self.statement();
        statement.ok_or_else(|| self.truncated(expected))
    }

    /// The next line, if its first word is this; else it stays the next.
    pub(super) fn optional(&mut self, word: &str) -> Option<Statement<'a>> {
        let before = self.bytes.clone();
        let mut statement = self.statement()?;
        if statement
            .word()
            .is_some_and(|found| found.eq_ignore_ascii_case(word.as_bytes()))
        {
            return Some(statement);
        }
        self.bytes = before;
        None
    }

    /// So many numbers.
    pub(super) fn array(
        &mut self,
        number: Number,
        (rows, components): (usize, usize),
        what: Arguments<'_>,
    ) -> Result<Numbers, ReadError> {
        let Some(count) = rows.checked_mul(components) else {
            return Err(self.truncated(what));
        };
        match (self.bytes.encoding, number) {
            (Encoding::Ascii, Number::F32 | Number::F64) => {
                let mut values = Vec::new();
                for index in 0..count {
                    values.push(self.bytes.real(format_args!("number {index} of {what}"))?);
                }
                Ok(Numbers::Reals(values))
            }
            (Encoding::Ascii, _) => {
                let mut values = Vec::new();
                for index in 0..count {
                    values.push(self.bytes.long(format_args!("number {index} of {what}"))?);
                }
                Ok(Numbers::Integers(values))
            }
            (Encoding::Binary, _) => {
                let length = count.checked_mul(number.size());
                let Some(bytes) = length.and_then(|length| self.bytes.rest().get(..length)) else {
                    return Err(self.truncated(what));
                };
                let start = self.bytes.at();
                self.bytes.skip(bytes.len());
                from_bytes(number, true, bytes, &mut self.budget)
                    .map_err(|problem| self.bytes.problem(start, problem))
            }
        }
    }

    /// So many integers.
    pub(super) fn integers(
        &mut self,
        number: Number,
        count: usize,
        what: Arguments<'_>,
    ) -> Result<Vec<i64>, ReadError> {
        let start = self.bytes.at();
        match self.array(number, (count, 1), what)? {
            Numbers::Integers(values) => Ok(values),
            Numbers::Reals(values) if values.is_empty() => Ok(Vec::new()),
            Numbers::Reals(_) => {
                let problem = ReadProblem::Expected {
                    expected: format!("integers as {what}"),
                    found: "floating-point numbers".into(),
                };
                Err(self.bytes.problem(start, problem))
            }
        }
    }

    pub(super) fn truncated(&self, expected: Arguments<'_>) -> ReadError {
        let expected = expected.to_string();
        let problem = ReadProblem::Truncated { expected };
        self.bytes.problem(self.bytes.at(), problem)
    }
}

/// A line of words, and where it stands.
pub(super) struct Statement<'a> {
    pub(super) start: usize,
    rest: &'a [u8],
}

impl<'a> Statement<'a> {
    /// The next word, if any.
    pub(super) fn word(&mut self) -> Option<&'a [u8]> {
        let text = self.rest.trim_ascii_start();
        let length = text.iter().position(u8::is_ascii_whitespace);
        let (word, rest) = text.split_at_checked(length.unwrap_or(text.len()))?;
        self.rest = rest;
        (!word.is_empty()).then_some(word)
    }

    /// The next word, which should be there.
    pub(super) fn due(&mut self, file: &File<'_>, expected: &str) -> Result<&'a [u8], ReadError> {
        let word = self.word();
        word.ok_or_else(|| self.unexpected(file, expected, b""))
    }

    /// The next word as a number.
    pub(super) fn number<T: FromStr>(
        &mut self,
        file: &File<'_>,
        expected: &str,
    ) -> Result<T, ReadError> {
        let word = self.due(file, expected)?;
        let number = std::str::from_utf8(word)
            .ok()
            .and_then(|word| word.parse().ok());
        number.ok_or_else(|| self.unexpected(file, expected, word))
    }

    /// The next word as the type of numbers.
    pub(super) fn number_type(&mut self, file: &File<'_>) -> Result<Number, ReadError> {
        let word = self.due(file, "the type of numbers")?;
        number_type(&word.to_ascii_lowercase()).ok_or_else(|| {
            let what = format!("VTK data of type {}", quoted(word));
            file.bytes
                .problem(self.start, ReadProblem::Unsupported(what))
        })
    }

    pub(super) fn unexpected(&self, file: &File<'_>, expected: &str, found: &[u8]) -> ReadError {
        let found = match found {
            b"" => "the end of the line".to_owned(),
            found => quoted(found),
        };
        let expected = expected.to_owned();
        file.bytes
            .problem(self.start, ReadProblem::Expected { expected, found })
    }
}

fn number_type(name: &[u8]) -> Option<Number> {
    Some(match name {
        b"char" | b"signed_char" | b"vtktypeint8" => Number::I8,
        b"unsigned_char" | b"vtktypeuint8" => Number::U8,
        b"short" | b"vtktypeint16" => Number::I16,
        b"unsigned_short" | b"vtktypeuint16" => Number::U16,
        // VTK writes its indices in 32 bits where it calls them so.
        b"int" | b"vtkidtype" | b"vtktypeint32" => Number::I32,
        b"unsigned_int" | b"vtktypeuint32" => Number::U32,
        b"long" | b"long_long" | b"vtktypeint64" => Number::I64,
        b"unsigned_long" | b"unsigned_long_long" | b"vtktypeuint64" => Number::U64,
        b"float" => Number::F32,
        b"double" => Number::F64,
        _ => return None,
    })
}
