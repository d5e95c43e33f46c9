//! Other boundary nodes than those given: along chains of edges that are smooth, between corners that stay.
//!
//! | step | file |
//! |---|---|
//! | which edges make a smooth chain, and the curve through its nodes | `chains.rs` |
//! | new nodes on these curves, with sizes that change slowly | `resample.rs` |
//! | nodes that move along these curves | `rails.rs` |

mod chains;
mod rails;
mod resample;

pub(crate) use rails::Rails;
pub use resample::{ResampleError, Resampled, Resampling, resample};
