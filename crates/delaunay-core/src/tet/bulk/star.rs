//! The star of a new vertex in a bulk build: links by a small table, spheres one by one (four at a time in the
//! wide loops).
//!
//! The vertices of the link get small numbers as they are met, kept in their marks, and the directed
//! edges of the link a place in a square table of those numbers: three stores and three loads glue a
//! tetrahedron, without search or hash. A link of more than [`LINK`] vertices takes the
//! [long way](super::large).

use super::circumsphere::{Arm, Circumsphere, arm};
use super::inserter::Inserter;
use crate::ids::{FacetId, TetId, VertexId};
use crate::tet::mesh::{FACET_CORNERS, Tet};
use glam::DVec3;

/// Most vertices of a link that the table holds, the ghost included.
pub(super) const LINK: usize = 64;

/// Most facets of a link that the table holds: a sphere of `v` vertices has `2 v - 4`. The ghost has
/// number 0 even where it is not in the link.
pub(super) const MAX_FACETS: usize = 2 * (LINK - 1) - 4;

/// Scratch arrays for one star, by facet or vertex of the link.
pub(super) struct Star {
    /// The corners of each new tetrahedron.
    pub(super) corners: [[VertexId; 4]; MAX_FACETS + 6],
    /// The numbers of its corners in the link.
    pub(super) locals: [[u8; 4]; MAX_FACETS + 6],
    pub(super) spheres: [Circumsphere; MAX_FACETS + 6],
    /// The vertices of the link; the ghost has number 0.
    pub(super) link: [VertexId; LINK],
    /// The vertices of the link as seen from the new one.
    pub(super) arms: [Arm; LINK],
    /// By two numbers, the facet on the directed edge between them.
    pub(super) edges: [FacetId; LINK * LINK],
}

impl Star {
    pub(super) fn boxed() -> Box<Self> {
        Box::new(Self {
            corners: [[VertexId::GHOST; 4]; MAX_FACETS + 6],
            locals: [[0; 4]; MAX_FACETS + 6],
            spheres: [Circumsphere::UNKNOWN; MAX_FACETS + 6],
            link: [VertexId::GHOST; LINK],
            arms: [[f64::NAN; 4]; LINK],
            edges: [FacetId::from_raw(0); LINK * LINK],
        })
    }

    /// Both numbers are below [`LINK`].
    #[inline(always)]
    fn edge(&self, from: u8, to: u8) -> FacetId {
        self.edges[(from as usize % LINK) * LINK + to as usize % LINK]
    }

    #[inline(always)]
    fn set_edge(&mut self, from: u8, to: u8, facet: FacetId) {
        self.edges[(from as usize % LINK) * LINK + to as usize % LINK] = facet;
    }
}

impl<const SHARED: bool> Inserter<SHARED> {
    /// Replaces the cavity just dug by the star of `v`, which is at `p`; the next walk starts in its
    /// tetrahedron nearest to `next`, in the sense of the power of a point.
    #[inline(always)]
    pub(super) fn fill(&mut self, v: VertexId, p: DVec3, next: DVec3) {
        let count = self.outer.len();
        self.survey(v, p, count);
        self.make_spheres(p, next, count);
        self.store(count);
        self.aim_at_real(count);
    }

    /// Notes corners, numbers and edges of all new tetrahedra, before their slots are overwritten.
    #[inline(always)]
    fn survey(&mut self, v: VertexId, p: DVec3, count: usize) {
        let mut met = 1;
        for i in 0..count {
            let inner = self.inner.at(i);
            let vertices = self.arena.tet(inner.tet()).vertex;
            let [a, b, c] = FACET_CORNERS[inner.corner()].map(|corner| vertices[corner]);
            let [a_local, b_local, c_local] = [a, b, c].map(|w| self.number(w, &mut met));
            self.star.corners[i] = [v, a, b, c];
            self.star.locals[i] = [a_local, b_local, c_local, 0];
            let facets = self.dug.at(i).facets();
            self.star.set_edge(a_local, b_local, facets[3]);
            self.star.set_edge(b_local, c_local, facets[1]);
            self.star.set_edge(c_local, a_local, facets[2]);
        }
        for local in 1..usize::from(met).min(LINK) {
            self.star.arms[local] = arm(self.arena.place(self.star.link[local]), p);
        }
    }

    /// The number of `w` in the link: its own, or else the next, which is `met`.
    #[inline(always)]
    fn number(&mut self, w: VertexId, met: &mut u16) -> u8 {
        let mark = self.arena.mark(w);
        if mark.stamp() >= self.stamp {
            return mark.local() as u8;
        }
        let local = *met;
        *met += 1;
        self.star.link[usize::from(local) % LINK] = w;
        self.arena
            .set_mark(w, mark.noting(self.stamp, u32::from(local)));
        local as u8
    }

    /// Makes the circumspheres of the star and aims at the one of least power with respect to `next`.
    #[inline(always)]
    fn make_spheres(&mut self, p: DVec3, next: DVec3, count: usize) {
        self.aim = count - 1;
        let mut least = f64::INFINITY;
        for i in 0..count {
            let [a, b, c, _] =
                self.star.locals[i].map(|local| self.star.arms[local as usize % LINK]);
            let sphere = Circumsphere::through(p, &a, &b, &c);
            let power = -sphere.depth(next).0;
            if power < least {
                (least, self.aim) = (power, i);
            }
            self.star.spheres[i] = sphere;
        }
    }

    /// Writes the new tetrahedra into their slots and glues them.
    #[inline(always)]
    fn store(&mut self, count: usize) {
        for i in 0..count {
            let [a, b, c, _] = self.star.locals[i];
            let (slot, outer) = (self.dug.at(i), self.outer.at(i));
            let twin = [
                outer,
                self.star.edge(c, b),
                self.star.edge(a, c),
                self.star.edge(b, a),
            ];
            let vertex = self.star.corners[i];
            self.arena
                .put(slot, Tet { vertex, twin }, self.star.spheres[i]);
            self.arena.set_twin(outer, slot.facet(0));
        }
    }

    /// Starts the next walk in the tetrahedron aimed at, or in a real one if that is a ghost.
    #[inline(always)]
    pub(super) fn aim_at_real(&mut self, count: usize) {
        let is_real = |&i: &usize| !self.star.corners[i][3].is_ghost();
        let aim = Some(self.aim).filter(is_real);
        let aim = aim.or_else(|| (0..count).find(is_real)).unwrap_or(self.aim);
        self.last = self.dug.at(aim);
    }

    /// Gives `dug` as many slots as there are new tetrahedra: those of the cavity, free ones, fresh ones.
    /// Answers `false`, with nothing changed, when there are not enough.
    #[inline(always)]
    pub(super) fn take_slots(&mut self) -> bool {
        let (old, new) = (self.dug.len(), self.outer.len());
        if new <= old {
            for i in new..old {
                self.free.push(self.dug.at(i));
            }
            self.dug.truncate(new);
            return true;
        }
        let missing = new - old;
        let fresh = missing.saturating_sub(self.free.len());
        if fresh > self.fresh.len() {
            return false;
        }
        self.dug.make_room(missing);
        for _ in 0..missing {
            let t = self.free.pop().unwrap_or_else(|| {
                let t = TetId::from_raw(self.fresh.start as u32);
                self.fresh.start += 1;
                t
            });
            self.dug.push_if(true, t);
        }
        true
    }
}
