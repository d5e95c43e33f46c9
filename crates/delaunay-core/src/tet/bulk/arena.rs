//! The records of a growing triangulation, shared by the threads that grow it. All pointers to them live here.
//!
//! # Who may touch what
//! Every real vertex belongs to one part, and every part to one thread. While threads run:
//! - **(write)** a thread writes the record of a tetrahedron, its sphere included, only if at least two
//!   real corners are its own and so are all others but one, the vertex at infinity counting as its own;
//! - **(read)** it reads such a record only if at least two real corners are its own.
//!
//! A record that one thread may write has at most one real corner of another thread, so no other may
//! read it. Both rules hold by construction: a thread starts a cavity only in a tetrahedron with all real corners its
//! own, deletes only such ones, fills their slots with tetrahedra between corners of those and its own new vertex, and reaches
//! others only across a facet with two real corners of its own. The outer side of such a facet has
//! three corners that satisfy the rule for writing if the facet bounds a tetrahedron that it deletes.
//!
//! - Places of vertices are written before threads run. What a mark notes about insertions is read and
//!   written by the owner of the vertex alone; the vertex at infinity is never marked.
//! - Slots without a tetrahedron are handed to one thread each.
//!
//! A slot whose tetrahedron has all real corners in one part stays so as long as the threads run: who
//! deletes it fills it with his own. So threads can start walks there without asking.

use super::circumsphere::Circumsphere;
use crate::ids::{FacetId, TetId, VertexId};
use crate::memory::prefetch;
use crate::tet::mesh::Tet;
use crate::tet::sight::Places;
use glam::DVec3;
use std::sync::atomic::AtomicU64;
use std::sync::atomic::Ordering::Relaxed;

/// A vertex of the growing triangulation.
#[derive(Debug)]
#[repr(C, align(32))]
pub(super) struct Site {
    pub(super) place: DVec3,
    /// A [`Mark`], as one word: what is written in parts cannot be read at once without a stall. Atomic,
    /// for other threads read the part in it; relaxed, for the part does not change meanwhile.
    mark: AtomicU64,
}

/// What the filling of a cavity notes about a vertex, and the part to which the vertex belongs.
#[derive(Clone, Copy, Debug)]
pub(super) struct Mark(u64);

impl Mark {
    /// The insertion that met the vertex last.
    #[inline(always)]
    pub(super) fn stamp(self) -> u32 {
        self.0 as u32
    }

    /// The number of the vertex in the link of that insertion.
    #[inline(always)]
    pub(super) fn local(self) -> u16 {
        (self.0 >> 32) as u16
    }

    #[inline(always)]
    pub(super) fn part(self) -> u16 {
        (self.0 >> 48) as u16
    }

    /// The mark with another stamp and number.
    #[inline(always)]
    pub(super) fn noting(self, stamp: u32, local: u32) -> Self {
        Self(self.0 >> 48 << 48 | u64::from(local) << 32 | u64::from(stamp))
    }
}

impl Site {
    /// The vertex at infinity: number 0 in every link, whatever the insertion.
    pub(super) fn ghost() -> Self {
        Self {
            place: DVec3::NAN,
            mark: AtomicU64::new(u64::from(u32::MAX)),
        }
    }

    pub(super) fn at(place: DVec3) -> Self {
        Self {
            place,
            mark: AtomicU64::new(0),
        }
    }

    pub(super) fn part(&self) -> u16 {
        Mark(self.mark.load(Relaxed)).part()
    }

    pub(super) fn set_part(&mut self, part: u16) {
        let mark = self.mark.get_mut();
        *mark = u64::from(part) << 48 | *mark << 16 >> 16;
    }

    /// Forgets all insertions.
    pub(super) fn clear_stamp(&mut self) {
        let mark = self.mark.get_mut();
        *mark = *mark >> 32 << 32;
    }
}

/// Access to the records by number. A copy for each thread.
#[derive(Clone, Copy)]
pub(super) struct Arena {
    tets: *mut Tet,
    spheres: *mut Circumsphere,
    /// Slots for tetrahedra and for spheres.
    room: usize,
    sites: *mut Site,
    site_count: usize,
}

// SAFETY: threads that hold copies keep to the rules at the top of this file.
unsafe impl Send for Arena {}

