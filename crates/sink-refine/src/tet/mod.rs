//! Refinement in space.
//!
//! | step | file |
//! |---|---|
//! | successors, sinks (§3.2, §3.3) | `flow.rs` |
//! | ancestors, the whole relation (§3.3) | `flow_graph.rs` |
//! | square distances π and φ (§3.1) | `square_distance.rs` |
//! | stable subcomplex (§5.1) | `stable.rs` |
//! | prestar, boundary test (§4.1, §5.1) | `proposal.rs` |
//! | independence, orthogonality (§4.4) | `independence.rs` |
//! | minimum separation, number of vertices (§4.4) | `separation.rs` |
//! | low quality (§4.3) | `records.rs`, `low.rs` |
//! | too large, beyond the paper | `sizes.rs` |
//! | sinks or circumcenters | `candidate.rs`, `watershed.rs` |
//! | schedules (§4.5) | `schedule/` |
//! | fewer points | `economical/` |
//! | dividing the boundary | `boundary/` |
//! | the driver | `refine.rs`, `refiner.rs` |

mod boundary;
mod candidate;
mod economical;
mod flow;
mod flow_graph;
mod independence;
mod low;
mod marks;
mod proposal;
mod records;
mod refine;
mod refiner;
mod schedule;
mod separation;
mod sizes;
mod square_distance;
mod stable;
mod watershed;

pub use flow::{FlowWalk, Successor3, is_sink, sink, successors};
pub use flow_graph::FlowGraph3;
pub use independence::{are_independent, are_orthogonal_or_further};
pub use low::{Low3, Reason3};
pub use refine::{Outcome3, refine3, refine3_sized};
pub use separation::Separation3;
pub use square_distance::{phi, pi};
pub use stable::stable_tets;
