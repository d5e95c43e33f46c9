//! A panel: a window of the plane with layers on it, a caption below and a colour bar beside it.

use super::color_map::ColorMap;
use super::layer::{Layer, Point};
use super::style::Style;

/// The rectangle of the plane that a panel shows; what lies outside is cut off.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Window {
    /// The corner with the smallest coordinates.
    pub low: Point,
    /// The corner with the largest.
    pub high: Point,
}

impl Window {
    /// The window between two corners.
    #[must_use]
    pub fn new(low: impl Into<Point>, high: impl Into<Point>) -> Self {
        Self {
            low: low.into(),
            high: high.into(),
        }
    }

    /// The smallest window that holds all points, which is empty when there are none.
    #[must_use]
    pub fn around<P: Into<Point>>(points: impl IntoIterator<Item = P>) -> Self {
        let nothing = Self {
            low: [f64::INFINITY; 2],
            high: [f64::NEG_INFINITY; 2],
        };
        points
            .into_iter()
            .map(Into::into)
            .fold(nothing, |window, [x, y]| Self {
                low: [window.low[0].min(x), window.low[1].min(y)],
                high: [window.high[0].max(x), window.high[1].max(y)],
            })
    }

    /// The window widened on all sides by `fraction` of its larger side.
    #[must_use]
    pub fn widened(self, fraction: f64) -> Self {
        let [width, height] = self.size();
        let by = fraction * width.max(height);
        Self {
            low: self.low.map(|c| c - by),
            high: self.high.map(|c| c + by),
        }
    }

    pub(super) fn size(&self) -> [f64; 2] {
        [self.high[0] - self.low[0], self.high[1] - self.low[1]]
    }

    pub(super) fn is_proper(&self) -> bool {
        self.size()
            .iter()
            .all(|side| side.is_finite() && *side > 0.0)
    }
}

/// The legend of a colour map.
#[derive(Clone, Debug, PartialEq)]
pub struct ColorBar {
    /// The map.
    pub map: ColorMap,
    /// What is coloured, above the bar.
    pub title: String,
    /// Values with a tick.
    pub ticks: Vec<f64>,
    /// What follows the number at a tick, for example `°`.
    pub unit: String,
}

/// One drawing of a picture.
#[derive(Clone, Debug)]
pub struct Panel {
    pub(super) window: Window,
    pub(super) width: f64,
    pub(super) caption: Option<String>,
    pub(super) color_bar: Option<ColorBar>,
    pub(super) layers: Vec<Layer>,
}

impl Panel {
    /// A panel that shows `window`, 420 pixels wide.
    #[must_use]
    pub const fn new(window: Window) -> Self {
        Self {
            window,
            width: 420.0,
            caption: None,
            color_bar: None,
            layers: Vec::new(),
        }
    }

    /// The same, `pixels` wide.
    #[must_use]
    pub const fn width(mut self, pixels: f64) -> Self {
        self.width = pixels;
        self
    }

    /// The same with a line of text below.
    #[must_use]
    pub fn caption(mut self, text: &str) -> Self {
        self.caption = Some(text.to_owned());
        self
    }

    /// The same with a colour bar on the right.
    #[must_use]
    pub fn color_bar(mut self, bar: ColorBar) -> Self {
        self.color_bar = Some(bar);
        self
    }

    /// Adds an empty layer on top of the others and gives it out to be filled.
    pub fn layer(&mut self, name: &str, style: Style) -> &mut Layer {
        self.layers.push(Layer::new(name, style));
        let last = self.layers.len() - 1;
        &mut self.layers[last]
    }

    pub(super) fn scale(&self) -> f64 {
        self.width / self.window.size()[0]
    }

    pub(super) fn height(&self) -> f64 {
        self.window.size()[1] * self.scale()
    }
}
