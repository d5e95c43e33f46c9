//! Numbers with at most three decimals.

use std::fmt;

/// A number that prints with at most three decimals, never as `-0`, and as 0 when it is not finite.
///
/// Coordinates that are not finite never come here; widths of lines and the like may.
pub(super) struct Rounded(pub(super) f64);

impl fmt::Display for Rounded {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let text = format!("{:.3}", if self.0.is_finite() { self.0 } else { 0.0 });
        let text = text.trim_end_matches('0').trim_end_matches('.');
        f.write_str(if text == "-0" { "0" } else { text })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn zeros_that_say_nothing_are_left_out() {
        let texts = [0.0, -0.0001, 1.5, -2.0004, 100.0, 1234.5678, f64::NAN]
            .map(|x| Rounded(x).to_string());
        assert_eq!(texts, ["0", "0", "1.5", "-2", "100", "1234.568", "0"]);
    }
}
