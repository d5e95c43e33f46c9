//! Writing: node counts, then coordinate after coordinate.

use std::io::{self, Write};

use crate::blocks::StructuredBlocks;
use crate::error::{WriteError, WriteProblem};
use crate::format::Format;
use crate::numbers::Encoding;

/// Writes blocks: planar when all of `z` is 0, otherwise in space with one layer of nodes. O(nodes).
///
/// # Errors
/// Blocks that contradict each other, more than 2^31 - 1 blocks or nodes along a side, and what `out` refuses.
pub fn write(
    out: &mut impl Write,
    blocks: &StructuredBlocks,
    encoding: Encoding,
) -> Result<(), WriteError> {
    blocks.check()?;
    let planar = blocks
        .blocks
        .iter()
        .flat_map(|block| &block.points)
        .all(|point| point[2] == 0.0);
    let mut out = Sink { out, encoding };
    out.counts(&[blocks.blocks.len()])?;
    for block in &blocks.blocks {
        let counts = [block.ni, block.nj, 1];
        out.counts(if planar { &counts[..2] } else { &counts })?;
    }
    for block in &blocks.blocks {
        for axis in 0..if planar { 2 } else { 3 } {
            // A row of nodes is a line, so that the text can be looked at.
            for row in block.points.chunks(block.ni) {
                out.coordinates(row.iter().map(|point| point[axis]))?;
            }
        }
    }
    Ok(())
}

struct Sink<'w, W> {
    out: &'w mut W,
    encoding: Encoding,
}

impl<W: Write> Sink<'_, W> {
    fn counts(&mut self, counts: &[usize]) -> Result<(), WriteError> {
        for (k, &count) in counts.iter().enumerate() {
            let count = i32::try_from(count).map_err(|_| too_many(self.encoding, count))?;
            match self.encoding {
                Encoding::Binary => self.out.write_all(&count.to_le_bytes())?,
                Encoding::Ascii => write!(self.out, "{}{count}", separator(k))?,
            }
        }
        Ok(self.end_row()?)
    }

    fn coordinates(&mut self, values: impl Iterator<Item = f64>) -> io::Result<()> {
        for (k, value) in values.enumerate() {
            match self.encoding {
                Encoding::Binary => self.out.write_all(&value.to_le_bytes())?,
                // The shortest form that reads back to the same double, with an exponent where it is long.
                Encoding::Ascii => write!(self.out, "{}{value:?}", separator(k))?,
            }
        }
        self.end_row()
    }

    fn end_row(&mut self) -> io::Result<()> {
        match self.encoding {
            Encoding::Binary => Ok(()),
            Encoding::Ascii => self.out.write_all(b"\n"),
        }
    }
}

const fn separator(position: usize) -> &'static str {
    if position == 0 { "" } else { " " }
}

fn too_many(encoding: Encoding, count: usize) -> WriteProblem {
    let format = match encoding {
        Encoding::Ascii => Format::Plot3dAscii,
        Encoding::Binary => Format::Plot3dBinary,
    };
    WriteProblem::Unsupported {
        format,
        what: format!("a count of {count}, only of 31 bits"),
    }
}
