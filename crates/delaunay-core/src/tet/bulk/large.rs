//! Stars too large for the table of [`star`](super::star): a hash of directed edges instead.

use super::circumsphere::{Circumsphere, arm};
use super::inserter::Inserter;
use crate::ids::{FacetId, VertexId};
use crate::tet::mesh::{FACET_CORNERS, Tet};
use crate::tet::star::ACROSS;
use glam::DVec3;
use rustc_hash::FxHashMap;

impl<const SHARED: bool> Inserter<SHARED> {
    /// As [`fill`](Self::fill), for a star of any size.
    #[cold]
    #[inline(never)]
    pub(super) fn fill_large(&mut self, v: VertexId, p: DVec3) {
        let count = self.outer.len();
        let corners: Vec<[VertexId; 4]> = (0..count).map(|i| self.corners(v, i)).collect();
        let mut edges: FxHashMap<(VertexId, VertexId), FacetId> = FxHashMap::default();
        edges.reserve(3 * count);
        for (i, new) in corners.iter().enumerate() {
            for (from, to, facet) in ACROSS {
                edges.insert((new[from], new[to]), self.dug.at(i).facet(facet));
            }
        }
        for (i, &vertex) in corners.iter().enumerate() {
            let (slot, outer) = (self.dug.at(i), self.outer.at(i));
            let mut twin = slot.facets();
            twin[0] = outer;
            for (from, to, facet) in ACROSS {
                let partner = edges.get(&(vertex[to], vertex[from]));
                debug_assert!(partner.is_some(), "the boundary of a cavity is closed");
                twin[facet] = partner.copied().unwrap_or(twin[facet]);
            }
            let [_, a, b, c] = vertex.map(|w| arm(self.arena.place(w), p));
            let sphere = Circumsphere::through(p, &a, &b, &c);
            self.arena.put(slot, Tet { vertex, twin }, sphere);
            self.arena.set_twin(outer, slot.facet(0));
            if !vertex[3].is_ghost() {
                self.last = slot;
            }
        }
    }

    fn corners(&self, v: VertexId, i: usize) -> [VertexId; 4] {
        let inner = self.inner.at(i);
        let vertices = self.arena.tet(inner.tet()).vertex;
        let [a, b, c] = FACET_CORNERS[inner.corner()].map(|corner| vertices[corner]);
        [v, a, b, c]
    }
}
