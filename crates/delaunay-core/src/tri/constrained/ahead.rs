//! What lies ahead of a vertex on the straight way to a point.
//!
//! ```text
//!        q
//!      /   \            the way runs through the triangle a, p, q when the point is on the left of a->p and on
//!    a ------+--> b     the right of a->q, and along the edge when it is on a->p and not behind a
//!      \   /
//!        p
//! ```

use super::super::around::Around;
use super::super::mesh::TriMesh;
use super::super::sight::{Sight, precedes};
use crate::ids::{HalfEdgeId, VertexId};
use geo_predicates::Sign;

/// What lies ahead.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Ahead {
    /// An edge along the way: its half-edge from the vertex, which ends before the point, at it or beyond.
    Along(HalfEdgeId),
    /// A triangle: its half-edge opposite the vertex.
    Across(HalfEdgeId),
}

/// A turn round a vertex, in search of what lies ahead.
pub(super) struct Turn<'a> {
    mesh: &'a TriMesh,
    /// From the point that the way leads to.
    sight: Sight<'a>,
    vertex: VertexId,
    around: Around<'a>,
}

impl<'a> Turn<'a> {
    pub(super) fn new(mesh: &'a TriMesh, sight: Sight<'a>, vertex: VertexId) -> Self {
        let around = mesh.around(vertex);
        Self {
            mesh,
            sight,
            vertex,
            around,
        }
    }

    /// Looks at the next half-edge. `None` when there are no more: the way leaves the hull at once.
    pub(super) fn step(&mut self) -> Option<Option<Ahead>> {
        self.around.next().map(|h| self.look(h))
    }

    /// What lies ahead, after a whole turn if need be.
    pub(super) fn find(mut self) -> Option<Ahead> {
        loop {
            if let Some(ahead) = self.step()? {
                return Some(ahead);
            }
        }
    }

    fn look(&self, h: HalfEdgeId) -> Option<Ahead> {
        let (right, left) = (self.mesh.target(h), self.mesh.apex(h));
        if right.is_ghost() {
            return None;
        }
        let [here, right, left] = [self.vertex, right, left].map(|v| self.sight.see(v));
        match self.sight.side(&here, &right) {
            Sign::Zero => self.is_ahead(right.vertex).then_some(Ahead::Along(h)),
            Sign::Positive if !left.vertex.is_ghost() => {
                let beyond = self.sight.side(&here, &left) == Sign::Negative;
                beyond.then_some(Ahead::Across(h.next()))
            }
            _ => None,
        }
    }

    /// Whether `v`, on the line of the way, is on the same side of the vertex as the point.
    fn is_ahead(&self, v: VertexId) -> bool {
        let [here, v] = [self.vertex, v].map(|v| self.sight.point(v));
        precedes(here, v) == precedes(here, self.sight.from())
    }
}

/// What lies ahead on the way from one vertex to another, seen from either end: whichever is found first. The half-edge
/// that starts the way tells which.
///
/// Turns round both ends at the same time, so that an end with many edges does not matter when the other has few.
/// `None` when one of the two is no vertex, or both are the same.
pub(super) fn between<'a>(
    mesh: &'a TriMesh,
    sight_from: impl Fn(VertexId) -> Sight<'a>,
    [a, b]: [VertexId; 2],
) -> Option<([VertexId; 2], Ahead)> {
    let mut from_a = Turn::new(mesh, sight_from(b), a);
    let mut from_b = Turn::new(mesh, sight_from(a), b);
    loop {
        if let Some(ahead) = from_a.step()? {
            return Some(([a, b], ahead));
        }
        if let Some(ahead) = from_b.step()? {
            return Some(([b, a], ahead));
        }
    }
}