impl Arena {
    /// The records in the allocations of three vectors, up to their capacities.
    ///
    /// # Safety
    /// While the arena is in use the vectors are neither moved nor read nor written but through it, and
    /// only with numbers of slots below the capacity of `tets` and of vertices below the length of `sites`.
    /// A tetrahedron is read only after it was written.
    pub(super) unsafe fn over(
        tets: &mut Vec<Tet>,
        spheres: &mut Vec<Circumsphere>,
        sites: &mut Vec<Site>,
    ) -> Self {
        Self {
            room: tets.capacity().min(spheres.capacity()),
            tets: tets.as_mut_ptr(),
            spheres: spheres.as_mut_ptr(),
            site_count: sites.len(),
            sites: sites.as_mut_ptr(),
        }
    }

    /// The number of slots.
    pub(super) fn room(&self) -> usize {
        self.room
    }

    #[inline(always)]
    pub(super) fn tet(&self, t: TetId) -> &Tet {
        debug_assert!(t.index() < self.room);
        // SAFETY: the slot is below the room and written, the rule for reading is kept.
        unsafe { &*self.tets.add(t.index()) }
    }

    #[inline(always)]
    pub(super) fn sphere(&self, t: TetId) -> &Circumsphere {
        debug_assert!(t.index() < self.room);
        // SAFETY: as for `tet`.
        unsafe { &*self.spheres.add(t.index()) }
    }

    #[inline(always)]
    pub(super) fn put(&self, t: TetId, tet: Tet, sphere: Circumsphere) {
        debug_assert!(t.index() < self.room);
        // SAFETY: the slot is below the room, the rule for writing is kept, and no reference from
        // `tet` or `sphere` outlives the expression that asked for it.
        unsafe {
            self.tets.add(t.index()).write(tet);
            self.spheres.add(t.index()).write(sphere);
        }
    }

    #[inline(always)]
    pub(super) fn set_twin(&self, facet: FacetId, twin: FacetId) {
        debug_assert!(facet.tet().index() < self.room);
        // SAFETY: as for `put`; a corner is below 4.
        unsafe {
            let tet = self.tets.add(facet.tet().index());
            let twins: *mut FacetId = (&raw mut (*tet).twin).cast();
            twins.add(facet.corner()).write(twin);
        }
    }

    #[inline(always)]
    pub(super) fn set_stamp(&self, t: TetId, stamp: u32) {
        debug_assert!(t.index() < self.room);
        // SAFETY: as for `put`.
        unsafe { (&raw mut (*self.spheres.add(t.index())).stamp).write(stamp) }
    }

    #[inline(always)]
    pub(super) fn place(&self, v: VertexId) -> DVec3 {
        debug_assert!(v.slot() < self.site_count);
        // SAFETY: below the count; places are not written while the arena is shared.
        unsafe { (&raw const (*self.sites.add(v.slot())).place).read() }
    }

    #[inline(always)]
    pub(super) fn mark(&self, v: VertexId) -> Mark {
        debug_assert!(v.slot() < self.site_count);
        // SAFETY: below the count; marks are atomic.
        let mark = unsafe { &(*self.sites.add(v.slot())).mark };
        Mark(mark.load(Relaxed))
    }

    #[inline(always)]
    pub(super) fn set_mark(&self, v: VertexId, mark: Mark) {
        debug_assert!(!v.is_ghost() && v.slot() < self.site_count);
        // SAFETY: below the count; marks are atomic.
        unsafe { (*self.sites.add(v.slot())).mark.store(mark.0, Relaxed) }
    }

    /// The part of a vertex; that of the ghost says nothing.
    #[inline(always)]
    pub(super) fn part(&self, v: VertexId) -> u16 {
        self.mark(v).part()
    }

    /// Asks for a tetrahedron to be brought near.
    #[inline(always)]
    pub(super) fn prefetch(&self, t: TetId) {
        prefetch(self.spheres.wrapping_add(t.index()));
        prefetch(self.tets.wrapping_add(t.index()));
    }
}

impl Places for Arena {
    #[inline(always)]
    fn place(self, v: VertexId) -> DVec3 {
        Self::place(&self, v)
    }
}
