//! Bytes of an array behind their header, plain or compressed by zlib.

use std::borrow::Cow;
use std::io::Read as _;

use flate2::read::ZlibDecoder;

use super::budget::Budget;
use crate::error::ReadProblem;

/// Bytes that a block costs besides its content: even an empty one sets up a decoder.
const PER_BLOCK: usize = 4 << 10;

/// How the binary arrays of a file are laid out.
#[derive(Clone, Copy, Debug)]
pub(super) struct Layout {
    pub(super) big_endian: bool,
    pub(super) wide_header: bool,
    pub(super) compressed: bool,
}

impl Layout {
    /// Bytes of one number of a header.
    pub(super) const fn header_width(self) -> usize {
        if self.wide_header { 8 } else { 4 }
    }
}

/// The bytes of the array at the start of some bytes. What follows the array is ignored.
///
/// # Errors
/// A header that claims more than there is, blocks that are no zlib or have another size than announced, an empty budget.
pub(super) fn unpack<'a>(
    layout: Layout,
    bytes: &'a [u8],
    budget: &mut Budget,
) -> Result<Cow<'a, [u8]>, ReadProblem> {
    if layout.compressed {
        return inflate(layout, bytes, budget).map(Cow::Owned);
    }
    let (size, data) = header(layout, bytes)?;
    let data = data.get(..size);
    data.map(Cow::Borrowed)
        .ok_or_else(|| ended("the bytes that the header announces"))
}

/// The blocks behind a header of block count, block size, size of the last block, and compressed sizes.
fn inflate(layout: Layout, bytes: &[u8], budget: &mut Budget) -> Result<Vec<u8>, ReadProblem> {
    let (block_count, rest) = header(layout, bytes)?;
    if block_count == 0 {
        return Ok(Vec::new());
    }
    let (block_size, rest) = header(layout, rest)?;
    let (last_size, rest) = header(layout, rest)?;
    let (mut sizes, mut data) = block_count
        .checked_mul(layout.header_width())
        .and_then(|length| rest.split_at_checked(length))
        .ok_or_else(|| ended("the sizes of the compressed blocks"))?;
    budget.spend(block_count.saturating_mul(PER_BLOCK))?;
    let mut inflated = Vec::new();
    for block in 0..block_count {
        let (compressed_size, rest) = header(layout, sizes)?;
        sizes = rest;
        let (compressed, rest) = data
            .split_at_checked(compressed_size)
            .ok_or_else(|| ended("a compressed block"))?;
        data = rest;
        let is_short = block + 1 == block_count && last_size != 0;
        let size = if is_short { last_size } else { block_size };
        budget.spend(size)?;
        inflate_block(block, compressed, size, &mut inflated)?;
    }
    Ok(inflated)
}

/// Appends what zlib unpacks from one block, which must be `size` bytes.
fn inflate_block(
    block: usize,
    compressed: &[u8],
    size: usize,
    inflated: &mut Vec<u8>,
) -> Result<(), ReadProblem> {
    let before = inflated.len();
    let stream = ZlibDecoder::new(compressed)
        .take(size as u64)
        .read_to_end(inflated);
    let found = inflated.len() - before;
    if stream.is_err() || found != size {
        return Err(ReadProblem::Count {
            what: format!("bytes in compressed block {block}"),
            claimed: size as u64,
            found: found as u64,
        });
    }
    Ok(())
}

/// The number at the start of a header, and what follows it.
fn header(layout: Layout, bytes: &[u8]) -> Result<(usize, &[u8]), ReadProblem> {
    let (word, rest) = bytes
        .split_at_checked(layout.header_width())
        .ok_or_else(|| ended("a header"))?;
    let size = unsigned(word, layout.big_endian);
    Ok((usize::try_from(size).unwrap_or(usize::MAX), rest))
}

/// At most eight bytes as an unsigned integer.
pub(super) fn unsigned(bytes: &[u8], big_endian: bool) -> u64 {
    let append = |value: u64, &byte: &u8| value << 8 | u64::from(byte);
    if big_endian {
        bytes.iter().fold(0, append)
    } else {
        bytes.iter().rev().fold(0, append)
    }
}

pub(super) fn ended(expected: &str) -> ReadProblem {
    ReadProblem::Truncated {
        expected: expected.into(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::io::Write as _;

    const PLAIN: Layout = Layout {
        big_endian: false,
        wide_header: false,
        compressed: false,
    };
    const ZLIB: Layout = Layout {
        compressed: true,
        ..PLAIN
    };

    fn zip(data: &[u8]) -> Vec<u8> {
        let mut encoder =
            flate2::write::ZlibEncoder::new(Vec::new(), flate2::Compression::default());
        encoder.write_all(data).unwrap();
        encoder.finish().unwrap()
    }

    fn words(words: &[usize]) -> Vec<u8> {
        words
            .iter()
            .flat_map(|&word| (word as u32).to_le_bytes())
            .collect()
    }

    #[test]
    fn a_header_that_claims_more_than_there_is_allocates_nothing() {
        let bytes = [255, 255, 255, 255, 0, 0];
        let error = unpack(PLAIN, &bytes, &mut Budget::of_file(0)).unwrap_err();
        insta::assert_snapshot!(error, @"the file ends where the bytes that the header announces should follow");
    }

    #[test]
    fn compressed_blocks_are_joined() {
        let (one, two) = (zip(&[1, 2, 3]), zip(&[4]));
        let bytes = [words(&[2, 3, 1, one.len(), two.len()]), one, two].concat();
        let unpacked = unpack(ZLIB, &bytes, &mut Budget::of_file(bytes.len())).unwrap();
        assert_eq!(*unpacked, [1, 2, 3, 4]);
    }

    #[test]
    fn blocks_that_swell_beyond_the_budget_are_refused() {
        let block = zip(&vec![0; 1 << 20]);
        let header = [vec![100, 1 << 20, 1 << 20], vec![block.len(); 100]].concat();
        let bytes = [words(&header), block.repeat(100)].concat();
        let error = unpack(ZLIB, &bytes, &mut Budget::of_file(0)).unwrap_err();
        insta::assert_snapshot!(error, @"the arrays unpack to more than 67108864 bytes, the most for a file of this size");
    }

    #[test]
    fn blocks_of_nothing_are_paid_for() {
        let bytes = words(&[vec![1000, 0, 0], vec![0; 1000]].concat());
        let mut budget = Budget::of_file(0);
        let accepted = (0..1000).take_while(|_| unpack(ZLIB, &bytes, &mut budget).is_ok());
        assert_eq!(accepted.count(), (64 << 20) / (1000 * PER_BLOCK));
    }
}
