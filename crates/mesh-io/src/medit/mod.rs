//! Medit `.mesh` in ASCII: vertices and elements in sections, each with a reference.
//!
//! References are the markers; when all of points or of cells are 0, there are none. Sections that say nothing about a
//! [`Mesh`](crate::Mesh) (corners, ridges, required elements, normals) are passed over. Cells stand kind by kind, so a mesh of
//! several kinds comes back in another order.
//!
//! The format: Frey, *MEDIT: an interactive mesh visualization software*, INRIA RT-0253 (2001), appendix; and the elements that later
//! writers add, prisms and pyramids.

mod read;
mod sections;
mod tokens;
mod write;

pub use read::parse;
pub use write::write;
