//! The fast loop behind a bulk build: the same steps as an insertion of one point (`locate.rs`, `cavity.rs`,
//! `star.rs`), on memory that is reserved once and accessed without checks, on one thread or several.
//!
//! | step | file |
//! |---|---|
//! | faces and points as memory | `arena.rs` |
//! | the first three points | `triangle.rs` |
//! | one thread: walk, dig, fill | `worker.rs`, `walk.rs`, `dig.rs`, `fill.rs` |
//! | the buffers of digging | `diggings.rs` |
//! | cavities that are given up | `undo.rs` |
//! | the vertices whose faces it may replace | `part.rs` |
//! | all points, round by round | `rounds.rs`, `share.rs` |
//! | from insertion order to the caller's numbers | `finish.rs` |
//!
//! # Where faces are
//! Each vertex brings two faces, and the vertex of slot `s` brings the faces `2 s - 4` and `2 s - 3`: in
//! which order and by which thread points are inserted does not move them, there is no counter to
//! share and no gap to close, except where a duplicate brings nothing.
//!
//! # Several threads
//! In a round (see [`crate::order`]) each thread inserts the points on its stretches of the curve. The
//! vertices there, of this round and of all before, are its *part*; parts are disjoint, and the ghost is
//! in none. A *face of the part* is one whose real corners all are. The rule is: **a thread replaces faces of its
//! part only.** When a cavity has any other face, or the walk leads to one, the thread puts back the faces that
//! it has replaced for this point and gives it up, for later. Postponed points are
//! inserted on several threads again if they are many, in parts with other borders, and then on one.
//!
//! There are no locks and no atomics in this. What a thread touches of the mesh is:
//!
//! 1. It **writes** faces of its part whole, and the two faces that its point brings. All corners of
//!    a face it writes are in the part, because the corners of a star are those of the cavity and
//!    the point.
//! 2. It **writes** single twins of faces outside a cavity, on an edge of a face in it.
//! 3. It **reads** twins of faces of its part, and the twin on the edge at which a walk starts, between two
//!    real vertices of the part.
//! 4. It **reads** corners of faces of its part and of faces across their edges.
//!
//! An edge has at most one ghost end, so a face across an edge of a face of the part has a real corner in
//! the part. Hence no other thread touches the same memory, unless both read it:
//!
//! - a face written under 1 has all real corners in the part, and faces that other threads touch have at least
//!   one in theirs: they are different faces;
//! - corners are written under 1 alone, so reading them under 4, of faces with a corner in the part, meets no writer;
//! - all real ends of an edge whose twin is touched under 2 or 3 are in the part, and there is at least one: no
//!   other thread touches the twin on that side of that edge.
//!
//! Single twins are written through pointers to them, never by way of their face: of a ghost face with the real
//! corners in two parts, two threads may write different twins at the same time.
//!
//! Between rounds, and before and after the postponed points, all threads meet. So what is built depends
//! on the parts, not on the speed of threads; and the set of faces depends on the points alone.

// Checked indices cost 5 to 7 % of a build.
#![allow(unsafe_code)]

mod arena;
mod dig;
mod diggings;
mod fill;
mod finish;
mod part;
mod rounds;
mod share;
mod triangle;
mod undo;
mod walk;
mod worker;

pub(super) use finish::Finish;
pub(super) use rounds::Bulk;
pub(super) use triangle::bring_triangle_to_front;
