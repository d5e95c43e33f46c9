//! What files are written with: numbers in either encoding, and lines of text.

use std::io::{self, Write};

use crate::numbers::Encoding;

/// Numbers to a stream, in either encoding.
pub(super) struct Sink<'w, W> {
    out: &'w mut W,
    encoding: Encoding,
    line_started: bool,
}

impl<'w, W: Write> Sink<'w, W> {
    pub(super) const fn new(out: &'w mut W, encoding: Encoding) -> Self {
        Self {
            out,
            encoding,
            line_started: false,
        }
    }

    pub(super) fn int(&mut self, value: i32) -> io::Result<()> {
        self.integer(value, &value.to_le_bytes())
    }

    pub(super) fn size(&mut self, value: usize) -> io::Result<()> {
        let value = value as u64;
        self.integer(value, &value.to_le_bytes())
    }

    fn integer(&mut self, value: impl itoa::Integer, bytes: &[u8]) -> io::Result<()> {
        if self.encoding == Encoding::Binary {
            return self.out.write_all(bytes);
        }
        self.separate()?;
        // Nearly all of a file are integers: with the formatter of the standard library it takes a third longer.
        self.out
            .write_all(itoa::Buffer::new().format(value).as_bytes())
    }

    /// The debug form is the shortest that reads back to the same double, with an exponent where it is long.
    pub(super) fn real(&mut self, value: f64) -> io::Result<()> {
        if self.encoding == Encoding::Binary {
            return self.out.write_all(&value.to_le_bytes());
        }
        self.separate()?;
        write!(self.out, "{value:?}")
    }

    /// A blank between the numbers of a line.
    fn separate(&mut self) -> io::Result<()> {
        if std::mem::replace(&mut self.line_started, true) {
            self.out.write_all(b" ")?;
        }
        Ok(())
    }

    /// Ends a line of numbers, which binary does not have.
    pub(super) fn end_row(&mut self) -> io::Result<()> {
        self.line_started = false;
        match self.encoding {
            Encoding::Ascii => self.out.write_all(b"\n"),
            Encoding::Binary => Ok(()),
        }
    }

    /// A line of text in either encoding.
    pub(super) fn line(&mut self, text: std::fmt::Arguments<'_>) -> io::Result<()> {
        self.out.write_fmt(text)?;
        self.out.write_all(b"\n")
    }

    /// `$EndName`, on a line of its own after binary numbers too.
    pub(super) fn end_section(&mut self, name: &str) -> io::Result<()> {
        if self.encoding == Encoding::Binary {
            self.out.write_all(b"\n")?;
        }
        self.line(format_args!("$End{name}"))
    }

    /// The section that every file begins with.
    pub(super) fn format(&mut self, version: &str) -> io::Result<()> {
        self.line(format_args!("$MeshFormat"))?;
        match self.encoding {
            Encoding::Ascii => self.line(format_args!("{version} 0 8\n$EndMeshFormat")),
            Encoding::Binary => {
                self.line(format_args!("{version} 1 8"))?;
                self.int(1)?;
                self.end_section("MeshFormat")
            }
        }
    }
}
