//! The hole that two neighbours would leave, and the tetrahedra that would fill it, in rounded numbers.

use super::super::marks::Marks;
use super::super::records::Records;
use delaunay_core::{FacetId, Subcomplex3, TetId, VertexId, WrappedTet, Wrapping};
use glam::DVec3;

/// The stars of two neighbours, and what would come in their place. Keeps its room from one pair to the next.
#[derive(Debug, Default)]
pub(super) struct Hole {
    stars: Vec<TetId>,
    in_stars: Marks,
    /// How many tetrahedra of the stars are of low quality.
    low_before: usize,
    /// The facets round the hole: each by its outer side, and by its corners as seen from outside the hole.
    outer: Vec<FacetId>,
    facets: Vec<[usize; 3]>,
    /// The vertices round the hole, and where they are; and of those inside, which have no tetrahedra but in the stars.
    vertices: Vec<VertexId>,
    points: Vec<DVec3>,
    /// By vertex: its place among those, if it is one of them.
    places: Vec<u32>,
    wrapping: Wrapping,
    /// The tetrahedra of low quality among those that fill the hole.
    low: Vec<usize>,
}

/// A place for one vertex instead of two.
#[derive(Clone, Copy, Debug)]
pub(super) struct Candidate {
    pub(super) point: DVec3,
    /// Tetrahedra of low quality that would stay in the hole.
    low: usize,
}

impl Candidate {
    pub(super) fn at(point: DVec3) -> Self {
        Self { point, low: 0 }
    }
}

impl Hole {
    /// Finds the hole of two neighbours; tells whether none of them is on the boundary.
    pub(super) fn open(
        &mut self,
        solid: &Subcomplex3,
        records: &Records<'_>,
        pair: [VertexId; 2],
    ) -> bool {
        let opened = self.find_stars(solid, pair);
        if opened {
            self.find_rim(solid, pair);
            let low = self.stars.iter().filter(|&&t| records.is_low(t));
            self.low_before = low.count();
        }
        opened
    }

    /// Collects both stars; `false` when one of the vertices is on the boundary.
    fn find_stars(&mut self, solid: &Subcomplex3, pair: [VertexId; 2]) -> bool {
        let mesh = solid.mesh();
        self.stars.clear();
        self.in_stars.clear(mesh.tet_slots());
        self.stars.extend(mesh.home(pair[0]));
        for &t in &self.stars {
            self.in_stars.mark(t);
        }
        let mut next = 0;
        while let Some(&t) = self.stars.get(next) {
            next += 1;
            if mesh.is_ghost_tet(t) {
                return false;
            }
            let in_pair = mesh.tet_vertices(t).map(|v| pair.contains(&v));
            for f in t.facets() {
                let mut corners = in_pair.into_iter().enumerate();
                let has_one = corners.any(|(corner, one)| one && corner != f.corner());
                let across = mesh.twin(f).tet();
                if has_one && self.in_stars.mark(across) {
                    self.stars.push(across);
                }
            }
        }
        true
    }

    /// Finds the vertices of the stars but the two, and the facets round them.
    fn find_rim(&mut self, solid: &Subcomplex3, pair: [VertexId; 2]) {
        let mesh = solid.mesh();
        self.vertices.clear();
        self.points.clear();
        self.places.resize(solid.points().len(), 0);
        let corners = self.stars.iter().flat_map(|&t| mesh.tet_vertices(t));
        for v in corners.filter(|v| !pair.contains(v)) {
            let place = &mut self.places[v.index()];
            if self.vertices.get(*place as usize) != Some(&v) {
                *place = self.vertices.len() as u32;
                self.vertices.push(v);
                self.points.push(solid.point(v));
            }
        }
        self.outer.clear();
        self.facets.clear();
        for inner in self.stars.iter().flat_map(|t| t.facets()) {
            let outer = mesh.twin(inner);
            if !self.in_stars.is_marked(outer.tet()) {
                let corners = mesh.facet_vertices(inner);
                self.outer.push(outer);
                self.facets
                    .push(corners.map(|v| self.places[v.index()] as usize));
            }
        }
    }

    /// Fills the hole as long as there are candidates that cure enough, and leaves those: with them no more tetrahedra of low
    /// quality stay in the hole than there were.
    pub(super) fn fill_for(&mut self, candidates: &mut Vec<Candidate>, records: &Records<'_>) {
        let (points, stars, low) = (&self.points, &self.stars, &mut self.low);
        let most = self.low_before;
        let mut count = 0;
        low.clear();
        let facets = self.facets.iter().copied();
        let filled = self.wrapping.fill(points, facets, |tet| {
            let quality = records.measure(tet.corners.map(|corner| points[corner]), stars);
            if quality.is_low(records.bound()) {
                low.push(count);
                candidates.retain_mut(|candidate| {
                    candidate.low += usize::from(!tet.is_in_conflict(candidate.point));
                    candidate.low <= most
                });
            }
            count += 1;
            !candidates.is_empty()
        });
        if filled.is_none() {
            candidates.clear();
        }
    }

    /// The tetrahedra of both stars.
    pub(super) fn stars(&self) -> &[TetId] {
        &self.stars
    }

    /// Whether a tetrahedron is in one of the stars.
    pub(super) fn contains(&self, t: TetId) -> bool {
        self.in_stars.is_marked(t)
    }

    /// How many tetrahedra of the stars are of low quality.
    pub(super) fn low_before(&self) -> usize {
        self.low_before
    }

    /// The facets round the hole, each by its outer side.
    pub(super) fn outer(&self) -> &[FacetId] {
        &self.outer
    }

    /// The middle of the vertices round the hole.
    pub(super) fn middle(&self) -> DVec3 {
        self.points.iter().sum::<DVec3>() / self.points.len() as f64
    }

    /// The tetrahedra that fill the hole.
    pub(super) fn filling(&self) -> &[WrappedTet] {
        self.wrapping.tets()
    }

    /// Those of the filling that are of low quality, by number.
    pub(super) fn low(&self) -> &[usize] {
        &self.low
    }

    /// The corners of a tetrahedron that fills the hole.
    pub(super) fn corners(&self, tet: &WrappedTet) -> [VertexId; 4] {
        tet.corners.map(|corner| self.vertices[corner])
    }
}
