//! Floating-point filters: determinants in doubles with a bound on their error.
//!
//! A kernel that inserts a point `p` meets each vertex as a vector from `p` with its squared
//! length ([`Relative2`], [`Relative3`]), computed once. [`Filter2`] and [`Filter3`] turn those
//! into signs; `None` means the doubles cannot tell, and the exact predicate of the crate root
//! must be asked. NaN coordinates (a vertex at infinity, say) always give `None`.
//!
//! ```
//! use geo_predicates::filter::{Filter2, Relative2};
//! use geo_predicates::{DVec2, Sign, in_circle};
//!
//! let p = DVec2::new(0.4, 0.3);
//! let corners = [DVec2::ZERO, DVec2::X, DVec2::Y];
//! let [a, b, c] = corners.map(|corner| Relative2::new(corner, p));
//! let filter = Filter2::for_points(&corners.map(|corner| corner * 0.1));
//! let inside = filter
//!     .in_circle_relative(&a, &b, &c)
//!     .unwrap_or_else(|| in_circle(corners[0], corners[1], corners[2], p));
//! assert_eq!(inside, Sign::Positive);
//! ```
//!
//! # Bounds
//! With unit roundoff `u = 2^-53` and `l` the squared lengths of the vectors from the query point,
//! the error is at most
//!
//! | determinant | bound |
//! |---|---|
//! | `orient2d`, `in_diametral_circle` | `(3 + 16 u) u` times the sum of the two products' magnitudes |
//! | `orient3d` | `7.78e-16` times the permanent, or times the product of the 1-norms of the rows |
//! | `in_circle` | `3.71e-16 (la + lb + lc)^2` |
//! | `in_sphere` | `2.6e-16 (la + lb + lc + ld)^(5/2)` |
//! | `in_diametral_sphere` | `5.6e-16` times the sum of the three products' magnitudes |
//! | `in_diametral_ball` | `2.5e-15 U V (U + V + 4 W) + 2^-1022` |
//! | `power_circle`, `power_sphere` | `4.6e-16 s^2`, `3.3e-16 s^(5/2)` |
//!
//! The first four start from bound A of Shewchuk 1997 ("Adaptive precision floating-point
//! arithmetic and fast robust geometric predicates"), whose order of evaluation is kept: `3`, `7`,
//! `10` and `16` times `u` times the permanent, the sum of the magnitudes of all products, where
//! the last rounding is left out because it cannot change a sign.
//! - `orient2d`: the two products of opposite sign do not cancel, so the magnitude of their sum
//!   may replace the sum of their magnitudes (Ozaki et al. 2016).
//! - `orient3d`: the permanent of three rows is part of the expanded product of their 1-norms.
//! - `in_circle`: the permanent is `la (|bx cy| + |by cx|) + ...`; by Cauchy the bracket is at most
//!   `|b| |c| <= (lb + lc) / 2`, and `la lb + lb lc + lc la <= (la + lb + lc)^2 / 3`.
//! - `in_sphere`: the permanent of three rows of unit length is at most `2 / sqrt 3`, so that of
//!   the determinant is at most `(2 / sqrt 3) |a| |b| |c| |d| (|a| + |b| + |c| + |d|)`, which for a
//!   given sum `s` of the lifts is largest when they are equal: `(2 / sqrt 3) (s / 4)^2 2 sqrt s`.
//! - power tests: as in-circle and in-sphere, with one more rounding in each lift and
//!   `s` the sum of `|vector|^2 + |weight difference|`.
//! - `in_diametral_ball`: counting roundings along the evaluation gives `19 u` times the sum over
//!   the axes of `P(u, v) (U P(v, w) + V P(w, u) + W P(u, v))`, with `P(a, b)` the permanent of two
//!   components and `U`, `V`, `W` the squared lengths. By Cauchy the sum of `P(a, b)^2` is at most
//!   `2 |a|^2 |b|^2`, hence `2 U V (|u| |w| + |v| |w| + W) <= U V (U + V + 4 W)`.
//!
//! Each constant has slack for terms of higher order and for the rounding of the bound itself.
//! Apart from `in_diametral_ball` nothing underflows or overflows for accepted coordinates: all
//! numbers on the way are multiples of 2^-970 and below 2^1018.
//!
//! # Few bits
//! When all coordinates are integers of few bits times one power of two, the doubles are exact
//! and the bound is 0 ([`Filter2::for_points`]): lattices, the worst case of the general filter,
//! then never reach the exact stage, and a determinant of 0 is a true tie. With differences of at
//! most `e` units, the determinants are at most `2 e^2`, `12 e^4`, `6 e^3` and `72 e^5`, sums on the
//! way included, and must not exceed 2^53.
//!
//! # What did not pay
//! Selecting the sign without branches (the compiler already does, and lost it; settling ties without branches
//! did pay, see [`Filter3::in_exact_sphere`] and [`raised_inside`]), a square root per
//! orientation in space, the greatest coordinates instead of the permanent, and determinants in
//! batches (no gain for `orient2d`, 1.3 times for `orient3d`, 1.7 times for `in_circle`; the
//! relative form gains more).

mod fixed;
mod plane;
mod space;

pub use fixed::{StaticFilter2, StaticFilter3};
pub use plane::{Cross, Filter2, Relative2, raised_inside};
pub(crate) use plane::{in_diametral_circle, power_circle};
pub use space::{Filter3, Relative3};
pub(crate) use space::{in_diametral_ball, in_diametral_sphere, power_sphere};

use crate::sign::Sign;
use crate::statistics::{Predicate, Stage, record};

/// Factor of a filter's bound: 0 where `extent` shows the doubles to be exact.
fn exact_up_to(limit: f64, extent: f64, general: f64) -> f64 {
    if extent <= limit { 0.0 } else { general }
}

/// Sign of a number known up to an error of at most `bound`, if certain. A bound of 0 says that
/// it is exact. NaN anywhere is never certain.
#[inline(always)]
fn certain(predicate: Predicate, value: f64, bound: f64) -> Option<Sign> {
    let sign = sign_within(value, bound);
    if sign.is_some() {
        record(predicate, Stage::Filter);
    }
    sign
}

#[inline(always)]
fn sign_within(value: f64, bound: f64) -> Option<Sign> {
    if value > bound {
        Some(Sign::Positive)
    } else if value < -bound {
        Some(Sign::Negative)
    } else if bound == 0.0 {
        Some(Sign::Zero)
    } else {
        None
    }
}
