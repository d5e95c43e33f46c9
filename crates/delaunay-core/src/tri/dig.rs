//! Digging the cavity of a point, see [`Cavity`].

use super::cavity::{Cavity, PendingEdge, RimEdge};
use super::delaunay::Delaunay2;
use super::mesh::TriMesh;
use super::sight::{Seen, Sight};
use crate::ids::{FaceId, HalfEdgeId};
use geo_predicates::CoordinateError;
use geo_predicates::filter::Cross;
use glam::DVec2;

impl Delaunay2 {
    /// The cavity of `p`: all faces whose open circumdisk contains it, ties broken as in the whole
    /// triangulation; empty when `p` is a vertex.
    ///
    /// # Errors
    /// [`CoordinateError`] when a coordinate of `p` is not accepted.
    pub fn cavity(&self, p: DVec2) -> Result<Cavity, CoordinateError> {
        let mut cavity = Cavity::default();
        if let Ok(seed) = self.seed(self.locate(p)?) {
            self.dig(p, seed, &mut cavity);
        }
        Ok(cavity)
    }

    /// Fills `cavity` with the cavity of `p`, from a face `seed` known to be in it.
    pub(super) fn dig(&self, p: DVec2, seed: FaceId, cavity: &mut Cavity) {
        let sight = self.sight(p);
        cavity.dig(&self.mesh, &sight, seed, |corners, backwards| {
            sight.in_conflict(corners, backwards)
        });
    }
}

impl Cavity {
    /// Fills the cavity with all faces that `conflicts` says yes to and that hang together with `seed`, which is in it.
    ///
    /// `conflicts` is asked as [`Sight::in_conflict`] is.
    #[inline(always)]
    pub(super) fn dig(
        &mut self,
        mesh: &TriMesh,
        sight: &Sight<'_>,
        seed: FaceId,
        mut conflicts: impl FnMut([&Seen; 3], Cross) -> bool,
    ) {
        let (mut start, mut edge) = self.open(mesh, sight, seed);
        loop {
            let (left, right) = (edge.outer.prev(), edge.outer.next());
            let face = &mesh.faces[edge.outer.face().index()];
            let apex = sight.see(face.origin[left.corner()]);
            if conflicts([&edge.end, &start, &apex], edge.backwards) {
                self.faces.push(edge.outer.face());
                self.pending.push(PendingEdge {
                    end: edge.end,
                    outer: face.twin[left.corner()],
                    backwards: edge.end.arm.cross(&apex.arm),
                });
                edge = PendingEdge {
                    end: apex,
                    outer: face.twin[right.corner()],
                    backwards: apex.arm.cross(&start.arm),
                };
            } else {
                self.rim.push(RimEdge {
                    origin: start.vertex,
                    outer: edge.outer,
                });
                start = edge.end;
                match self.pending.pop() {
                    Some(below) => edge = below,
                    None => return,
                }
            }
        }
    }

    /// Starts the cavity with the face `seed` and its three edges; gives the start of the first edge and
    /// that edge, the others wait.
    #[inline(always)]
    fn open(&mut self, mesh: &TriMesh, sight: &Sight<'_>, seed: FaceId) -> (Seen, PendingEdge) {
        self.clear();
        self.faces.push(seed);
        let face = &mesh.faces[seed.index()];
        let [a, b, c] = face.origin.map(|v| sight.see(v));
        let edge = |start: &Seen, end: Seen, outer: HalfEdgeId| PendingEdge {
            end,
            outer,
            backwards: end.arm.cross(&start.arm),
        };
        self.pending.push(edge(&c, a, face.twin[2]));
        self.pending.push(edge(&b, c, face.twin[1]));
        (a, edge(&a, b, face.twin[0]))
    }
}
