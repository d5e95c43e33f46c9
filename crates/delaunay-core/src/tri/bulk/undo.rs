//! Faces of a cavity that is given up are put back.

use super::part::Part;
use super::worker::Worker;
use crate::ids::FaceId;

impl<P: Part> Worker<'_, P> {
    /// Notes the face `f` before another is written in its place, unless no cavity of this part is ever given up.
    ///
    /// # Safety
    /// `f` is a face of the part.
    #[inline(always)]
    pub(super) unsafe fn save(&mut self, f: FaceId) {
        if P::HAS_BORDER {
            // SAFETY: no other thread writes faces of this part.
            let face = unsafe { self.arena.face(f) };
            self.diggings.saved.push((f, face));
        }
    }

    /// Puts back all faces noted, and the twins on the edges round them.
    ///
    /// # Safety
    /// As [`insert`](Self::insert), and the faces noted are the cavity as far as it was dug.
    #[cold]
    #[inline(never)]
    pub(super) unsafe fn restore(&mut self) {
        for &(f, face) in &self.diggings.saved {
            // SAFETY: a face of the part.
            unsafe { self.arena.put(f, face) };
        }
        for &(f, face) in &self.diggings.saved {
            for (h, twin) in f.half_edges().into_iter().zip(face.twin) {
                // SAFETY: the real ends of the edge are in the part, so no other thread touches this twin.
                unsafe { self.arena.set_twin(twin, h) };
            }
        }
    }
}
