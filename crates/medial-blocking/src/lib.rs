//! Multiblock structured quad meshes around circles, from the medial axis.
//!
//! Circles in, blocks out: the domain inside a bounding circle, or in a periodic rectangle, and
//! outside circular holes is cut into blocks with a structured grid each, body-fitted and
//! orthogonal to every circle, conforming from block to block. The method is that of Guoy and
//! Erickson, *Automatic blocking scheme for structured meshing in 2D multiphase flow simulation*.
//!
//! ```
//! use medial_blocking::{Circle, Domain, Params, mesh};
//! use glam::DVec2;
//!
//! let holes = [Circle::new(DVec2::new(-1.0, 0.0), 0.5), Circle::new(DVec2::new(1.0, 0.2), 0.4)];
//! let domain = Domain::in_circle(Circle::new(DVec2::ZERO, 2.5), &holes)?;
//! let mesh = mesh(&domain, &Params::default())?;
//! assert_eq!(mesh.blocking().blocks().len(), 6);
//! # Ok::<(), medial_blocking::BlockingError>(())
//! ```
//!
//! The steps, one file each:
//!
//! 1. [`Domain`]: circles, checked (Problem 1, §5);
//! 2. [`sample`]: samples of the walls, spaced by the local gap (§2);
//! 3. [`triangulation`]: their Delaunay triangulation inside the domain, in a periodic one that of
//!    the infinite tiling (§2, §5);
//! 4. [`medial_axis`]: interior triangles and the sequences between them (Algorithm 1);
//! 5. [`blocking2d`]: the curves C1, M and C2 of every pair of blocks (Algorithm 2);
//! 6. [`medial_graph`]: vertices and arcs made exact: circles that touch three walls, bisectors of
//!    two;
//! 7. [`block`]: blocks with their four curves and three neighbours (§3);
//! 8. [`nodes`](params): nodes along the curves, and [`transfinite`] interpolation between them
//!    (§3, §5).
//!
//! Topology comes from exact predicates on the samples and is the same on every machine. Vertices,
//! arcs and touching points are computed from the circles, not from the samples, to rounding error.
//! What the paper leaves for special cases (thin blocks between nearly co-circular holes, poor
//! angles) is left as it is and can be asked for: [`Blocking::thin_arcs`].

mod arc_length;
pub mod bisector;
pub mod block;
mod blocking;
pub mod blocking2d;
mod clearance;
pub mod corner;
mod domain;
mod error;
#[cfg(test)]
mod example_domains;
mod grid;
pub mod medial_axis;
pub mod medial_graph;
mod nodes;
pub mod params;
mod periodic;
mod resolve;
pub mod sample;
mod tangent_circle;
pub mod transfinite;
pub mod triangulation;
mod turn;
mod validate;
mod wall;

use std::ops::ControlFlow;

use delaunay_core::progress::Progress;

pub use block::{ArcSide, Block, BlockCorner, BlockId, BlockSide, Neighbours};
pub use blocking::{Blocking, COLLAPSED};
pub use domain::Domain;
pub use error::{BlockingError, Defect, DomainError, MAX_LISTED_DEFECTS};
pub use grid::{BlockGrid, BlockMesh};
pub use medial_graph::{ArcEnd, ArcId, MedialArc, MedialVertex, MedialVertexId, Touch};
pub use params::{CellCounts, MAX_CELLS, NodeMatching, Params};
pub use validate::RESOLVED_GAP;
pub use wall::{Circle, Shift, Wall, WallId, WallImage, WallKind, WallName};

/// Hears of progress and may stop the work; see [`delaunay_core::progress`].
type Report<'a> = dyn FnMut(Progress) -> ControlFlow<()> + 'a;

/// The multiblock structured mesh of a domain.
///
/// # Errors
/// See [`Blocking::of`] and [`BlockMesh::of`].
///
/// O(s log s + cells) for s boundary samples, which are proportional to the number of holes while
/// gaps are of the size of the holes: 1,000 random holes with 16 by 16 cells per block took 0.23 s on
/// one thread of a busy machine. A wall that runs along another at a gap g costs 1 / g of its length
/// in samples, as when a hole nearly fills the bounding circle.
pub fn mesh(domain: &Domain, params: &Params) -> Result<BlockMesh, BlockingError> {
    BlockMesh::of(Blocking::of(domain)?, params)
}

/// The same as [`mesh`], reporting progress to `report`, which may stop the work.
///
/// # Errors
/// As [`mesh`], and [`BlockingError::Cancelled`].
pub fn mesh_with(
    domain: &Domain,
    params: &Params,
    report: &mut dyn FnMut(Progress) -> ControlFlow<()>,
) -> Result<BlockMesh, BlockingError> {
    BlockMesh::of_with(Blocking::of_with(domain, report)?, params, report)
}
