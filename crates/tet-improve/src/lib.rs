//! Local improvement of tetrahedral meshes: exchanges, smoothing and insertion inside a fixed boundary.
//!
//! Delaunay refinement bounds the ratio of circumradius and shortest edge, and still leaves *slivers*: four points nearly on
//! a circle, with dihedral angles near 0° and 180°. [`improve`] takes the tetrahedra one after the other, the worst first,
//! and changes the mesh round each so that its worst angle becomes better. The facets of the boundary stay as they are.
//!
//! ```
//! use delaunay_core::{Delaunay3, Subcomplex3, progress::silent};
//! use glam::DVec3;
//! use tet_improve::{Params, Stop, improve};
//!
//! // A cube with a lattice of vertices on its faces; those inside lie anyhow.
//! let (mut points, mut inside) = (Vec::new(), 0.0);
//! for [x, y, z] in (0..343_u32).map(|i| [i % 7, i / 7 % 7, i / 49]) {
//!     let mut place = DVec3::new(x.into(), y.into(), z.into());
//!     if [x, y, z].iter().all(|&i| i % 6 != 0) {
//!         inside += 1.0;
//!         place += 0.8 * ((DVec3::new(0.755, 0.57, 0.43) * inside).fract() - 0.5);
//!     }
//!     points.push(place);
//! }
//! let solid = Subcomplex3::of(&Delaunay3::build(&points)?, |_| true);
//! let outcome = improve(solid, &Params { goal: 30.0, vertices_below: 30.0, ..Params::default() }, &mut silent)?;
//! let (before, after) = (outcome.before.unwrap(), outcome.after.unwrap());
//! assert!(before.min < 5.0 && before.max > 175.0);
//! assert!(after.min > 29.99 && after.max < 150.01);
//! assert_eq!((outcome.stop, outcome.solid.boundary().count()), (Stop::AllGood, 432));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! | what | how | file |
//! |---|---|---|
//! | an edge inside goes | the n tetrahedra round it become 2 (n - 2), by dynamic programming | `edge_removal.rs`, `ring.rs` |
//! | facets inside go | those between two vertices give way to an edge | `face_removal.rs` |
//! | a vertex inside moves | to where the worst tetrahedron round it is best | `smoothing.rs`, `ascent.rs`, `min_norm.rs` |
//! | a vertex inside goes | onto a neighbour | `contraction.rs` |
//! | a vertex comes | in the place of the tetrahedra that it is best to replace by its star | `insertion.rs` |
//! | the order of all this | worst first, cheap means first | `schedule.rs`, `worklist.rs`, `attempt.rs` |
//!
//! The quality of a tetrahedron is the smallest sine of its dihedral angles (`quality.rs`), so that small and large angles
//! are one thing. Changes are planned with rounded qualities. Whether what is planned makes a mesh is decided exactly by
//! [`Complex3`](delaunay_core::Complex3), which makes it or refuses.
//!
//! The solids of the sink paper, refined with few points to the ratio 2 (`examples/improve_solid.rs`; both angles the same):
//!
//! | solid | given | asked for | outcome |
//! |---|---|---|---|
//! | cuboctahedron | 13,832 tetrahedra, 0.03° to 179.95° | 20° | 13,127, 20.0° to 159.2° |
//! | | | 30° | 14,185, 30.0° to 149.9° |
//! | paraboloid | 12,334, 0.10° to 179.83° | 20° | 11,801, 20.0° to 156.4° |
//! | | | 30° | 12,937, 30.0° to 148.7° |
//! | star | 114,681, 0.03° to 179.96° | 20° | 112,881, 20.0° to 160.0° |
//! | | | 25° | 163,436, 24.4° to 155.0° |
//! | head | 168,922, 0.37° to 179.18° | 20° | 164,102, 20.0° to 159.9° |
//! | | | 25° | 219,497, 25.0° to 155.0° |
//!
//! 20° takes some 5 microseconds for each tetrahedron given, 30° for the first two some 30, 25° for the others some 70.
//!
//! What can be reached is a matter of the boundary: a tetrahedron on a triangle of the boundary has no more freedom than
//! its fourth corner, and where the boundary turns by less than 40° at an edge, no tetrahedron there has 40°.
//!
//! Sources: Freitag and Ollivier-Gooch 1997; Shewchuk 2002; Klingner and Shewchuk 2007; each file names its own.

mod ascent;
mod attempt;
mod contraction;
mod edge_removal;
mod error;
mod face_removal;
mod improve;
mod improver;
mod insertion;
mod min_norm;
mod outcome;
mod params;
mod plan;
mod quality;
mod records;
mod ring;
#[cfg(test)]
mod sample;
mod schedule;
mod smoothing;
mod stars;
mod worklist;

pub use error::ImproveError;
pub use improve::improve;
pub use outcome::{Counters, Dihedrals, Low, Outcome, Stop};
pub use params::Params;
