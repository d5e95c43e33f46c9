//! Names of mesh elements: 32-bit numbers that know their kind and print themselves.
//!
//! What arithmetic can answer is answered here and not stored in a mesh: the face of a half-edge,
//! the half-edge that follows it, the tetrahedron of a facet. Data about elements live in a `Vec`
//! beside the mesh, at the `index()` of their ids.

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

    /// What stands for a short while where a half-edge would: a number below [`FaceId::LIMIT`], told from a half-edge by
    /// [`number`](Self::number).
    pub(crate) const fn numbered(number: usize) -> Self {
        Self(4 * number as u32 + 3)
    }

    /// The number that [`numbered`](Self::numbered) was given; `None` for a half-edge.
    pub(crate) const fn number(self) -> Option<usize> {
        if self.0 % 4 == 3 {
            Some(self.0 as usize / 4)
        } else {
            None
        }
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

/// A tetrahedron of a triangulation of space: a real one, or a ghost on a hull facet.
///
/// Prints as `t4`. The id stays good until the tetrahedron is removed; vacated ids are given out again.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[repr(transparent)]
pub struct TetId(u32);

impl TetId {
    /// The greatest number of tetrahedra whose facets 32 bits can number.
    pub const LIMIT: usize = 1 << 30;

    /// No tetrahedron: the home of a vertex that is not in the mesh.
    pub(crate) const NONE: Self = Self(u32::MAX);

    /// Tetrahedron number `index`.
    ///
    /// # Panics
    /// When `index` is not below [`TetId::LIMIT`].
    #[must_use]
    pub const fn new(index: usize) -> Self {
        assert!(index < Self::LIMIT, "tetrahedron index beyond 30 bits");
        Self(index as u32)
    }

    /// Tetrahedron number `raw`, which the caller knows to be below the limit.
    pub(crate) const fn from_raw(raw: u32) -> Self {
        Self(raw)
    }

    /// The number of the tetrahedron, from 0.
    #[must_use]
    pub const fn index(self) -> usize {
        self.0 as usize
    }

    /// The facet opposite corner `corner`.
    ///
    /// # Panics
    /// When `corner` is not below 4.
    #[must_use]
    pub const fn facet(self, corner: usize) -> FacetId {
        assert!(corner < 4, "a tetrahedron has four corners");
        FacetId(4 * self.0 + corner as u32)
    }

    /// The four facets, by the corner opposite each.
    #[must_use]
    pub const fn facets(self) -> [FacetId; 4] {
        let first = 4 * self.0;
        [
            FacetId(first),
            FacetId(first + 1),
            FacetId(first + 2),
            FacetId(first + 3),
        ]
    }
}

/// One side of a facet: facet `4 t + i` bounds tetrahedron `t`, opposite its corner `i`.
///
/// Prints as `t4.2`.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[repr(transparent)]
pub struct FacetId(u32);

impl FacetId {
    /// Facet number `index`.
    ///
    /// # Panics
    /// When `index` is beyond the last tetrahedron.
    #[must_use]
    pub const fn new(index: usize) -> Self {
        assert!(index < 4 * TetId::LIMIT, "facet index beyond 32 bits");
        Self(index as u32)
    }

    /// The number of the facet in 32 bits.
    pub(crate) const fn raw(self) -> u32 {
        self.0
    }

    /// Facet number `raw`.
    pub(crate) const fn from_raw(raw: u32) -> Self {
        Self(raw)
    }

    /// The number of the facet, `4 t + i`.
    #[must_use]
    pub const fn index(self) -> usize {
        self.0 as usize
    }

    /// The tetrahedron that the facet bounds.
    #[must_use]
    pub const fn tet(self) -> TetId {
        TetId(self.0 / 4)
    }

    /// The corner of the tetrahedron opposite the facet: 0, 1, 2 or 3.
    #[must_use]
    pub const fn corner(self) -> usize {
        (self.0 % 4) as usize
    }
}

impl fmt::Display for TetId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "t{}", self.0)
    }
}

impl fmt::Display for FacetId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}.{}", self.tet(), self.corner())
    }
}

impl fmt::Debug for TetId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

impl fmt::Debug for FacetId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
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
        assert_eq!(TetId::new(4).to_string(), "t4");
        assert_eq!(FacetId::new(18).to_string(), "t4.2");
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
    fn a_facet_knows_its_tet_and_corner() {
        for (corner, facet) in TetId::new(9).facets().into_iter().enumerate() {
            assert_eq!(facet, TetId::new(9).facet(corner));
            assert_eq!((facet.tet(), facet.corner()), (TetId::new(9), corner));
            assert_eq!(FacetId::new(facet.index()), facet);
        }
    }

    #[test]
    fn the_ghost_has_no_usable_index() {
        assert_eq!(VertexId::GHOST.index(), VertexId::LIMIT);
        assert!(VertexId::new(VertexId::LIMIT - 1).index() == VertexId::LIMIT - 1);
    }
}
