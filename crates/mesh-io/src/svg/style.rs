//! How lines and areas look.

use super::color::Color;

/// A line that is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stroke {
    /// Its colour.
    pub color: Color,
    /// Its width in pixels of the picture, whatever the scale.
    pub width: f64,
    /// Whether it is dotted.
    pub dotted: bool,
}

impl Stroke {
    /// A thin line: mesh lines, triangulations.
    #[must_use]
    pub const fn thin(color: Color) -> Self {
        Self {
            color,
            width: 0.5,
            dotted: false,
        }
    }

    /// A line of medium width: walls.
    #[must_use]
    pub const fn medium(color: Color) -> Self {
        Self {
            color,
            width: 1.1,
            dotted: false,
        }
    }

    /// A thick line: the medial axis.
    #[must_use]
    pub const fn thick(color: Color) -> Self {
        Self {
            color,
            width: 2.4,
            dotted: false,
        }
    }

    /// A dotted line of medium width: η-lines, empty circles.
    #[must_use]
    pub const fn dotted(color: Color) -> Self {
        Self {
            color,
            width: 1.3,
            dotted: true,
        }
    }
}

/// How the marks of a layer are drawn: outlined, filled, or both.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Style {
    /// The line along the outline.
    pub stroke: Option<Stroke>,
    /// The colour inside. Open lines are never filled.
    pub fill: Option<Color>,
}

impl Style {
    /// Lines only.
    #[must_use]
    pub const fn line(stroke: Stroke) -> Self {
        Self {
            stroke: Some(stroke),
            fill: None,
        }
    }

    /// Areas only.
    #[must_use]
    pub const fn area(fill: Color) -> Self {
        Self {
            stroke: None,
            fill: Some(fill),
        }
    }

    /// The same with areas filled.
    #[must_use]
    pub const fn filled(self, fill: Color) -> Self {
        Self {
            fill: Some(fill),
            ..self
        }
    }
}
