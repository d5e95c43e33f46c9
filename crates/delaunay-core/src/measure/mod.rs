//! Measures of shape and size, and their statistics: the one measuring module of the workspace.
//!
//! A measure is a rounded number that judges quality; it never decides topology (predicates do). The
//! papers use several ratios that are easily confused, so each has a name of its own:
//!
//! | name | meaning | range, best | source |
//! |---|---|---|---|
//! | `radius_edge_ratio` | r/l, circumradius over shortest edge | [1/√3, ∞] triangle, [√6/4, ∞] tetrahedron; small is good | blocking §4.1, sinks §4.3 |
//! | [`triangle::radius_ratio`], [`facet::radius_ratio`] | twice inradius over circumradius | [0, 1], 1 for the equilateral | bubbles, eq. 10 |
//! | [`tetrahedron::radius_ratio`] | three times inradius over circumradius | [0, 1], 1 for the regular | |
//! | [`tetrahedron::inradius_quality`] | Q = 2√6 inradius over longest edge | [0, 1], 1 for the regular | CVT, §2.2 |
//! | [`quad::scaled_jacobian`] | least sine of a corner angle | [-1, 1], 1 for the rectangle | |
//!
//! - [`triangle`] measures triangles in the plane, [`facet`] triangles in space; the other modules are named
//!   after what they measure. Corners come as arrays, `[a, b, c]`.
//! - Angles are in **degrees**, as in the papers and reports. They come from an arctangent of sine over
//!   cosine, which is accurate at every angle, unlike an arccosine near 0° and 180°.
//! - For coordinates in the accepted range (`docs/conventions.md`) nothing overflows or vanishes. For finite
//!   coordinates no measure answers NaN: degenerate elements have stated values, the worst of the range.
//! - [`Statistics`] sums up a measure over a mesh; [`AngleSummary`] gives the four angle figures of the
//!   blocking paper (§5).
//!
//! ```
//! use delaunay_core::measure::{Statistics, quad, triangle};
//! use glam::DVec2;
//!
//! let [a, b, c, d] = [[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [0.0, 1.0]].map(DVec2::from);
//! assert_eq!(quad::corner_angles([a, b, c, d]), [90.0; 4]);
//!
//! let ratios = [[a, b, c], [a, c, d]].map(triangle::radius_edge_ratio);
//! let statistics = Statistics::of(ratios.into_iter().enumerate()).unwrap();
//! assert_eq!(statistics.count(), 2);
//! assert!((statistics.max() - 5f64.sqrt() / 2.0).abs() < 1e-15);
//! ```

pub mod facet;
pub mod quad;
mod statistics;
pub mod tetrahedron;
pub mod triangle;

mod angle;
mod double_double;
mod doubled_area;
mod histogram;
mod scale;
mod shape;
mod sum;
mod summary;

pub use angle::AngleSummary;
pub use histogram::Histogram;
pub use statistics::Statistics;
pub use sum::Sum;
pub use summary::Summary;
