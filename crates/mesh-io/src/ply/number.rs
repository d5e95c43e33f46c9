//! The number types of PLY.

/// What a property is stored as.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Number {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    F32,
    F64,
}

impl Number {
    /// Both the names of the first files and those that tell the width.
    pub(super) fn from_name(name: &str) -> Option<Self> {
        Some(match name {
            "char" | "int8" => Self::I8,
            "uchar" | "uint8" => Self::U8,
            "short" | "int16" => Self::I16,
            "ushort" | "uint16" => Self::U16,
            "int" | "int32" => Self::I32,
            "uint" | "uint32" => Self::U32,
            "float" | "float32" => Self::F32,
            "double" | "float64" => Self::F64,
            _ => return None,
        })
    }

    /// Bytes of one number.
    pub(super) const fn size(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::I32 | Self::U32 | Self::F32 => 4,
            Self::F64 => 8,
        }
    }

    pub(super) const fn is_integer(self) -> bool {
        !matches!(self, Self::F32 | Self::F64)
    }

    /// The number in the first [`Number::size`] bytes; all fit into a double. `None` when there are fewer.
    #[inline]
    pub(super) fn decode(self, bytes: &[u8], big_endian: bool) -> Option<f64> {
        Some(match self {
            Self::I8 => i8::from_le_bytes(*bytes.first_chunk()?).into(),
            Self::U8 => u8::from_le_bytes(*bytes.first_chunk()?).into(),
            Self::I16 => i16::from_le_bytes(little(bytes, big_endian)?).into(),
            Self::U16 => u16::from_le_bytes(little(bytes, big_endian)?).into(),
            Self::I32 => i32::from_le_bytes(little(bytes, big_endian)?).into(),
            Self::U32 => u32::from_le_bytes(little(bytes, big_endian)?).into(),
            Self::F32 => f32::from_le_bytes(little(bytes, big_endian)?).into(),
            Self::F64 => f64::from_le_bytes(little(bytes, big_endian)?),
        })
    }
}

/// The first bytes, the least significant first.
#[inline]
fn little<const N: usize>(bytes: &[u8], big_endian: bool) -> Option<[u8; N]> {
    let mut chunk = *bytes.first_chunk()?;
    if big_endian {
        chunk.reverse();
    }
    Some(chunk)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_type_keeps_its_value_in_either_byte_order() {
        let ones = [0xff; 8];
        let expected = [
            (Number::I8, -1.0),
            (Number::U8, 255.0),
            (Number::I16, -1.0),
            (Number::U16, 65535.0),
            (Number::I32, -1.0),
            (Number::U32, 4_294_967_295.0),
        ];
        for (number, value) in expected {
            assert_eq!(number.decode(&ones[..number.size()], false), Some(value));
            assert_eq!(number.decode(&ones[1..number.size()], true), None);
        }
        assert_eq!(Number::F32.decode(&1.5f32.to_be_bytes(), true), Some(1.5));
        assert_eq!(
            Number::F64.decode(&(-2.5f64).to_le_bytes(), false),
            Some(-2.5)
        );
        assert_eq!(Number::U16.decode(&[1, 2], true), Some(258.0));
    }
}
