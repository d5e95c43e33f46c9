//! Why a refinement ended.

use delaunay_core::progress::Cancelled;

/// Why a refinement ended. The mesh is valid in every case.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stop {
    /// No element of low quality is left.
    AllGood,
    /// All that is left of low quality is listed, each element with the reason why nothing could be inserted for it.
    NothingToInsert,
    /// The budget of vertices is used up.
    OutOfVertices,
    /// The ids of vertices or tetrahedra are used up.
    OutOfIds,
    /// The report closure stopped the work.
    Cancelled(Cancelled),
}

impl From<Cancelled> for Stop {
    fn from(cancelled: Cancelled) -> Self {
        Self::Cancelled(cancelled)
    }
}
