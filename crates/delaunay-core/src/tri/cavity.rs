//! Cavity of a point: the faces whose circumdisk contains it, and their boundary.
//!
//! The sink paper calls the cavity *prestar*. It holds no vertex inside, so the faces hang together
//! like a tree, and a walk round that tree from left to right meets the boundary edges in
//! counterclockwise order and no face twice: no marks, no queue, no hash.
//!
//! ```text
//!        c                 top of the pending edges: a->b, with the outer half-edge o = b->a.
//!      /   \               Face (b, a, c) of o is in the cavity: pending a->c above c->b.
//!    /       \             It is not: a->b is on the rim, b becomes the current start.
//!   a --------- b
//!        p
//! ```
//!
//! A ghost face stands on a hull edge and its "circumdisk" is the open half-plane outside, together
//! with the open edge itself.

use super::sight::Seen;
use crate::ids::{FaceId, HalfEdgeId, VertexId};
use geo_predicates::filter::Cross;

/// One edge of the rim of a cavity, counterclockwise round it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RimEdge {
    /// Where the edge starts; it ends where the next one starts.
    pub origin: VertexId,
    /// The half-edge on the other side, in the face outside the cavity.
    pub outer: HalfEdgeId,
}

/// The faces whose open circumdisk contains a point, and the edges that bound them.
#[derive(Clone, Debug, Default)]
pub struct Cavity {
    pub(super) faces: Vec<FaceId>,
    pub(super) rim: Vec<RimEdge>,
    pub(super) pending: Vec<PendingEdge>,
}

/// An edge that still has to be crossed or put on the rim; it starts where the one above ends.
#[derive(Clone, Copy, Debug)]
pub(super) struct PendingEdge {
    pub(super) end: Seen,
    pub(super) outer: HalfEdgeId,
    /// Cross of the end and the start.
    pub(super) backwards: Cross,
}

impl Cavity {
    /// The faces, ghosts included, the one that contains the point first.
    #[must_use]
    pub fn faces(&self) -> &[FaceId] {
        &self.faces
    }

    /// The edges round the cavity, counterclockwise, two more than faces.
    #[must_use]
    pub fn rim(&self) -> &[RimEdge] {
        &self.rim
    }

    /// The vertices round the cavity, counterclockwise; those that inserting the point would make
    /// its neighbours, the ghost included.
    #[must_use]
    pub fn vertices(&self) -> impl ExactSizeIterator<Item = VertexId> + '_ {
        self.rim.iter().map(|edge| edge.origin)
    }

    /// Becomes a cavity found earlier, of faces that have not changed since.
    pub fn assign(&mut self, faces: &[FaceId], rim: &[RimEdge]) {
        self.clear();
        self.faces.extend_from_slice(faces);
        self.rim.extend_from_slice(rim);
    }

    pub(super) fn clear(&mut self) {
        self.faces.clear();
        self.rim.clear();
        self.pending.clear();
    }
}
