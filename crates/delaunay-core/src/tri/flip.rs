//! The edge between two triangles turned into the other diagonal of their quadrilateral.
//!
//! ```text
//!        c                      c
//!      /   \                  / | \          f = (a, b, c), g = (b, a, d), h = a->b
//!    /   f   \              /   |   \
//!   a ------- b    ──>     a  f | g  b       f = (a, d, c), g = (b, c, d), and h is d->c
//!    \   g   /              \   |   /
//!      \   /                  \ | /
//!        d                      d
//! ```

use super::mesh::{Face, TriMesh};
use crate::ids::HalfEdgeId;

impl TriMesh {
    /// The half-edges on the far sides of the quadrilateral round the edge of `h`, in the order a -> d, c -> a, b -> c, d -> b.
    pub(super) fn quadrilateral(&self, h: HalfEdgeId) -> [HalfEdgeId; 4] {
        let t = self.twin(h);
        [t.next(), h.prev(), h.next(), t.prev()]
    }

    /// Turns the edge of `h` into the other diagonal, with the same two face ids; whether the quadrilateral is convex is
    /// not asked.
    ///
    /// Gives the half-edges that [`quadrilateral`](Self::quadrilateral) gave, in that order, as they are called now; the new
    /// edge is the one after the first of them and after the third.
    pub(super) fn flip(&mut self, h: HalfEdgeId) -> [HalfEdgeId; 4] {
        let (f, g) = (h.face(), self.twin(h).face());
        let outer = self.quadrilateral(h).map(|side| self.twin(side));
        let [a, b, c, d] = [
            self.origin(h),
            self.target(h),
            self.apex(h),
            self.apex(self.twin(h)),
        ];
        self.faces[f.index()] = Face {
            origin: [a, d, c],
            twin: [outer[0], g.half_edge(1), outer[1]],
        };
        self.faces[g.index()] = Face {
            origin: [b, c, d],
            twin: [outer[2], f.half_edge(1), outer[3]],
        };
        let sides = [
            f.half_edge(0),
            f.half_edge(2),
            g.half_edge(0),
            g.half_edge(2),
        ];
        for (side, outer) in sides.into_iter().zip(outer) {
            self.set_twin(outer, side);
            self.set_outgoing(side);
        }
        sides
    }
}

#[cfg(test)]
mod tests {
    use crate::Delaunay2;
    use crate::ids::VertexId;
    use glam::DVec2;

    #[test]
    fn two_flips_exchange_the_triangles_and_leave_the_rest() {
        let corners = [[0.0, 0.0], [4.0, -1.0], [5.0, 5.0], [-1.0, 4.0]];
        let mut mesh = Delaunay2::build(&corners.map(DVec2::from)).unwrap().mesh;
        let before = mesh.canonical();
        let h = mesh
            .half_edges()
            .find(|&h| !mesh.is_ghost_face(h.face()) && !mesh.is_ghost_face(mesh.twin(h).face()))
            .unwrap();
        let ends = [mesh.apex(h), mesh.apex(mesh.twin(h))];
        let sides = mesh.flip(h);
        assert_eq!(mesh.check(), Ok(()));
        let diagonal = sides[0].next();
        assert_eq!(
            [mesh.origin(diagonal), mesh.target(diagonal)],
            [ends[1], ends[0]]
        );
        assert_eq!(mesh.twin(diagonal), sides[2].next());
        let back = mesh.flip(diagonal);
        assert_eq!((mesh.check(), mesh.canonical()), (Ok(()), before));
        assert!(
            back.iter()
                .all(|&side| mesh.origin(side) != VertexId::GHOST)
        );
    }
}
