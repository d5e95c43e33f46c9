//! Words one after the other, wherever lines end.

use std::fmt::Arguments;
use std::str::FromStr;

use crate::error::{ReadError, ReadProblem};
use crate::lines::{Line, Lines};

/// The words that have not been read yet.
pub(super) struct Tokens<'a> {
    lines: Lines<'a>,
    /// The line that was begun last.
    line: Option<Line<'a>>,
}

impl<'a> Tokens<'a> {
    pub(super) fn new(bytes: &'a [u8]) -> Result<Self, ReadError> {
        Ok(Self {
            lines: Lines::new(bytes)?,
            line: None,
        })
    }

    /// The line on which the next word stands.
    pub(super) fn line(&mut self, expected: Arguments<'_>) -> Result<&mut Line<'a>, ReadError> {
        let line = match self.line.take() {
            Some(line) if !line.is_done() => line,
            _ => self.lines.due(expected)?,
        };
        Ok(self.line.insert(line))
    }

    /// The next word as a number.
    pub(super) fn number<T: FromStr>(&mut self, expected: Arguments<'_>) -> Result<T, ReadError> {
        self.line(expected)?.number(expected)
    }

    /// The next word, which should be this.
    pub(super) fn keyword_due(&mut self, keyword: &str) -> Result<(), ReadError> {
        let expected = format_args!("the word {keyword}");
        let line = self.line(expected)?;
        match line.word() {
            Some(word) if word == keyword => Ok(()),
            word => Err(line.unexpected(expected, word.unwrap_or_default())),
        }
    }

    /// The next word, which should be the name of a section; `None` at the end of the file.
    pub(super) fn keyword(&mut self) -> Result<Option<&'a str>, ReadError> {
        if self.is_at_end() {
            return Ok(None);
        }
        let expected = format_args!("the name of a section");
        let line = self.line(expected)?;
        match line.word() {
            Some(word) if begins_section(word) => Ok(Some(word)),
            word => Err(line.unexpected(expected, word.unwrap_or_default())),
        }
    }

    /// Passes over words up to the next that can be the name of a section.
    pub(super) fn pass_to_keyword(&mut self) {
        loop {
            if let Some(line) = &mut self.line {
                while !line.is_done() {
                    if line.first_word().is_some_and(begins_section) {
                        return;
                    }
                    line.word();
                }
            }
            match self.lines.next() {
                Some(line) => self.line = Some(line),
                None => return,
            }
        }
    }

    /// Refuses a word that nothing asked for.
    pub(super) fn end(&mut self) -> Result<(), ReadError> {
        if let Some(line) = &mut self.line {
            line.end(format_args!("the word End"))?;
        }
        self.lines.end()
    }

    /// Refuses coordinates that are infinite or NaN.
    pub(super) fn finite(&self, index: usize, point: &[f64]) -> Result<(), ReadError> {
        let line = self.line.as_ref();
        line.map_or(Ok(()), |line| line.finite("point", index, point))
    }

    /// A problem on the line that was begun last.
    pub(super) fn problem(&self, problem: impl Into<ReadProblem>) -> ReadError {
        match &self.line {
            Some(line) => line.problem(problem),
            None => problem.into().into(),
        }
    }

    /// Room for as many elements as are announced, but for no more than the text can hold.
    pub(super) fn room_for(&self, announced: usize) -> usize {
        self.lines.room_for(announced)
    }

    fn is_at_end(&self) -> bool {
        self.line.as_ref().is_none_or(Line::is_done) && self.lines.is_at_end()
    }
}

fn begins_section(word: &str) -> bool {
    word.starts_with(|first: char| first.is_ascii_alphabetic())
}
