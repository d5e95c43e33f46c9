//! What is kept of a cavity while it is dug.

use super::super::mesh::Face;
use super::super::sight::Seen;
use crate::ids::{FaceId, HalfEdgeId, VertexId};
use geo_predicates::filter::{Cross, Relative2};
use glam::DVec2;

/// Faces that a cavity may have before its buffers grow. Nearly all have fewer than twenty.
const FIRST_ROOM: usize = 64;

/// The places of the faces of a star, and the edges still to be looked at.
///
/// `places` and `pending` are filled with anything up to their length. A cavity of m faces gives way to a star of m + 2,
/// whose last face is asked for a place after its own, and has at most m + 1 pending edges.
pub(super) struct Diggings {
    /// Places for faces of the star in order: the two that the vertex brings, then those of the faces dug.
    pub(super) places: Vec<FaceId>,
    pub(super) pending: Vec<Pending>,
    /// The faces dug, if they may have to be put back.
    pub(super) saved: Vec<(FaceId, Face)>,
}

/// An edge that is either crossed or on the rim; it starts where the one above ends.
#[derive(Clone, Copy)]
pub(super) struct Pending {
    pub(super) end: Seen,
    /// The half-edge on the other side.
    pub(super) outer: HalfEdgeId,
    /// Cross of the start and the end.
    pub(super) forwards: Cross,
    pub(super) beyond: Beyond,
}

/// The corner of a face that is not on the edge from which it is looked at. It is fetched as soon as
/// the edge is known, so that it is there when the edge has its turn.
#[derive(Clone, Copy)]
pub(super) struct Beyond {
    pub(super) apex: VertexId,
    pub(super) place: DVec2,
}

impl Diggings {
    pub(super) fn new() -> Self {
        let mut diggings = Self {
            places: Vec::new(),
            pending: Vec::new(),
            saved: Vec::new(),
        };
        diggings.make_room(FIRST_ROOM);
        diggings
    }

    /// Makes room for twice as many faces; what is in the buffers stays.
    #[cold]
    #[inline(never)]
    pub(super) fn grow(&mut self) {
        self.make_room(2 * self.room());
    }

    fn make_room(&mut self, faces: usize) {
        let outer = HalfEdgeId::new(0);
        let end = Seen {
            vertex: VertexId::GHOST,
            arm: Relative2::new(DVec2::ZERO, DVec2::ZERO),
        };
        let beyond = Beyond {
            apex: VertexId::GHOST,
            place: DVec2::ZERO,
        };
        let forwards = end.arm.cross(&end.arm);
        let pending = Pending {
            end,
            outer,
            forwards,
            beyond,
        };
        self.places.resize(faces + 3, outer.face());
        self.pending.resize(faces + 1, pending);
    }

    /// The most faces that a cavity may have.
    pub(super) fn room(&self) -> usize {
        self.places.len() - 3
    }
}
