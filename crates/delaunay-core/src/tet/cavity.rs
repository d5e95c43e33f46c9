//! Cavity of a point: the tetrahedra whose circumball contains it, and their boundary.
//!
//! The sink paper calls the cavity *prestar*, the vertices and facets round it *flower*. It is found by
//! crossing facets from a tetrahedron known to be in it; each tetrahedron is tested once.

use super::delaunay::Delaunay3;
use super::locate::Location3;
use super::mesh::TetMesh;
use super::sight::Sight3;
use super::table::Table;
use crate::ids::{FacetId, TetId, VertexId};
use geo_predicates::CoordinateError;
use glam::DVec3;
use rustc_hash::FxHashSet;

/// The tetrahedra whose open circumball contains a point, and the facets that bound them.
#[derive(Clone, Debug, Default)]
pub struct Cavity3 {
    pub(super) tets: Vec<TetId>,
    pub(super) boundary: Vec<FacetId>,
    /// What was found out about each tetrahedron met.
    tested: Table<bool>,
    /// The new facets on the directed edges of the boundary, see [`super::star`].
    pub(super) edges: Table<u32>,
}

impl Cavity3 {
    /// The tetrahedra, ghosts included, the one in which the search began first.
    #[must_use]
    pub fn tets(&self) -> &[TetId] {
        &self.tets
    }

    /// The facets that bound the cavity, each by its outer side, in a tetrahedron that stays.
    #[must_use]
    pub fn boundary(&self) -> &[FacetId] {
        &self.boundary
    }

    /// The vertices round the cavity, each once: those that inserting the point would make its
    /// neighbours, the ghost included; ascending.
    #[must_use]
    pub fn vertices(&self, mesh: &TetMesh) -> Vec<VertexId> {
        let corners = self.boundary.iter().flat_map(|&f| mesh.facet_vertices(f));
        let distinct: FxHashSet<VertexId> = corners.collect();
        let mut vertices: Vec<VertexId> = distinct.into_iter().collect();
        vertices.sort_unstable();
        vertices
    }

    /// Fills the cavity with all that `conflicts` says of tetrahedra connected with `seed`.
    pub(super) fn dig(
        &mut self,
        mesh: &TetMesh,
        seed: TetId,
        mut conflicts: impl FnMut(TetId) -> bool,
    ) {
        self.tets.clear();
        self.boundary.clear();
        self.tested.clear();
        self.tets.push(seed);
        self.tested.insert(key(seed), true);
        let mut next = 0;
        while let Some(&t) = self.tets.get(next) {
            next += 1;
            for facet in t.facets() {
                let outer = mesh.twin(facet);
                let across = outer.tet();
                let known = self.tested.get(key(across));
                let inside = known.unwrap_or_else(|| {
                    let inside = conflicts(across);
                    self.tested.insert(key(across), inside);
                    if inside {
                        self.tets.push(across);
                    }
                    inside
                });
                if !inside {
                    self.boundary.push(outer);
                }
            }
        }
    }
}

fn key(t: TetId) -> u64 {
    t.index() as u64
}

impl Delaunay3 {
    /// The cavity of `p`: all tetrahedra whose open circumball contains it, ties broken as in the whole
    /// triangulation; empty when `p` is a vertex.
    ///
    /// # Errors
    /// [`CoordinateError`] when a coordinate of `p` is not accepted.
    pub fn cavity(&self, p: DVec3) -> Result<Cavity3, CoordinateError> {
        let mut cavity = Cavity3::default();
        if let Ok(seed) = self.seed(self.locate(p)?) {
            self.dig(p, seed, &mut cavity);
        }
        Ok(cavity)
    }

    /// As [`cavity`](Self::cavity), located by a walk from `hint`, a vertex near `p`.
    ///
    /// # Errors
    /// [`CoordinateError`] when a coordinate of `p` is not accepted.
    pub fn cavity_near(&self, p: DVec3, hint: VertexId) -> Result<Cavity3, CoordinateError> {
        let mut cavity = Cavity3::default();
        if let Ok(seed) = self.seed(self.locate_near(p, hint)?) {
            self.dig(p, seed, &mut cavity);
        }
        Ok(cavity)
    }

    /// A tetrahedron in the cavity of a point at `location`, or the vertex that is there already.
    pub(super) fn seed(&self, location: Location3) -> Result<TetId, VertexId> {
        location.seed(&self.mesh)
    }

    /// Fills `cavity` with the cavity of `p`, from a tetrahedron `seed` known to be in it.
    pub(super) fn dig(&self, p: DVec3, seed: TetId, cavity: &mut Cavity3) {
        let sight = Sight3::new(self.coords.as_slice(), self.filter, p);
        cavity.dig(&self.mesh, seed, |t| sight.in_conflict(&self.mesh, t));
    }
}
