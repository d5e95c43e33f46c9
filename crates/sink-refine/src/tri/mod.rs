//! Refinement in the plane.
//!
//! | step | file |
//! |---|---|
//! | successors (§3.3) | `flow.rs` |
//! | sinks, watersheds (§3.2, §3.3) | `sinks.rs` |
//! | square distances π and φ (§3.1) | `square_distance.rs` |
//! | stable subcomplex (§5.1) | `stable.rs` |
//! | prestar, boundary test (§4.1, §5.1) | `proposal.rs` |
//! | independence, orthogonality (§4.4) | `independence.rs` |
//! | minimum separation, number of vertices (§4.4) | `separation.rs` |
//! | low quality (§4.3) | `records.rs`, `low.rs` |
//! | too large, beyond the paper | `sizes.rs` |
//! | sinks or circumcenters | `candidate.rs` |
//! | schedules (§4.5) | `schedule/` |
//! | fewer points | `economical/` |
//! | dividing the boundary | `boundary/` |
//! | the driver | `refine.rs`, `refiner.rs` |

mod boundary;
mod candidate;
mod economical;
mod flow;
mod independence;
mod low;
mod proposal;
mod records;
mod refine;
mod refiner;
mod schedule;
mod separation;
mod sinks;
mod sizes;
mod square_distance;
mod stable;

pub use flow::{Successor, Triangles, flows_through, path, successor};
pub use independence::{are_independent, are_orthogonal_or_further};
pub use low::{Low2, Reason2};
pub use refine::{Outcome2, refine2, refine2_sized};
pub use separation::Separation2;
pub use sinks::{End, Sinks, sink};
pub use square_distance::{phi, pi};
pub use stable::stable_faces;
