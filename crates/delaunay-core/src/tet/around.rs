//! What lies around a vertex or an edge: star, link, neighbours, ring.

use super::mesh::TetMesh;
use super::table::Table;
use crate::ids::{FacetId, TetId, VertexId};
use rustc_hash::FxHashSet;

impl TetMesh {
    /// The star of `v`: the tetrahedra with the corner `v`, ghosts included, each once; nothing when `v`
    /// is not in the mesh.
    ///
    /// Takes time and memory proportional to what is drawn from it.
    #[must_use]
    pub fn star(&self, v: VertexId) -> Star<'_> {
        let mut seen = Table::default();
        seen.clear();
        let pending: Vec<TetId> = self.home(v).into_iter().collect();
        for t in &pending {
            seen.meet(t.index() as u64, ());
        }
        Star {
            mesh: self,
            vertex: v,
            seen,
            pending,
        }
    }

    /// The link of `v`: for each tetrahedron of the star the facet opposite `v`.
    pub fn link(&self, v: VertexId) -> impl Iterator<Item = FacetId> + '_ {
        let opposite = move |t: TetId| Some(t.facet(self.corner_of(t, v)?));
        self.star(v).filter_map(opposite)
    }

    /// The vertices joined with `v` by an edge, each once; the ghost is one of them when `v` is on the
    /// hull.
    pub fn neighbors(&self, v: VertexId) -> impl Iterator<Item = VertexId> + '_ {
        let mut seen = FxHashSet::default();
        let corners = self.star(v).flat_map(|t| self.tet_vertices(t));
        corners.filter(move |&w| w != v && seen.insert(w))
    }

    /// A tetrahedron with the edge from `a` to `b`, if there is an edge between them.
    ///
    /// Takes time proportional to the size of the star of `a`.
    #[must_use]
    pub fn find_edge(&self, a: VertexId, b: VertexId) -> Option<TetId> {
        self.star(a).find(|&t| self.corner_of(t, b).is_some())
    }

    /// The tetrahedron side with the corners `a`, `b`, `c`, counterclockwise seen from outside it, if
    /// they are the corners of a facet.
    ///
    /// Takes time proportional to the size of the star of `a`.
    #[must_use]
    pub fn find_facet(&self, [a, b, c]: [VertexId; 3]) -> Option<FacetId> {
        let mut facets = self.star(a).flat_map(TetId::facets);
        facets.find(|&f| {
            let mut corners = self.facet_vertices(f);
            let first = corners.iter().position(|&v| v == a).unwrap_or(0);
            corners.rotate_left(first);
            corners == [a, b, c]
        })
    }

    /// The ring of the edge from `a` to `b`: the tetrahedra with that edge, ghosts included, in order
    /// counterclockwise round it as seen from `b`, starting with `t`; nothing when `t` has no such edge.
    #[must_use]
    pub fn ring(&self, t: TetId, a: VertexId, b: VertexId) -> Ring<'_> {
        Ring {
            mesh: self,
            edge: [a, b],
            start: t,
            here: self.leading_vertex(t, [a, b]).map(|behind| (t, behind)),
        }
    }

    /// The corner `c` of `t` off the edge from `a` to `b` such that `[a, b, c]` and the fourth corner are
    /// right-handed: the one that comes first round the edge. `None` when `t` has no such edge.
    pub(super) fn leading_vertex(&self, t: TetId, [a, b]: [VertexId; 2]) -> Option<VertexId> {
        let (i, j) = self.corner_of(t, a).zip(self.corner_of(t, b))?;
        (i != j).then(|| self.tet_vertices(t)[leading_corner(i, j)])
    }
}

/// The corner `k` such that the other corners turn from `k` to the fourth counterclockwise round the
/// edge from `i` to `j` as seen from `j`: `[i, j, k, l]` is right-handed.
fn leading_corner(i: usize, j: usize) -> usize {
    let others = (0..4).filter(|&corner| corner != i && corner != j);
    let right_handed = others.into_iter().find(|&k| {
        let l = 6 - i - j - k;
        let order = [i, j, k, l];
        let pairs = (0..4).flat_map(|m| (m + 1..4).map(move |n| (m, n)));
        pairs.filter(|&(m, n)| order[m] > order[n]).count() % 2 == 0
    });
    right_handed.unwrap_or(0)
}

/// Iterator over the tetrahedra round a vertex, see [`TetMesh::star`].
#[derive(Clone, Debug)]
pub struct Star<'a> {
    mesh: &'a TetMesh,
    vertex: VertexId,
    seen: Table<()>,
    pending: Vec<TetId>,
}

impl Iterator for Star<'_> {
    type Item = TetId;

    fn next(&mut self) -> Option<TetId> {
        let t = self.pending.pop()?;
        for f in t.facets() {
            let across = self.mesh.twin(f).tet();
            let key = across.index() as u64;
            if self.mesh.apex(f) != self.vertex && self.seen.meet(key, ()).is_none() {
                self.pending.push(across);
            }
        }
        Some(t)
    }
}

/// Iterator over the tetrahedra round an edge, see [`TetMesh::ring`].
#[derive(Clone, Debug)]
pub struct Ring<'a> {
    mesh: &'a TetMesh,
    edge: [VertexId; 2],
    start: TetId,
    /// The next tetrahedron and the corner opposite the facet through which the ring leaves it.
    here: Option<(TetId, VertexId)>,
}

impl Iterator for Ring<'_> {
    type Item = TetId;

    fn next(&mut self) -> Option<TetId> {
        let (t, behind) = self.here?;
        let exit = self.mesh.corner_of(t, behind).map(|corner| t.facet(corner));
        let ahead = exit.and_then(|exit| {
            let others = self.mesh.facet_vertices(exit);
            let kept = others.into_iter().find(|v| !self.edge.contains(v))?;
            Some((self.mesh.twin(exit).tet(), kept))
        });
        self.here = ahead.filter(|&(next, _)| next != self.start);
        Some(t)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Seen from `j` towards `i`, the corners `k` and `l` of a right-handed `[i, j, k, l]` turn
    /// counterclockwise: the drawing of a right-handed tetrahedron turned on its side.
    #[test]
    fn the_leading_corner_makes_a_right_handed_tetrahedron() {
        assert_eq!(leading_corner(0, 1), 2);
        assert_eq!(leading_corner(1, 0), 3);
        assert_eq!(leading_corner(2, 3), 0);
        assert_eq!(leading_corner(0, 3), 1);
    }
}
