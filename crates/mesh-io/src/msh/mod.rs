//! Gmsh MSH, `.msh`: version 4.1 in ASCII and binary is read and written, version 2.2 in both read, and written in ASCII.
//!
//! Cell markers are Gmsh's *physical tags*: the writer gives every dimension and marker an entity of its own, in the physical group of that
//! number. Gmsh takes a negative number as the group of its absolute value, the other way round. A cell that is read and is in no group,
//! while others are, has marker 0. [`Mesh::point_data`] and [`Mesh::cell_data`] become `$NodeData` and `$ElementData`, and
//! point markers the node data [`POINT_MARKERS`]. Names of physical groups stand beside the mesh, in [`MshFile`].
//!
//! Version 2.2 stores the physical tag with every element, 0 for none, so there a marker 0 is none, and when all are 0 there are none.
//!
//! The reader keeps points in the order of the file and sorts cells by tag, so that what was written comes back in its order. Of the physical
//! groups of an entity the first counts. Higher-order elements, partitioned meshes and big-endian files are errors; sections that
//! say nothing about a [`Mesh`] are passed over.
//!
//! An own reader, because the crate `mshio` 0.4 (last released in 2020) neither reads physical names nor data, does not look
//! whether the corners of elements exist, and panicked for 6 of 20 000 binary files with a single flipped bit.
//!
//! The format: Gmsh reference manual, "MSH file format".

mod data;
mod element_type;
mod entities;
mod format_line;
mod nodes;
mod parts;
mod read;
mod read_v2;
mod read_v41;
mod section;
mod sink;
mod tag_index;
mod write;
mod write_data;
mod write_v2;

use crate::mesh::Mesh;

pub use read::parse;
pub use write::write;
pub use write_v2::write_v2;

/// Name of the node data that holds point markers.
pub const POINT_MARKERS: &str = "point marker";

/// What an MSH file holds.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MshFile {
    /// Points, cells, markers and data.
    pub mesh: Mesh,
    /// Names of physical groups, in the order of the file.
    pub names: Vec<PhysicalName>,
}

/// The name of a physical group.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PhysicalName {
    /// Dimension of its cells, 0 to 3.
    pub dimension: usize,
    /// Marker of its cells.
    pub marker: i32,
    /// The name, without quotation marks and line breaks.
    pub name: String,
}
