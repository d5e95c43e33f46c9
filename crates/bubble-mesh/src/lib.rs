//! Bubbles that say how large a triangle mesh should be, after Luo, *Automatic Delaunay mesh generation method
//! and physically-based mesh optimization method on two-dimensional regions*.
//!
//! Only the boundary of a region is given, with the nodes that it shall have. Its edges give a bubble to every boundary node,
//! the bubbles of nodes give bubbles to triangles, and the ratio of bubble to triangle says where a node is
//! missing.
//!
//! - A [`Domain`] is the region and its boundary nodes with their [`Bubble`]s (§2.1, §2.3).
//! - [`paper`] is the method of the paper as it is printed: generation (§2.4) and optimization by bubble forces (§3).
//! - [`curve`] makes boundary nodes from smooth curves.
//! - [`graded`] is what goes beyond it: meshes without a poor triangle where the boundary allows that.
//! - [`radius_ratio`] judges triangles (eq. 10).

mod boundary;
mod bubble;
pub mod curve;
mod domain;
mod envelope;
mod error;
pub mod graded;
pub mod paper;
mod spacing;

pub use boundary::{ResampleError, Resampled, Resampling, resample};
pub use bubble::{
    Bubble, boundary_bubbles, boundary_node_area, boundary_node_radius, bubble_density, centroid,
};
/// Radius ratio, the quality of a triangle. Source: eq. 10.
pub use delaunay_core::measure::triangle::radius_ratio;
pub use domain::Domain;
pub use error::{DomainError, OptimizeError};
pub use spacing::{NodeSpacing, Spacing};
