//! What follows the header of a PLY: numbers, one behind the other, as text or in bytes.

use std::fmt::Arguments;

use super::header::{Header, Kind, Property, Storage};
use super::number::Number;
use crate::error::{ReadError, ReadProblem};
use crate::numbers::{Encoding, Numbers, quoted};

/// The numbers that have not been read yet.
pub(super) struct Body<'a> {
    /// The whole file, for places; the encoding only says whether they are lines or bytes.
    numbers: Numbers<'a>,
    storage: Storage,
}

impl<'a> Body<'a> {
    pub(super) fn behind(header: &Header, file: &'a [u8]) -> Self {
        let encoding = match header.storage {
            Storage::Text => Encoding::Ascii,
            Storage::LittleEndian | Storage::BigEndian => Encoding::Binary,
        };
        let mut numbers = Numbers::new(file, encoding);
        numbers.skip(header.length);
        Self {
            numbers,
            storage: header.storage,
        }
    }

    /// Where the next number is.
    pub(super) fn at(&mut self) -> usize {
        self.numbers.skip_blanks_in_text();
        self.numbers.at()
    }

    /// Room for as many elements as are announced, but for no more than the rest of the file can hold.
    pub(super) fn room_for(&self, announced: u64, properties: &[Property]) -> usize {
        let width = |property: &Property| match (self.storage, property.kind) {
            // A digit and a blank.
            (Storage::Text, _) => 2,
            (_, Kind::Scalar(number) | Kind::List { count: number, .. }) => number.size(),
        };
        let each = properties.iter().map(width).sum();
        self.numbers.room_for(announced, each)
    }

    /// The next number.
    #[inline]
    pub(super) fn real(
        &mut self,
        number: Number,
        expected: Arguments<'_>,
    ) -> Result<f64, ReadError> {
        let big_endian = match self.storage {
            Storage::Text => return self.numbers.real(expected),
            Storage::LittleEndian => false,
            Storage::BigEndian => true,
        };
        let Some(value) = number.decode(self.numbers.rest(), big_endian) else {
            return Err(self.truncated(expected));
        };
        self.numbers.skip(number.size());
        Ok(value)
    }

    /// The next number, which counts something.
    pub(super) fn whole(
        &mut self,
        number: Number,
        expected: Arguments<'_>,
    ) -> Result<u64, ReadError> {
        let at = self.at();
        let value = self.real(number, expected)?;
        if value < 0.0 || value.fract() != 0.0 {
            let problem = ReadProblem::Expected {
                expected: expected.to_string(),
                found: quoted(value.to_string().as_bytes()),
            };
            return Err(self.problem(at, problem));
        }
        // What a double holds beyond 2^64 becomes the greatest count, and no file has so much.
        Ok(value as u64)
    }

    /// Passes over everything that is stored for one property of one element.
    pub(super) fn pass(&mut self, property: &Property, element: &str) -> Result<(), ReadError> {
        let name = &property.name;
        match property.kind {
            Kind::Scalar(number) => {
                self.pass_numbers(1, number, format_args!("{name} of a {element}"))
            }
            Kind::List { count, item } => {
                let length =
                    self.whole(count, format_args!("the length of {name} of a {element}"))?;
                self.pass_numbers(length, item, format_args!("{name} of a {element}"))
            }
        }
    }

    fn pass_numbers(
        &mut self,
        count: u64,
        number: Number,
        expected: Arguments<'_>,
    ) -> Result<(), ReadError> {
        if self.storage == Storage::Text {
            return (0..count).try_for_each(|_| self.numbers.real(expected).map(drop));
        }
        let length = usize::try_from(count)
            .ok()
            .and_then(|count| count.checked_mul(number.size()))
            .filter(|&length| length <= self.numbers.rest().len());
        let Some(length) = length else {
            return Err(self.truncated(expected));
        };
        self.numbers.skip(length);
        Ok(())
    }

    /// Refuses anything but blanks.
    pub(super) fn end(mut self) -> Result<(), ReadError> {
        self.numbers.skip_blanks();
        if self.numbers.rest().is_empty() {
            return Ok(());
        }
        let problem = ReadProblem::Expected {
            expected: "the end of the file".into(),
            found: format!("{} bytes more", self.numbers.rest().len()),
        };
        Err(self.problem(self.numbers.at(), problem))
    }

    fn truncated(&self, expected: Arguments<'_>) -> ReadError {
        let expected = expected.to_string();
        self.problem(self.numbers.at(), ReadProblem::Truncated { expected })
    }

    pub(super) fn problem(&self, at: usize, problem: ReadProblem) -> ReadError {
        self.numbers.problem(at, problem)
    }
}
