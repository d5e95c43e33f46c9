//! What is remembered of every tetrahedron: its ratio r/l (§4.3), where the flow leaves it (§3.3), and when it was made.

use super::flow::FlowFacets;
use crate::stamp::Stamp;
use delaunay_core::measure::tetrahedron::radius_edge_ratio;
use delaunay_core::{Subcomplex3, TetId};
use glam::DVec3;
use rayon::prelude::*;

/// Records of the tetrahedra of a subcomplex.
#[derive(Clone, Debug)]
pub(crate) struct Records {
    bound: f64,
    /// By tetrahedron.
    entries: Vec<Entry>,
    /// That of the last change.
    last: Stamp,
}

#[derive(Clone, Copy, Debug)]
struct Entry {
    squared_ratio: f64,
    stamp: Stamp,
    flow: FlowFacets,
}

impl Entry {
    const GONE: Self = Self {
        squared_ratio: 0.0,
        stamp: Stamp::NONE,
        flow: FlowFacets::NONE,
    };

    fn of(solid: &Subcomplex3, t: TetId, stamp: Stamp) -> Self {
        Self {
            squared_ratio: squared_ratio(solid.tetrahedron(t)),
            stamp,
            flow: FlowFacets::of(solid, t),
        }
    }
}

impl Records {
    /// The tetrahedra of `solid`, of low quality when r/l exceeds `bound`.
    pub(crate) fn of(solid: &Subcomplex3, bound: f64) -> Self {
        let mut records = Self {
            bound,
            entries: Vec::new(),
            last: Stamp::NONE,
        };
        let tets: Vec<TetId> = solid.tets().collect();
        records.examine_together(solid, &tets);
        records
    }

    /// Measures tetrahedra that are new.
    pub(crate) fn examine(&mut self, solid: &Subcomplex3, tets: &[TetId]) {
        let stamp = self.last.advance();
        self.entries.resize(solid.mesh().tet_slots(), Entry::GONE);
        for &t in tets {
            self.entries[t.index()] = Entry::of(solid, t, stamp);
        }
    }

    /// As [`examine`](Self::examine), on all threads.
    pub(crate) fn examine_together(&mut self, solid: &Subcomplex3, tets: &[TetId]) {
        let stamp = self.last.advance();
        let chunks = tets.par_chunks(1 << 10);
        let new: Vec<Vec<Entry>> = chunks
            .map(|tets| tets.iter().map(|&t| Entry::of(solid, t, stamp)).collect())
            .collect();
        self.entries.resize(solid.mesh().tet_slots(), Entry::GONE);
        for (t, entry) in tets.iter().zip(new.into_iter().flatten()) {
            self.entries[t.index()] = entry;
        }
    }

    /// Forgets tetrahedra that are gone.
    pub(crate) fn forget(&mut self, tets: impl IntoIterator<Item = TetId>) {
        for t in tets {
            self.entries[t.index()] = Entry::GONE;
        }
    }

    /// One more than the greatest id of a tetrahedron.
    pub(crate) fn slots(&self) -> usize {
        self.entries.len()
    }

    /// Whether there is a tetrahedron of this id.
    pub(crate) fn is_there(&self, t: TetId) -> bool {
        self.entries[t.index()].stamp != Stamp::NONE
    }

    pub(crate) fn stamp(&self, t: TetId) -> Stamp {
        self.entries[t.index()].stamp
    }

    /// The facets through which the flow leaves a tetrahedron.
    #[inline]
    pub(crate) fn flow(&self, t: TetId) -> FlowFacets {
        self.entries[t.index()].flow
    }

    pub(crate) fn squared_ratio(&self, t: TetId) -> f64 {
        self.entries[t.index()].squared_ratio
    }

    pub(crate) fn ratio(&self, t: TetId) -> f64 {
        self.squared_ratio(t).sqrt()
    }

    pub(crate) fn is_low(&self, t: TetId) -> bool {
        self.is_low_ratio(self.squared_ratio(t))
    }

    /// The ratios of all tetrahedra, by id.
    pub(crate) fn ratios(&self) -> impl Iterator<Item = f64> {
        let there = self
            .entries
            .iter()
            .filter(|entry| entry.stamp != Stamp::NONE);
        there.map(|entry| entry.squared_ratio.sqrt())
    }

    /// All tetrahedra of low quality with their squared ratios, by id.
    pub(crate) fn all_low(&self) -> impl Iterator<Item = (TetId, f64)> {
        let all = (0..self.slots()).map(TetId::new);
        let low = all.filter(|&t| self.is_low(t));
        low.map(|t| (t, self.squared_ratio(t)))
    }

    /// Whether a squared ratio is one of low quality.
    pub(crate) fn is_low_ratio(&self, squared_ratio: f64) -> bool {
        squared_ratio > self.bound * self.bound
    }

    /// By how much a squared ratio exceeds that of the bound, as a logarithm.
    pub(crate) fn excess(&self, squared_ratio: f64) -> f64 {
        (squared_ratio / (self.bound * self.bound)).ln()
    }

    /// The bound on r/l.
    pub(crate) fn bound(&self) -> f64 {
        self.bound
    }
}

/// The square of r/l of a tetrahedron.
///
/// r = |n| / 2d with `n` the vector towards the circumcenter and `d` the determinant of the edges from one corner.
#[inline]
pub(crate) fn squared_ratio(corners: [DVec3; 4]) -> f64 {
    let [a, b, c, d] = corners;
    let [u, v, w] = [b - a, c - a, d - a];
    let [uu, vv, ww] = [u, v, w].map(DVec3::length_squared);
    let (vw, wu, uv) = (v.cross(w), w.cross(u), u.cross(v));
    let toward_center = uu * vw + vv * wu + ww * uv;
    let determinant = u.dot(vw);
    let others = [v - u, w - v, u - w].map(DVec3::length_squared);
    let shortest = [vv, ww, others[0], others[1], others[2]]
        .into_iter()
        .fold(uu, f64::min);
    let divisor = 4.0 * determinant * determinant * shortest;
    let squared = toward_center.length_squared() / divisor;
    // Beyond these sizes doubles run out.
    if divisor > 1e-250 && squared < 1e250 {
        squared
    } else {
        radius_edge_ratio(corners).powi(2)
    }
}
