//! Delaunay refinement by sinks, after Edelsbrunner and Guoy, *Sink-insertion for mesh improvement* (2001).
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
//! [`refine2`] improves the triangles of a region, [`refine3`] the tetrahedra of a solid. The boundary stays as it is,
//! unless [`Boundary::Split`] allows that it is divided.
//! [`refine2_sized`] and [`refine3_sized`] also keep elements from being too large.
//!
//! ```
//! use delaunay_core::{BuildOptions, Outline, Subcomplex2, VertexId, progress::silent};
//! use glam::DVec2;
//! use sink_refine::{Candidate, Coarsening, Method, Params, Schedule, Stop, refine2};
//!
//! // A round window in a square frame, all edges about as long.
//! let ring = |n: usize, place: fn(f64) -> DVec2| (0..n).map(move |i| place(i as f64 / n as f64));
//! let mut points: Vec<DVec2> = ring(12, |t| DVec2::from_angle(t * std::f64::consts::TAU) * 2.0).collect();
//! for corner in [[-7.0, -7.0], [7.0, -7.0], [7.0, 7.0], [-7.0, 7.0]].map(DVec2::from) {
//!     points.extend((0..14).map(|i| corner.lerp(corner.perp(), f64::from(i) / 14.0)));
//! }
//! let circle = (0..12).map(|i| [i, (i + 1) % 12]);
//! let frame = (0..56).map(|i| [12 + i, 12 + (i + 1) % 56]);
//! let segments = circle.chain(frame).map(|ends| ends.map(VertexId::new)).collect();
//! let region = Outline::new(points, segments)?.region(BuildOptions::default(), &mut silent)?;
//! let region = region.subcomplex();
//!
//! // As in the paper; and with as few points as can be.
//! let method = Method::Paper { candidate: Candidate::Sink, schedule: Schedule::Parallel };
//! let paper = refine2(region.clone(), &Params { ratio: 1.0, method, ..Params::default() }, &mut silent)?;
//! let method = Method::Economical(Coarsening::Merging);
//! let fewer = refine2(region, &Params { ratio: 1.0, method, ..Params::default() }, &mut silent)?;
//! assert_eq!((paper.stop, fewer.stop), (Stop::AllGood, Stop::AllGood));
//! assert!(fewer.region.faces().count() < paper.region.faces().count());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! | what | where |
//! |---|---|
//! | the plane | [`tri`] |
//! | space | [`tet`] |
//! | what is asked for | [`Params`], [`Sizing`] |
//! | what was done | [`Round`], [`Counters`], [`Stop`] |

mod boundary;
mod error;
mod history;
mod params;
mod quality;
mod random_points;
mod region_sizes;
mod sizing;
mod spheres;
mod stamp;
mod stop;
mod taken;
pub mod tet;
pub mod tri;
mod worklist;

pub use error::RefineError;
pub use history::{Counters, Round};
pub use params::{Boundary, Candidate, Coarsening, Method, Params, Schedule};
pub use sizing::{RegionLimit, Sizing, Sizing2, Sizing3, UnusableSize};
pub use stop::Stop;
pub use tet::{Low3, Outcome3, Reason3, Separation3, refine3, refine3_sized};
pub use tri::{
    End, Low2, Outcome2, Reason2, Separation2, Sinks, Successor, Triangles, flows_through, path,
    refine2, refine2_sized, sink, successor,
};
