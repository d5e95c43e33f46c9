//! The cavity of a point in a hole: partly among the tetrahedra that would fill it, partly among those round it.

use super::super::marks::Marks;
use super::hole::Hole;
use delaunay_core::{Across, FACET_CORNERS, FacetId, Subcomplex3, TetId, VertexId};
use glam::DVec3;

/// The cavity of a point. Keeps its room from one point to the next.
#[derive(Debug, Default)]
pub(super) struct HoleCavity {
    /// Whether each tetrahedron that fills the hole is in the cavity.
    inside: Vec<bool>,
    /// The tetrahedra round the hole that are.
    outside: Vec<TetId>,
    in_outside: Marks,
    /// The facets of the cavity with a tetrahedron beyond that was round the hole, by that side.
    outer_rim: Vec<FacetId>,
    /// All facets of the cavity, counterclockwise as seen from outside of it.
    rim: Vec<[VertexId; 3]>,
}

impl HoleCavity {
    /// Finds the cavity of a point.
    pub(super) fn dig(&mut self, solid: &Subcomplex3, hole: &Hole, point: DVec3) {
        let filling = hole.filling().iter();
        self.inside.clear();
        self.inside
            .extend(filling.map(|tet| tet.is_in_conflict(point)));
        self.outside.clear();
        self.in_outside.clear(solid.mesh().tet_slots());
        self.outer_rim.clear();
        self.rim.clear();
        self.leave_hole(solid, hole, point);
        self.spread(solid, hole, point);
        // Some were met before what is beyond them became part of the cavity.
        let mesh = solid.mesh();
        self.outer_rim
            .retain(|f| !self.in_outside.is_marked(f.tet()));
        let outer = self.outer_rim.iter().map(|&f| mesh.facet_vertices(f));
        self.rim.extend(outer.map(|[a, b, c]| [c, b, a]));
    }

    /// Goes from the tetrahedra of the cavity in the hole to what is beyond their facets.
    fn leave_hole(&mut self, solid: &Subcomplex3, hole: &Hole, point: DVec3) {
        for (index, tet) in hole.filling().iter().enumerate() {
            if !self.inside[index] {
                continue;
            }
            for (facet, across) in FACET_CORNERS.into_iter().zip(tet.across) {
                match across {
                    Across::Tet(other) if self.inside[other] => {}
                    Across::Tet(_) => {
                        let corners = hole.corners(tet);
                        self.rim.push(facet.map(|corner| corners[corner]));
                    }
                    Across::Facet(number) => self.cross(solid, hole.outer()[number], point),
                }
            }
        }
    }

    /// Goes on from the tetrahedra of the cavity round the hole.
    fn spread(&mut self, solid: &Subcomplex3, hole: &Hole, point: DVec3) {
        let mut next = 0;
        while let Some(&t) = self.outside.get(next) {
            next += 1;
            for f in t.facets() {
                let outer = solid.mesh().twin(f);
                if !hole.contains(outer.tet()) {
                    self.cross(solid, outer, point);
                } else if !self.is_inside_behind(hole, f) {
                    self.rim.push(solid.mesh().facet_vertices(f));
                }
            }
        }
    }

    /// Takes the tetrahedron of a facet's outer side into the cavity if it is in conflict with the point, else the facet into
    /// its rim.
    fn cross(&mut self, solid: &Subcomplex3, outer: FacetId, point: DVec3) {
        let t = outer.tet();
        if self.in_outside.is_marked(t) {
            return;
        }
        if !solid.mesh().is_ghost_tet(t) && solid.in_conflict(point, t) {
            self.in_outside.mark(t);
            self.outside.push(t);
        } else {
            self.outer_rim.push(outer);
        }
    }

    /// Whether the tetrahedron in the hole behind one of the facets round it is in the cavity.
    fn is_inside_behind(&self, hole: &Hole, outer: FacetId) -> bool {
        let number = hole.outer().iter().position(|&f| f == outer);
        let side = number.map(Across::Facet);
        let mut filling = hole.filling().iter().zip(&self.inside);
        filling
            .any(|(tet, &inside)| inside && tet.across.iter().any(|&across| Some(across) == side))
    }

    /// Whether the tetrahedron of this number among those that fill the hole is in the cavity.
    pub(super) fn contains(&self, index: usize) -> bool {
        self.inside[index]
    }

    /// How many tetrahedra stay in the hole.
    pub(super) fn staying(&self) -> usize {
        self.inside.iter().filter(|&&inside| !inside).count()
    }

    /// The tetrahedra of the cavity round the hole.
    pub(super) fn outside(&self) -> &[TetId] {
        &self.outside
    }

    /// The facets of the cavity, counterclockwise as seen from outside of it.
    pub(super) fn rim(&self) -> &[[VertexId; 3]] {
        &self.rim
    }

    /// Those of them that are boundary, by the side of the ghost.
    pub(super) fn boundary<'a>(
        &'a self,
        solid: &'a Subcomplex3,
    ) -> impl Iterator<Item = FacetId> + 'a {
        let outer = self.outer_rim.iter().copied();
        outer.filter(|f| solid.mesh().is_ghost_tet(f.tet()))
    }
}
