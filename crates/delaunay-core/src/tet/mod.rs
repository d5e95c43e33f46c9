//! Triangulations of space.
//!
//! | step | file |
//! |---|---|
//! | connectivity, surgery | `mesh.rs`, `around.rs`, `exchange.rs`, `canonical.rs` |
//! | the triangulation and read access | `delaunay.rs` |
//! | one point: locate, cavity, star | `insert.rs`, `locate.rs`, `cavity.rs`, `sight.rs`, `star.rs` |
//! | all points | `build.rs`, `simplex.rs`, `bulk/`; a few `grow.rs` |
//! | one point less | `remove.rs` |
//! | points on a plane | `coplanar.rs` |
//! | questions | `nearest.rs`, `hull.rs` |
//! | invariants | `check.rs` |

mod around;
mod build;
mod bulk;
mod canonical;
mod cavity;
mod check;
mod coplanar;
mod delaunay;
mod exchange;
mod grow;
mod hull;
mod insert;
mod locate;
mod mesh;
mod nearest;
mod remove;
mod sight;
mod simplex;
mod star;

pub use around::{Ring, Star};
pub use cavity::Cavity3;
pub use check::Violation3;
pub use delaunay::Delaunay3;
pub use locate::Location3;
pub use mesh::{FACET_CORNERS, TetMesh};
