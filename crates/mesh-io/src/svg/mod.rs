//! Pictures as SVG: polygons, lines, circles, dots, arrows and text in the coordinates of the drawing, y up.
//!
//! A [`Picture`] is a row of [`Panel`]s with a title and a key; a panel shows a [`Window`] of the plane through [`Layer`]s that
//! share a [`Style`] each; areas can be coloured by a [`ColorMap`] with a [`ColorBar`] beside the panel. Line widths, dots and
//! text are measured in pixels and do not scale with the drawing. See [`Picture`] for an example.
//!
//! Documents are plain SVG 1.1 without style sheets, scripts or identifiers, so that several can share a page.

mod color;
mod color_map;
mod draw;
mod error;
mod frame;
mod layer;
mod legend;
mod number;
mod panel;
mod picture;
mod style;
mod write;

pub use color::Color;
pub use color_map::ColorMap;
pub use error::PictureError;
pub use layer::{Anchor, Layer, Point};
pub use panel::{ColorBar, Panel, Window};
pub use picture::{Picture, Sample};
pub use style::{Stroke, Style};

#[cfg(test)]
mod tests;
