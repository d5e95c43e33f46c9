//! Formats of surfaces and tetrahedra, and any bytes in all formats. One program, as linking takes longer than running.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

#[path = "../meshes/mod.rs"]
mod meshes;
#[path = "../spoiled/mod.rs"]
mod spoiled;
#[path = "../written/mod.rs"]
mod written;

mod any_bytes;
mod medit;
mod piecewise_complex;
mod surfaces;
mod vtk;
