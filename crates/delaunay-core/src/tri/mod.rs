//! Triangulations of the plane.
//!
//! | step | file |
//! |---|---|
//! | connectivity, surgery | `mesh.rs`, `around.rs`, `canonical.rs` |
//! | the triangulation and read access | `delaunay.rs`, `duplicates.rs`, `flat.rs` |
//! | one point: locate, cavity, star | `insert.rs`, `locate.rs`, `cavity.rs`, `dig.rs`, `sight.rs`, `star.rs` |
//! | all points | `build.rs`, `bulk/` |
//! | one point less, one edge turned | `remove.rs`, `flip.rs` |
//! | with segments as edges | `constrained/` |
//! | questions | `nearest.rs`, `hull.rs` |
//! | the Voronoi diagram | `dual.rs`, `convex.rs`, `carve.rs` |
//! | closed outlines and what they enclose | `outline.rs`, `region.rs`, `crossing.rs` |
//! | a part with a boundary of its own | `subcomplex.rs`, `boundary_cavity.rs` |
//! | triangles that need not be Delaunay | `complex.rs`, `piece.rs` |
//! | weighted points | `regular/` |
//! | invariants | `check.rs` |

mod around;
mod boundary_cavity;
mod build;
mod bulk;
mod canonical;
mod carve;
mod cavity;
mod check;
mod complex;
mod constrained;
mod convex;
mod crossing;
mod delaunay;
mod dig;
mod dual;
mod duplicates;
mod flat;
mod flip;
mod hull;
mod insert;
mod locate;
mod mesh;
mod nearest;
mod outline;
mod piece;
mod region;
mod regular;
mod remove;
mod renumber;
mod sight;
mod star;
mod subcomplex;

pub use around::Around;
pub use cavity::{Cavity, RimEdge};
pub use check::Violation;
pub use complex::Complex2;
pub use constrained::{
    Components, ConstrainError, Constrained2, ConstrainedViolation, Crossing, Crossings, SeedError,
};
pub use convex::{ConvexPolygon, PolygonError};
pub use crossing::segments_cross;
pub use delaunay::Delaunay2;
pub use dual::{Voronoi, VoronoiEdge};
pub use duplicates::Duplicates;
pub use flat::{Extent, Flat};
pub use hull::Hull;
pub use insert::Inserted;
pub use locate::Location;
pub use mesh::TriMesh;
pub use outline::{Outline, OutlineError};
pub use piece::Piece2;
pub use region::{Region, RegionError};
pub use regular::{Regular2, RegularViolation2};
pub use remove::Refilled;
pub use subcomplex::{Patch2, Subcomplex2};
