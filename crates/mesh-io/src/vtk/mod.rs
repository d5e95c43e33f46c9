//! Legacy VTK, `.vtk`: a grid or polygons in a file without XML.
//!
//! Read are versions 1 to 5.1, ASCII and binary, of unstructured grids and of polydata, whose polygons of 3 and 4 corners are
//! triangles and quads; written is an unstructured grid of version 3.0 in ASCII, which the oldest readers understand. Point and cell data
//! of every kind are named numbers; integers called `marker` are the markers, as in a [`vtu`](crate::vtu).
//!
//! Binary numbers are big-endian. Names are written as VTK does, with `%20` for a blank.
//!
//! The format: Kitware, *VTK file formats*, "Simple legacy formats"; for version 5.1 its release notes of `vtkCellArray`.

mod attributes;
mod cells;
mod name;
mod numbers;
mod read;
mod write;

pub use read::parse;
pub use write::write;
