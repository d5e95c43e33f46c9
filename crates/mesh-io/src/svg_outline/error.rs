//! What can be wrong with a drawing.

/// What makes outlines of a drawing impossible. Elements are shown as `<path id=...>`.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum DrawingDefect {
    /// An attribute is not what the format wants: path data, a transform, a number, a list of points.
    #[error("{element}: {attribute} is not valid: {fault}")]
    Attribute {
        /// Whose attribute.
        element: String,
        /// Its name.
        attribute: &'static str,
        /// What is wrong with it.
        fault: String,
    },
    /// A radius, width or height is negative.
    #[error("{element}: {attribute} is {value}, which is negative")]
    Negative {
        /// Whose attribute.
        element: String,
        /// Its name.
        attribute: &'static str,
        /// The offending value.
        value: f64,
    },
    /// Coordinates overflow, before or after the transforms.
    #[error("{element}: not all coordinates are finite numbers")]
    NotFinite {
        /// Whose coordinates.
        element: String,
    },
    /// The drawing is larger than a number can say.
    #[error("the bounding box of the drawing has no finite diagonal")]
    TooWide,
    /// Elements stand inside each other without end.
    #[error("{element}: nested deeper than {limit} elements")]
    TooDeep {
        /// The first element that is too deep.
        element: String,
        /// Elements that may stand inside each other.
        limit: usize,
    },
    /// The flattened drawing has too many points.
    #[error("the outlines have more than {limit} points")]
    TooManyPoints {
        /// Points that a drawing may have.
        limit: usize,
    },
    /// Nothing in the drawing has an outline.
    #[error("the drawing has no outline: no path, polygon, rect, circle or the like of any size")]
    NoOutline,
}
