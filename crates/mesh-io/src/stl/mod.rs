//! STL: triangles one by one, from text or from binary.
//!
//! Every triangle brings its own three corners, so the points are found by place: corners with equal coordinates are one
//! point, and points are numbered as they first appear. Normals, names and colours are passed over.
//!
//! Text holds doubles and keeps their bits; binary holds floats of 4 bytes, so every coordinate is rounded to the nearest of these, and
//! points that come to lie at one place are one when they are read again.

mod normal;
mod read;
mod write;

pub use read::parse;
pub use write::write;

/// Bytes in front of the triangles of a binary file: anything, then their number.
const HEADER: usize = 80;
