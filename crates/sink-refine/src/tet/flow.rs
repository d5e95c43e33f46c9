//! The flow from tetrahedron to tetrahedron, toward larger circumspheres (§3.3), and the sinks where it ends (§3.2).
//!
//! A tetrahedron precedes its neighbour when its circumcenter lies strictly beyond their common facet: when its apex
//! over that facet is strictly inside the facet's diametral sphere. One exact sign decides, no rounded center.
//!
//! A tetrahedron has at most two successors. Along the flow the circumradius grows; it stays the same only between
//! tetrahedra of one sphere, which have one center and are crossed toward it. So the flow never runs in circles.
//!
//! All this is about Delaunay tetrahedra. Near a divided boundary some may not be Delaunay, and the flow between them may return;
//! walks end all the same, as they pass no tetrahedron twice.

use super::marks::Marks;
use delaunay_core::measure::tetrahedron::circumcenter;
use delaunay_core::{FacetId, Subcomplex3, TetId};
use glam::DVec3;

/// Where the flow goes from a tetrahedron through one of its facets.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Successor3 {
    /// Into the neighbour on whose side of the common facet the circumcenter lies.
    Tet(TetId),
    /// Across the boundary, to the dummy element ω that stands for all outside.
    Outside(FacetId),
}

/// The facets through which the flow leaves a tetrahedron: at most two.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct FlowFacets(u8);

impl FlowFacets {
    pub(crate) const NONE: Self = Self(0);

    pub(crate) fn of(solid: &Subcomplex3, t: TetId) -> Self {
        let bit = |f: FacetId| u8::from(solid.flows_through(f)) << f.corner();
        Self(t.facets().into_iter().map(bit).sum())
    }

    pub(crate) fn successors(
        self,
        solid: &Subcomplex3,
        t: TetId,
    ) -> impl Iterator<Item = Successor3> {
        let facets = t.facets().into_iter();
        let crossed = facets.filter(move |f| self.0 >> f.corner() & 1 == 1);
        crossed.map(|f| match solid.mesh().twin(f).tet() {
            beyond if solid.mesh().is_ghost_tet(beyond) => Successor3::Outside(f),
            beyond => Successor3::Tet(beyond),
        })
    }
}

/// The successors of `t`, at most two; none for a sink tetrahedron. Exact, O(1). Source: §3.3.
///
/// # Panics
/// When there is no tetrahedron `t` or it is a ghost.
pub fn successors(solid: &Subcomplex3, t: TetId) -> impl Iterator<Item = Successor3> + '_ {
    FlowFacets::of(solid, t).successors(solid, t)
}

/// Whether `t` contains its circumcenter, in its interior or on its surface. Exact, O(1).
///
/// # Panics
/// When there is no tetrahedron `t` or it is a ghost.
#[must_use]
pub fn is_sink(solid: &Subcomplex3, t: TetId) -> bool {
    FlowFacets::of(solid, t) == FlowFacets::NONE
}

/// The sink of a sink tetrahedron: its circumcenter, rounded.
///
/// As it lies in the tetrahedron, rounding moves it by a few units in the last place of the corners' coordinates.
///
/// # Panics
/// When there is no tetrahedron `t` or it is a ghost.
#[must_use]
pub fn sink(solid: &Subcomplex3, t: TetId) -> DVec3 {
    circumcenter(solid.tetrahedron(t))
}

/// Follows the flow; keeps its room from one tetrahedron to the next.
#[derive(Clone, Debug, Default)]
pub struct FlowWalk {
    passed: Vec<TetId>,
    seen: Marks,
    sinks: Vec<TetId>,
    leaves: bool,
}

impl FlowWalk {
    /// The sink tetrahedra in which the flow from `t` ends, by id. Takes time proportional to the tetrahedra passed,
    /// of which there are a handful in usual meshes. Exact. Source: §3.3, "set of sinks".
    ///
    /// # Panics
    /// When there is no tetrahedron `t` or it is a ghost.
    pub fn sinks_of(&mut self, solid: &Subcomplex3, t: TetId) -> &[TetId] {
        self.follow(solid, t, |t| FlowFacets::of(solid, t))
    }

    /// As [`sinks_of`](Self::sinks_of), by flow facets known already.
    pub(crate) fn follow(
        &mut self,
        solid: &Subcomplex3,
        t: TetId,
        flow: impl Fn(TetId) -> FlowFacets,
    ) -> &[TetId] {
        self.seen.clear(solid.mesh().tet_slots());
        self.passed.clear();
        self.passed.push(t);
        self.sinks.clear();
        self.leaves = false;
        let mut next = 0;
        while let Some(&here) = self.passed.get(next) {
            next += 1;
            let facets = flow(here);
            if facets == FlowFacets::NONE {
                self.sinks.push(here);
            }
            for successor in facets.successors(solid, here) {
                match successor {
                    Successor3::Tet(beyond) => {
                        if self.seen.mark(beyond) {
                            self.passed.push(beyond);
                        }
                    }
                    Successor3::Outside(_) => self.leaves = true,
                }
            }
        }
        self.sinks.sort_unstable();
        &self.sinks
    }

    /// `t` alone, as if the flow ended there.
    pub(crate) fn stay(&mut self, t: TetId) -> &[TetId] {
        self.sinks.clear();
        self.sinks.push(t);
        &self.sinks
    }

    /// Whether some of the flow followed last leaves through the boundary.
    #[must_use]
    pub fn leaves(&self) -> bool {
        self.leaves
    }

    /// The tetrahedra passed last: the descendants of the one it started from, itself first.
    #[must_use]
    pub fn passed(&self) -> &[TetId] {
        &self.passed
    }
}
