//! What inserting a point, or another exchange of triangles, would do to the mesh.

use super::super::proposal::Proposal;
use super::super::records::Records;
use delaunay_core::{FaceId, Patch2, Subcomplex2};
use glam::DVec2;
use std::ops::Add;

/// Changes of the mesh that an exchange of triangles would make.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Gain {
    /// More triangles of low quality.
    pub(super) low: isize,
    /// More of the sum of the logarithms of (r/l)² over its bound, over triangles of low quality; of those that are worse for
    /// their size, of r² over its bound.
    pub(super) excess: f64,
    /// The largest (r/l)² of the triangles that come, or what is as bad for their size.
    pub(super) worst: f64,
    /// The square of the largest size, circumradius over that allowed, of the triangles that come last.
    largest: f64,
}

impl Gain {
    /// What inserting the point would do.
    pub(super) fn of(region: &Subcomplex2, records: &Records<'_>, proposal: &Proposal) -> Self {
        let mut gain = Self::default();
        let gone = proposal.prestar.faces();
        for &f in gone {
            gain.take(records, f);
        }
        for edge in proposal.prestar.rim() {
            let [b, a] = region.segment(edge.outer);
            gain.make(records, [proposal.point, a, b], gone);
        }
        gain
    }

    /// What removing the vertex of a patch would do.
    pub(super) fn of_removal(region: &Subcomplex2, records: &Records<'_>, patch: &Patch2) -> Self {
        let mut gain = Self::default();
        let gone = patch.star();
        for &f in gone {
            gain.take(records, f);
        }
        for corners in patch.made() {
            gain.make(records, corners.map(|v| region.point(v)), gone);
        }
        gain
    }

    /// Whether no more triangles are of low quality, as many are not worse on the whole, and none that comes is too large.
    pub(super) fn is_harmless(&self) -> bool {
        // What comes and goes in between leaves some rounding.
        (self.low, self.excess) <= (0, 1e-12) && self.largest <= 1.0
    }

    /// Whether it leaves fewer triangles of low quality than `other` does, or as many and better ones.
    pub(super) fn is_better(&self, other: &Self) -> bool {
        (self.low, self.excess, self.worst) < (other.low, other.excess, other.worst)
    }

    /// Counts a triangle that goes.
    fn take(&mut self, records: &Records<'_>, f: FaceId) {
        if records.is_low(f) {
            self.low -= 1;
            self.excess -= records.quality(f).excess(records.bound());
        }
    }

    /// Counts a triangle that comes in the place of those gone.
    fn make(&mut self, records: &Records<'_>, corners: [DVec2; 3], gone: &[FaceId]) {
        let quality = records.measure(corners, gone);
        self.worst = self.worst.max(quality.badness(records.bound()));
        self.largest = self.largest.max(quality.squared_size);
        if quality.is_low(records.bound()) {
            self.low += 1;
            self.excess += quality.excess(records.bound());
        }
    }
}

impl Add for Gain {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            low: self.low + other.low,
            excess: self.excess + other.excess,
            largest: other.largest,
            worst: self.worst.max(other.worst),
        }
    }
}
