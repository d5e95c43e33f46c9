//! Mesh file formats: plain points, cells, markers and structured blocks, read and written without a panic.

pub mod svg;
