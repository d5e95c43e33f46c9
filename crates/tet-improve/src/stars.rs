//! Stars of vertices, without new memory for each.

use delaunay_core::{TetId, TetMesh, VertexId};

/// Finds the tetrahedra round a vertex. [`TetMesh::star`] does it once; this is for many vertices.
#[derive(Clone, Debug, Default)]
pub(crate) struct Stars {
    /// By tetrahedron: the search that has met it last.
    met: Vec<u32>,
    search: u32,
    star: Vec<TetId>,
}

impl Stars {
    /// The star of `v`; empty when it is not in the mesh.
    pub(crate) fn of(&mut self, mesh: &TetMesh, v: VertexId) -> &[TetId] {
        self.met.resize(mesh.tet_slots(), 0);
        self.search = self.search.wrapping_add(1);
        if self.search == 0 {
            self.met.fill(0);
            self.search = 1;
        }
        self.star.clear();
        self.star.extend(mesh.home(v));
        if let Some(home) = self.star.first() {
            self.met[home.index()] = self.search;
        }
        let mut next = 0;
        while let Some(&t) = self.star.get(next) {
            next += 1;
            for f in t.facets().into_iter().filter(|&f| mesh.apex(f) != v) {
                let across = mesh.twin(f).tet();
                let met = &mut self.met[across.index()];
                if *met != self.search {
                    *met = self.search;
                    self.star.push(across);
                }
            }
        }
        &self.star
    }

    /// The star found last.
    pub(crate) fn last(&self) -> &[TetId] {
        &self.star
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample::cube;

    #[test]
    fn stars_are_those_of_the_mesh_search_after_search() {
        let complex = cube(3, 1);
        let mut stars = Stars::default();
        for start in [0, u32::MAX - 20] {
            stars.search = start;
            for v in (0..complex.points().len()).map(VertexId::new) {
                let mut star = stars.of(complex.mesh(), v).to_vec();
                let mut expected: Vec<TetId> = complex.mesh().star(v).collect();
                star.sort_unstable();
                expected.sort_unstable();
                assert_eq!(star, expected);
            }
        }
        assert_eq!(stars.of(complex.mesh(), VertexId::new(99)), []);
        assert_eq!(stars.last(), []);
    }
}
