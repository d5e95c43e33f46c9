//! Why a refinement ended.

use crate::sizing::UnusableSize;
use delaunay_core::progress::Cancelled;

/// Why a refinement ended. The mesh is valid in every case.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Stop {
    /// No element of low quality is left, nor one that is too large.
    AllGood,
    /// All that is left of low quality is listed, each element with the reason why nothing could be inserted for it.
    NothingToInsert,
    /// The budget of vertices is used up.
    OutOfVertices,
    /// The ids of vertices or tetrahedra are used up.
    OutOfIds,
    /// The sizing field has answered what is no size. Nothing more was inserted; elements there count as if no size had been
    /// asked for.
    UnusableSize(UnusableSize),
    /// The report closure stopped the work.
    Cancelled(Cancelled),
}

impl From<Cancelled> for Stop {
    fn from(cancelled: Cancelled) -> Self {
        Self::Cancelled(cancelled)
    }
}
