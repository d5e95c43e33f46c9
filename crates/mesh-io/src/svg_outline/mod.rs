//! SVG drawings read as outlines: the lines of every shape, joined where they meet.
//!
//! Read are `<path>`, `<polygon>`, `<polyline>`, `<rect>`, `<circle>`, `<ellipse>` and `<line>` with the `transform` of the
//! element and of each `<svg>`, `<g>`, `<a>` and `<switch>` around it. Elements are known by their name alone, with the prefix
//! `svg:` or with none.
//!
//! - SVG has y pointing down; it is flipped here (y becomes -y), so that the drawing stands upright in a plane with y up.
//! - User units are kept: size, units and `viewBox` of the drawing are ignored. A nested `<svg>` that is moved or scaled by
//!   its own `x`, `y` or `viewBox` is refused, and so is a shape that measures in anything but user units or `px`.
//! - Each curve becomes chords of equal steps of its parameter, none farther from it than [`FLATNESS`] of the diagonal of the
//!   bounding box of all outlines.
//! - How things look means nothing: a filled shape, a stroked one and one without paint give the same outline. The file
//!   does not tell holes from islands; that is left to whoever fills the loops.
//! - Ignored are text, images, `<use>` and all other elements with what is inside them, hence also what `<defs>`,
//!   `<clipPath>`, `<mask>`, `<symbol>`, `<pattern>` and `<marker>` hold; elements with `display` none, as attribute or in
//!   `style`, with what is inside them; style sheets and transforms in `style`.
//! - No entity is known but the five of XML; a document type is passed over and nothing is fetched.
//!
//! The points of arcs come from `sin` and `cos`, so their last bits may differ between machines.

mod arc;
mod document;
mod element;
mod error;
mod flatten;
mod graph;
mod path_data;
mod shape;
#[cfg(test)]
mod tests;

use crate::error::{ReadError, ReadProblem};
use crate::planar_graph::PlanarGraph;

pub use error::DrawingDefect;

/// Farthest that a chord may stray from its curve, as a share of the diagonal of the bounding box of the drawing.
pub const FLATNESS: f64 = 1e-3;

/// Points that a drawing may have after its curves are flattened.
pub const MOST_POINTS: usize = 1_000_000;

/// Elements that may stand inside each other.
pub const DEEPEST_NESTING: usize = 256;

/// The outlines in a drawing, without holes, regions, markers and data.
///
/// Points at exactly one place are one point, chords without length are dropped, a chord drawn twice (in whatever direction)
/// is kept once, and every point has a segment. Places that merely nearly agree stay apart, but for the gap that rounding of
/// relative coordinates leaves (below 1e-12 of the greatest coordinate) at a `Z`. So a subpath closed by `Z`, or whose ends meet, makes a loop, any other one
/// loose segments. Points and segments come in the order in which they are drawn.
///
/// # Errors
/// With its line: malformed XML; a document that is not `<svg>`; and, naming the element, a [`DrawingDefect`]. For the whole
/// drawing: more than [`MOST_POINTS`] points, or no outline at all. O(file).
pub fn parse(bytes: &[u8]) -> Result<PlanarGraph, ReadError> {
    let text = std::str::from_utf8(bytes)
        .map_err(|error| ReadError::at_byte(error.valid_up_to(), ReadProblem::NotText))?;
    let curves = document::curves(text.strip_prefix('\u{feff}').unwrap_or(text))?;
    Ok(flatten::outlines(&curves)?)
}
