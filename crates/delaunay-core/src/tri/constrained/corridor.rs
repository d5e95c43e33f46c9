//! The triangles that a straight way between two vertices crosses.
//!
//! ```text
//!           l ------- l              left wall, from b to a
//!         / | \     / | \
//!       /   |   \ /   |   \          the faces hang together like a chain; the walls
//!     a ----+----+----+----> b       are what bounds them on either side
//!       \   |   / \   |   /
//!         \ | /     \ | /
//!           r ------- r              right wall, from a to b
//! ```
//!
//! A wall may come to a vertex twice, when an edge sticks into the corridor that does not cross the way: then it has
//! that edge on both sides.

use super::super::mesh::TriMesh;
use super::super::sight::Sight;
use crate::ids::{FaceId, HalfEdgeId, VertexId};
use geo_predicates::Sign;

/// The faces crossed, and the half-edges of theirs that bound them.
#[derive(Clone, Debug, Default)]
pub(super) struct Corridor {
    pub(super) faces: Vec<FaceId>,
    /// Counterclockwise round the faces, from the start to the end.
    pub(super) right: Vec<HalfEdgeId>,
    /// Counterclockwise round the faces, from the end to the start.
    pub(super) left: Vec<HalfEdgeId>,
}

/// Where a way through triangles ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum End {
    /// At a vertex: the one that it leads to, or one on the way.
    Vertex(VertexId),
    /// At an edge that it may not cross; its half-edge on the near side.
    Barrier(HalfEdgeId),
}

impl Corridor {
    /// Follows the way to the vertex that `sight` looks from, out of `start` across the half-edge `first` opposite it,
    /// until the next vertex on the way or an edge that may not be crossed.
    pub(super) fn dig(
        &mut self,
        mesh: &TriMesh,
        sight: &Sight<'_>,
        start: VertexId,
        first: HalfEdgeId,
        is_barrier: impl Fn(HalfEdgeId) -> bool,
    ) -> End {
        self.clear();
        self.faces.push(first.face());
        self.right.push(first.prev());
        self.left.push(first.next());
        let here = sight.see(start);
        let mut crossed = first;
        let reached = loop {
            if is_barrier(crossed) {
                return End::Barrier(crossed);
            }
            let entry = mesh.twin(crossed);
            self.faces.push(entry.face());
            let apex = mesh.apex(entry);
            // The end is on the right of the way to a vertex on the left, and on the way to one on the way.
            match sight.side(&here, &sight.see(apex)) {
                Sign::Negative => {
                    self.left.push(entry.prev());
                    crossed = entry.next();
                }
                Sign::Positive => {
                    self.right.push(entry.next());
                    crossed = entry.prev();
                }
                Sign::Zero => {
                    self.right.push(entry.next());
                    self.left.push(entry.prev());
                    break apex;
                }
            }
        };
        self.left.reverse();
        End::Vertex(reached)
    }

    fn clear(&mut self) {
        self.faces.clear();
        self.right.clear();
        self.left.clear();
    }
}
