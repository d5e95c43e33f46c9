//! Text formats made of lines of words: the next line that says something, and the next word on it as a number.
//!
//! Only ASCII blanks separate words, so a line is cut byte by byte without decoding a character.

use std::fmt::Arguments;
use std::str::FromStr;

use memchr::memchr;

use crate::error::{ReadError, ReadProblem};
use crate::mesh::first_not_finite;

/// The lines of a text that are neither blank nor a comment.
pub(crate) struct Lines<'a> {
    rest: &'a str,
    /// Number of the line read last, from 1.
    last: usize,
    /// Number of bytes in the whole text.
    length: usize,
}

/// What stands on a line before the comment.
pub(crate) struct Line<'a> {
    /// From 1.
    pub(crate) number: usize,
    pub(crate) text: &'a str,
    words: Words<'a>,
}

impl<'a> Lines<'a> {
    /// The lines of a file in UTF-8, with or without byte order mark.
    pub(crate) fn new(bytes: &'a [u8]) -> Result<Self, ReadError> {
        let text = std::str::from_utf8(bytes)
            .map_err(|error| ReadError::at_byte(error.valid_up_to(), ReadProblem::NotText))?;
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        Ok(Self {
            rest: text,
            last: 0,
            length: text.len(),
        })
    }

    /// The next line; `None` at the end of the file.
    pub(crate) fn next(&mut self) -> Option<Line<'a>> {
        while !self.rest.is_empty() {
            let (line, rest) = cut(self.rest, b'\n');
            self.rest = rest;
            self.last += 1;
            let (said, _comment) = cut(line, b'#');
            let text = said.trim_ascii();
            if !text.is_empty() {
                return Some(Line {
                    number: self.last,
                    text,
                    words: Words(text),
                });
            }
        }
        None
    }

    /// Whether nothing but blanks and comments follows.
    pub(crate) fn is_at_end(&self) -> bool {
        let mut ahead = Self { ..*self };
        ahead.next().is_none()
    }

    /// The next line, which should hold what is expected.
    pub(crate) fn due(&mut self, expected: Arguments<'_>) -> Result<Line<'a>, ReadError> {
        let line = self.next();
        line.ok_or_else(|| {
            let expected = expected.to_string();
            ReadError::at_line(self.last.max(1), ReadProblem::Truncated { expected })
        })
    }

    /// Refuses a line that nothing asked for.
    pub(crate) fn end(&mut self) -> Result<(), ReadError> {
        self.next().map_or(Ok(()), |line| {
            Err(line.unexpected(format_args!("the end of the file"), line.text))
        })
    }

    /// Room for as many lines as are announced, but for no more than the text can hold.
    pub(crate) fn room_for(&self, announced: usize) -> usize {
        announced.min(self.length / 2)
    }
}

/// What stands before the first `mark`, and what stands behind it.
fn cut(text: &str, mark: u8) -> (&str, &str) {
    let (before, from_mark) = memchr(mark, text.as_bytes())
        .and_then(|at| text.split_at_checked(at))
        .unwrap_or((text, ""));
    (before, from_mark.get(1..).unwrap_or_default())
}

/// What stands between ASCII blanks.
struct Words<'a>(&'a str);

impl<'a> Iterator for Words<'a> {
    type Item = &'a str;

    fn next(&mut self) -> Option<&'a str> {
        let rest = self.0.trim_ascii_start();
        let length = rest.bytes().position(|byte| byte.is_ascii_whitespace());
        let (word, rest) = rest.split_at_checked(length.unwrap_or(rest.len()))?;
        self.0 = rest;
        (!word.is_empty()).then_some(word)
    }
}

impl<'a> Line<'a> {
    /// The next word, if any.
    pub(crate) fn word(&mut self) -> Option<&'a str> {
        self.words.next()
    }

    /// Whether no word is left.
    pub(crate) fn is_done(&self) -> bool {
        self.words.0.trim_ascii_start().is_empty()
    }

    /// The next word, which stays the next.
    pub(crate) fn first_word(&self) -> Option<&'a str> {
        Words(self.words.0).next()
    }

    /// The next word as a number (for a double: also infinite or NaN).
    pub(crate) fn number<T: FromStr>(&mut self, expected: Arguments<'_>) -> Result<T, ReadError> {
        match self.word() {
            Some(word) => word.parse().map_err(|_| self.unexpected(expected, word)),
            None => Err(self.problem(ReadProblem::Expected {
                expected: expected.to_string(),
                found: "the end of the line".into(),
            })),
        }
    }

    /// The next words as the coordinates of an element.
    pub(crate) fn coordinates<const N: usize>(
        &mut self,
        element: &'static str,
        index: usize,
    ) -> Result<[f64; N], ReadError> {
        let mut point = [0.0; N];
        for (coordinate, axis) in point.iter_mut().zip(crate::mesh::Axis::ALL) {
            *coordinate = self.number(format_args!("coordinate {axis} of {element} {index}"))?;
        }
        self.finite(element, index, &point)?;
        Ok(point)
    }

    /// Refuses coordinates that are infinite or NaN.
    pub(crate) fn finite(
        &self,
        element: &'static str,
        index: usize,
        point: &[f64],
    ) -> Result<(), ReadError> {
        first_not_finite(point).map_or(Ok(()), |(axis, value)| {
            Err(self.problem(ReadProblem::NotFinite {
                element,
                index,
                axis,
                value,
            }))
        })
    }

    /// Refuses a word that nothing asked for.
    pub(crate) fn end(&mut self, after: Arguments<'_>) -> Result<(), ReadError> {
        self.word().map_or(Ok(()), |word| {
            Err(self.unexpected(format_args!("nothing after {after}"), word))
        })
    }

    /// A problem on this line.
    pub(crate) fn problem(&self, problem: impl Into<ReadProblem>) -> ReadError {
        ReadError::at_line(self.number, problem)
    }

    /// Something else than expected on this line.
    pub(crate) fn unexpected(&self, expected: Arguments<'_>, found: &str) -> ReadError {
        self.problem(ReadProblem::Expected {
            expected: expected.to_string(),
            found: quoted(found),
        })
    }
}

/// A piece of the file for a message, shortened and without control characters.
pub(crate) fn quoted(found: &str) -> String {
    const SHOWN: usize = 24;
    let shown = found.chars().take(SHOWN).map(|c| {
        if c.is_control() {
            char::REPLACEMENT_CHARACTER
        } else {
            c
        }
    });
    let more = if found.chars().nth(SHOWN).is_some() {
        "…"
    } else {
        ""
    };
    format!("`{}{more}`", shown.collect::<String>())
}
