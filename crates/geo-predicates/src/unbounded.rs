//! The last resort: doubles as integers of any length over one common power of two.
//!
//! Slow, and exact for every finite input: no exponent is out of range.

use crate::sign::Sign;
use num_bigint::{BigInt, Sign as BigSign};

/// The coordinates divided by one common power of two that makes all of them integers.
///
/// Coordinates that are not finite count as zero.
pub(crate) fn integers<const N: usize, const M: usize>(points: [[f64; N]; M]) -> [[BigInt; N]; M] {
    let exponent = least_exponent(points.as_flattened());
    points.map(|point| point.map(|value| scaled(value, exponent)))
}

/// As [`integers`], with weights divided by the square of that power of two.
pub(crate) fn integers_and_weights<const N: usize, const M: usize>(
    points: [[f64; N]; M],
    weights: [f64; M],
) -> ([[BigInt; N]; M], [BigInt; M]) {
    let lightest = least_exponent(&weights).div_euclid(2);
    let exponent = least_exponent(points.as_flattened()).min(lightest);
    let points = points.map(|point| point.map(|value| scaled(value, exponent)));
    (points, weights.map(|weight| scaled(weight, 2 * exponent)))
}

/// `value` divided by 2^`exponent`, which must divide it.
pub(crate) fn scaled(value: f64, exponent: i32) -> BigInt {
    let (mantissa, own) = decode(value);
    BigInt::from(mantissa) << (own - exponent).max(0) as usize
}

/// Exponent of the least significant bit that some of the values has; 0 if all are zero.
pub(crate) fn least_exponent(values: &[f64]) -> i32 {
    let exponents = values.iter().map(|&value| decode(value));
    exponents
        .filter(|part| part.0 != 0)
        .map(|part| part.1)
        .min()
        .unwrap_or(0)
}

/// `(m, e)` with `value = m * 2^e`; `m` is zero for NaN and infinities.
fn decode(value: f64) -> (i64, i32) {
    let bits = value.to_bits();
    let biased = ((bits >> 52) & 0x7ff) as i32;
    let fraction = (bits & ((1 << 52) - 1)) as i64;
    let (magnitude, exponent) = match biased {
        0 => (fraction, -1074),
        0x7ff => (0, 0),
        _ => (fraction | (1 << 52), biased - 1075),
    };
    (
        if bits >> 63 == 0 {
            magnitude
        } else {
            -magnitude
        },
        exponent,
    )
}

/// Sign of an integer.
pub(crate) fn sign(value: &BigInt) -> Sign {
    match value.sign() {
        BigSign::Minus => Sign::Negative,
        BigSign::NoSign => Sign::Zero,
        BigSign::Plus => Sign::Positive,
    }
}

/// `a x - b y` of vectors of the plane.
pub(crate) fn cross(a: &[BigInt; 2], b: &[BigInt; 2]) -> BigInt {
    &a[0] * &b[1] - &a[1] * &b[0]
}

/// Inner product.
pub(crate) fn dot<const N: usize>(a: &[BigInt; N], b: &[BigInt; N]) -> BigInt {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

/// Coordinate differences `a - b`.
pub(crate) fn minus<const N: usize>(a: &[BigInt; N], b: &[BigInt; N]) -> [BigInt; N] {
    std::array::from_fn(|i| &a[i] - &b[i])
}

/// Vector product.
pub(crate) fn cross3(a: &[BigInt; 3], b: &[BigInt; 3]) -> [BigInt; 3] {
    let minor = |i: usize, j: usize| &a[i] * &b[j] - &a[j] * &b[i];
    [minor(1, 2), minor(2, 0), minor(0, 1)]
}

/// Determinant of the rows `a`, `b`, `c`.
pub(crate) fn det3(a: &[BigInt; 3], b: &[BigInt; 3], c: &[BigInt; 3]) -> BigInt {
    let minor = |i: usize, j: usize| &b[i] * &c[j] - &b[j] * &c[i];
    &a[0] * minor(1, 2) - &a[1] * minor(0, 2) + &a[2] * minor(0, 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn decoding_and_encoding_agree_on_every_kind_of_number() {
        for value in [
            0.0,
            -0.0,
            1.0,
            -0.1,
            f64::MAX,
            -f64::MIN_POSITIVE,
            f64::from_bits(3),
            6e-310,
        ] {
            let (mantissa, exponent) = decode(value);
            let half = exponent / 2;
            let back = mantissa as f64 * 2f64.powi(half) * 2f64.powi(exponent - half);
            assert_eq!(back, value);
        }
        assert_eq!(decode(f64::NAN).0, 0);
        assert_eq!(decode(f64::NEG_INFINITY).0, 0);
    }

    #[test]
    fn integers_share_one_scale() {
        let big = |x: i64| BigInt::from(x);
        assert_eq!(
            integers([[0.5, 0.0, -3.0]])[0],
            [big(1 << 52), big(0), big(-6 << 52)]
        );
    }
}
