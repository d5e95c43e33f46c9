//! Exact signs of orientation, in-circle and in-sphere determinants, with fast filters and symbolic
//! perturbation.
//!
//! A triangulation decides everything by the signs of a few determinants of its points. Rounded,
//! those signs contradict each other and the triangulation breaks; here they are never wrong.
//!
//! ```
//! use geo_predicates::{DVec2, Sign, check_points2, in_circle, in_circle_perturbed, orient2d};
//!
//! let square = [DVec2::ZERO, DVec2::X, DVec2::ONE, DVec2::Y].map(|corner| corner * 0.1);
//! check_points2(&square)?; // once, at the door
//! let [a, b, c, d] = square;
//! assert_eq!(orient2d(a, b, c), Sign::Positive);
//! assert_eq!(in_circle(a, b, c, d), Sign::Zero);
//! // The tie is broken, always the same way: exactly one of the two diagonals is Delaunay.
//! assert_ne!(in_circle_perturbed(a, b, c, d), in_circle_perturbed(b, c, d, a));
//! # Ok::<(), geo_predicates::CoordinateError>(())
//! ```
//!
//! # Signs
//!
//! ```text
//!          c                                   orient2d(a, b, c)
//!         / \          a, b, c turn            Positive: c is left of the line from a to b
//!        /   \         counterclockwise        Zero: the three are on a line
//!       a --- b
//!
//!          d
//!         /|\          abcd is right-handed:   orient3d(a, b, c, d)
//!        / | \         seen from d, a, b, c    Positive: det [b-a, c-a, d-a] > 0
//!       a -|- c        turn counterclockwise   Zero: the four are on a plane
//!        \ | /
//!          b           (b is nearest to us)
//!
//!        .--c--.
//!      .'       '.     in_circle(a, b, c, d)       of the counterclockwise a, b, c and
//!      a    d    |     in_sphere(a, b, c, d, e)    the right-handed a, b, c, d
//!      '.       .'     Positive: the last point is strictly inside
//!        '--b--'       Zero: it is on the circle (sphere); swapping two corners flips the sign
//!
//!        .--p--.       in_diametral_circle(a, b, p), in_diametral_sphere(a, b, p)
//!      .'  / \  '.     in_diametral_ball(a, b, c, p)
//!      a -------- b    Positive: p is strictly inside the smallest ball through a, b (and c)
//!      '.       .'     Zero: the angle at p is right, as drawn
//!        '-----'
//!
//!                      power_circle(a, b, c, d), power_sphere(a, b, c, d, e)
//!                      Positive: the last is below the others, lifted to |p|^2 - weight
//!
//!        \  | /        meet_in_front([p, q, r], s)
//!      ---\-|/---s     Positive: the common point of the planes p, q, r is in front of s
//!         p\q/r
//! ```
//!
//! Ties of in-circle, in-sphere and power tests are broken in [`perturb`]; orientation never is.
//!
//! # Stages
//!
//! 1. [`filter`]: the determinant in doubles, with a bound on its error. Decides nearly all generic
//!    cases; with the bound 0 for coordinates of few bits, all cases.
//! 2. Coordinates within 61 bits of each other are integers on a common grid, and integers of a few
//!    machine words give the exact sign, without branches: 10 to 120 nanoseconds.
//! 3. Coordinates further apart: floating-point expansions (the `robust` crate), or integers of
//!    any length where that has no such predicate or the degree is too high for doubles.
//!
//! A kernel may put a static filter, with one bound for a whole bounding box, before the first
//! stage, or call the filters itself with vectors relative to its query point.
//!
//! # Ranges and errors
//!
//! Coordinates are finite, and zero or of magnitude 2^-142 to 2^201 ([`coordinate`]). For others every
//! function answers, but signs may be wrong, so check once. Same input, same sign, on all machines.
//!
//! # Features
//!
//! `statistics` counts which stage decided ([`statistics`]); without it counting costs nothing.

pub mod coordinate;
pub mod filter;
pub mod perturb;
pub mod statistics;

mod diametral;
mod few_bits;
mod grid;
mod in_ball;
mod meet;
mod orient;
mod power;
mod sign;
mod unbounded;
mod wide;

pub use coordinate::{
    Axis, CoordinateError, WeightError, check_point2, check_point3, check_points2, check_points3,
    check_weights,
};
pub use diametral::{in_diametral_ball, in_diametral_circle, in_diametral_sphere};
pub use glam::{DVec2, DVec3};
pub use in_ball::{in_circle, in_sphere};
pub use meet::{Plane, meet_in_front, meet_place};
pub use orient::{orient2d, orient3d};
pub use perturb::{
    Lexicographic2, Lexicographic3, cocircular_inside, in_circle_perturbed, in_circle_perturbed_by,
    in_sphere_perturbed, in_sphere_perturbed_by, power_circle_perturbed, power_circle_perturbed_by,
    power_sphere_perturbed, power_sphere_perturbed_by,
};
pub use power::{WeightedPoint2, WeightedPoint3, power_circle, power_sphere};
pub use sign::Sign;
