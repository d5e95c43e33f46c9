//! Faces and points of a build as plain memory, without checks, shared by its threads without locks.

use super::super::mesh::Face;
use crate::ids::{FaceId, HalfEdgeId, VertexId};
use glam::DVec2;
use std::marker::PhantomData;
use std::mem::MaybeUninit;

/// The faces of a mesh in the making and the points it is made of.
///
/// All access is by raw pointers to single fields, never by references to whole faces: two threads may use
/// different fields of one face at the same time, see the [module](super).
pub(super) struct Arena<'a> {
    faces: *mut Face,
    room: usize,
    coords: &'a [DVec2],
    memory: PhantomData<&'a mut [Face]>,
}

// SAFETY: an arena by itself does nothing. Its methods that touch the faces are unsafe, and their callers
// keep to the rules of the module, under which no two threads touch one field unless both read it.
unsafe impl Sync for Arena<'_> {}

impl<'a> Arena<'a> {
    /// An arena over room for faces, none of them written yet, and over the points by vertex slot.
    pub(super) fn new(room: &'a mut [MaybeUninit<Face>], coords: &'a [DVec2]) -> Self {
        Self {
            faces: room.as_mut_ptr().cast(),
            room: room.len(),
            coords,
            memory: PhantomData,
        }
    }

    /// The points by vertex slot.
    pub(super) fn coords(&self) -> &'a [DVec2] {
        self.coords
    }

    /// The point of a vertex.
    ///
    /// # Safety
    /// The vertex has a slot in the points.
    #[inline(always)]
    pub(super) unsafe fn point(&self, v: VertexId) -> DVec2 {
        debug_assert!(v.slot() < self.coords.len());
        // SAFETY: the caller's promise.
        unsafe { *self.coords.get_unchecked(v.slot()) }
    }

    /// The vertex that `h` leaves.
    ///
    /// # Safety
    /// The face of `h` has been written, and no other thread writes its corners now.
    #[inline(always)]
    pub(super) unsafe fn origin(&self, h: HalfEdgeId) -> VertexId {
        let face = self.face(h.face());
        // SAFETY: `face` is in the room and written; a half-edge has corner 0, 1 or 2.
        unsafe {
            (&raw const (*face).origin)
                .cast::<VertexId>()
                .add(h.corner())
                .read()
        }
    }

    /// The other side of the edge of `h`.
    ///
    /// # Safety
    /// The face of `h` has been written, and no other thread writes this twin now.
    #[inline(always)]
    pub(super) unsafe fn twin(&self, h: HalfEdgeId) -> HalfEdgeId {
        let face = self.face(h.face());
        // SAFETY: as in `origin`.
        unsafe {
            (&raw const (*face).twin)
                .cast::<HalfEdgeId>()
                .add(h.corner())
                .read()
        }
    }

    /// Makes `twin` the other side of the edge of `h`, in the face of `h` alone.
    ///
    /// # Safety
    /// No other thread reads or writes this twin now.
    #[inline(always)]
    pub(super) unsafe fn set_twin(&self, h: HalfEdgeId, twin: HalfEdgeId) {
        let face = self.face(h.face());
        // SAFETY: `face` is in the room; a half-edge has corner 0, 1 or 2.
        unsafe {
            (&raw mut (*face).twin)
                .cast::<HalfEdgeId>()
                .add(h.corner())
                .write(twin);
        }
    }

    /// Writes the face `f`.
    ///
    /// # Safety
    /// `f` is in the room, and no other thread reads or writes anything of it now.
    #[inline(always)]
    pub(super) unsafe fn put(&self, f: FaceId, face: Face) {
        // SAFETY: the caller's promise.
        unsafe { self.face(f).write(face) }
    }

    #[inline(always)]
    fn face(&self, f: FaceId) -> *mut Face {
        debug_assert!(f.index() < self.room);
        self.faces.wrapping_add(f.index())
    }
}
