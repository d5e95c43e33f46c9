//! Bubbles that say how large a triangle mesh should be, after Luo, *Automatic Delaunay mesh generation method
//! and physically-based mesh optimization method on two-dimensional regions*.
//!
//! Only the boundary of a domain is given. Its edges give a bubble to every boundary node, the bubbles of
//! nodes give bubbles to triangles, and the ratio of bubble to triangle says where a node is missing.
//!
//! ```
//! use bubble_mesh::{Bubble, boundary_bubbles, bubble_density};
//! use glam::DVec2;
//!
//! // An equilateral triangle is as large as its own edges ask for.
//! let corners = [[0.0, 0.0], [2.0, 0.0], [1.0, 3f64.sqrt()]].map(DVec2::from);
//! let nodes = boundary_bubbles(&corners)?;
//! let [a, b, c] = [nodes[0], nodes[1], nodes[2]];
//! assert!((bubble_density([a, b, c]) - 1.0).abs() < 1e-15);
//!
//! // With one corner far off it is too large for its short edge.
//! let far = Bubble { center: DVec2::new(1.0, 9.0), ..c };
//! assert!(bubble_density([a, b, far]) < 0.25);
//! # Ok::<(), bubble_mesh::BoundaryError>(())
//! ```
//!
//! In the crate today: node bubbles, element bubbles and bubble density (§2.3, eq. 1–5), and the radius ratio
//! (eq. 10) from the shared measures. To come: the generation of meshes (§2.4) and their optimization by
//! bubble forces (§3). The crate does not make meshes yet.

mod bubble;
mod error;

pub use bubble::{
    Bubble, boundary_bubbles, boundary_node_area, boundary_node_radius, bubble_density, centroid,
};
/// Radius ratio, the quality of a triangle. Source: eq. 10.
pub use delaunay_core::measure::triangle::radius_ratio;
pub use error::BoundaryError;
