//! Triangles judged exactly: a domain that can be meshed, or a list of all that is wrong.
//!
//! | step | file |
//! |---|---|
//! | all steps, one after the other | `build.rs` |
//! | points and triangles one by one, and which are twice | `soup.rs`, `../places.rs` |
//! | how many triangles an edge has, and what is open | `edges.rs`, `holes.rs` |
//! | triangles that agree on their two sides | `patches.rs` |
//! | triangles that intersect | `intersections.rs`, `hierarchy.rs`, `parting.rs` |
//! | which side of a patch is inside | `outwards.rs` |
//! | what was repaired | `options.rs`, `repairs.rs` |
//! | what is wrong | `defect.rs`, `kind.rs`, `defects.rs`, `error.rs` |
//! | closed parts and their volumes | `shells.rs` |

mod build;
mod defect;
mod defects;
mod edges;
mod error;
mod hierarchy;
mod holes;
mod intersections;
mod kind;
mod options;
mod outwards;
mod parting;
mod patches;
mod repairs;
mod shells;
mod soup;

pub use build::Domain3;
pub use defect::{
    Coincident, DomainDefect, Intersection, NoArea, NoSuchCorner, OddEdge, OneSided, OpenEdge,
    Placed, RepeatedCorner, RepeatedTriangle, UnusedPoint,
};
pub use defects::DomainDefects;
pub use error::{DomainError, MarkerCount};
pub use holes::Hole;
pub use kind::DefectKind;
pub use options::Domain3Options;
pub use repairs::Repairs;
pub use shells::Shell;
