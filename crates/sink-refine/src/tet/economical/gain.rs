//! What inserting a point, or another exchange of tetrahedra, would do to the mesh.

use super::super::proposal::Proposal;
use super::super::records::{Records, squared_ratio};
use delaunay_core::{Patch, Subcomplex3, TetId};
use glam::DVec3;
use std::ops::Add;

/// Changes of the mesh that an exchange of tetrahedra would make.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Gain {
    /// More tetrahedra of low quality.
    pub(super) low: isize,
    /// More tetrahedra.
    pub(super) tets: isize,
    /// More of the sum of the logarithms of (r/l)² over its bound, over tetrahedra of low quality.
    pub(super) excess: f64,
}

impl Gain {
    /// What inserting the point would do.
    pub(super) fn of(solid: &Subcomplex3, records: &Records, proposal: &Proposal) -> Self {
        let mut gain = Self::default();
        for &t in proposal.prestar.tets() {
            gain.take(records, t);
        }
        for &f in proposal.prestar.boundary() {
            let [a, b, c] = solid.triangle(f);
            gain.make(records, [proposal.point, a, b, c]);
        }
        gain
    }

    /// What removing the vertex of a patch would do.
    pub(super) fn of_removal(solid: &Subcomplex3, records: &Records, patch: &Patch) -> Self {
        let mut gain = Self::default();
        for &t in patch.star() {
            gain.take(records, t);
        }
        for corners in patch.made() {
            gain.make(records, corners.map(|v| solid.point(v)));
        }
        gain
    }

    /// Counts a tetrahedron that goes.
    fn take(&mut self, records: &Records, t: TetId) {
        self.tets -= 1;
        if records.is_low(t) {
            self.low -= 1;
            self.excess -= records.excess(records.squared_ratio(t));
        }
    }

    /// Counts a tetrahedron that comes.
    fn make(&mut self, records: &Records, corners: [DVec3; 4]) {
        self.tets += 1;
        let squared = squared_ratio(corners);
        if records.is_low_ratio(squared) {
            self.low += 1;
            self.excess += records.excess(squared);
        }
    }
}

impl Add for Gain {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            low: self.low + other.low,
            tets: self.tets + other.tets,
            excess: self.excess + other.excess,
        }
    }
}
