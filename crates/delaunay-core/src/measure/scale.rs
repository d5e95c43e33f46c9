//! Elements of any size measured at size one, so that no product overflows or vanishes on the way.

use glam::DVec3;

/// The power of two at or below the largest of `magnitudes`; `None` when that is zero or not a number below
/// infinity, that is for an element that is a point or too large to have edges.
///
/// Dividing by it is exact.
pub(super) fn scale<const N: usize>(magnitudes: [f64; N]) -> Option<f64> {
    const EXPONENT: u64 = 0x7ff << 52;
    let largest = magnitudes.into_iter().fold(0.0, f64::max);
    let power = f64::from_bits(largest.to_bits() & EXPONENT);
    // Below the normal numbers there are no powers to read off; the smallest normal one does.
    (largest > 0.0 && largest < f64::INFINITY).then(|| power.max(f64::MIN_POSITIVE))
}

/// A power of two near the length of `vector`, and the vector in units of it; both zero for no length.
pub(super) fn scaled(vector: DVec3) -> (f64, DVec3) {
    scale(vector.abs().to_array()).map_or((0.0, DVec3::ZERO), |unit| (unit, vector / unit))
}

/// The length of a vector so short or long that its square has no place among the numbers.
pub(super) fn length(vector: DVec3) -> f64 {
    let (unit, vector) = scaled(vector);
    unit * vector.length()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_scale_is_the_power_of_two_below() {
        assert_eq!(scale([1.5, 0.1]), Some(1.0));
        assert_eq!(scale([0.3, 7.9]), Some(4.0));
        assert_eq!(scale([f64::MAX]), Some(2f64.powi(1023)));
        assert_eq!(scale([5e-324]), Some(f64::MIN_POSITIVE));
    }

    #[test]
    fn points_and_unbounded_elements_have_none() {
        assert_eq!(scale([0.0, 0.0]), None);
        assert_eq!(scale([1.0, f64::INFINITY]), None);
        assert_eq!(scale([]), None);
    }

    #[test]
    fn lengths_do_not_underflow() {
        assert_eq!(length(DVec3::new(3e-200, 0.0, 4e-200)), 5e-200);
        assert_eq!(length(DVec3::ZERO), 0.0);
    }
}
