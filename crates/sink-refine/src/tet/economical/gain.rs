//! What inserting a point, or another exchange of tetrahedra, would do to the mesh.

use super::super::proposal::Proposal;
use super::super::records::Records;
use delaunay_core::{Patch, Subcomplex3, TetId};
use glam::DVec3;

/// Changes of the mesh that an exchange of tetrahedra would make.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Gain {
    /// More tetrahedra of low quality.
    pub(super) low: isize,
    /// More tetrahedra.
    pub(super) tets: isize,
    /// More of the sum of the logarithms of (r/l)² over its bound, over tetrahedra of low quality; of those that are worse for
    /// their size, of r² over its bound.
    pub(super) excess: f64,
    /// The square of the largest size, circumradius over that allowed, of the tetrahedra that come last.
    largest: f64,
}

impl Gain {
    /// What inserting the point would do.
    pub(super) fn of(solid: &Subcomplex3, records: &Records<'_>, proposal: &Proposal) -> Self {
        let mut gain = Self::default();
        let gone = proposal.prestar.tets();
        for &t in gone {
            gain.take(records, t);
        }
        for &f in proposal.prestar.boundary() {
            let [a, b, c] = solid.triangle(f);
            gain.make(records, [proposal.point, a, b, c], gone);
        }
        gain
    }

    /// What removing the vertex of a patch would do.
    pub(super) fn of_removal(solid: &Subcomplex3, records: &Records<'_>, patch: &Patch) -> Self {
        let mut gain = Self::default();
        let gone = patch.star();
        for &t in gone {
            gain.take(records, t);
        }
        for corners in patch.made() {
            gain.make(records, corners.map(|v| solid.point(v)), gone);
        }
        gain
    }

    /// Whether no more tetrahedra are of low quality, and none that comes is too large.
    pub(super) fn is_harmless(&self) -> bool {
        self.low <= 0 && self.largest <= 1.0
    }

    /// Counts a tetrahedron that goes.
    fn take(&mut self, records: &Records<'_>, t: TetId) {
        self.tets -= 1;
        if records.is_low(t) {
            self.low -= 1;
            self.excess -= records.quality(t).excess(records.bound());
        }
    }

    /// Counts a tetrahedron that comes in the place of those gone.
    fn make(&mut self, records: &Records<'_>, corners: [DVec3; 4], gone: &[TetId]) {
        self.tets += 1;
        let quality = records.measure(corners, gone);
        self.largest = self.largest.max(quality.squared_size);
        if quality.is_low(records.bound()) {
            self.low += 1;
            self.excess += quality.excess(records.bound());
        }
    }
}
