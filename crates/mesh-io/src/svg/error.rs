//! What cannot be drawn.

use thiserror::Error;

/// Why a picture was refused. Panels, layers and marks are counted from 0 in the order in which they were added.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum PictureError {
    /// A coordinate or length is not finite, or so far outside the window that its position in the picture means nothing.
    #[error("panel {panel}, layer `{layer}`, mark {mark}: {value} is not a drawable coordinate")]
    Coordinate {
        /// The panel.
        panel: usize,
        /// The layer's name.
        layer: String,
        /// The mark within the layer.
        mark: usize,
        /// The coordinate, in the units of the drawing.
        value: f64,
    },
    /// The window of a panel is empty or not finite, or its width in the picture is not positive.
    #[error("panel {panel}: the window from ({}, {}) to ({}, {}) is empty or not finite", low[0], low[1], high[0], high[1])]
    Window {
        /// The panel.
        panel: usize,
        /// The corner with the smallest coordinates.
        low: [f64; 2],
        /// The corner with the largest.
        high: [f64; 2],
    },
}
