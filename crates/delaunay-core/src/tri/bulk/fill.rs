//! A cavity is replaced by the star of the new vertex, as in `star.rs`.

use super::super::mesh::Face;
use super::part::Part;
use super::worker::Worker;
use crate::ids::{FaceId, VertexId};

/// The two faces that the insertion of `v` adds to a mesh; the first three vertices have four together.
pub(super) fn faces_of(v: VertexId) -> [FaceId; 2] {
    let first = 2 * v.slot() - 4;
    [first, first + 1].map(FaceId::new)
}

impl<P: Part> Worker<'_, P> {
    /// Replaces the cavity just dug by the star of `v`, and starts the next walk at its face on edge `aimed`.
    ///
    /// # Safety
    /// As [`insert`](Self::insert); the diggings hold the cavity of `v`, which has `edges` edges.
    #[inline(always)]
    pub(super) unsafe fn fill(&mut self, v: VertexId, edges: usize, aimed: usize) {
        let faces = self.diggings.faces.as_mut_ptr();
        let rim = self.diggings.rim.as_mut_ptr();
        // SAFETY: there is room for `edges` faces and one edge more. The faces of the cavity are of the part
        // and those of `v` are this thread's, so it may write them; the faces outside share two
        // corners with one of the cavity, so no other thread touches their twins on the rim.
        unsafe {
            let [first, second] = faces_of(v);
            faces.add(edges - 2).write(first);
            faces.add(edges - 1).write(second);
            rim.add(edges).write(rim.read());
            let (mut before, mut here) = (second, faces.read());
            let mut edge = rim.read();
            for j in 1..=edges {
                let after = faces.add(if j == edges { 0 } else { j }).read();
                let next = rim.add(j).read();
                self.arena.set_twin(edge.outer, here.half_edge(1));
                let face = Face {
                    origin: [v, edge.origin, next.origin],
                    twin: [before.half_edge(2), edge.outer, after.half_edge(0)],
                };
                self.arena.put(here, face);
                (before, here, edge) = (here, after, next);
            }
            self.start = self.real_side(faces.add(aimed).read().half_edge(1));
        }
    }
}
