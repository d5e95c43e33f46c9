//! Values of options that are numbers of some range.

/// A length, or a ratio: finite and above zero.
///
/// # Errors
/// What is wrong with it.
pub(super) fn positive(text: &str) -> Result<f64, String> {
    match text.parse() {
        Ok(value) if value > 0.0 && value < f64::INFINITY => Ok(value),
        _ => Err("not a finite number above zero".to_owned()),
    }
}

/// An angle at which something is no longer smooth, in degrees.
///
/// # Errors
/// What is wrong with it.
pub(super) fn crease(text: &str) -> Result<f64, String> {
    match text.parse() {
        Ok(angle) if (0.0..=180.0).contains(&angle) => Ok(angle),
        _ => Err("an angle is a number of degrees from 0 to 180".to_owned()),
    }
}
