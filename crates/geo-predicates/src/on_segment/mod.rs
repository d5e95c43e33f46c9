//! Points that lie exactly on a segment between two others, and signs for them.
//!
//! ```text
//!   from ────────── p ───── to       p = from + share · (to - from), a number that doubles seldom can hold
//! ```
//!
//! A mesh that has to contain a segment divides it at such points. Rounded they would lie beside it, and beside the planes
//! through it. So [`SegmentPoint3`] keeps the three numbers that define the point; what of it can be told in twice the precision of a
//! double decides nearly all signs, and integers of any length decide the rest.
//!
//! | step | file |
//! |---|---|
//! | the point, and its place in twice the precision | `point.rs`, `doubled.rs` |
//! | differences with a bound on their error, and determinants of them | `difference.rs` |
//! | integers | `whole.rs` |
//! | signs | `signs.rs` |

mod difference;
mod doubled;
mod point;
mod signs;
mod whole;

pub use point::{ExactPoint3, SegmentPoint3};
pub use signs::{in_sphere_perturbed_exact, orient3d_exact};
