//! Mesh file formats: plain points, cells, markers and structured blocks, read and written without a panic.

mod atomic;
pub mod block_mesh_dict;
mod blocks;
mod blocks_to_mesh;
mod cell;
mod circles;
pub mod circles_toml;
pub mod connectivity_map;
mod error;
mod format;
mod lines;
mod mesh;
pub mod msh;
mod numbers;
pub mod off;
mod planar_graph;
pub mod plot3d;
mod read;
pub mod svg;
pub mod triangle;
pub mod vtu;
mod write;
pub mod xy;

pub use atomic::write_atomically;
pub use blocks::{BlockSide, BlocksDefect, Connection, StructuredBlock, StructuredBlocks};
pub use cell::{Cell, CellKind, Cells};
pub use circles::{CirclesDomain, Frame, Hole};
pub use error::{Place, ReadError, ReadProblem, WriteError, WriteProblem};
pub use format::Format;
pub use mesh::{Axis, DataArray, Mesh, MeshDefect};
pub use numbers::Encoding;
pub use planar_graph::{PlanarGraph, Region};
pub use read::{read_blocks, read_circles, read_mesh, read_planar_graph, read_points};
pub use write::{write_blocks, write_circles, write_mesh, write_planar_graph};
