//! Other boundary nodes than those given: along chains of edges that are smooth, between corners that stay.
//!
//! | step | file |
//! |---|---|
//! | which edges make a smooth chain, and the curve through its nodes | `chains.rs` |
//! | new nodes on these curves, with sizes that change slowly | `resample.rs` |
//! | nodes that move along these curves | `rails.rs` |
//! | whether the boundary meets itself then | `simple.rs` |

mod chains;
mod rails;
mod resample;
mod simple;

pub(crate) use rails::Rails;
pub use resample::{ResampleError, Resampled, Resampling, resample};
pub(crate) use simple::is_boundary_simple;
