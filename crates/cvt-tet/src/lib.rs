//! Meshes from centroidal Voronoi tessellations, after Du and Wang, *Tetrahedral mesh generation and optimization
//! based on centroidal Voronoi tessellations* (2003).
//!
//! Points that are the mass centroids of their own Voronoi cells are spread evenly, and their Delaunay
//! triangulation is a good mesh. Lloyd's iteration finds such points:
//!
//! ```
//! use cvt_tet::{Generators, Params, Stop, lloyd};
//! use delaunay_core::{ConvexPolygon, progress::silent};
//! use glam::DVec2;
//!
//! let square = ConvexPolygon::rectangle(DVec2::ZERO, DVec2::ONE)?;
//! let points = [[0.1, 0.2], [0.9, 0.3], [0.6, 0.7], [0.2, 0.6]].map(DVec2::from);
//! let outcome = lloyd(Generators::new(square, &points)?, &Params::default(), &mut silent);
//! assert_eq!(outcome.stop, Stop::Converged);
//! // Four points come to rest at the centers of four quarters, the cost at 4 (1/2)⁴ / 6.
//! assert!((outcome.costs.last().unwrap() - 1.0 / 24.0).abs() < 1e-5);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! In the crate today: centroidal Voronoi tessellations of convex regions of the plane (§3, figure 1), for
//! density 1 with exact moments and for any density by quadrature, free or with points bound to the boundary
//! (§3.4, see [`Generators::attached`]). To come: what gives the crate its name, constrained tessellations of
//! solids and their tetrahedra (§4, §5).

mod boundary;
mod cost;
mod error;
mod generators;
mod lloyd;
mod moments;
mod place;

pub use cost::{cost, cost_with};
pub use error::{DensityError, GeneratorError};
pub use generators::Generators;
pub use lloyd::{Outcome, Params, Stop, lloyd, lloyd_with};
pub use moments::Moments;
pub use place::Place;
