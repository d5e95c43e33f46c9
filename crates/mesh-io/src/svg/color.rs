//! Colours, and a restrained set of them that works on white paper.

use std::fmt;

/// An opaque sRGB colour.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Color(pub [u8; 3]);

impl Color {
    /// Near black, for text and walls.
    pub const INK: Self = Self([0x1c, 0x20, 0x26]);
    /// Mid grey, for what stands back: mesh lines, triangulations.
    pub const GREY: Self = Self([0x8d, 0x95, 0x9f]);
    /// Light grey, for areas.
    pub const MIST: Self = Self([0xe9, 0xec, 0xf0]);
    /// Dark blue, for what the picture is about.
    pub const BLUE: Self = Self([0x1f, 0x4e, 0x8c]);
    /// Light blue, for areas that go with it.
    pub const SKY: Self = Self([0xd3, 0xe2, 0xf3]);
    /// Brick red, for what must be told apart from it.
    pub const RED: Self = Self([0xb5, 0x3a, 0x2e]);
    /// Light red, for areas that go with it.
    pub const ROSE: Self = Self([0xf5, 0xd9, 0xd3]);
    /// Ochre, a third hue.
    pub const OCHRE: Self = Self([0xc9, 0x8a, 0x1b]);
    /// The paper.
    pub const WHITE: Self = Self([0xff; 3]);

    /// The colour a fraction `t` in [0, 1] of the way to `other`, component by component; `t` outside is clamped.
    #[must_use]
    pub fn mixed(self, other: Self, t: f64) -> Self {
        let t = t.clamp(0.0, 1.0);
        let mix =
            |k: usize| (f64::from(self.0[k]) * (1.0 - t) + f64::from(other.0[k]) * t).round() as u8;
        Self([mix(0), mix(1), mix(2)])
    }
}

impl fmt::Display for Color {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [r, g, b] = self.0;
        write!(f, "#{r:02x}{g:02x}{b:02x}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_colour_prints_as_hexadecimal() {
        assert_eq!(Color([1, 16, 255]).to_string(), "#0110ff");
    }

    #[test]
    fn mixing_clamps_its_fraction() {
        assert_eq!(Color::WHITE.mixed(Color::INK, -3.0), Color::WHITE);
        assert_eq!(Color::WHITE.mixed(Color::INK, 2.0), Color::INK);
    }
}
