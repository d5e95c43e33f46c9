//! The method of the paper, step by step: the mode to compare with.
//!
//! Luo, *Automatic Delaunay mesh generation method and physically-based mesh optimization method on two-dimensional regions*.
//!
//! | step | file |
//! |---|---|
//! | §2.1 the region and its initial boundary mesh | [`Domain`](crate::Domain) |
//! | §2.3 node bubbles, element bubbles, bubble density (eq. 1–5) | [`Bubble`](crate::Bubble) |
//! | §2.4 generation, steps a–f (eq. 6) | `generate.rs`, `queue.rs` |
//! | §3.6 optimization, steps a–e | `optimize.rs`, `bubbles.rs` |
//! | §3.3 nearby nodes in three rings, and those of them that can overlap | `nearby.rs`, `contacts.rs` |
//! | §3.2 position adjustment (eq. 7, 8), and what keeps nodes inside | `force.rs`, `confine.rs` |
//! | §3.4 size adjustment (eq. 9) | `resize.rs` |
//! | §3.5 constrained Delaunay triangulation of the moved nodes | `triangulate.rs` |
//!
//! ```
//! use bubble_mesh::{Domain, paper, radius_ratio};
//! use delaunay_core::{BuildOptions, Outline, VertexId, progress::silent};
//! use glam::DVec2;
//!
//! // A circle with 60 nodes.
//! let node = |i: usize| DVec2::from_angle(i as f64 * std::f64::consts::TAU / 60.0);
//! let edges = (0..60).map(|i| [i, (i + 1) % 60].map(VertexId::new));
//! let circle = Outline::new((0..60).map(node).collect(), edges.collect())?;
//! let domain = Domain::new(&circle, BuildOptions::default(), &mut silent)?;
//!
//! let params = paper::Params::paper();
//! let generated = paper::generate(&domain, &params, &mut silent);
//! assert_eq!(generated.stop(), paper::Stop::Filled);
//! let optimized = paper::optimize(&generated, &params, &mut silent)?;
//!
//! let mean = |region: &delaunay_core::Subcomplex2| {
//!     let ratios = region.faces().map(|f| radius_ratio(region.triangle(f)));
//!     ratios.sum::<f64>() / region.faces().count() as f64
//! };
//! assert!(mean(generated.region()) > 0.8 && mean(&optimized.region) > 0.94);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod bubbles;
mod confine;
mod contacts;
mod force;
mod generate;
mod nearby;
mod optimize;
mod params;
mod queue;
mod resize;
mod triangulate;

pub use force::{moved, repulsion};
pub use generate::{Mesh, Stop, generate};
pub use nearby::{RINGS, rings};
pub use optimize::{Optimized, initial_bubbles, optimize};
pub use params::Params;
pub use resize::resized;
