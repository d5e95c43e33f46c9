//! Every Sphère Vide crate behind one dependency, the conversions between them, and the `vide`
//! program.
//!
//! ```
//! use vide::{convert, medial_blocking, mesh_io};
//!
//! let text = r#"
//!     [domain]
//!     kind = "circle"
//!     centre = [0.0, 0.0]
//!     radius = 2.0
//!     [[hole]]
//!     centre = [0.5, 0.0]
//!     radius = 0.5
//! "#;
//! let circles = mesh_io::circles_toml::parse(text.as_bytes())?;
//! let domain = convert::domain_of(&circles)?;
//! let mesh = medial_blocking::mesh(&domain, &medial_blocking::Params::default())?;
//! let blocks = convert::structured_blocks(&mesh);
//! assert_eq!(blocks.blocks.len(), 8);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! | crate | what it does |
//! |---|---|
//! | [`geo_predicates`] | exact signs of the determinants that decide topology |
//! | [`delaunay_core`] | Delaunay triangulations, Voronoi dual, measures |
//! | [`medial_blocking`] | multiblock structured quads around circles |
//! | [`sink_refine`] | refinement by sink insertion |
//! | [`tet_improve`] | tetrahedra without slivers, inside a fixed boundary |
//! | [`bubble_mesh`] | graded triangles steered by bubbles |
//! | [`cvt_tet`] | centroidal Voronoi meshes |
//! | [`mesh_io`] | file formats |
//!
//! The program is behind the feature `cli`, which is on by default; libraries switch it off.

pub mod convert;
pub mod marks;
pub mod picture;
pub mod plane;
mod polygons;
pub mod quality;
pub mod solid;
pub mod triangles;
pub mod voronoi;

pub use bubble_mesh;
pub use cvt_tet;
pub use delaunay_core;
pub use geo_predicates;
pub use glam;
pub use medial_blocking;
pub use mesh_io;
pub use sink_refine;
pub use tet_improve;

/// The examples of the README are tests.
#[cfg(doctest)]
#[doc = include_str!("../../../README.md")]
struct Readme;
