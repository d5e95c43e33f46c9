//! The header of a PLY: which elements follow, how many, and what is stored of each.

use std::str::{FromStr, SplitAsciiWhitespace};

use memchr::memchr;

use super::number::Number;
use crate::error::{ReadError, ReadProblem};
use crate::lines::quoted;

/// What stands before `end_header`, and where the elements begin.
#[derive(Debug)]
pub(super) struct Header {
    pub(super) storage: Storage,
    pub(super) elements: Vec<Element>,
    /// Bytes up to the end of the line `end_header`.
    pub(super) length: usize,
}

/// How numbers are stored.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Storage {
    Text,
    LittleEndian,
    BigEndian,
}

/// A run of equal things.
#[derive(Debug)]
pub(super) struct Element {
    pub(super) name: String,
    pub(super) count: u64,
    pub(super) properties: Vec<Property>,
}

/// What is stored of an element.
#[derive(Debug)]
pub(super) struct Property {
    pub(super) name: String,
    pub(super) kind: Kind,
}

/// One number, or a count and as many numbers.
#[derive(Clone, Copy, Debug)]
pub(super) enum Kind {
    Scalar(Number),
    List { count: Number, item: Number },
}

impl Header {
    /// Reads the header at the start of a file.
    pub(super) fn parse(bytes: &[u8]) -> Result<Self, ReadError> {
        let mut lines = HeaderLines {
            bytes,
            at: 0,
            line: 0,
        };
        let first = lines.next("the word ply")?;
        if first != "ply" {
            return Err(lines.unexpected("the word ply", first));
        }
        let storage = storage(&mut lines)?;
        let mut elements: Vec<Element> = Vec::new();
        loop {
            let text = lines.next("the word end_header")?;
            let mut words = text.split_ascii_whitespace();
            match words.next() {
                Some("end_header") => break,
                None | Some("comment" | "obj_info") => {}
                Some("element") => elements.push(element(&lines, words)?),
                Some("property") => {
                    let property = property(&lines, words)?;
                    let of = elements.last_mut();
                    let of = of.ok_or_else(|| lines.unexpected("an element first", text))?;
                    of.properties.push(property);
                }
                Some(word) => return Err(lines.unexpected("element, property or end_header", word)),
            }
        }
        Ok(Self {
            storage,
            elements,
            length: lines.at,
        })
    }
}

fn storage(lines: &mut HeaderLines<'_>) -> Result<Storage, ReadError> {
    let text = loop {
        let text = lines.next("the format")?;
        if !matches!(first_word(text), None | Some("comment" | "obj_info")) {
            break text;
        }
    };
    let mut words = text.split_ascii_whitespace();
    match (words.next(), words.next(), words.next()) {
        (Some("format"), Some("ascii"), Some("1.0")) => Ok(Storage::Text),
        (Some("format"), Some("binary_little_endian"), Some("1.0")) => Ok(Storage::LittleEndian),
        (Some("format"), Some("binary_big_endian"), Some("1.0")) => Ok(Storage::BigEndian),
        (Some("format"), ..) => Err(lines.unexpected("a format of version 1.0", text)),
        _ => Err(lines.unexpected("the format", text)),
    }
}

fn first_word(text: &str) -> Option<&str> {
    text.split_ascii_whitespace().next()
}

fn element(
    lines: &HeaderLines<'_>,
    mut words: SplitAsciiWhitespace<'_>,
) -> Result<Element, ReadError> {
    let name = lines.word(words.next(), "the name of an element")?;
    let count = lines.parsed(words.next(), "the number of elements")?;
    Ok(Element {
        name: name.to_owned(),
        count,
        properties: Vec::new(),
    })
}

fn property(
    lines: &HeaderLines<'_>,
    mut words: SplitAsciiWhitespace<'_>,
) -> Result<Property, ReadError> {
    let first = lines.word(words.next(), "the type of a property")?;
    let kind = if first == "list" {
        let count = lines.number(words.next(), "the type of the length of a list")?;
        if !count.is_integer() {
            return Err(lines.unexpected("an integer as the length of a list", "a real number"));
        }
        let item = lines.number(words.next(), "the type of the items of a list")?;
        Kind::List { count, item }
    } else {
        Kind::Scalar(lines.number(Some(first), "the type of a property")?)
    };
    let name = lines.word(words.next(), "the name of a property")?;
    Ok(Property {
        name: name.to_owned(),
        kind,
    })
}

