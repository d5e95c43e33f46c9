//! What inserting a point, or another exchange of triangles, would do to the mesh.

use super::super::proposal::Proposal;
use super::super::records::{Records, squared_ratio};
use delaunay_core::{FaceId, Patch2, Subcomplex2};
use glam::DVec2;
use std::ops::Add;

/// Changes of the mesh that an exchange of triangles would make.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Gain {
    /// More triangles of low quality.
    pub(super) low: isize,
    /// More of the sum of the logarithms of (r/l)² over its bound, over triangles of low quality.
    pub(super) excess: f64,
    /// The largest (r/l)² of the triangles that come.
    pub(super) worst: f64,
}

impl Gain {
    /// What inserting the point would do.
    pub(super) fn of(region: &Subcomplex2, records: &Records, proposal: &Proposal) -> Self {
        let mut gain = Self::default();
        for &f in proposal.prestar.faces() {
            gain.take(records, f);
        }
        for edge in proposal.prestar.rim() {
            let [b, a] = region.segment(edge.outer);
            gain.make(records, [proposal.point, a, b]);
        }
        gain
    }

    /// What removing the vertex of a patch would do.
    pub(super) fn of_removal(region: &Subcomplex2, records: &Records, patch: &Patch2) -> Self {
        let mut gain = Self::default();
        for &f in patch.star() {
            gain.take(records, f);
        }
        for corners in patch.made() {
            gain.make(records, corners.map(|v| region.point(v)));
        }
        gain
    }

    /// Whether no more triangles are of low quality, and as many are not worse on the whole.
    pub(super) fn is_harmless(&self) -> bool {
        // What comes and goes in between leaves some rounding.
        (self.low, self.excess) <= (0, 1e-12)
    }

    /// Whether it leaves fewer triangles of low quality than `other` does, or as many and better ones.
    pub(super) fn is_better(&self, other: &Self) -> bool {
        (self.low, self.excess, self.worst) < (other.low, other.excess, other.worst)
    }

    /// Counts a triangle that goes.
    fn take(&mut self, records: &Records, f: FaceId) {
        if records.is_low(f) {
            self.low -= 1;
            self.excess -= records.excess(records.squared_ratio(f));
        }
    }

    /// Counts a triangle that comes.
    fn make(&mut self, records: &Records, corners: [DVec2; 3]) {
        let squared = squared_ratio(corners);
        self.worst = self.worst.max(squared);
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
            excess: self.excess + other.excess,
            worst: self.worst.max(other.worst),
        }
    }
}
