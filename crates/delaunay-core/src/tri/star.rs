//! A cavity is replaced by the star of the new vertex.
//!
//! ```text
//!      a2 ---- a1         face j = (v, a_j, a_j+1): half-edge 0 and 2 are glued to the faces
//!     /  \ 1  /  \        before and after j in the rim, half-edge 1 to the outside of the rim.
//!    / 2  \  / 0  \
//!   a3 ---- v ---- a0     A cavity of m - 2 faces has m rim edges: its slots are filled again
//!                         and two are new.
//! ```

use super::cavity::{Cavity, RimEdge};
use super::mesh::{Face, TriMesh};
use crate::ids::{FaceId, VertexId};

impl TriMesh {
    /// Replaces the faces of `cavity` by the triangles between `v` and its rim.
    ///
    /// Afterwards `cavity.faces()[j]` is the new face on rim edge `j`, with `v` as its corner 0.
    /// Outgoing half-edges are left alone, see [`point_at_star`](Self::point_at_star).
    pub(super) fn fill(&mut self, cavity: &mut Cavity, v: VertexId) {
        let count = self.faces.len();
        cavity.faces.extend([count, count + 1].map(FaceId::new));
        debug_assert_eq!(cavity.faces.len(), cavity.rim.len());
        let (Some(&first), Some(&last)) = (cavity.faces.first(), cavity.faces.last()) else {
            return;
        };
        let (mut before, mut here) = (last, first);
        for (j, &RimEdge { origin, outer }) in cavity.rim.iter().enumerate() {
            let after = cavity.faces.get(j + 1).copied().unwrap_or(first);
            let end = cavity.rim.get(j + 1).unwrap_or(&cavity.rim[0]).origin;
            self.set_twin(outer, here.half_edge(1));
            self.put(
                here,
                Face {
                    origin: [v, origin, end],
                    twin: [before.half_edge(2), outer, after.half_edge(0)],
                },
            );
            (before, here) = (here, after);
        }
    }

    /// Stores a face in its slot, or in a new one behind the last.
    fn put(&mut self, f: FaceId, face: Face) {
        match self.faces.get_mut(f.index()) {
            Some(slot) => *slot = face,
            None => self.faces.push(face),
        }
    }

    /// Makes the new faces of a star the home of the outgoing half-edges of all its vertices.
    pub(super) fn point_at_star(&mut self, star: &[FaceId]) {
        for f in star {
            self.set_outgoing(f.half_edge(0));
            self.set_outgoing(f.half_edge(1));
        }
    }
}
