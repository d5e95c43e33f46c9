//! Sinks of Delaunay triangulations, after Edelsbrunner and Guoy, *Sink-insertion for mesh improvement* (2001).
//!
//! From a triangle whose circumcenter lies beyond one of its edges, the flow runs across that edge, and so on
//! until a triangle contains its circumcenter, which is then a *sink*, or the flow leaves the convex hull.
//! Triangles of low quality come in crowds that share a few sinks: to insert sinks instead of all
//! circumcenters is a thrifty way to a good mesh.
//!
//! ```
//! use delaunay_core::Delaunay2;
//! use glam::DVec2;
//! use sink_refine::{End, Sinks, sink};
//!
//! // A flat triangle on top of an acute one.
//! let points = [[0.0, 0.0], [4.0, 0.0], [2.0, 1.0], [2.0, -8.0]].map(DVec2::from);
//! let delaunay = Delaunay2::build(&points)?;
//! let sinks = Sinks::of(&delaunay);
//! let acute = sinks.triangles().next().unwrap();
//! assert_eq!(sink(&delaunay, acute), DVec2::new(2.0, -3.75));
//! assert_eq!(sinks.ancestors(End::Sink(acute)).len(), 2);
//! # Ok::<(), delaunay_core::BuildError>(())
//! ```
//!
//! [`refine3`] improves the tetrahedra of a solid. In the plane the crate has the flow and the sinks of a
//! triangulation; refinement there is to come.

mod error;
mod flow;
mod history;
mod params;
mod sinks;
mod stop;
pub mod tet;

pub use error::RefineError;
pub use flow::{Successor, flows_through, path, successor};
pub use history::{Counters, Round};
pub use params::{Candidate, Coarsening, Method, Params, Schedule};
pub use sinks::{End, Sinks, sink};
pub use stop::Stop;
pub use tet::{Low3, Outcome3, Reason3, Separation3, refine3};
