//! What is remembered of every tetrahedron: its ratio r/l (§4.3) and size, where the flow leaves it (§3.3), and when it was made.

use super::flow::FlowFacets;
use super::sizes::Sizes;
use crate::quality::Quality;
use crate::stamp::Stamp;
use crate::stop::Stop;
use delaunay_core::measure::Summary;
use delaunay_core::measure::tetrahedron::radius_edge_ratio;
use delaunay_core::{Subcomplex3, TetId};
use glam::DVec3;
use rayon::prelude::*;

/// Records of the tetrahedra of a subcomplex.
#[derive(Clone, Debug)]
pub(crate) struct Records<'a> {
    bound: f64,
    sizes: Sizes<'a>,
    /// By tetrahedron.
    entries: Vec<Entry>,
    /// That of the last change.
    last: Stamp,
    /// The first tetrahedron found for which the sizing field gives no size, by its corners.
    unusable: Option<[DVec3; 4]>,
}

#[derive(Clone, Copy, Debug)]
struct Entry {
    quality: Quality,
    stamp: Stamp,
    flow: FlowFacets,
}

impl Entry {
    const GONE: Self = Self {
        quality: Quality::NONE,
        stamp: Stamp::NONE,
        flow: FlowFacets::NONE,
    };
}

impl<'a> Records<'a> {
    /// The tetrahedra of `solid`, of low quality when r/l exceeds `bound` or they are too large.
    pub(crate) fn of(solid: &Subcomplex3, bound: f64, sizes: Sizes<'a>) -> Self {
        let mut records = Self {
            bound,
            sizes,
            entries: Vec::new(),
            last: Stamp::NONE,
            unusable: None,
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
            let entry = self.entry(solid, t, stamp);
            self.record(solid, t, entry);
        }
    }

    /// As [`examine`](Self::examine), on all threads.
    pub(crate) fn examine_together(&mut self, solid: &Subcomplex3, tets: &[TetId]) {
        let stamp = self.last.advance();
        let chunks = tets.par_chunks(1 << 10);
        let new: Vec<Vec<Entry>> = chunks
            .map(|tets| tets.iter().map(|&t| self.entry(solid, t, stamp)).collect())
            .collect();
        self.entries.resize(solid.mesh().tet_slots(), Entry::GONE);
        for (&t, entry) in tets.iter().zip(new.into_iter().flatten()) {
            self.record(solid, t, entry);
        }
    }

    fn entry(&self, solid: &Subcomplex3, t: TetId, stamp: Stamp) -> Entry {
        Entry {
            quality: self.measure(solid.tetrahedron(t), &[t]),
            stamp,
            flow: FlowFacets::of(solid, t),
        }
    }

    fn record(&mut self, solid: &Subcomplex3, t: TetId, entry: Entry) {
        self.entries[t.index()] = entry;
        if entry.quality.squared_size.is_nan() && self.unusable.is_none() {
            self.unusable = Some(solid.tetrahedron(t));
        }
    }

    /// The quality of a tetrahedron, there or not, in the region of others.
    pub(crate) fn measure(&self, corners: [DVec3; 4], home: &[TetId]) -> Quality {
        let in_region = self.sizes.of_region(home);
        Quality {
            squared_ratio: squared_ratio(corners),
            squared_size: self.sizes.squared_size(corners, in_region),
        }
    }

    /// Whether the sizing field has given sizes for all tetrahedra.
    ///
    /// # Errors
    /// [`Stop::UnusableSize`].
    pub(crate) fn check_sizes(&self) -> Result<(), Stop> {
        let found = self.unusable.map(|corners| self.sizes.unusable(corners));
        found.map_or(Ok(()), |unusable| Err(Stop::UnusableSize(unusable)))
    }

    /// Takes note that tetrahedra have come in the place of others.
    pub(crate) fn inherit(&mut self, heirs: &[TetId], from: &[TetId]) {
        self.sizes.inherit(heirs, from);
    }

    /// The largest circumradius that a tetrahedron may have for its size.
    pub(crate) fn largest_radius(&self, solid: &Subcomplex3, t: TetId) -> f64 {
        let in_region = self.sizes.of_region(&[t]);
        self.sizes.largest_radius(solid.tetrahedron(t), in_region)
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
        self.stamp(t) != Stamp::NONE
    }

    pub(crate) fn stamp(&self, t: TetId) -> Stamp {
        self.entries[t.index()].stamp
    }

    /// The facets through which the flow leaves a tetrahedron.
    #[inline]
    pub(crate) fn flow(&self, t: TetId) -> FlowFacets {
        self.entries[t.index()].flow
    }

    pub(crate) fn quality(&self, t: TetId) -> Quality {
        self.entries[t.index()].quality
    }

    /// How bad a tetrahedron is, see [`Quality::badness`].
    pub(crate) fn badness(&self, t: TetId) -> f64 {
        self.quality(t).badness(self.bound)
    }

    pub(crate) fn is_low(&self, t: TetId) -> bool {
        self.quality(t).is_low(self.bound)
    }

    /// The ratios of all tetrahedra, and how many of them are of low quality; on all threads.
    pub(crate) fn summary(&self) -> (Option<Summary>, usize) {
        let parts = self.entries.par_chunks(1 << 13).map(|entries| {
            let there = entries.iter().filter(|entry| entry.stamp != Stamp::NONE);
            let ratios = there.clone().map(|entry| entry.quality.ratio());
            let low = there.filter(|entry| entry.quality.is_low(self.bound));
            (Summary::of(ratios), low.count())
        });
        let (summaries, low): (Vec<Option<Summary>>, Vec<usize>) = parts.unzip();
        let summaries = summaries.into_iter().flatten();
        (Summary::of_all(summaries), low.into_iter().sum())
    }

    /// All tetrahedra of low quality, with how bad they are, by id.
    pub(crate) fn all_low(&self) -> impl Iterator<Item = (TetId, f64)> {
        let all = (0..self.slots()).map(TetId::new);
        let low = all.filter(|&t| self.is_low(t));
        low.map(|t| (t, self.badness(t)))
    }

    /// Whether the ratio of a tetrahedron makes it one of low quality.
    pub(crate) fn is_skinny(&self, t: TetId) -> bool {
        self.is_low_ratio(self.quality(t).squared_ratio)
    }

    /// Whether a squared ratio is one of low quality.
    pub(crate) fn is_low_ratio(&self, squared_ratio: f64) -> bool {
        squared_ratio > self.bound * self.bound
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
fn squared_ratio(corners: [DVec3; 4]) -> f64 {
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
