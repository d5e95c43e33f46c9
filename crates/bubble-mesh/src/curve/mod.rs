//! Boundaries from smooth curves: nodes and edges as fine as size, curvature and neighbours ask for.
//!
//! A [`Curve`] is a closed loop or an open chain of [`Piece`]s: straight ones, arcs of circles and ellipses, cubics of Bézier, cubic
//! splines through points. [`sample_all`] places nodes on curves as a [`Sampling`] asks; what it returns is the
//! [`Outline`](delaunay_core::Outline) of a [`Domain`](crate::Domain).
//!
//! ```
//! use bubble_mesh::curve::{Curve, Piece, Sampling, sample_all};
//! use bubble_mesh::graded::{GradedParams, mesh};
//! use bubble_mesh::{Domain, radius_ratio};
//! use delaunay_core::{BuildOptions, progress::silent};
//! use glam::DVec2;
//!
//! // An airfoil, NACA 0012 with a sharp trailing edge, in a channel.
//! let thickness = |x: f64| {
//!     0.6 * (0.2969 * x.sqrt() + x * (-0.126 + x * (-0.3516 + x * (0.2843 - 0.1036 * x))))
//! };
//! let around = |k: i32| {
//!     let x = (f64::from(k) / 24.0).powi(2);
//!     DVec2::new(x, thickness(x).copysign(f64::from(k)))
//! };
//! let points: Vec<DVec2> = (-24..=24).map(around).collect();
//! let airfoil = Curve::closed(vec![Piece::spline(&points)?])?;
//! let corners = [[-1.0, -0.8], [2.0, -0.8], [2.0, 0.8], [-1.0, 0.8]].map(DVec2::from);
//! let channel = Curve::polygon(&corners)?;
//!
//! let sampling = Sampling { chord: 1e-3, grade: 0.2, ..Sampling::new(0.2) };
//! let sampled = sample_all(&[channel, airfoil], &sampling)?;
//! let domain = Domain::new(&sampled.outline()?, BuildOptions::default(), &mut silent)?;
//! let mesh = mesh(&domain, &GradedParams::default(), &mut silent)?.complex;
//! assert!(mesh.faces().all(|f| radius_ratio(mesh.triangle(f)) > 0.85));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # How
//!
//! The size at a place of a curve is the least of `size`, the edge that strays by `chord` from a circle of the same curvature `k`, which is
//! `sqrt(8 chord / k)`, and what all sizes elsewhere permit: that of a place at a distance `d`, on the same curve or on another, and
//! `grade · d` more. Nodes divide the integral of one over the size into equal shares from joint to joint.
//!
//! # What is promised
//!
//! Lengths are arc lengths, numbers are as good as rounding to the ninth digit.
//!
//! - The ends of pieces are nodes, exactly.
//! - No edge is longer than `size`, nor than its piece, nor than a third of a closed curve.
//! - No part of a curve is further than `chord` from its edge. Curves that are more than two `chord`s apart have edges that do not cross.
//! - On one piece an edge is at most `exp(grade)` times as long as the one before or after it; where pieces meet, at most
//!   `(exp(grade) - 1) / (1 - exp(-grade / 2))` times, which is 2.5 for 0.3. That happens next to pieces with very few edges; as a rule
//!   it is about `exp(grade)` there too.
//! - The circle of radius r alone has equal edges, as many as 2 π r over its size, rounded up, three at least. So has an arc.
//! - Sizes H and h at two places at a distance g, on one curve or on two, have (H - h) / g up to `grade`. Edges are 0.84 to 1.08 of the size
//!   in their middle with a `grade` of 0.3, because sizes vary within an edge and the number of edges is whole; pieces
//!   with few edges may have shorter ones in rare cases, half as long at worst.
//!
//! Sizes do not ask how wide a gap is: where two coarse edges face each other across a narrow one, say a smaller `size`.
//!
//! | step | file |
//! |---|---|
//! | formulas for places, derivatives and lengths | `stretch.rs`, `spline.rs`, `interval.rs` |
//! | curves of pieces, judged | `piece.rs`, `chain.rs` |
//! | sizes along a curve | `track.rs` |
//! | sizes that grow slowly in the plane | `grade.rs`, and `envelope.rs` beside this folder |
//! | nodes at equal shares | `place.rs` |
//! | edges that stray too far | `stray.rs` |
//! | the whole, step by step | `sample.rs`, `sampled.rs`, `params.rs` |

mod chain;
mod error;
mod grade;
mod interval;
mod params;
mod piece;
mod place;
#[cfg(test)]
mod promises;
mod sample;
mod sampled;
mod spline;
mod stray;
mod stretch;
mod track;

pub use chain::Curve;
pub use error::{CurveError, SamplingError};
pub use params::Sampling;
pub use piece::Piece;
pub(crate) use sample::sample_sized;
pub use sample::{sample, sample_all};
pub use sampled::Sampled;
pub(crate) use track::Sizes;
