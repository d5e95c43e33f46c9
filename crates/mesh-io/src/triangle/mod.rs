//! The files of Shewchuk's Triangle: `.node` (points), `.ele` (elements) and `.poly` (planar straight-line graphs).
//!
//! All three are lines of numbers, `#` before comments. Elements are counted from 0 or from 1, as the first point says. Points may
//! have attributes and a boundary marker, elements attributes, segments a marker. `TetGen` writes points of space and tetrahedra in
//! the same way, which is read and written too; what it makes of `.poly` stands in [`tetgen`](crate::tetgen).

mod ele;
pub(crate) mod node;
mod poly;
pub(crate) mod rows;
pub(crate) mod seeds;

pub use ele::{parse_ele, write_ele};
pub use node::{Nodes, parse_node, write_node};
pub use poly::{parse_poly, write_poly};
