//! Numbers of a `DataArray`: text or bytes, decoded into one of two lists.

use std::io::Read as _;

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use flate2::read::ZlibDecoder;

use crate::error::ReadProblem;
use crate::lines::quoted;

/// The number types of VTK.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Number {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    I64,
    U64,
    F32,
    F64,
}

impl Number {
    pub(super) fn from_name(name: &str) -> Option<Self> {
        Some(match name {
            "Int8" => Self::I8,
            "UInt8" => Self::U8,
            "Int16" => Self::I16,
            "UInt16" => Self::U16,
            "Int32" => Self::I32,
            "UInt32" => Self::U32,
            "Int64" => Self::I64,
            "UInt64" => Self::U64,
            "Float32" => Self::F32,
            "Float64" => Self::F64,
            _ => return None,
        })
    }

    const fn size(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::I32 | Self::U32 | Self::F32 => 4,
            Self::I64 | Self::U64 | Self::F64 => 8,
        }
    }

    const fn is_integer(self) -> bool {
        !matches!(self, Self::F32 | Self::F64)
    }

    const fn is_signed(self) -> bool {
        matches!(self, Self::I8 | Self::I16 | Self::I32 | Self::I64)
    }
}

/// Decoded numbers. Integers are kept apart because indices must be exact.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Numbers {
    Integers(Vec<i64>),
    Reals(Vec<f64>),
}

impl Numbers {
    pub(super) const fn len(&self) -> usize {
        match self {
            Self::Integers(values) => values.len(),
            Self::Reals(values) => values.len(),
        }
    }

    pub(super) fn into_reals(self) -> Vec<f64> {
        match self {
            Self::Integers(values) => values.into_iter().map(|value| value as f64).collect(),
            Self::Reals(values) => values,
        }
    }
}

/// How the binary arrays of a file are laid out.
#[derive(Clone, Copy, Debug)]
pub(super) struct Layout {
    pub(super) big_endian: bool,
    pub(super) wide_header: bool,
    pub(super) compressed: bool,
}

/// Numbers separated by white space.
pub(super) fn from_text(number: Number, text: &str) -> Result<Numbers, ReadProblem> {
    let words = text.split_ascii_whitespace();
    let bad = |word: &str| ReadProblem::Expected {
        expected: "a number".into(),
        found: quoted(word),
    };
    if number.is_integer() {
        words
            .map(|word| word.parse().map_err(|_| bad(word)))
            .collect::<Result<_, _>>()
            .map(Numbers::Integers)
    } else {
        words
            .map(|word| word.parse().map_err(|_| bad(word)))
            .collect::<Result<_, _>>()
            .map(Numbers::Reals)
    }
}

/// Numbers behind a header, in base64. What follows the array (in appended data) is ignored.
pub(super) fn from_base64(
    number: Number,
    layout: Layout,
    text: &[u8],
) -> Result<Numbers, ReadProblem> {
    from_bytes(number, layout, &decode_base64(text)?)
}

/// Numbers behind a header. What follows the array is ignored.
pub(super) fn from_bytes(
    number: Number,
    layout: Layout,
    bytes: &[u8],
) -> Result<Numbers, ReadProblem> {
    if layout.compressed {
        return Ok(numbers(number, layout, &inflate(layout, bytes)?));
    }
    let (size, data) = header(layout, bytes)?;
    let data = data
        .get(..size)
        .ok_or_else(|| ended("the bytes that the header announces"))?;
    Ok(numbers(number, layout, data))
}

