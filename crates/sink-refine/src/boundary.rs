//! What both kinds of boundary have in common, curves in the plane and surfaces in space.

/// Turns of less than this many radians are rounding: corners of a flat part may be a little off.
pub(crate) const TURN_TOLERANCE: f64 = 1e-9;

/// Into how many parts of its length the shortest edge at a boundary vertex may be divided; or the largest circumradius
/// allowed, where a smaller size is asked for.
///
/// Where boundary parts meet at small angles, points on each call for points on the other, ever nearer to the corner. This ends
/// that.
pub(crate) const PARTS: f64 = 8.0;

/// Whether two boundary edges with this angle between them, in radians, divide each other without end unless their vertices are
/// at the same distances from their common one. Not for the edge itself, at no angle.
pub(crate) fn is_acute(angle: f64) -> bool {
    angle > 1e-12 && angle < std::f64::consts::FRAC_PI_3
}

/// The power of two nearest to half of a length, as a share of it: between 0.35 and 0.71.
pub(crate) fn shell(length: f64) -> f64 {
    (0.5 * length).log2().round().exp2() / length
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_shell_is_a_power_of_two() {
        for (length, share) in [(1.0, 0.5), (6.0, 2.0 / 3.0), (5.0, 0.4), (0.01, 0.390_625)] {
            assert_eq!(shell(length), share, "{length}");
        }
    }
}
