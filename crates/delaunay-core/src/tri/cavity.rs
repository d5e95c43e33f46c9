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
use crate::ids::{FaceId, HalfEdgeId, VertexId};
use geo_predicates::{CoordinateError, Sign, in_circle_perturbed, orient2d};
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
    pending: Vec<PendingEdge>,
}

/// An edge that still has to be crossed or put on the rim; it starts where the one above ends.
#[derive(Clone, Copy, Debug)]
struct PendingEdge {
    end: VertexId,
    outer: HalfEdgeId,
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

    fn start(&mut self, seed: FaceId, delaunay: &Delaunay2) {
        self.faces.clear();
        self.rim.clear();
        self.pending.clear();
        self.faces.push(seed);
        for h in seed.half_edges().into_iter().rev() {
            self.pending.push(PendingEdge {
                end: delaunay.mesh.target(h),
                outer: delaunay.mesh.twin(h),
            });
        }
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
            self.dig(p, seed, &mut cavity);
        }
        Ok(cavity)
    }

    /// Fills `cavity` with the cavity of `p`, from a face `seed` known to be in it.
    pub(super) fn dig(&self, p: DVec2, seed: FaceId, cavity: &mut Cavity) {
        cavity.start(seed, self);
        let mut start = self.mesh.face_vertices(seed)[0];
        while let Some(edge) = cavity.pending.pop() {
            let [base, right, left] = outer_half_edges(edge.outer);
            let corners = self.mesh.face_vertices(base.face());
            let apex = corners[left.corner()];
            if self.in_conflict(corners, p) {
                cavity.faces.push(base.face());
                cavity.pending.push(PendingEdge {
                    end: edge.end,
                    outer: self.mesh.twin(left),
                });
                cavity.pending.push(PendingEdge {
                    end: apex,
                    outer: self.mesh.twin(right),
                });
            } else {
                cavity.rim.push(RimEdge {
                    origin: start,
                    outer: base,
                });
                start = edge.end;
            }
        }
    }

    /// Whether the open circumdisk of the face with these corners contains `p`.
    pub(super) fn in_conflict(&self, corners: [VertexId; 3], p: DVec2) -> bool {
        let [a, b, c] = corners;
        if a.is_ghost() {
            self.ghost_conflict(b, c, p)
        } else if b.is_ghost() {
            self.ghost_conflict(c, a, p)
        } else if c.is_ghost() {
            self.ghost_conflict(a, b, p)
        } else {
            let [a, b, c] = corners.map(|v| self.point_of(v));
            in_circle_perturbed(a, b, c, p)
        }
    }

    /// Whether `p` is strictly on the left of `a -> b`, where the ghost is, or strictly between.
    fn ghost_conflict(&self, a: VertexId, b: VertexId, p: DVec2) -> bool {
        let (a, b) = (self.point_of(a), self.point_of(b));
        match orient2d(a, b, p) {
            Sign::Positive => true,
            Sign::Negative => false,
            Sign::Zero => precedes(a, p) == precedes(p, b),
        }
    }
}

/// The half-edge itself, the one after it and the one before it.
fn outer_half_edges(base: HalfEdgeId) -> [HalfEdgeId; 3] {
    [base, base.next(), base.prev()]
}

/// Whether `a` comes before `b` in lexicographic order: along any line, one of its two directions.
pub(super) fn precedes(a: DVec2, b: DVec2) -> bool {
    (a.x, a.y) < (b.x, b.y)
}
