//! A stack on which pushing costs no branch.
//!
//! Whether a tetrahedron joins the cavity is a toss-up: a branch on it is mispredicted every other time.
//! Here every candidate is stored and the length alone depends on the outcome.

/// A stack with room made in advance.
#[derive(Debug)]
pub(super) struct Pile<T> {
    items: Vec<T>,
    len: usize,
    /// What fills room that is not in use.
    filler: T,
}

impl<T: Copy> Pile<T> {
    pub(super) fn new(filler: T) -> Self {
        Self {
            items: Vec::new(),
            len: 0,
            filler,
        }
    }

    pub(super) fn clear(&mut self) {
        self.len = 0;
    }

    #[inline(always)]
    pub(super) fn len(&self) -> usize {
        self.len
    }

    /// Makes room for `more` items beyond the length.
    #[inline(always)]
    pub(super) fn make_room(&mut self, more: usize) {
        if self.items.len() < self.len + more {
            self.grow(more);
        }
    }

    #[cold]
    #[inline(never)]
    fn grow(&mut self, more: usize) {
        self.items.resize(2 * self.len + more + 64, self.filler);
    }

    /// Item `i` of the room made, whether or not it is below the length.
    #[inline(always)]
    pub(super) fn at(&self, i: usize) -> T {
        debug_assert!(i < self.items.len());
        // SAFETY: callers stay within the room that they made.
        unsafe { *self.items.get_unchecked(i) }
    }

    /// Pushes `item` if `kept`; there must be room for it either way.
    #[inline(always)]
    pub(super) fn push_if(&mut self, kept: bool, item: T) {
        debug_assert!(self.len < self.items.len());
        // SAFETY: callers have made room.
        unsafe { *self.items.get_unchecked_mut(self.len) = item };
        self.len += usize::from(kept);
    }

    /// Where the next items go; there must be room for all that is written there.
    #[inline(always)]
    pub(super) fn end(&mut self) -> *mut T {
        debug_assert!(self.len < self.items.len());
        self.items.as_mut_ptr().wrapping_add(self.len)
    }

    /// Counts `more` items written at the [`end`](Self::end).
    #[inline(always)]
    pub(super) fn advance(&mut self, more: usize) {
        debug_assert!(self.len + more <= self.items.len());
        self.len += more;
    }

    /// Drops what is beyond `len`.
    #[inline(always)]
    pub(super) fn truncate(&mut self, len: usize) {
        debug_assert!(len <= self.len);
        self.len = len;
    }
}
