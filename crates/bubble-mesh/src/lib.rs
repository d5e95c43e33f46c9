//! Bubbles that say how large a triangle mesh should be, after Luo, *Automatic Delaunay mesh generation method
//! and physically-based mesh optimization method on two-dimensional regions*.
//!
//! Only the boundary of a domain is given. Its edges give a bubble to every boundary node, the bubbles of
//! nodes give bubbles to triangles, and the ratio of bubble to triangle says where a node is missing.
//!
//! ```
//! use bubble_mesh::{Domain, Params, Stop, generate, radius_ratio};
//! use delaunay_core::progress::silent;
//! use glam::DVec2;
//!
//! // A circle with 60 nodes.
//! let node = |i: u32| DVec2::from_angle(f64::from(i) * std::f64::consts::TAU / 60.0);
//! let boundary: Vec<DVec2> = (0..60).map(node).collect();
//! let mesh = generate(Domain::convex(&boundary)?, &Params::default(), &mut silent);
//! assert_eq!(mesh.stop, Stop::Filled);
//!
//! let quality = |f| radius_ratio(mesh.delaunay.triangle(f));
//! assert!(mesh.delaunay.faces().map(quality).sum::<f64>() > 0.8 * mesh.delaunay.faces().count() as f64);
//! # Ok::<(), bubble_mesh::DomainError>(())
//! ```
//!
//! In the crate today: node bubbles, element bubbles and bubble density (§2.3, eq. 1–5), the radius ratio
//! (eq. 10) from the shared measures, and the generation of meshes (§2.4) for convex regions. To come: regions
//! of any outline with holes, which need constrained edges (§2.1), and the optimization by bubble forces (§3).

mod bubble;
mod domain;
mod error;
mod generate;

pub use bubble::{
    Bubble, boundary_bubbles, boundary_node_area, boundary_node_radius, bubble_density, centroid,
};
/// Radius ratio, the quality of a triangle. Source: eq. 10.
pub use delaunay_core::measure::triangle::radius_ratio;
pub use domain::Domain;
pub use error::{BoundaryError, DomainError};
pub use generate::{Mesh, Params, Stop, generate};
