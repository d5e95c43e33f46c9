//! Faces and points of a build as plain memory, without checks, shared by its threads without locks.

use super::super::mesh::Face;
use crate::ids::{FaceId, HalfEdgeId, VertexId};
use glam::DVec2;
use std::marker::PhantomData;
use std::mem::{MaybeUninit, offset_of};

/// The faces of a mesh in the making and the points it is made of.
///
/// All access is by raw pointers to single fields, never by references to whole faces: two threads may use
/// different fields of one face at the same time, see the [module](super).
///
/// While a mesh grows, the place of an origin holds the apex instead, the corner that is not on the half-edge: nearly
/// all questions are for the corner beyond an edge, and nothing but a load should be between them and the answer.
/// [`finish`](super::finish) turns the corners back.
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

    /// The corner of the face of `h` that is not on `h`.
    ///
    /// # Safety
    /// The face of `h` has been written, and no other thread writes its corners now.
    #[inline(always)]
    pub(super) unsafe fn apex(&self, h: HalfEdgeId) -> VertexId {
        // SAFETY: the face is in the room and written; a half-edge has corner 0, 1 or 2.
        unsafe { self.item::<VertexId>(h, offset_of!(Face, origin)).read() }
    }

    /// The other side of the edge of `h`.
    ///
    /// # Safety
    /// The face of `h` has been written, and no other thread writes this twin now.
    #[inline(always)]
    pub(super) unsafe fn twin(&self, h: HalfEdgeId) -> HalfEdgeId {
        // SAFETY: as in `apex`.
        unsafe { self.item::<HalfEdgeId>(h, offset_of!(Face, twin)).read() }
    }

    /// Makes `twin` the other side of the edge of `h`, in the face of `h` alone.
    ///
    /// # Safety
    /// No other thread reads or writes this twin now.
    #[inline(always)]
    pub(super) unsafe fn set_twin(&self, h: HalfEdgeId, twin: HalfEdgeId) {
        // SAFETY: as in `apex`.
        unsafe {
            self.item::<HalfEdgeId>(h, offset_of!(Face, twin))
                .write(twin);
        }
    }

    /// Writes the face `f`, given with origins.
    ///
    /// # Safety
    /// `f` is in the room, and no other thread reads or writes anything of it now.
    #[inline(always)]
    pub(super) unsafe fn put(&self, f: FaceId, face: Face) {
        let [a, b, c] = face.origin;
        let origin = [c, a, b];
        // SAFETY: the caller's promise.
        unsafe { self.at(f).write(Face { origin, ..face }) }
    }

    /// The face `f`, with origins.
    ///
    /// # Safety
    /// `f` has been written, and no other thread writes anything of it now.
    #[inline(always)]
    pub(super) unsafe fn face(&self, f: FaceId) -> Face {
        // SAFETY: the caller's promise.
        let face = unsafe { self.at(f).read() };
        let [c, a, b] = face.origin;
        let origin = [a, b, c];
        Face { origin, ..face }
    }

    /// Where the item of `h` is in the array of three ids at `offset` in its face.
    #[inline(always)]
    fn item<T>(&self, h: HalfEdgeId, offset: usize) -> *mut T {
        const { assert!(size_of::<Face>() == 24 && size_of::<T>() == 4) };
        debug_assert!(h.face().index() < self.room);
        // For half-edge 4 f + i, 24 f + 4 i bytes on: this way it is one step less than from face and corner.
        let bytes = 2 * (3 * h.index() - h.corner());
        self.faces
            .cast::<u8>()
            .wrapping_add(bytes + offset)
            .cast::<T>()
    }

    #[inline(always)]
    fn at(&self, f: FaceId) -> *mut Face {
        debug_assert!(f.index() < self.room);
        self.faces.wrapping_add(f.index())
    }
}
