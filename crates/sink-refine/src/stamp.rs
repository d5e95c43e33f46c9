//! When an element was made: what tells it from its predecessor with the same id.

/// Never the same for two elements that had one id.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(crate) struct Stamp(u32);

impl Stamp {
    /// That of an id without an element.
    pub(crate) const NONE: Self = Self(0);

    /// The next one.
    pub(crate) fn advance(&mut self) -> Self {
        self.0 += 1;
        *self
    }
}
