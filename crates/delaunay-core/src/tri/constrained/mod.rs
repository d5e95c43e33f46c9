//! Constrained Delaunay triangulations of the plane.
//!
//! | step | file |
//! |---|---|
//! | the triangulation and read access | `triangulation.rs` |
//! | points and segments to a triangulation | `build.rs`, `error.rs` |
//! | a segment becomes an edge | `recover.rs`, `ahead.rs`, `corridor.rs`, `pocket.rs`, `large.rs` |
//! | which vertices a segment leads over | `paths.rs` |
//! | segments that cross are divided | `divide.rs` |
//! | one point: locate, star, flips | `locate.rs`, `insert.rs` |
//! | what segments separate | `components.rs` |
//! | invariants | `check.rs` |

mod ahead;
mod build;
mod check;
mod components;
mod corridor;
mod divide;
mod error;
mod insert;
mod large;
mod locate;
mod paths;
mod pocket;
mod recover;
mod triangulation;

pub use check::ConstrainedViolation;
pub use components::{Components, SeedError};
pub use divide::Crossings;
pub use error::{ConstrainError, Crossing};
pub use triangulation::Constrained2;
