//! base64 as VTK writes it: runs set one after the other, each with its own padding.

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;

use super::packed::{Layout, ended, unsigned};
use crate::error::ReadProblem;

/// Bytes of runs of base64, up to anything that is none. White space is passed over. O(text).
pub(super) fn decode(text: &[u8]) -> Result<Vec<u8>, ReadProblem> {
    // Nearly every array is a single run without blanks, and several can be told from one by the first padding.
    STANDARD
        .decode(text.trim_ascii())
        .or_else(|_| decode_runs(text))
}

fn decode_runs(text: &[u8]) -> Result<Vec<u8>, ReadProblem> {
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
        let letters = rest
            .iter()
            .position(|&byte| byte == b'=')
            .unwrap_or(rest.len());
        if letters == 0 {
            return Err(no_base64("="));
        }
        // Only a run that fills its last four letters can be followed by another.
        let (run, tail) = rest.split_at(letters.next_multiple_of(4).min(rest.len()));
        STANDARD
            .decode_vec(run, &mut bytes)
            .map_err(|error| no_base64(&error.to_string()))?;
        rest = tail;
    }
    Ok(bytes)
}

fn no_base64(found: &str) -> ReadProblem {
    ReadProblem::Expected {
        expected: "base64".into(),
        found: found.into(),
    }
}

/// The letters of the appended array at the start of `text`: as many as its header says.
///
/// Arrays follow each other without a mark between them, and an array whose bytes are a multiple of three has no
/// padding, so the length has to be computed.
pub(super) fn appended_run(layout: Layout, text: &[u8]) -> Result<&[u8], ReadProblem> {
    let width = layout.header_width();
    let first = size(layout, &decode_start(text, width)?);
    let length = if layout.compressed {
        let header_size = first.saturating_add(3).saturating_mul(width);
        let head = decode_start(text, header_size)?;
        let sizes = head
            .get(3 * width..header_size)
            .ok_or_else(|| ended("the sizes of the compressed blocks"))?;
        let sum = sizes
            .chunks_exact(width)
            .map(|word| size(layout, word))
            .fold(0, usize::saturating_add);
        letters(header_size).saturating_add(letters(sum))
    } else {
        letters(width.saturating_add(first))
    };
    // A header with its own padding is longer by at most four letters; the decoder ignores what it does not need.
    Ok(text.get(..length).unwrap_or(text))
}

/// The first bytes of a text, at least as many as asked for.
fn decode_start(text: &[u8], bytes: usize) -> Result<Vec<u8>, ReadProblem> {
    let run = text
        .get(..letters(bytes))
        .ok_or_else(|| ended("a header"))?;
    let decoded = decode(run)?;
    if decoded.len() < bytes {
        return Err(ended("a header"));
    }
    Ok(decoded)
}

/// The size at the start of some bytes.
fn size(layout: Layout, bytes: &[u8]) -> usize {
    let word = bytes.get(..layout.header_width()).unwrap_or(bytes);
    usize::try_from(unsigned(word, layout.big_endian)).unwrap_or(usize::MAX)
}

/// Letters that hold some bytes, padding included.
const fn letters(bytes: usize) -> usize {
    bytes.div_ceil(3).saturating_mul(4)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn runs_with_their_own_padding_are_joined() {
        let joint = STANDARD.encode([4, 0, 0, 0, 255, 255, 255, 255]);
        let apart = STANDARD.encode([4, 0, 0, 0]) + &STANDARD.encode([255, 255, 255, 255]);
        let blanks = joint.replace('/', "/\n ");
        for text in [joint, apart, blanks] {
            let decoded = decode(text.as_bytes()).unwrap();
            assert_eq!(decoded, [4, 0, 0, 0, 255, 255, 255, 255], "{text}");
        }
    }

    #[test]
    fn padding_without_letters_is_refused() {
        insta::assert_snapshot!(decode(b"====").unwrap_err(), @"expected base64, found =");
        insta::assert_snapshot!(decode(b"AA==x").unwrap_err(), @"expected base64, found Invalid input length: 1");
    }
}
