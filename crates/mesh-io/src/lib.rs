//! Mesh file formats: plain points, cells, markers and structured blocks, read and written without a panic.
//!
//! ```
//! use mesh_io::{Cell, Cells, Mesh, read_mesh, write_mesh};
//!
//! let points = vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
//! let mesh = Mesh::new(points, Cells::from_iter([Cell::Triangle([0, 1, 2])]));
//!
//! let folder = tempfile::tempdir()?;
//! write_mesh(&folder.path().join("triangle.vtu"), &mesh)?;
//! assert_eq!(read_mesh(&folder.path().join("triangle.vtu"))?, mesh);
//!
//! std::fs::write(folder.path().join("bad.off"), "OFF\n3 1 0\n0 0 0\n1 0 nan\n")?;
//! let error = read_mesh(&folder.path().join("bad.off")).unwrap_err();
//! assert!(error.to_string().ends_with("bad.off:4: point 1: z is NaN, which is not a finite number"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! | name of the file | [`Format`] | reads | writes | keeps |
//! |---|---|---|---|---|
//! | `.vtu` | [`vtu`] | mesh | mesh | everything |
//! | `.vtk` | [`vtk`] | mesh | mesh, in ASCII | everything |
//! | `.msh` | [`msh`] | mesh | mesh | everything, markers of cells as physical groups |
//! | `.mesh` | [`medit`] | mesh | all cells but vertices | points, cells kind by kind, markers |
//! | `.p3d`, `.p3b` | [`plot3d`] | blocks | blocks | names and connections in a [`connectivity_map`] beside it |
//! | `blockMeshDict` | [`block_mesh_dict`] | | blocks | what `blockMesh` needs to make them anew |
//! | `.node`, `.ele` | [`triangle`] | mesh | triangles or tetrahedra | markers, and data without names |
//! | `.poly` | [`triangle`] | planar graph | planar graph | everything but names of data |
//! | `.poly` in space | [`tetgen`] | piecewise complex; mesh, if of triangles | piecewise complex | everything but names of data |
//! | `.smesh` | [`tetgen`] | piecewise complex; mesh, if of triangles | | everything but names of data |
//! | `.off` | [`off`] | mesh, planar graph | cells without volume | points and cells; of a planar graph the outline of the faces |
//! | `.xy`, `.xyz` | [`xy`] | points | points | points; weights are read |
//! | `.2d.f64`, `.3d.f64` | [`raw`] | points | points | points and weights |
//! | `.ply` | [`ply`] | mesh, points | triangles, quads, segments | points and cells, segments behind faces; weights are read |
//! | `.stl` | [`stl`] | triangles | triangles, in binary | points rounded to 4 bytes and merged by place, and triangles |
//! | `.obj` | [`obj`] | mesh | triangles, quads, segments | points and cells |
//! | `.svg` | [`svg_outline`] | planar graph | | outlines of shapes, curves as chords |
//! | `.geojson`, `.json` | [`geojson`] | planar graph | | rings and lines, points merged by place; `marker` of features |
//! | `DOMAIN.toml` | [`circles_toml`] | circles | circles | everything |
//!
//! The crate knows no geometry: nothing is oriented, repaired or judged here but form. What it promises instead:
//!
//! - a reader answers any bytes with data that pass [`Mesh::check`] (or its like), or with a [`ReadError`] that names line or byte,
//!   element and value; it allocates for what it has seen, never for what a header claims, and unpacks no more than a stated
//!   multiple of the file;
//! - a writer puts a whole file at its place or leaves what was there ([`write_atomically`], [`Outputs`] for several); a format that has no place for a cell
//!   refuses it, and what else is left out stands in the table;
//! - what is written and read back has the same bits, but for a `z` of -0.0 in a planar file, which is 0.0.
//!
//! [`svg`] draws pictures; it shares nothing with the rest, [`svg_outline`] among it, but the name of being a file format.

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
pub mod geojson;
mod lines;
pub mod medit;
mod mesh;
pub mod msh;
mod numbers;
pub mod obj;
pub mod off;
mod outline;
mod outputs;
mod piecewise_complex;
mod planar_graph;
pub mod plot3d;
pub mod ply;
mod points;
mod polytopes;
pub mod raw;
mod read;
mod read_points;
pub mod stl;
pub mod svg;
pub mod svg_outline;
pub mod tetgen;
pub mod triangle;
pub mod vtk;
pub mod vtu;
mod write;
mod write_as;
pub mod xy;

pub use atomic::{Counted, StagedWriter, write_atomically};
pub use blocks::{BlockSide, BlocksDefect, Connection, StructuredBlock, StructuredBlocks};
pub use cell::{Cell, CellKind, Cells};
pub use circles::{CirclesDomain, Frame, Hole};
pub use error::{Place, ReadError, ReadProblem, WriteError, WriteProblem};
pub use format::Format;
pub use mesh::{Axis, DataArray, Mesh, MeshDefect};
pub use numbers::Encoding;
pub use outputs::{Outputs, companion};
pub use piecewise_complex::{ComplexDefect, Facet, NoTriangle, PiecewiseComplex, SolidRegion};
pub use planar_graph::{PlanarGraph, Region};
pub use points::{Coordinates, Dimension, OffPlane, Points, PointsWanted};
pub use polytopes::Polytopes;
pub use read::{read_blocks, read_circles, read_mesh, read_piecewise_complex, read_planar_graph};
pub use read_points::read_points;
pub use write::{
    write_blocks, write_circles, write_mesh, write_piecewise_complex, write_planar_graph,
};
