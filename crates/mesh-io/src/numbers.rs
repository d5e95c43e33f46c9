//! Numbers of a file one after the other, from text or from little-endian binary, each with its place.

use std::fmt::Arguments;

use memchr::memchr;

use crate::error::{Place, ReadError, ReadProblem};

/// How the numbers of a file are written down.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Encoding {
    /// Decimal, between blanks.
    Ascii,
    /// Little-endian, IEEE 754; of what width is up to the format.
    Binary,
}

/// A file that is read number by number. Where a number is due, the caller says what it should be, for the error.
#[derive(Clone)]
pub(crate) struct Numbers<'a> {
    bytes: &'a [u8],
    at: usize,
    pub(crate) encoding: Encoding,
}

impl<'a> Numbers<'a> {
    pub(crate) const fn new(bytes: &'a [u8], encoding: Encoding) -> Self {
        Self {
            bytes,
            at: 0,
            encoding,
        }
    }

    /// Offset of the next byte.
    pub(crate) const fn at(&self) -> usize {
        self.at
    }

    /// Length of the whole file: words of a text, bytes of a binary file.
    pub(crate) fn length(&self) -> u128 {
        let is_blank = |&at: &usize| self.bytes.get(at).is_none_or(u8::is_ascii_whitespace);
        match self.encoding {
            Encoding::Binary => self.bytes.len() as u128,
            // Every word is followed by a blank or by the end of the file.
            Encoding::Ascii => (0..self.bytes.len())
                .filter(|at| !is_blank(at) && is_blank(&(at + 1)))
                .count() as u128,
        }
    }

    /// What has not been read yet.
    pub(crate) fn rest(&self) -> &'a [u8] {
        self.bytes.get(self.at..).unwrap_or_default()
    }

    /// Passes over bytes, at most to the end.
    pub(crate) fn skip(&mut self, count: usize) {
        self.at = self.at.saturating_add(count).min(self.bytes.len());
    }

    /// Room for as many elements as are announced, but for no more than the rest of the file can hold.
    pub(crate) fn room_for(&self, announced: u64, bytes_each: usize) -> usize {
        let possible = self.rest().len() / bytes_each.max(1);
        usize::try_from(announced).map_or(possible, |announced| announced.min(possible))
    }

    /// A problem at an offset: named by line in text, by byte in binary.
    pub(crate) fn problem(&self, at: usize, problem: impl Into<ReadProblem>) -> ReadError {
        let place = match self.encoding {
            Encoding::Ascii => Place::Line(line_of(self.bytes, at)),
            Encoding::Binary => Place::Byte(at),
        };
        ReadError {
            path: None,
            place,
            problem: problem.into(),
        }
    }

    /// A 32-bit integer.
    pub(crate) fn int(&mut self, expected: Arguments<'_>) -> Result<i32, ReadError> {
        match self.encoding {
            Encoding::Ascii => self.word_as(expected, |word| i32::try_from(integer(word)?).ok()),
            Encoding::Binary => self.array(expected).map(i32::from_le_bytes),
        }
    }

    /// A count or a tag that is not negative.
    pub(crate) fn size(&mut self, expected: Arguments<'_>) -> Result<u64, ReadError> {
        match self.encoding {
            Encoding::Ascii => self.word_as(expected, |word| u64::try_from(integer(word)?).ok()),
            Encoding::Binary => self.array(expected).map(u64::from_le_bytes),
        }
    }

    /// A 64-bit integer.
    pub(crate) fn long(&mut self, expected: Arguments<'_>) -> Result<i64, ReadError> {
        match self.encoding {
            Encoding::Ascii => self.word_as(expected, |word| i64::try_from(integer(word)?).ok()),
            Encoding::Binary => self.array(expected).map(i64::from_le_bytes),
        }
    }

    /// A double, perhaps infinite or NaN.
    pub(crate) fn real(&mut self, expected: Arguments<'_>) -> Result<f64, ReadError> {
        match self.encoding {
            Encoding::Ascii => self.word_as(expected, |word| {
                std::str::from_utf8(word).ok()?.parse().ok()
            }),
            Encoding::Binary => self.array(expected).map(f64::from_le_bytes),
        }
    }

    /// The next word of a text; `None` at the end of the file. Leaves `at` behind it.
    pub(crate) fn word(&mut self) -> Option<&'a [u8]> {
        self.skip_blanks();
        let rest = self.rest();
        let length = rest
            .iter()
            .position(u8::is_ascii_whitespace)
            .unwrap_or(rest.len());
        self.at += length;
        rest.get(..length).filter(|word| !word.is_empty())
    }

    /// Passes over the rest of a line, so that binary numbers can follow.
    pub(crate) fn end_line(&mut self) {
        let rest = self.rest();
        let length = memchr(b'\n', rest).map_or(rest.len(), |length| length + 1);
        self.skip(length);
    }

    /// The rest of a line, without blanks at its ends; `None` at the end of the file.
    pub(crate) fn line(&mut self) -> Option<&'a [u8]> {
        let rest = self.rest();
        if rest.is_empty() {
            return None;
        }
        self.end_line();
        let length = rest.len() - self.rest().len();
        rest.get(..length).map(<[u8]>::trim_ascii)
    }

    /// Passes over blanks and ends of lines.
    pub(crate) fn skip_blanks(&mut self) {
        let rest = self.rest();
        self.at += rest
            .iter()
            .position(|byte| !byte.is_ascii_whitespace())
            .unwrap_or(rest.len());
    }

    /// Passes over blanks where numbers stand between blanks, so that [`Numbers::at`] is the place of the next one.
    pub(crate) fn skip_blanks_in_text(&mut self) {
        if self.encoding == Encoding::Ascii {
            self.skip_blanks();
        }
    }

    fn word_as<T>(
        &mut self,
        expected: Arguments<'_>,
        parse: impl FnOnce(&[u8]) -> Option<T>,
    ) -> Result<T, ReadError> {
        let Some(word) = self.word() else {
            return Err(self.problem(
                self.at,
                ReadProblem::Truncated {
                    expected: expected.to_string(),
                },
            ));
        };
        parse(word).ok_or_else(|| {
            let problem = ReadProblem::Expected {
                expected: expected.to_string(),
                found: quoted(word),
            };
            self.problem(self.at - word.len(), problem)
        })
    }

    fn array<const N: usize>(&mut self, expected: Arguments<'_>) -> Result<[u8; N], ReadError> {
        let Some(&bytes) = self.rest().first_chunk() else {
            return Err(self.problem(
                self.at,
                ReadProblem::Truncated {
                    expected: expected.to_string(),
                },
            ));
        };
        self.at += N;
        Ok(bytes)
    }
}

