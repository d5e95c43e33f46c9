//! Sums and products of doubles without loss, as two doubles (Dekker 1971, Knuth 1969).

/// `a + b` rounded, and what is lost.
#[inline]
pub(super) fn sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let b_part = sum - a;
    let a_part = sum - b_part;
    (sum, (a - a_part) + (b - b_part))
}

/// `a b` rounded, and what is lost.
#[inline]
pub(super) fn product(a: f64, b: f64) -> (f64, f64) {
    let product = a * b;
    let ((a_high, a_low), (b_high, b_low)) = (halves(a), halves(b));
    let rest = product - a_high * b_high - a_low * b_high - a_high * b_low;
    (product, a_low * b_low - rest)
}

/// A double as a sum of two with half of its bits each.
#[inline]
fn halves(a: f64) -> (f64, f64) {
    /// 2^27 + 1.
    const SPLITTER: f64 = 134_217_729.0;
    let scaled = SPLITTER * a;
    let high = scaled - (scaled - a);
    (high, a - high)
}

/// `from + share (to - from)` as a double and a small rest, up to 2^-100 of the larger of `from` and `to`, where `share` is
/// from 0 to 1.
pub(super) fn between(from: f64, to: f64, share: f64) -> (f64, f64) {
    let (length, length_rest) = sum(to, -from);
    let (step, step_rest) = product(share, length);
    let (near, near_rest) = sum(from, step);
    let rest = near_rest + (step_rest + share * length_rest);
    sum(near, rest)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_is_lost() {
        assert_eq!(sum(1.0, 1e-30), (1.0, 1e-30));
        let third = 1.0 / 3.0;
        let (square, rest) = product(third, third);
        assert!(rest != 0.0 && rest.abs() < 1e-17 && square + rest == square);
        assert_eq!(between(1.0, 3.0, 0.25), (1.5, 0.0));
        let (near, rest) = between(0.1, 0.7, third);
        assert!((near - 0.3).abs() < 1e-15 && rest != 0.0 && near + rest == near);
    }
}
