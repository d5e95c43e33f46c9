//! Plot3D grids of many blocks: ASCII, `.p3d`, and binary, `.p3b`.
//!
//! A file is the number of blocks, then the node counts of every block, then block after block all `x`, all `y` and, in space, all `z`, with `i`
//! running fastest. There are no blanks (`IBLANK`), no Fortran record marks, and binary is little-endian with 4-byte integers and 8-byte
//! reals ("C binary"). VTK's and `ParaView`'s reader wants *multi grid* for it, *double precision* and *little endian* for binary, and
//! *2D geometry* for planar files; it finds all of that by itself with *auto detect format*, which works for binary only.
//!
//! Blocks with `z = 0` throughout are written planar, as `ni nj` and without `z`, others in space with one layer of nodes, `ni nj 1`.
//! Reading tells the two apart by the length of the file. What lies behind the sides has no place in the format; it stands in a
//! [`connectivity_map`](crate::connectivity_map) beside the file. Without one every side reads as a patch called [`UNKNOWN_SIDE`].
//!
//! The format: P. P. Walatka et al., *PLOT3D User's Manual*, NASA TM 101067, 1990.

mod read;
mod write;

pub use read::parse;
pub use write::write;

/// Name of the patch behind a side of which nothing is known.
pub const UNKNOWN_SIDE: &str = "unknown";
