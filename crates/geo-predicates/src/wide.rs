//! Signed integers of a few machine words, on the stack and without branches.

use crate::sign::Sign;
use std::ops::{Add, Neg, Sub};

/// A two's complement integer of `N` words of 64 bits, least significant first.
///
/// Sums and differences must fit; the exact predicates leave room for them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Wide<const N: usize>([u64; N]);

impl From<i64> for Wide<1> {
    #[inline]
    fn from(value: i64) -> Self {
        Self([value as u64])
    }
}

impl From<i128> for Wide<2> {
    #[inline]
    fn from(value: i128) -> Self {
        Self([value as u64, (value >> 64) as u64])
    }
}

impl<const N: usize> Wide<N> {
    /// The product, which always fits into the `P == N + M` words of the result.
    #[inline]
    pub(crate) fn times<const M: usize, const P: usize>(self, other: Wide<M>) -> Wide<P> {
        const { assert!(P == N + M) };
        let (a, b) = (self.magnitude(), other.magnitude());
        let mut product = [0; P];
        for i in 0..N {
            let mut carry = 0;
            for j in 0..M {
                (product[i + j], carry) = multiply_add(a[i], b[j], product[i + j], carry);
            }
            product[i + M] = carry;
        }
        Wide(product).negated_if(self.is_negative() != other.is_negative())
    }

    /// Sign of the integer.
    #[inline]
    pub(crate) fn sign(self) -> Sign {
        if self.is_negative() {
            Sign::Negative
        } else if self.0 == [0; N] {
            Sign::Zero
        } else {
            Sign::Positive
        }
    }

    #[inline]
    fn is_negative(self) -> bool {
        self.0[N - 1] >> 63 == 1
    }

    #[inline]
    fn magnitude(self) -> [u64; N] {
        self.negated_if(self.is_negative()).0
    }

    /// Flips all bits and adds one, or neither.
    #[inline]
    fn negated_if(mut self, negate: bool) -> Self {
        let flip = u64::from(negate).wrapping_neg();
        let mut carry = negate;
        for word in &mut self.0 {
            (*word, carry) = (*word ^ flip).overflowing_add(u64::from(carry));
        }
        self
    }
}

/// Low and high word of `a b + c + d`, which cannot overflow.
#[inline]
fn multiply_add(a: u64, b: u64, c: u64, d: u64) -> (u64, u64) {
    let sum = u128::from(a) * u128::from(b) + u128::from(c) + u128::from(d);
    (sum as u64, (sum >> 64) as u64)
}

impl<const N: usize> Add for Wide<N> {
    type Output = Self;

    #[inline]
    fn add(mut self, other: Self) -> Self {
        let mut carry = 0;
        for (word, addend) in self.0.iter_mut().zip(other.0) {
            let sum = u128::from(*word) + u128::from(addend) + carry;
            *word = sum as u64;
            carry = sum >> 64;
        }
        self
    }
}

impl<const N: usize> Neg for Wide<N> {
    type Output = Self;

    #[inline]
    fn neg(self) -> Self {
        self.negated_if(true)
    }
}

impl<const N: usize> Sub for Wide<N> {
    type Output = Self;

    #[inline]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use num_bigint::BigInt;
    use proptest::prelude::*;

    fn big<const N: usize>(value: Wide<N>) -> BigInt {
        let bytes: Vec<u8> = value.0.iter().flat_map(|word| word.to_le_bytes()).collect();
        BigInt::from_signed_bytes_le(&bytes)
    }

    /// Words that are often all zeros or all ones, so that carries travel far.
    fn word() -> impl Strategy<Value = u64> {
        prop_oneof![Just(0), Just(u64::MAX), Just(1 << 63), any::<u64>()]
    }

    proptest! {
        #[test]
        fn products_agree_with_long_integers(a in [word(), word(), word()], b in [word(), word()]) {
            let (a, b) = (Wide(a), Wide(b));
            prop_assert_eq!(big::<5>(a.times(b)), big(a) * big(b));
        }

        #[test]
        fn sums_and_differences_agree_with_long_integers(a: [i64; 3], b: [i64; 3]) {
            let [a, b] = [a, b].map(|[x, y, z]| {
                Wide::<3>::from_words([x as u64, y as u64, (z >> 2) as u64])
            });
            prop_assert_eq!(big(a + b), big(a) + big(b));
            prop_assert_eq!(big(a - b), big(a) - big(b));
        }
    }

    impl<const N: usize> Wide<N> {
        fn from_words(words: [u64; N]) -> Self {
            Self(words)
        }
    }

    #[test]
    fn signs_of_small_integers_survive() {
        for value in [-3i128, 0, 3] {
            assert_eq!(Wide::from(value).sign(), Sign::of(value as f64));
            assert_eq!(Wide::from(value as i64).sign(), Sign::of(value as f64));
            assert_eq!((-Wide::from(value)).sign(), -Sign::of(value as f64));
        }
    }
}
