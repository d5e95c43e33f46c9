//! Names of data, in which blanks and the like stand as their number in hexadecimal behind a percent sign.

use std::fmt::Write as _;

/// The name as it stands in a file.
pub(super) fn encoded(name: &str) -> String {
    let mut text = String::new();
    for byte in name.bytes() {
        match byte {
            b'!'..=b'~' if byte != b'%' && byte != b'"' => text.push(char::from(byte)),
            // Writing to a string cannot fail.
            _ => _ = write!(text, "%{byte:02X}"),
        }
    }
    text
}

/// The name that stands in a file; what is not UTF-8 is replaced.
pub(super) fn decoded(text: &[u8]) -> String {
    let mut name = Vec::with_capacity(text.len());
    let mut rest = text;
    while let Some((&byte, after)) = rest.split_first() {
        let number = after.first_chunk::<2>().and_then(|digits| {
            let [high, low] = digits.map(|digit| char::from(digit).to_digit(16));
            u8::try_from(16 * high? + low?).ok()
        });
        match number {
            Some(number) if byte == b'%' => {
                name.push(number);
                rest = after.get(2..).unwrap_or_default();
            }
            _ => {
                name.push(byte);
                rest = after;
            }
        }
    }
    String::from_utf8_lossy(&name).into_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_name_comes_back_and_is_one_word() {
        for name in [
            "velocity <&>",
            "100 %",
            "\u{fffd}é\n\t",
            "%20",
            "\"",
            "plain_1",
        ] {
            let text = encoded(name);
            assert!(text.bytes().all(|byte| byte.is_ascii_graphic()), "{text}");
            assert_eq!(decoded(text.as_bytes()), name);
        }
        assert_eq!(decoded(b"50% of %4 %zz%"), "50% of %4 %zz%");
    }
}
