//! The answer of every predicate: one of three signs, never a number to compare.

use std::ops::{Mul, Neg};

/// Sign of a determinant, exact.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[repr(i8)]
pub enum Sign {
    /// Less than zero.
    Negative = -1,
    /// Exactly zero: the degenerate case.
    Zero = 0,
    /// Greater than zero.
    Positive = 1,
}

impl Sign {
    /// Sign of a number; `Zero` for both zeros and for NaN, which has no sign.
    #[inline]
    #[must_use]
    pub fn of(value: f64) -> Self {
        if value > 0.0 {
            Self::Positive
        } else if value < 0.0 {
            Self::Negative
        } else {
            Self::Zero
        }
    }

    /// True for `Positive`.
    #[inline]
    #[must_use]
    pub const fn is_positive(self) -> bool {
        matches!(self, Self::Positive)
    }

    /// True for `Negative`.
    #[inline]
    #[must_use]
    pub const fn is_negative(self) -> bool {
        matches!(self, Self::Negative)
    }

    /// True for `Zero`.
    #[inline]
    #[must_use]
    pub const fn is_zero(self) -> bool {
        matches!(self, Self::Zero)
    }
}

impl Neg for Sign {
    type Output = Self;

    #[inline]
    fn neg(self) -> Self {
        match self {
            Self::Negative => Self::Positive,
            Self::Zero => Self::Zero,
            Self::Positive => Self::Negative,
        }
    }
}

/// Sign of the product of two numbers of the given signs.
impl Mul for Sign {
    type Output = Self;

    #[inline]
    fn mul(self, other: Self) -> Self {
        match self {
            Self::Negative => -other,
            Self::Zero => Self::Zero,
            Self::Positive => other,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const ALL: [Sign; 3] = [Sign::Negative, Sign::Zero, Sign::Positive];

    #[test]
    fn sign_of_a_number_is_its_side_of_zero() {
        assert_eq!(Sign::of(f64::MIN_POSITIVE), Sign::Positive);
        assert_eq!(Sign::of(-f64::INFINITY), Sign::Negative);
        assert_eq!(Sign::of(-0.0), Sign::Zero);
        assert_eq!(Sign::of(f64::NAN), Sign::Zero);
    }

    #[test]
    fn negation_and_product_agree_with_those_of_numbers() {
        for a in ALL {
            assert_eq!(-a as i8, -(a as i8));
            assert_eq!(
                (a.is_negative(), a.is_zero(), a.is_positive()),
                ((a as i8) < 0, a as i8 == 0, a as i8 > 0)
            );
            for b in ALL {
                assert_eq!((a * b) as i8, a as i8 * b as i8);
            }
        }
    }
}