/// The lines of the header, one after the other.
struct HeaderLines<'a> {
    bytes: &'a [u8],
    at: usize,
    /// Number of the line read last, from 1.
    line: usize,
}

impl<'a> HeaderLines<'a> {
    fn next(&mut self, expected: &str) -> Result<&'a str, ReadError> {
        let rest = self.bytes.get(self.at..).unwrap_or_default();
        self.line += 1;
        let Some(length) = memchr(b'\n', rest) else {
            let expected = expected.to_owned();
            return Err(self.problem(ReadProblem::Truncated { expected }));
        };
        self.at += length + 1;
        let line = rest.get(..length).unwrap_or_default();
        let text = std::str::from_utf8(line).map_err(|_| self.problem(ReadProblem::NotText))?;
        Ok(text.trim_ascii())
    }

    fn word<'w>(&self, word: Option<&'w str>, expected: &str) -> Result<&'w str, ReadError> {
        word.ok_or_else(|| self.unexpected(expected, ""))
    }

    fn parsed<T: FromStr>(&self, word: Option<&str>, expected: &str) -> Result<T, ReadError> {
        let word = self.word(word, expected)?;
        word.parse().map_err(|_| self.unexpected(expected, word))
    }

    fn number(&self, word: Option<&str>, expected: &str) -> Result<Number, ReadError> {
        let word = self.word(word, expected)?;
        Number::from_name(word).ok_or_else(|| self.unexpected(expected, word))
    }

    fn unexpected(&self, expected: &str, found: &str) -> ReadError {
        let found = match found {
            "" => "the end of the line".to_owned(),
            found => quoted(found),
        };
        let expected = expected.to_owned();
        self.problem(ReadProblem::Expected { expected, found })
    }

    fn problem(&self, problem: ReadProblem) -> ReadError {
        ReadError::at_line(self.line, problem)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn error(text: &str) -> String {
        Header::parse(text.as_bytes()).unwrap_err().to_string()
    }

    #[test]
    fn elements_and_properties_are_listed_in_order() {
        let text = "ply\r\ncomment made by hand\r\nformat binary_big_endian 1.0\nobj_info x\nelement face 7\n\
                    property list uchar int vertex_indices\nelement vertex 2\nproperty double x\nend_header\n";
        let header = Header::parse(text.as_bytes()).unwrap();
        assert_eq!(header.storage, Storage::BigEndian);
        assert_eq!(header.length, text.len());
        let names: Vec<_> = header
            .elements
            .iter()
            .map(|element| (element.name.as_str(), element.count))
            .collect();
        assert_eq!(names, [("face", 7), ("vertex", 2)]);
        assert_eq!(header.elements[1].properties[0].name, "x");
    }

    #[test]
    fn errors_name_the_line() {
        insta::assert_snapshot!(error(""), @"line 1: the file ends where the word ply should follow");
        insta::assert_snapshot!(error("PLY\n"), @"line 1: expected the word ply, found `PLY`");
        insta::assert_snapshot!(error("ply\nelement vertex 3\n"), @"line 2: expected the format, found `element vertex 3`");
        insta::assert_snapshot!(error("ply\nformat ascii 2.0\n"), @"line 2: expected a format of version 1.0, found `format ascii 2.0`");
        let after = |text: &str| error(&format!("ply\nformat ascii 1.0\n{text}\n"));
        insta::assert_snapshot!(after("element vertex"), @"line 3: expected the number of elements, found the end of the line");
        insta::assert_snapshot!(after("element vertex -1"), @"line 3: expected the number of elements, found `-1`");
        insta::assert_snapshot!(after("property float x"), @"line 3: expected an element first, found `property float x`");
        insta::assert_snapshot!(after("element v 1\nproperty int128 x"), @"line 4: expected the type of a property, found `int128`");
        insta::assert_snapshot!(after("element v 1\nproperty list float int x"), @"line 4: expected an integer as the length of a list, found `a real number`");
        insta::assert_snapshot!(after("element v 1\nproperty float"), @"line 4: expected the name of a property, found the end of the line");
        insta::assert_snapshot!(after("elephant"), @"line 3: expected element, property or end_header, found `elephant`");
        insta::assert_snapshot!(after("element v 1"), @"line 4: the file ends where the word end_header should follow");
        insta::assert_snapshot!(Header::parse(b"ply\n\xff\n").unwrap_err(), @"line 2: not text in UTF-8");
    }
}
