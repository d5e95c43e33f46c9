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

use super::delaunay::Delaunay2;
use super::sight::{Seen, Sight};
use crate::ids::{FaceId, HalfEdgeId, VertexId};
use geo_predicates::CoordinateError;
use geo_predicates::filter::{Cross, Relative2};
use glam::DVec2;

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
    /// The rim edge that seems to lie in the direction of the next point.
    pub(super) aimed: usize,
    /// Whether the end of the last rim edge seemed to be on the left of that direction.
    left_before: bool,
    pending: Vec<PendingEdge>,
}

/// An edge that still has to be crossed or put on the rim; it starts where the one above ends.
#[derive(Clone, Copy, Debug)]
pub(super) struct PendingEdge {
    pub(super) end: Seen,
    pub(super) outer: HalfEdgeId,
    /// Cross of the end and the start.
    pub(super) backwards: Cross,
}

impl PendingEdge {
    #[inline(always)]
    pub(super) fn new(start: &Seen, end: Seen, outer: HalfEdgeId) -> Self {
        Self {
            end,
            outer,
            backwards: end.arm.cross(&start.arm),
        }
    }
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

    fn clear(&mut self) {
        self.faces.clear();
        self.rim.clear();
        self.pending.clear();
        self.aimed = 0;
        self.left_before = true;
    }

    /// Puts an edge on the rim; `towards` is the next point as seen from this one.
    ///
    /// Rounding does no harm to the aim, the walk is exact.
    #[inline(always)]
    fn emit(&mut self, start: &Seen, edge: &PendingEdge, towards: &Relative2) {
        let left = towards.cross(&edge.end.arm).seems_left();
        if left && !self.left_before {
            self.aimed = self.rim.len();
        }
        self.left_before = left;
        self.rim.push(RimEdge {
            origin: start.vertex,
            outer: edge.outer,
        });
    }
}

impl Delaunay2 {
    /// The cavity of `p`: all faces whose open circumdisk contains it, ties broken as in the whole
    /// triangulation; empty when `p` is a vertex.
    ///
    /// # Errors
    /// [`CoordinateError`] when a coordinate of `p` is not accepted.
    pub fn cavity(&self, p: DVec2) -> Result<Cavity, CoordinateError> {
        let mut cavity = Cavity::default();
        if let Ok(seed) = self.seed(self.locate(p)?) {
            self.dig(p, seed, p, &mut cavity);
        }
        Ok(cavity)
    }

    /// Fills `cavity` with the cavity of `p`, from a face `seed` known to be in it, and aims at `next`.
    pub(super) fn dig(&self, p: DVec2, seed: FaceId, next: DVec2, cavity: &mut Cavity) {
        let sight = self.sight(p);
        let towards = Relative2::new(next, p);
        let (mut start, mut edge) = self.open(&sight, seed, cavity);
        loop {
            let (left, right) = (edge.outer.prev(), edge.outer.next());
            let face = &self.mesh.faces[edge.outer.face().index()];
            let apex = sight.see(face.origin[left.corner()]);
            if sight.in_conflict([&edge.end, &start, &apex], edge.backwards) {
                cavity.faces.push(edge.outer.face());
                cavity.pending.push(PendingEdge {
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
                cavity.emit(&start, &edge, &towards);
                start = edge.end;
                match cavity.pending.pop() {
                    Some(below) => edge = below,
                    None => return,
                }
            }
        }
    }

    /// Starts `cavity` with the face `seed` and its three edges; gives the start of the first edge and
    /// that edge, the others wait.
    #[inline(always)]
    fn open(&self, sight: &Sight<'_>, seed: FaceId, cavity: &mut Cavity) -> (Seen, PendingEdge) {
        cavity.clear();
        cavity.faces.push(seed);
        let face = &self.mesh.faces[seed.index()];
        let [a, b, c] = face.origin.map(|v| sight.see(v));
        let edge = |start: &Seen, end: Seen, outer: HalfEdgeId| PendingEdge {
            end,
            outer,
            backwards: end.arm.cross(&start.arm),
        };
        cavity.pending.push(edge(&c, a, face.twin[2]));
        cavity.pending.push(edge(&b, c, face.twin[1]));
        (a, edge(&a, b, face.twin[0]))
    }
}
