//! The star of a new vertex on processors with AVX2: what [`star`](super::star) does, with the corners of a
//! facet shuffled into place at once and edges of the link kept as keys of the table.

use super::inserter::Inserter;
use super::star::{LINK, Star};
use crate::ids::{FacetId, VertexId};
use crate::tet::mesh::{FACET_CORNERS, Tet};
use glam::DVec3;
use std::arch::x86_64::*;

/// By corner, the byte shuffle that moves the corners of the facet opposite it to the lanes 1, 2, 3.
static FACET_SHUFFLES: [[u8; 16]; 4] = facet_shuffles();

const fn facet_shuffles() -> [[u8; 16]; 4] {
    let mut shuffles = [[0x80; 16]; 4];
    let mut corner = 0;
    while corner < 4 {
        let mut byte = 4;
        while byte < 16 {
            let from = FACET_CORNERS[corner][byte / 4 - 1];
            shuffles[corner][byte] = (4 * from + byte % 4) as u8;
            byte += 1;
        }
        corner += 1;
    }
    shuffles
}

impl<const SHARED: bool> Inserter<SHARED> {
    /// As [`fill`](Self::fill).
    #[target_feature(enable = "avx2,fma,popcnt")]
    pub(super) fn fill_wide(&mut self, v: VertexId, p: DVec3, next: DVec3) {
        let count = self.outer.len();
        self.survey_wide(v, p, count);
        self.make_spheres_wide(p, next, count);
        self.store_wide(count);
        self.aim_at_real(count);
    }

    /// As [`survey`](Self::survey).
    #[target_feature(enable = "avx2,fma,popcnt")]
    #[inline]
    fn survey_wide(&mut self, v: VertexId, p: DVec3, count: usize) {
        let (arena, stamp) = (self.arena, self.stamp);
        let star = &mut *self.star;
        let mut met = 1_u32;
        for i in 0..count {
            let inner = self.inner.at(i);
            let vertices = &raw const arena.tet(inner.tet()).vertex;
            let shuffle = &raw const FACET_SHUFFLES[inner.corner() % 4];
            // SAFETY: both are 16 bytes.
            let corners = unsafe {
                _mm_shuffle_epi8(
                    _mm_loadu_si128(vertices.cast()),
                    _mm_loadu_si128(shuffle.cast()),
                )
            };
            let corners = _mm_insert_epi32::<0>(corners, v.slot() as i32);
            star.set_corners(i, corners);
            let ids = [
                _mm_extract_epi32::<1>(corners),
                _mm_extract_epi32::<2>(corners),
                _mm_extract_epi32::<3>(corners),
            ];
            let [a, b, c] = ids.map(|id| {
                let w = VertexId::from_slot(id as u32 as usize);
                if w.is_ghost() {
                    return 0;
                }
                let mark = arena.mark(w);
                let is_new = mark.stamp() < stamp;
                let local = if is_new { met } else { u32::from(mark.local()) };
                arena.set_mark(w, mark.noting(stamp, local));
                star.set_link(local, w);
                met += u32::from(is_new);
                local
            });
            star.set_locals(i, [a, b, c]);
            let first = self.dug.at(i).facet(0).raw();
            star.join(a, b, first + 3);
            star.join(b, c, first + 1);
            star.join(c, a, first + 2);
        }
        for local in 1..(met as usize).min(LINK) {
            star.arms[local] = super::circumsphere::arm(arena.place(star.link[local]), p);
        }
    }

    /// As [`store`](Self::store).
    #[target_feature(enable = "avx2,fma,popcnt")]
    #[inline]
    fn store_wide(&mut self, count: usize) {
        let (arena, star) = (self.arena, &*self.star);
        for i in 0..count {
            let (slot, outer) = (self.dug.at(i), self.outer.at(i));
            let [a, b, c] = star.locals_of(i);
            let twin = [
                outer,
                star.joined(c, b),
                star.joined(a, c),
                star.joined(b, a),
            ];
            let vertex = star.corners_of(i);
            arena.put(slot, Tet { vertex, twin }, star.sphere_of(i));
            arena.set_twin(outer, slot.facet(0));
        }
    }
}

/// Access without checks: facet numbers are below the count of the star, numbers of vertices below
/// [`LINK`].
impl Star {
    #[inline(always)]
    fn set_corners(&mut self, i: usize, corners: __m128i) {
        debug_assert!(i < self.corners.len());
        // SAFETY: in range; four ids of four bytes.
        unsafe { _mm_storeu_si128(self.corners.as_mut_ptr().add(i).cast(), corners) }
    }

    #[inline(always)]
    fn corners_of(&self, i: usize) -> [VertexId; 4] {
        debug_assert!(i < self.corners.len());
        // SAFETY: in range.
        unsafe { *self.corners.get_unchecked(i) }
    }

    #[inline(always)]
    fn set_locals(&mut self, i: usize, [a, b, c]: [u32; 3]) {
        debug_assert!(i < self.locals.len());
        let packed = a | b << 8 | c << 16;
        // SAFETY: in range.
        unsafe { *self.locals.get_unchecked_mut(i) = packed.to_le_bytes() }
    }

    #[inline(always)]
    fn locals_of(&self, i: usize) -> [u32; 3] {
        debug_assert!(i < self.locals.len());
        // SAFETY: in range.
        let [a, b, c, _] = unsafe { *self.locals.get_unchecked(i) };
        [a, b, c].map(u32::from)
    }

    #[inline(always)]
    fn sphere_of(&self, i: usize) -> super::circumsphere::Circumsphere {
        debug_assert!(i < self.spheres.len());
        // SAFETY: in range.
        unsafe { *self.spheres.get_unchecked(i) }
    }

    #[inline(always)]
    fn set_link(&mut self, local: u32, w: VertexId) {
        debug_assert!((local as usize) < LINK);
        // SAFETY: in range.
        unsafe { *self.link.get_unchecked_mut(local as usize) = w }
    }

    /// Notes that `facet` is on the directed edge between two vertices.
    #[inline(always)]
    fn join(&mut self, from: u32, to: u32, facet: u32) {
        let key = from as usize * LINK + to as usize;
        debug_assert!(key < self.edges.len());
        // SAFETY: in range.
        unsafe { *self.edges.get_unchecked_mut(key) = FacetId::from_raw(facet) }
    }

    #[inline(always)]
    fn joined(&self, from: u32, to: u32) -> FacetId {
        let key = from as usize * LINK + to as usize;
        debug_assert!(key < self.edges.len());
        // SAFETY: in range.
        unsafe { *self.edges.get_unchecked(key) }
    }
}