/// Decodes runs of base64 set one after the other, each with its own padding, up to anything that is none.
fn decode_base64(text: &[u8]) -> Result<Vec<u8>, ReadProblem> {
    let in_alphabet =
        |byte: &u8| byte.is_ascii_alphanumeric() || matches!(byte, b'+' | b'/' | b'=');
    let text: Vec<u8> = text
        .iter()
        .copied()
        .filter(|byte| !byte.is_ascii_whitespace())
        .take_while(in_alphabet)
        .collect();
    let mut bytes = Vec::with_capacity(text.len() / 4 * 3);
    let mut rest = text.as_slice();
    while !rest.is_empty() {
        let padding = rest
            .iter()
            .position(|&byte| byte == b'=')
            .unwrap_or(rest.len());
        let run = padding.next_multiple_of(4).min(rest.len());
        let (run, tail) = rest.split_at(run);
        STANDARD
            .decode_vec(run, &mut bytes)
            .map_err(|error| ReadProblem::Expected {
                expected: "base64".into(),
                found: error.to_string(),
            })?;
        // Only a run that fills its last four letters can be followed by another.
        rest = tail;
        if run.is_empty() {
            return Err(ReadProblem::Expected {
                expected: "base64".into(),
                found: "=".into(),
            });
        }
    }
    Ok(bytes)
}

/// The letters of the appended array at the start of `text`: as many as its header says.
///
/// Arrays follow each other without a mark between them, and an array whose bytes are a multiple of three has no
/// padding, so the length has to be computed.
pub(super) fn appended_run(layout: Layout, text: &[u8]) -> Result<&[u8], ReadProblem> {
    let letters = |bytes: usize| bytes.div_ceil(3).saturating_mul(4);
    let width = if layout.wide_header { 8 } else { 4 };
    let decode = |bytes: usize| {
        let run = text
            .get(..letters(bytes))
            .ok_or_else(|| ended("a header"))?;
        decode_base64(run)
    };
    let (first, _) = header(layout, &decode(width)?).map(|(size, rest)| (size, rest.len()))?;
    let length = if layout.compressed {
        let header_size = first.saturating_add(3).saturating_mul(width);
        let head = decode(header_size)?;
        let sizes = head
            .get(3 * width..header_size)
            .ok_or_else(|| ended("the sizes of the compressed blocks"))?;
        let sum = sizes
            .chunks_exact(width)
            .map(|word| unsigned(word, layout.big_endian))
            .fold(0, u64::saturating_add);
        letters(header_size).saturating_add(letters(usize::try_from(sum).unwrap_or(usize::MAX)))
    } else {
        letters(width.saturating_add(first))
    };
    // A header with its own padding is longer by at most four letters; the decoder ignores what it does not need.
    Ok(&text[..length.min(text.len())])
}

fn header(layout: Layout, bytes: &[u8]) -> Result<(usize, &[u8]), ReadProblem> {
    let width = if layout.wide_header { 8 } else { 4 };
    let Some((word, rest)) = bytes.split_at_checked(width) else {
        return Err(ended("a header"));
    };
    let size = unsigned(word, layout.big_endian);
    Ok((usize::try_from(size).unwrap_or(usize::MAX), rest))
}

/// The blocks behind a header of block count, block size, size of the last block, and compressed sizes.
fn inflate(layout: Layout, bytes: &[u8]) -> Result<Vec<u8>, ReadProblem> {
    let (block_count, rest) = header(layout, bytes)?;
    if block_count == 0 {
        return Ok(Vec::new());
    }
    let (block_size, rest) = header(layout, rest)?;
    let (last_size, mut sizes) = header(layout, rest)?;
    let width = if layout.wide_header { 8 } else { 4 };
    let data_start = block_count
        .checked_mul(width)
        .filter(|&start| start <= sizes.len());
    let mut data =
        &sizes[data_start.ok_or_else(|| ended("the sizes of the compressed blocks"))?..];
    let mut inflated = Vec::new();
    for block in 0..block_count {
        let (compressed_size, rest) = header(layout, sizes)?;
        sizes = rest;
        let Some((compressed, rest)) = data.split_at_checked(compressed_size) else {
            return Err(ended("a compressed block"));
        };
        data = rest;
        let size = if block + 1 == block_count && last_size != 0 {
            last_size
        } else {
            block_size
        };
        let before = inflated.len();
        let stream = ZlibDecoder::new(compressed)
            .take(size as u64)
            .read_to_end(&mut inflated);
        if stream.is_err() || inflated.len() - before != size {
            return Err(ReadProblem::Count {
                what: format!("bytes in compressed block {block}"),
                claimed: size as u64,
                found: (inflated.len() - before) as u64,
            });
        }
    }
    Ok(inflated)
}

