//! A cavity is replaced by the star of the new vertex.
//!
//! ```text
//!      a2 ---- a1         face j = (v, a_j, a_j+1): half-edge 0 and 2 are glued to the faces
//!     /  \ 1  /  \        before and after j in the rim, half-edge 1 to the outside of the rim.
//!    / 2  \  / 0  \
//!   a3 ---- v ---- a0     A cavity of m - 2 faces has m rim edges: its slots are filled again
//!                         and two are new.
//! ```

use super::cavity::Cavity;
use super::mesh::{Face, TriMesh};
use crate::ids::{FaceId, VertexId};

impl TriMesh {
    /// Replaces the faces of `cavity` by the triangles between `v` and its rim.
    ///
    /// Afterwards `cavity.faces()[j]` is the new face on rim edge `j`, with `v` as its corner 0.
    /// Outgoing half-edges are left alone, see [`point_at_star`](Self::point_at_star).
    pub(super) fn fill(&mut self, cavity: &mut Cavity, v: VertexId) {
        for _ in 0..2 {
            cavity.faces.push(self.push_face([v; 3]));
        }
        debug_assert_eq!(cavity.faces.len(), cavity.rim.len());
        let (Some(&last), Some(&first)) = (cavity.faces.last(), cavity.rim.first()) else {
            return;
        };
        let mut before = last;
        let ends = cavity.rim.iter().skip(1).chain([&first]);
        let after = cavity.faces.iter().skip(1).chain(cavity.faces.first());
        for (((&f, edge), end), after) in cavity.faces.iter().zip(&cavity.rim).zip(ends).zip(after)
        {
            self.faces[f.index()] = Face {
                origin: [v, edge.origin, end.origin],
                twin: [before.half_edge(2), edge.outer, after.half_edge(0)],
            };
            let outer = edge.outer;
            self.faces[outer.face().index()].twin[outer.corner()] = f.half_edge(1);
            before = f;
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
