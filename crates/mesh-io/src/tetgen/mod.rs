//! The input of `TetGen`: `.poly` and `.smesh`, piecewise linear complexes as lines of numbers.
//!
//! Four sections follow each other: points, as in a `.node` (none when they stand in the `.node` beside the file), facets, seeds of
//! holes, and seeds of regions; the last two may be left out. A facet of a `.smesh` is one polygon on one line; a facet of a `.poly` has
//! a line that counts its polygons and holes, and a line for each of them. The corners of a polygon may go on over several lines.
//!
//! A `.poly` of the plane is a file of [`triangle`](crate::triangle), whose points, attributes and markers these are too.
//!
//! The format: Si, `TetGen` 1.5, *A Quality Tetrahedral Mesh Generator*, user's manual, section 5.2.

mod facets;
mod read;
mod write;

pub use read::{parse_poly, parse_smesh};
pub use write::write_poly;

pub(crate) use read::is_of_space;
