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
use crate::memory::prefetch;
use geo_predicates::CoordinateError;
use glam::DVec3;
use rustc_hash::FxHashSet;

/// As many tetrahedra as all but a few cavities have in evenly spread points.
const USUAL_TETS: usize = 40;

/// The tetrahedra whose open circumball contains a point, and the facets that bound them.
#[derive(Clone, Debug, Default)]
pub struct Cavity3 {
    pub(super) tets: Vec<TetId>,
    pub(super) boundary: Vec<FacetId>,
    /// The tetrahedra round the layer added last, each by the facet it was met through.
    around: Vec<FacetId>,
    /// The facets of the cavity by their outer sides, with the number of the tetrahedron there.
    sides: Vec<(FacetId, u32)>,
    /// Whether each tetrahedron met is in the cavity.
    inside: Vec<bool>,
    /// In which order tetrahedra were met.
    numbers: Table<u32>,
    /// The new facets on the edges of the boundary, see [`super::star`].
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

    /// Becomes a cavity found earlier, of tetrahedra that have not changed since.
    pub fn assign(&mut self, tets: &[TetId], boundary: &[FacetId]) {
        self.tets.clear();
        self.tets.extend_from_slice(tets);
        self.boundary.clear();
        self.boundary.extend_from_slice(boundary);
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

    /// Fills the cavity with all that `conflicts` says of tetrahedra connected with `seed`; `coords` are the places
    /// of the vertices.
    ///
    /// It grows in layers. All that has to be looked at to test the tetrahedra round a layer is called for
    /// before the first is tested, so that the waits for memory, which take most of the time in a large mesh,
    /// pass together.
    pub(super) fn dig(
        &mut self,
        mesh: &TetMesh,
        coords: &[DVec3],
        seed: TetId,
        mut conflicts: impl FnMut(TetId) -> bool,
    ) {
        self.tets.clear();
        self.sides.clear();
        self.inside.clear();
        // Room for all but a few cavities, so that a new list grows once.
        self.tets.reserve(USUAL_TETS);
        self.sides.reserve(4 * USUAL_TETS);
        self.inside.reserve(2 * USUAL_TETS);
        self.numbers.clear();
        self.tets.push(seed);
        self.inside.push(true);
        self.numbers.meet(key(seed), 0);
        let mut layer = 0;
        while layer < self.tets.len() {
            let first = self.inside.len();
            self.surround(mesh, layer);
            layer = self.tets.len();
            for &outer in &self.around {
                let apex = mesh.apex(outer);
                prefetch(&coords[apex.slot()]);
                mesh.prefetch_home(apex);
            }
            for (number, outer) in (first..).zip(&self.around) {
                if conflicts(outer.tet()) {
                    self.inside[number] = true;
                    self.tets.push(outer.tet());
                }
            }
        }
        let sides = self.sides.iter();
        let boundary = sides.filter(|&&(_, number)| !self.inside[number as usize]);
        self.boundary.clear();
        self.boundary.extend(boundary.map(|&(outer, _)| outer));
    }

    /// Finds the tetrahedra round those from number `layer` on that have not been met before; they count as
    /// outside for now.
    fn surround(&mut self, mesh: &TetMesh, layer: usize) {
        self.around.clear();
        let sides = self.tets[layer..].iter().flat_map(|t| t.facets());
        for outer in sides.map(|facet| mesh.twin(facet)) {
            let across = outer.tet();
            let next = self.inside.len() as u32;
            let known = self.numbers.meet(key(across), next);
            if known.is_none() {
                self.inside.push(false);
                self.around.push(outer);
                mesh.prefetch_tet(across);
            }
            self.sides.push((outer, known.unwrap_or(next)));
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
        cavity.dig(&self.mesh, &self.coords, seed, |t| {
            sight.in_conflict(&self.mesh, t)
        });
    }
}
