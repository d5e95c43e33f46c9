//! Tetrahedra glued along facets: connectivity only, no coordinates.
//!
//! ```text
//!          3                 facet 4t + i is opposite corner i; its corners, counterclockwise
//!         /|\                seen from outside:
//!        / | \                  0: 1 2 3
//!       0 -|- 2                 1: 2 0 3
//!        \ | /                  2: 0 1 3
//!          1                    3: 2 1 0
//!                            Corner 3 is always last, so a ghost, whose vertex at infinity is
//!   corners [0, 1, 2, 3]     corner 3, hands that place on to the tetrahedra built on its facets.
//!   are right-handed
//! ```
//!
//! A tetrahedron is one record of 32 bytes: four corners and four twins. Everything else about a facet
//! is arithmetic on its number, see [`FacetId`].

use crate::ids::{FacetId, TetId, VertexId};
use crate::memory::{prefetch, vec_of};

/// Corners of the facet opposite each corner, counterclockwise seen from outside a right-handed
/// tetrahedron. With `p` inside and `[a, b, c]` the corners of a facet, `[p, a, b, c]` is right-handed.
pub const FACET_CORNERS: [[usize; 3]; 4] = [[1, 2, 3], [2, 0, 3], [0, 1, 3], [2, 1, 0]];

/// What is stored of a tetrahedron: its corners and the other side of the facet opposite each.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(C, align(32))]
pub(super) struct Tet {
    pub(super) vertex: [VertexId; 4],
    pub(super) twin: [FacetId; 4],
}

impl Tet {
    /// What a slot without a tetrahedron holds.
    pub(super) const VACANT: Self = Self {
        vertex: [VertexId::GHOST; 4],
        twin: [FacetId::from_raw(0); 4],
    };
}

/// Tetrahedra glued along facets into a closed complex: connectivity only, no coordinates.
///
/// Ids are stable: a tetrahedron keeps its id until it is removed, and ids vacated are given out again,
/// the last one first. [`compact`](Self::compact) closes the gaps.
///
/// Invariants ([`check`](TetMesh::check) names the first one broken):
/// 1. `twin(twin(f)) == f` and `twin(f) != f`;
/// 2. the corners of `twin(f)` are those of `f` in the other sense of rotation;
/// 3. the vertex at infinity, if it is a corner at all, is corner 3;
/// 4. the [`home`](TetMesh::home) of a vertex has it as a corner.
///
/// Methods that take an id panic when the mesh has no such element.
///
/// ```
/// use delaunay_core::{TetMesh, VertexId};
///
/// // Two tetrahedra glued back to back: the smallest closed complex.
/// let [a, b, c, d] = [0, 1, 2, 3].map(VertexId::new);
/// let mut mesh = TetMesh::default();
/// let front = mesh.push_tet([a, b, c, d]);
/// let back = mesh.push_tet([b, a, c, d]);
/// for (i, j) in [(0, 1), (1, 0), (2, 2), (3, 3)] {
///     mesh.glue(front.facet(i), back.facet(j));
/// }
/// mesh.settle(front);
/// assert_eq!(mesh.check(), Ok(()));
/// assert_eq!(mesh.star(a).count(), 2);
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct TetMesh {
    pub(super) tets: Vec<Tet>,
    /// Slots without a tetrahedron, the last vacated on top.
    pub(super) vacant: Vec<TetId>,
    /// By vertex slot, the ghost in front; empty while a bulk build runs.
    pub(super) homes: Vec<TetId>,
}

impl TetMesh {
    /// The corners of `t`; right-handed if they are real.
    #[must_use]
    #[inline]
    pub fn tet_vertices(&self, t: TetId) -> [VertexId; 4] {
        self.tets[t.index()].vertex
    }

    /// The corners of `f`, counterclockwise seen from outside its tetrahedron.
    #[must_use]
    #[inline]
    pub fn facet_vertices(&self, f: FacetId) -> [VertexId; 3] {
        let vertices = self.tet_vertices(f.tet());
        FACET_CORNERS[f.corner()].map(|corner| vertices[corner])
    }

    /// The corner of the tetrahedron of `f` opposite `f`.
    #[must_use]
    #[inline]
    pub fn apex(&self, f: FacetId) -> VertexId {
        self.tet_vertices(f.tet())[f.corner()]
    }

    /// The other side of `f`.
    #[must_use]
    #[inline]
    pub fn twin(&self, f: FacetId) -> FacetId {
        self.tets[f.tet().index()].twin[f.corner()]
    }

    /// The tetrahedron across facet `corner` of `t`.
    #[must_use]
    #[inline]
    pub fn neighbor(&self, t: TetId, corner: usize) -> TetId {
        self.twin(t.facet(corner)).tet()
    }

    /// Which corner of `t` is `v`, if it is one.
    #[must_use]
    pub fn corner_of(&self, t: TetId, v: VertexId) -> Option<usize> {
        self.tet_vertices(t).iter().position(|&corner| corner == v)
    }

