//! Numbers of a `DataArray`, from text or from bytes.

use super::budget::Budget;
use crate::error::ReadProblem;
use crate::lines::quoted;

/// The number types of VTK.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Number {
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
    pub(crate) fn from_name(name: &str) -> Option<Self> {
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

    pub(crate) const fn size(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::I32 | Self::U32 | Self::F32 => 4,
            Self::I64 | Self::U64 | Self::F64 => 8,
        }
    }
}

/// Decoded numbers. Integers are kept apart because indices must be exact.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Numbers {
    Integers(Vec<i64>),
    Reals(Vec<f64>),
}

impl Numbers {
    pub(crate) const fn len(&self) -> usize {
        match self {
            Self::Integers(values) => values.len(),
            Self::Reals(values) => values.len(),
        }
    }

    pub(crate) fn into_reals(self) -> Vec<f64> {
        match self {
            Self::Integers(values) => values.into_iter().map(|value| value as f64).collect(),
            Self::Reals(values) => values,
        }
    }
}

/// Numbers separated by white space.
pub(crate) fn from_text(number: Number, text: &str) -> Result<Numbers, ReadProblem> {
    match number {
        Number::F32 | Number::F64 => words(text).map(Numbers::Reals),
        _ => words(text).map(Numbers::Integers),
    }
}

fn words<T: std::str::FromStr>(text: &str) -> Result<Vec<T>, ReadProblem> {
    let parse = |word: &str| {
        word.parse().map_err(|_| ReadProblem::Expected {
            expected: "a number".into(),
            found: quoted(word),
        })
    };
    text.split_ascii_whitespace().map(parse).collect()
}

/// Numbers one behind the other, as many as the bytes hold.
///
/// # Errors
/// Bytes that are no whole count of numbers, or more numbers than the budget has place for.
pub(crate) fn from_bytes(
    number: Number,
    big_endian: bool,
    bytes: &[u8],
    budget: &mut Budget,
) -> Result<Numbers, ReadProblem> {
    let count = bytes.len() / number.size();
    if !bytes.len().is_multiple_of(number.size()) {
        return Err(ReadProblem::Expected {
            expected: format!("numbers of {} bytes each", number.size()),
            found: format!("{} bytes in all", bytes.len()),
        });
    }
    budget.spend(count.saturating_mul(size_of::<f64>()))?;
    Ok(if big_endian {
        // The bytes of each number turned round; what remains is little-endian.
        let mut turned = bytes.to_vec();
        turned
            .chunks_exact_mut(number.size())
            .for_each(<[u8]>::reverse);
        from_little_endian(number, &turned)
    } else {
        from_little_endian(number, bytes)
    })
}

fn from_little_endian(number: Number, bytes: &[u8]) -> Numbers {
    match number {
        Number::I8 => integers(bytes, i8::from_le_bytes),
        Number::U8 => integers(bytes, u8::from_le_bytes),
        Number::I16 => integers(bytes, i16::from_le_bytes),
        Number::U16 => integers(bytes, u16::from_le_bytes),
        Number::I32 => integers(bytes, i32::from_le_bytes),
        Number::U32 => integers(bytes, u32::from_le_bytes),
        Number::I64 => integers(bytes, i64::from_le_bytes),
        Number::U64 => unsigned(bytes),
        Number::F32 => Numbers::Reals(each(bytes, |word| f64::from(f32::from_le_bytes(word)))),
        Number::F64 => Numbers::Reals(each(bytes, f64::from_le_bytes)),
    }
}

fn integers<const N: usize, T: Into<i64>>(bytes: &[u8], from: impl Fn([u8; N]) -> T) -> Numbers {
    Numbers::Integers(each(bytes, |word| from(word).into()))
}

/// Integers where they fit, else real numbers: what is no index can only be data.
fn unsigned(bytes: &[u8]) -> Numbers {
    let values = each(bytes, u64::from_le_bytes);
    let integers: Result<_, _> = values.iter().map(|&value| i64::try_from(value)).collect();
    integers.map_or_else(
        |_| Numbers::Reals(values.iter().map(|&value| value as f64).collect()),
        Numbers::Integers,
    )
}

fn each<const N: usize, T>(bytes: &[u8], from: impl Fn([u8; N]) -> T) -> Vec<T> {
    let (words, _) = bytes.as_chunks();
    words.iter().map(|&word| from(word)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn decoded(number: Number, big_endian: bool, bytes: &[u8]) -> Result<Numbers, ReadProblem> {
        from_bytes(number, big_endian, bytes, &mut Budget::of_file(0))
    }

    #[test]
    fn big_endian_numbers_are_turned_round() {
        assert_eq!(
            decoded(Number::F64, true, &1.5_f64.to_be_bytes()).unwrap(),
            Numbers::Reals(vec![1.5])
        );
    }

    #[test]
    fn integers_of_every_width_keep_sign_and_value() {
        let ones = [0xff; 8];
        let expected: [(Number, i64); 7] = [
            (Number::I8, -1),
            (Number::U8, 255),
            (Number::I16, -1),
            (Number::U16, 65535),
            (Number::I32, -1),
            (Number::U32, 4_294_967_295),
            (Number::I64, -1),
        ];
        for (number, value) in expected {
            let count = 8 / number.size();
            assert_eq!(
                decoded(number, false, &ones).unwrap(),
                Numbers::Integers(vec![value; count])
            );
        }
    }

    #[test]
    fn unsigned_integers_beyond_the_signed_ones_become_reals() {
        assert_eq!(
            decoded(Number::U64, false, &[0xff; 8]).unwrap(),
            Numbers::Reals(vec![u64::MAX as f64])
        );
    }

    #[test]
    fn half_a_number_is_refused() {
        insta::assert_snapshot!(decoded(Number::I32, false, &[0; 7]).unwrap_err(), @"expected numbers of 4 bytes each, found 7 bytes in all");
    }
}
