//! VTU, the XML unstructured grids of VTK: what ParaView opens.
//!
//! Written as inline base64 of little-endian numbers, not compressed, indices in 32 bits where they fit: raw numbers behind the XML would
//! be a quarter shorter, but the reader of meshio confuses their arrays. Read as ASCII, inline or appended (raw or base64), plain or
//! compressed by zlib, in either byte order. Integer arrays named `marker` are the markers.
//!
//! Own code over `quick-xml`, `base64` and `flate2` rather than `vtkio`: only arrays cut out of the bytes at hand can promise that no
//! size claimed in a file is believed.

mod appended;
mod array;
mod base64_runs;
pub(crate) mod budget;
pub(crate) mod number;
mod packed;
pub(crate) mod piece;
mod read;
mod write;
mod write_polytopes;

pub use read::parse;
pub use write::write;
pub use write_polytopes::write_polytopes;

use crate::cell::CellKind;

/// Name of the integer arrays that hold markers.
pub(crate) const MARKER: &str = "marker";

/// VTK's number of a kind of cell.
pub(crate) const fn vtk_type(kind: CellKind) -> u8 {
    match kind {
        CellKind::Vertex => 1,
        CellKind::Segment => 3,
        CellKind::Triangle => 5,
        CellKind::Quad => 9,
        CellKind::Tetrahedron => 10,
        CellKind::Hexahedron => 12,
        CellKind::Wedge => 13,
        CellKind::Pyramid => 14,
    }
}

/// Turns the triangles of a wedge round, or back: those of VTK run clockwise seen from the inside.
pub(crate) fn turn_wedge(corners: &mut [u32]) {
    corners.swap(1, 2);
    corners.swap(4, 5);
}