    /// Whether the vertex at infinity is a corner of `t`.
    #[must_use]
    #[inline]
    pub fn is_ghost_tet(&self, t: TetId) -> bool {
        self.tet_vertices(t)[3].is_ghost()
    }

    /// Whether `t` names a tetrahedron of the mesh.
    #[must_use]
    pub fn contains_tet(&self, t: TetId) -> bool {
        let tet = self.tets.get(t.index());
        tet.is_some_and(|tet| !tet.vertex[0].is_ghost())
    }

    /// The number of tetrahedra, ghosts included.
    #[must_use]
    pub fn tet_count(&self) -> usize {
        self.tets.len() - self.vacant.len()
    }

    /// One more than the greatest id that was ever given out: the length of arrays beside the mesh.
    #[must_use]
    pub fn tet_slots(&self) -> usize {
        self.tets.len()
    }

    /// All tetrahedra, ghosts included, by id.
    pub fn tets(&self) -> impl DoubleEndedIterator<Item = TetId> + Clone + '_ {
        let slots = (0..self.tets.len()).map(TetId::new);
        slots.filter(|&t| self.contains_tet(t))
    }

    /// All facets, those of ghosts included, by id; each facet comes once from either side.
    pub fn facets(&self) -> impl Iterator<Item = FacetId> + Clone + '_ {
        self.tets().flat_map(TetId::facets)
    }

    /// A tetrahedron with the corner `v`; `None` when `v` is not in the mesh.
    #[must_use]
    pub fn home(&self, v: VertexId) -> Option<TetId> {
        let home = *self.homes.get(v.slot())?;
        (home != TetId::NONE).then_some(home)
    }
}

/// Surgery. Between calls the invariants may be broken; the caller restores them.
impl TetMesh {
    /// Adds a tetrahedron that is not glued to anything yet: each facet is its own twin. It takes the
    /// id vacated last, or a new one.
    ///
    /// The vertex at infinity may be corner 3 and no other.
    ///
    /// # Panics
    /// When there are [`TetId::LIMIT`] tetrahedra already, or corner 0 is the vertex at infinity.
    pub fn push_tet(&mut self, corners: [VertexId; 4]) -> TetId {
        assert!(!corners[0].is_ghost(), "the vertex at infinity is corner 3");
        let t = self.vacant.pop();
        let t = t.unwrap_or_else(|| TetId::new(self.tets.len()));
        self.put(t, corners, t.facets());
        t
    }

    /// Makes `f` and `g` the two sides of one facet.
    pub fn glue(&mut self, f: FacetId, g: FacetId) {
        self.set_twin(f, g);
        self.set_twin(g, f);
    }

    /// Removes `t` and vacates its id.
    ///
    /// No facet outside may be glued to `t` any more, and no vertex have its home there.
    pub fn vacate(&mut self, t: TetId) {
        self.tets[t.index()].vertex = [VertexId::GHOST; 4];
        self.vacant.push(t);
    }

    /// Makes `t` the home of its four corners.
    ///
    /// # Panics
    /// When a corner is beyond the vertices that the mesh was made for by more than the number of its
    /// tetrahedra times four: vertices are numbered without wide gaps.
    pub fn settle(&mut self, t: TetId) {
        for v in self.tet_vertices(t) {
            if v.slot() >= self.homes.len() {
                let room = self.homes.len() + 4 * self.tets.len() + 5;
                assert!(v.slot() < room, "{v} is beyond the vertices of the mesh");
                self.homes.resize(v.slot() + 1, TetId::NONE);
            }
            self.homes[v.slot()] = t;
        }
    }

    /// Makes `v` a vertex of no tetrahedron.
    pub(super) fn forget_vertex(&mut self, v: VertexId) {
        if let Some(home) = self.homes.get_mut(v.slot()) {
            *home = TetId::NONE;
        }
    }

    /// Calls for what is stored of a tetrahedron.
    #[inline]
    pub(super) fn prefetch_tet(&self, t: TetId) {
        prefetch(&self.tets[t.index()]);
    }

    /// Calls for the home of a vertex.
    #[inline]
    pub(super) fn prefetch_home(&self, v: VertexId) {
        if let Some(home) = self.homes.get(v.slot()) {
            prefetch(home);
        }
    }

    pub(super) fn set_twin(&mut self, f: FacetId, twin: FacetId) {
        self.tets[f.tet().index()].twin[f.corner()] = twin;
    }

    /// Stores a tetrahedron in its slot, or in a new one behind the last.
    pub(super) fn put(&mut self, t: TetId, vertex: [VertexId; 4], twin: [FacetId; 4]) {
        let tet = Tet { vertex, twin };
        match self.tets.get_mut(t.index()) {
            Some(slot) => *slot = tet,
            None => self.tets.push(tet),
        }
    }