fn numbers(number: Number, layout: Layout, bytes: &[u8]) -> Numbers {
    let words = bytes
        .chunks_exact(number.size())
        .map(|word| unsigned(word, layout.big_endian));
    match number {
        Number::F32 => Numbers::Reals(
            words
                .map(|word| f64::from(f32::from_bits(word as u32)))
                .collect(),
        ),
        Number::F64 => Numbers::Reals(words.map(f64::from_bits).collect()),
        _ => Numbers::Integers(words.map(|word| integer(number, word)).collect()),
    }
}

fn integer(number: Number, word: u64) -> i64 {
    if number.is_signed() {
        let unused = 64 - 8 * number.size();
        ((word << unused) as i64) >> unused
    } else {
        i64::try_from(word).unwrap_or(i64::MAX)
    }
}

/// At most eight bytes as an unsigned integer.
fn unsigned(bytes: &[u8], big_endian: bool) -> u64 {
    let append = |value: u64, &byte: &u8| value << 8 | u64::from(byte);
    if big_endian {
        bytes.iter().fold(0, append)
    } else {
        bytes.iter().rev().fold(0, append)
    }
}

fn ended(expected: &str) -> ReadProblem {
    ReadProblem::Truncated {
        expected: expected.into(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const LAYOUT: Layout = Layout {
        big_endian: false,
        wide_header: false,
        compressed: false,
    };

    #[test]
    fn a_header_with_its_own_padding_is_read_like_a_joint_one() {
        let joint = STANDARD.encode([4, 0, 0, 0, 255, 255, 255, 255]);
        let apart = STANDARD.encode([4, 0, 0, 0]) + &STANDARD.encode([255, 255, 255, 255]);
        for text in [joint, apart] {
            let decoded = from_base64(Number::I32, LAYOUT, text.as_bytes()).unwrap();
            assert_eq!(decoded, Numbers::Integers(vec![-1]));
        }
    }

    #[test]
    fn a_header_that_claims_more_than_there_is_allocates_nothing() {
        let error = from_bytes(Number::F64, LAYOUT, &[255, 255, 255, 255, 0, 0]).unwrap_err();
        assert_eq!(
            error.to_string(),
            "the file ends where the bytes that the header announces should follow"
        );
    }

    #[test]
    fn big_endian_numbers_are_turned_round() {
        let layout = Layout {
            big_endian: true,
            ..LAYOUT
        };
        let mut bytes = vec![0, 0, 0, 8];
        bytes.extend(1.5_f64.to_be_bytes());
        assert_eq!(
            from_bytes(Number::F64, layout, &bytes).unwrap(),
            Numbers::Reals(vec![1.5])
        );
    }

    #[test]
    fn compressed_blocks_are_joined() {
        use std::io::Write as _;
        let zip = |data: &[u8]| {
            let mut encoder =
                flate2::write::ZlibEncoder::new(Vec::new(), flate2::Compression::default());
            encoder.write_all(data).unwrap();
            encoder.finish().unwrap()
        };
        let (one, two) = (zip(&[1, 2, 3]), zip(&[4]));
        let mut bytes: Vec<u8> = Vec::new();
        for word in [2, 3, 1, one.len() as u32, two.len() as u32] {
            bytes.extend(word.to_le_bytes());
        }
        bytes.extend(one.into_iter().chain(two));
        let layout = Layout {
            compressed: true,
            ..LAYOUT
        };
        assert_eq!(
            from_bytes(Number::U8, layout, &bytes).unwrap(),
            Numbers::Integers(vec![1, 2, 3, 4])
        );
    }
}
