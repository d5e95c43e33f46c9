//! From the coordinates of the drawing to the pixels of a panel.

use super::error::PictureError;
use super::layer::Point;
use super::panel::Panel;

/// Pixels beyond which a position means nothing.
const FAR: f64 = 1e6;

/// The map of one panel, and where its marks are for error messages.
pub(super) struct Frame {
    panel: usize,
    low: f64,
    high: f64,
    scale: f64,
}

/// A mark's place in the picture, for error messages.
#[derive(Clone, Copy)]
pub(super) struct Place<'a> {
    pub(super) layer: &'a str,
    pub(super) mark: usize,
}

impl Frame {
    pub(super) fn of(index: usize, panel: &Panel) -> Result<Self, PictureError> {
        let window = panel.window;
        let drawable = |pixels: f64| pixels > 0.0 && pixels < FAR;
        if !(window.is_proper() && drawable(panel.width) && drawable(panel.height())) {
            return Err(PictureError::Window {
                panel: index,
                low: window.low,
                high: window.high,
            });
        }
        Ok(Self {
            panel: index,
            low: window.low[0],
            high: window.high[1],
            scale: panel.scale(),
        })
    }

    /// Pixels from the upper left corner of the panel, y down.
    pub(super) fn position(&self, [x, y]: Point, place: Place<'_>) -> Result<Point, PictureError> {
        let horizontal = self.checked((x - self.low) * self.scale, x, place)?;
        let vertical = self.checked((self.high - y) * self.scale, y, place)?;
        Ok([horizontal, vertical])
    }

    pub(super) fn length(&self, length: f64, place: Place<'_>) -> Result<f64, PictureError> {
        self.checked(length * self.scale, length, place)
    }

    fn checked(&self, pixels: f64, value: f64, place: Place<'_>) -> Result<f64, PictureError> {
        if pixels.abs() <= FAR {
            return Ok(pixels);
        }
        let layer = place.layer.to_owned();
        Err(PictureError::Coordinate {
            panel: self.panel,
            layer,
            mark: place.mark,
            value,
        })
    }
}