    /// Gives each vertex the name in its slot and finds it a home, the tetrahedron with the smallest id;
    /// no home for vertices without a tetrahedron. There must be no vacant slots. `huge_pages` is about
    /// the list of homes.
    pub(super) fn rename_vertices(&mut self, names: &[VertexId], huge_pages: bool) {
        // Old names are near each other in a tetrahedron and its neighbours, new ones are anywhere: one
        // scattered write for each vertex, not for each corner.
        let mut homes = vec_of(TetId::NONE, names.len(), huge_pages);
        for (index, tet) in self.tets.iter_mut().enumerate().rev() {
            for v in tet.vertex {
                homes[v.slot()] = TetId::new(index);
            }
            tet.vertex = tet.vertex.map(|v| names[v.slot()]);
        }
        self.homes = vec_of(TetId::NONE, names.len(), huge_pages);
        for (home, name) in homes.into_iter().zip(names) {
            if home != TetId::NONE {
                self.homes[name.slot()] = home;
            }
        }
    }

    /// Closes the gaps by moving the last tetrahedra into them; homes are left alone.
    ///
    /// Takes time proportional to the number of gaps, times its logarithm.
    pub(super) fn fill_gaps(&mut self) {
        self.vacant.sort_unstable();
        for gap in std::mem::take(&mut self.vacant).into_iter().rev() {
            let last = TetId::new(self.tets.len() - 1);
            let moved = self.tets.swap_remove(gap.index());
            debug_assert!(moved.vertex[0].is_ghost());
            if gap != last {
                for (facet, twin) in gap.facets().into_iter().zip(self.tets[gap.index()].twin) {
                    self.set_twin(twin, facet);
                }
            }
        }
    }

    /// Finds a home for every vertex, the tetrahedron with the smallest id, and none for vertices
    /// without a tetrahedron.
    ///
    /// `slots` is one more than the greatest vertex index, plus one for the ghost.
    pub(super) fn index_vertices(&mut self, slots: usize) {
        self.homes.clear();
        self.homes.resize(slots, TetId::NONE);
        for (index, tet) in self.tets.iter().enumerate().rev() {
            if !tet.vertex[0].is_ghost() {
                for v in tet.vertex {
                    self.homes[v.slot()] = TetId::new(index);
                }
            }
        }
    }

    /// Closes the gaps: the tetrahedra take the ids `0..tet_count`, in the order of their old ids.
    ///
    /// Returns, by old id, the new one; `None` for vacant ids. Linear.
    pub fn compact(&mut self) -> Vec<Option<TetId>> {
        let mut renamed = vec![None; self.tets.len()];
        for (rank, t) in self.tets().enumerate() {
            renamed[t.index()] = Some(TetId::new(rank));
        }
        let rename = |t: TetId| renamed.get(t.index()).copied().flatten();
        let facet = |f: FacetId| rename(f.tet()).map_or(f, |t| t.facet(f.corner()));
        self.tets.retain(|tet| !tet.vertex[0].is_ghost());
        for tet in &mut self.tets {
            tet.twin = tet.twin.map(facet);
        }
        for home in &mut self.homes {
            *home = rename(*home).unwrap_or(TetId::NONE);
        }
        self.vacant.clear();
        renamed
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_record_takes_32_bytes() {
        assert_eq!(size_of::<Tet>(), 32);
    }

    /// A corner and the facet opposite make the tetrahedron again, in an even permutation.
    #[test]
    fn facet_corners_keep_the_sense_of_rotation() {
        for (corner, facet) in FACET_CORNERS.into_iter().enumerate() {
            let order = [corner, facet[0], facet[1], facet[2]];
            let pairs = (0..4).flat_map(|i| (i + 1..4).map(move |j| (i, j)));
            let inversions = pairs.filter(|&(i, j)| order[i] > order[j]).count();
            assert_eq!(inversions % 2, 0, "{order:?}");
        }
    }

    #[test]
    fn vacated_ids_are_given_out_again_and_compaction_closes_gaps() {
        let corners = [0, 1, 2, 3].map(VertexId::new);
        let mut mesh = TetMesh::default();
        let ids: Vec<TetId> = (0..4).map(|_| mesh.push_tet(corners)).collect();
        mesh.glue(ids[3].facet(0), ids[0].facet(2));
        mesh.settle(ids[3]);
        mesh.vacate(ids[1]);
        mesh.vacate(ids[2]);
        assert_eq!((mesh.tet_count(), mesh.tet_slots()), (2, 4));
        assert_eq!(mesh.push_tet(corners), ids[2]);
        let renamed = mesh.compact();
        assert_eq!(renamed[3], Some(TetId::new(2)));
        assert_eq!(renamed[1], None);
        assert_eq!(mesh.twin(TetId::new(0).facet(2)), TetId::new(2).facet(0));
        assert_eq!(mesh.home(corners[0]), Some(TetId::new(2)));
    }
}
