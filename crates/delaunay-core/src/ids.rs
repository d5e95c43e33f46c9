//! Names of mesh elements: 32-bit numbers that know their kind and print themselves.
//!
//! What arithmetic can answer is answered here and not stored in a mesh: the face of a half-edge,
//! the half-edge that follows it. Data about elements live in a `Vec` beside the mesh, at
//! [`VertexId::index`], [`FaceId::index`] or [`HalfEdgeId::index`].

use std::fmt;

/// A vertex: input point `i` is vertex `i` for ever.
///
/// [`VertexId::GHOST`] is the vertex at infinity; it has no index and sorts before every other.
/// Prints as `v17`, the ghost as `v∞`.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct VertexId(u32);

impl VertexId {
    /// The vertex at infinity, a corner of every ghost face.
    pub const GHOST: Self = Self(0);

    /// The greatest number of vertices that ids can tell apart.
    pub const LIMIT: usize = u32::MAX as usize;

    /// The vertex of input point `index`.
    ///
    /// # Panics
    /// When `index` is not below [`VertexId::LIMIT`]: a mesh never has that many vertices.
    #[must_use]
    pub const fn new(index: usize) -> Self {
        assert!(index < Self::LIMIT, "vertex index beyond 32 bits");
        Self(index as u32 + 1)
    }

    /// The index of the vertex in the points; [`VertexId::LIMIT`] for the ghost, so that using it
    /// as an index fails at once.
    #[must_use]
    pub const fn index(self) -> usize {
        self.0.wrapping_sub(1) as usize
    }

    /// Whether this is the vertex at infinity.
    #[must_use]
    pub const fn is_ghost(self) -> bool {
        self.0 == 0
    }

    /// Position in arrays that keep the ghost in front.
    pub(crate) const fn slot(self) -> usize {
        self.0 as usize
    }

    /// Inverse of [`VertexId::slot`]; the slots of a mesh fit in 32 bits.
    pub(crate) const fn from_slot(slot: usize) -> Self {
        Self(slot as u32)
    }
}

/// A face of a triangulation of the plane: a triangle, or a ghost on a hull edge.
///
/// Prints as `f4`. Face ids are dense: `0..face_count`.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct FaceId(u32);

impl FaceId {
    /// The greatest number of faces whose half-edges 32 bits can number.
    pub const LIMIT: usize = 1 << 30;

    /// Face number `index`.
    ///
    /// # Panics
    /// When `index` is not below [`FaceId::LIMIT`].
    #[must_use]
    pub const fn new(index: usize) -> Self {
        assert!(index < Self::LIMIT, "face index beyond 30 bits");
        Self(index as u32)
    }

    /// The number of the face, from 0.
    #[must_use]
    pub const fn index(self) -> usize {
        self.0 as usize
    }

    /// The half-edge that leaves corner `corner` of the face.
    ///
    /// # Panics
    /// When `corner` is not 0, 1 or 2.
    #[must_use]
    pub const fn half_edge(self, corner: usize) -> HalfEdgeId {
        assert!(corner < 3, "a face has three corners");
        HalfEdgeId(4 * self.0 + corner as u32)
    }

    /// The three half-edges of the face, counterclockwise.
    #[must_use]
    pub const fn half_edges(self) -> [HalfEdgeId; 3] {
        let first = 4 * self.0;
        [
            HalfEdgeId(first),
            HalfEdgeId(first + 1),
            HalfEdgeId(first + 2),
        ]
    }
}

/// One side of an edge: half-edge `4 f + i` leaves corner `i` of face `f`, which is on its left.
///
/// Prints as `h17`.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct HalfEdgeId(u32);

impl HalfEdgeId {
    /// No half-edge: the outgoing half-edge of a vertex that is not in the mesh.
    pub(crate) const NONE: Self = Self(u32::MAX);

    /// Half-edge number `index`.
    ///
    /// # Panics
    /// When `index` is 3 modulo 4, a slot that no half-edge uses, or beyond the last face.
    #[must_use]
    pub const fn new(index: usize) -> Self {
        assert!(
            index % 4 != 3 && index < 4 * FaceId::LIMIT,
            "no half-edge has this index"
        );
        Self(index as u32)
    }

    /// The number of the half-edge, `4 f + i`; numbers that are 3 modulo 4 are not used.
    #[must_use]
    pub const fn index(self) -> usize {
        self.0 as usize
    }

    /// The face on the left.
    #[must_use]
    pub const fn face(self) -> FaceId {
        FaceId(self.0 / 4)
    }

    /// Which corner of its face the half-edge leaves: 0, 1 or 2.
    #[must_use]
    pub const fn corner(self) -> usize {
        (self.0 % 4) as usize
    }

    /// The half-edge that follows, counterclockwise round the same face.
    #[must_use]
    pub const fn next(self) -> Self {
        Self(if self.0 % 4 == 2 {
            self.0 - 2
        } else {
            self.0 + 1
        })
    }

    /// The half-edge before, counterclockwise round the same face.
    #[must_use]
    pub const fn prev(self) -> Self {
        Self(if self.0.is_multiple_of(4) {
            self.0 + 2
        } else {
            self.0 - 1
        })
    }
}

impl fmt::Display for VertexId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.is_ghost() {
            f.write_str("v∞")
        } else {
            write!(f, "v{}", self.index())
        }
    }
}

impl fmt::Display for FaceId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "f{}", self.0)
    }
}

impl fmt::Display for HalfEdgeId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "h{}", self.0)
    }
}

impl fmt::Debug for VertexId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

impl fmt::Debug for FaceId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

impl fmt::Debug for HalfEdgeId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ids_print_their_kind_and_index() {
        assert_eq!(VertexId::new(17).to_string(), "v17");
        assert_eq!(VertexId::GHOST.to_string(), "v∞");
        assert_eq!(FaceId::new(4).to_string(), "f4");
        assert_eq!(HalfEdgeId::new(17).to_string(), "h17");
    }

    #[test]
    fn next_three_times_comes_back_and_prev_undoes_it() {
        for h in FaceId::new(7).half_edges() {
            assert_eq!(h.next().next().next(), h);
            assert_eq!(h.next().prev(), h);
            assert_eq!(h.face(), FaceId::new(7));
            assert_eq!(h.face().half_edge(h.corner()), h);
        }
    }

    #[test]
    fn the_ghost_has_no_usable_index() {
        assert_eq!(VertexId::GHOST.index(), VertexId::LIMIT);
        assert!(VertexId::new(VertexId::LIMIT - 1).index() == VertexId::LIMIT - 1);
    }
}