/// A word of the file for a message, shortened and without control characters.
pub(crate) fn quoted(word: &[u8]) -> String {
    const SHOWN: usize = 24;
    let shown = word.get(..SHOWN).unwrap_or(word);
    let text: String = String::from_utf8_lossy(shown)
        .chars()
        .map(|c| {
            if c.is_control() {
                char::REPLACEMENT_CHARACTER
            } else {
                c
            }
        })
        .collect();
    let more = if word.len() > SHOWN { "…" } else { "" };
    format!("`{text}{more}`")
}

/// Number of the line that holds an offset, from 1.
fn line_of(bytes: &[u8], at: usize) -> usize {
    bytes.iter().take(at).filter(|&&byte| byte == b'\n').count() + 1
}

/// A decimal integer, wide enough for both `i32` and `u64`.
fn integer(word: &[u8]) -> Option<i128> {
    const MOST_DIGITS: usize = 20;
    let (negative, digits) = match word.split_first()? {
        (b'-', digits) => (true, digits),
        (b'+', digits) => (false, digits),
        _ => (false, word),
    };
    if digits.is_empty() || digits.len() > MOST_DIGITS {
        return None;
    }
    let mut value: i128 = 0;
    for digit in digits {
        value = value * 10 + i128::from(char::from(*digit).to_digit(10)?);
    }
    Some(if negative { -value } else { value })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_and_binary_give_the_same_numbers() {
        let mut text = Numbers::new(b" -7\n18446744073709551615 \t2.5e-3", Encoding::Ascii);
        let bytes = [
            &(-7i32).to_le_bytes()[..],
            &u64::MAX.to_le_bytes(),
            &2.5e-3f64.to_le_bytes(),
        ]
        .concat();
        let mut binary = Numbers::new(&bytes, Encoding::Binary);
        for numbers in [&mut text, &mut binary] {
            assert_eq!(numbers.int(format_args!("a")).unwrap(), -7);
            assert_eq!(numbers.size(format_args!("b")).unwrap(), u64::MAX);
            assert_eq!(numbers.real(format_args!("c")).unwrap(), 2.5e-3);
            assert!(numbers.rest().is_empty());
        }
    }

    #[test]
    fn what_is_not_the_number_due_is_named_with_its_place() {
        let problem = |text: &'static str, skip: usize| {
            let mut numbers = Numbers::new(text.as_bytes(), Encoding::Ascii);
            numbers.skip(skip);
            numbers.int(format_args!("the tag of node 3")).unwrap_err()
        };
        insta::assert_snapshot!(problem("1\n2\n12a", 3), @"line 3: expected the tag of node 3, found `12a`");
        insta::assert_snapshot!(problem("1\n4294967296", 1), @"line 2: expected the tag of node 3, found `4294967296`");
        insta::assert_snapshot!(problem("1\n \n", 1), @"line 3: the file ends where the tag of node 3 should follow");
        insta::assert_snapshot!(
            problem("1234567890123456789012345678901234567890", 0),
            @"line 1: expected the tag of node 3, found `123456789012345678901234…`"
        );
        insta::assert_snapshot!(
            Numbers::new(&[1, 2, 3], Encoding::Binary).int(format_args!("a tag")).unwrap_err(),
            @"byte 0: the file ends where a tag should follow"
        );
    }

    #[test]
    fn a_text_is_as_long_as_its_words_and_a_binary_file_as_its_bytes() {
        let length = |bytes: &'static [u8], encoding| Numbers::new(bytes, encoding).length();
        assert_eq!(length(b"", Encoding::Ascii), 0);
        assert_eq!(length(b" 1 22\n\n3", Encoding::Ascii), 3);
        assert_eq!(length(b"1 2 ", Encoding::Ascii), 2);
        assert_eq!(length(b"1 2 ", Encoding::Binary), 4);
    }

    #[test]
    fn room_is_bounded_by_what_follows() {
        let numbers = Numbers::new(&[0; 32], Encoding::Binary);
        assert_eq!(
            (
                numbers.room_for(u64::MAX, 8),
                numbers.room_for(3, 8),
                numbers.room_for(9, 0)
            ),
            (4, 3, 9)
        );
    }
}
