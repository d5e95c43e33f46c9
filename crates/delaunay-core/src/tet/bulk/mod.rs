//! The fast way to insert many points: cached circumspheres, no branches on coin tosses, no hash, no
//! allocation in the loop, any number of threads. The result is that of the plain way, tetrahedron for
//! tetrahedron.
//!
//! | step | file |
//! |---|---|
//! | circumspheres and their proved tolerance | `circumsphere.rs` |
//! | records, and which thread may touch which | `arena.rs` |
//! | one point: walk, dig, fill | `inserter.rs`, `walk.rs`, `dig.rs`, `star.rs`, `large.rs` |
//! | branchless stacks | `pile.rs` |
//! | the hottest loops four lanes wide, and doubled precision | `wide.rs`, `wide_star.rs`, `doubled.rs` |
//! | all points, on one thread or several | `growth.rs`, `parts.rs` |

#![allow(unsafe_code)]

mod arena;
mod circumsphere;
mod dig;
#[cfg(target_arch = "x86_64")]
mod doubled;
mod growth;
mod inserter;
mod large;
mod parts;
mod pile;
mod star;
mod walk;
#[cfg(target_arch = "x86_64")]
mod wide;
#[cfg(target_arch = "x86_64")]
mod wide_star;

pub(super) use growth::{Grown, NotGrown, grow};
