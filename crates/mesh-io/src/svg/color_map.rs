//! Numbers as colours.
//!
//! Lightness grows steadily along the map, so equal steps of the value look like equal steps, in print without colour and to
//! colour-blind readers too. Values are put into a few dozen classes, which keeps pictures small: cells of one class share one path.

use super::color::Color;

/// Colours of viridis (S. van der Walt and N. Smith, released to the public domain as CC0) at equal steps.
const VIRIDIS: [Color; 10] = [
    Color([0x44, 0x01, 0x54]),
    Color([0x48, 0x28, 0x78]),
    Color([0x3e, 0x49, 0x89]),
    Color([0x31, 0x68, 0x8e]),
    Color([0x26, 0x82, 0x8e]),
    Color([0x1f, 0x9e, 0x89]),
    Color([0x35, 0xb7, 0x79]),
    Color([0x6e, 0xce, 0x58]),
    Color([0xb5, 0xde, 0x2b]),
    Color([0xfd, 0xe7, 0x25]),
];

/// A map from an interval of values to colours, dark at `low` and bright at `high`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ColorMap {
    low: f64,
    high: f64,
}

impl ColorMap {
    /// Number of colours the interval is divided into.
    pub const CLASSES: usize = 64;

    /// The map of the interval from `low` to `high`. An interval that is empty or not finite maps everything to one colour.
    #[must_use]
    pub const fn new(low: f64, high: f64) -> Self {
        Self { low, high }
    }

    /// The value at the dark end.
    #[must_use]
    pub const fn low(&self) -> f64 {
        self.low
    }

    /// The value at the bright end.
    #[must_use]
    pub const fn high(&self) -> f64 {
        self.high
    }

    /// The class of a value, from 0 to `CLASSES - 1`; values outside the interval go to its ends. `None` for NaN.
    ///
    /// A value that is a border between classes up to rounding, such as a right angle, is in the upper one on every machine.
    #[must_use]
    pub fn class(&self, value: f64) -> Option<usize> {
        if value.is_nan() {
            return None;
        }
        let fraction = (value - self.low) / (self.high - self.low) + 1e-9;
        let class = (fraction * Self::CLASSES as f64).clamp(0.0, (Self::CLASSES - 1) as f64);
        Some(if class.is_nan() { 0 } else { class as usize })
    }

    /// The colour of a class; classes beyond the last have the brightest colour.
    #[must_use]
    pub fn class_color(class: usize) -> Color {
        let t = class as f64 / (Self::CLASSES - 1) as f64 * (VIRIDIS.len() - 1) as f64;
        let k = (t as usize).min(VIRIDIS.len() - 2);
        VIRIDIS[k].mixed(VIRIDIS[k + 1], t - k as f64)
    }

    /// The colour of a value; white for NaN.
    #[must_use]
    pub fn color(&self, value: f64) -> Color {
        self.class(value).map_or(Color::WHITE, Self::class_color)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lightness_grows_from_class_to_class() {
        let lightness = |class| {
            let Color([r, g, b]) = ColorMap::class_color(class);
            0.2126 * f64::from(r) + 0.7152 * f64::from(g) + 0.0722 * f64::from(b)
        };
        assert!((1..ColorMap::CLASSES).all(|class| lightness(class) > lightness(class - 1) - 0.5));
        assert!(lightness(ColorMap::CLASSES - 1) > 10.0 * lightness(0));
    }

    #[test]
    fn values_outside_take_the_ends_and_nan_is_white() {
        let map = ColorMap::new(0.0, 90.0);
        assert_eq!(map.color(-1e300), map.color(0.0));
        assert_eq!(map.color(f64::INFINITY), map.color(90.0));
        assert_eq!(map.color(f64::NAN), Color::WHITE);
    }

    #[test]
    fn rounding_does_not_move_a_border_value_to_another_class() {
        let map = ColorMap::new(0.0, 90.0);
        assert_eq!(map.class(45.0 - 1e-13), Some(ColorMap::CLASSES / 2));
        assert_eq!(map.class(45.0 + 1e-13), Some(ColorMap::CLASSES / 2));
    }

    #[test]
    fn an_empty_interval_has_one_colour() {
        let map = ColorMap::new(1.0, 1.0);
        assert_eq!(map.class(1.0), Some(0));
    }
}
