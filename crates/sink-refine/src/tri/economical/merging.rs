//! Two inserted vertices become one.
//!
//! Both are removed, and the best point for the triangles of low quality that appear is inserted, or one on the way between
//! the two. It is kept when no more triangles are of low quality than before, nor worse ones, and
//! none that comes is too large; there are two less then. Else the two come back, and with them, because the triangulation is
//! unique, the triangles that were there.

use super::super::flow::sink_triangle;
use super::super::proposal::Proposal;
use super::super::refiner::Refiner;
use super::super::sinks::sink;
use super::cascade::SHARE;
use super::gain::Gain;
use super::off_center::OffCenters;
use crate::stop::Stop;
use delaunay_core::measure::triangle::circumcenter;
use delaunay_core::{FaceId, VertexId};
use glam::DVec2;
use std::collections::BTreeSet;

/// Nearest neighbours that a vertex is merged with, at most.
const PARTNERS: usize = 4;

/// Triangles of low quality whose candidates are tried, at most.
const CASES: usize = 6;

/// Merges vertices from number `given` on.
pub(super) fn run(refiner: &mut Refiner<'_>, given: usize) -> Result<(), Stop> {
    let all = (given..refiner.region.points().len()).map(VertexId::new);
    let mut waiting: BTreeSet<VertexId> = all.collect();
    let mut merger = Merger::default();
    while let Some(vertex) = waiting.pop_last() {
        for partner in partners(refiner, vertex, given) {
            if merger.merge(refiner, vertex, partner)? {
                let star = merger.best.prestar.faces().iter();
                let around = star.flat_map(|&f| refiner.region.mesh().face_vertices(f));
                waiting.extend(around.filter(|v| v.index() >= given));
                break;
            }
        }
    }
    Ok(())
}

/// The nearest of the inserted neighbours of a vertex, nearest first.
fn partners(refiner: &Refiner<'_>, vertex: VertexId, given: usize) -> Vec<VertexId> {
    let region = &refiner.region;
    let neighbors = region.mesh().neighbors(vertex);
    let mut partners: Vec<VertexId> = neighbors
        .filter(|v| !v.is_ghost() && v.index() >= given)
        .collect();
    let distance = |v: &VertexId| region.point(*v).distance_squared(region.point(vertex));
    partners.sort_by(|u, v| distance(u).total_cmp(&distance(v)).then(u.cmp(v)));
    partners.truncate(PARTNERS);
    partners
}

/// Room for merging.
#[derive(Default)]
struct Merger {
    /// The triangles in the place of the two vertices.
    made: Vec<FaceId>,
    candidates: Vec<(DVec2, FaceId)>,
    best: Proposal,
    best_gain: Option<Gain>,
}

impl Merger {
    /// Merges two vertices if that pays; tells whether it did.
    fn merge(&mut self, refiner: &mut Refiner<'_>, u: VertexId, v: VertexId) -> Result<bool, Stop> {
        let points = [u, v].map(|vertex| refiner.region.point(vertex));
        self.made.clear();
        let Some(first) = self.remove(refiner, u)? else {
            return Ok(false);
        };
        let Some(second) = self.remove(refiner, v)? else {
            self.restore(refiner, points[0])?;
            return Ok(false);
        };
        self.find_best(refiner, points, first + second);
        if self.best_gain.is_some() {
            refiner.insert(&mut self.best)?;
            return Ok(true);
        }
        self.restore(refiner, points[1])?;
        self.restore(refiner, points[0])?;
        Ok(false)
    }

    fn remove(
        &mut self,
        refiner: &mut Refiner<'_>,
        vertex: VertexId,
    ) -> Result<Option<Gain>, Stop> {
        let Some(patch) = refiner.region.patch(vertex) else {
            return Ok(None);
        };
        let gain = Gain::of_removal(&refiner.region, &refiner.records, &patch);
        let refilled = refiner.remove(&patch)?;
        self.made.retain(|f| !patch.star().contains(f));
        for (old, new) in refilled.moved {
            let moved = self.made.iter_mut().filter(|f| **f == old);
            moved.for_each(|f| *f = new);
        }
        self.made.extend(refilled.made);
        Ok(Some(gain))
    }

    /// Inserts a vertex again.
    fn restore(&mut self, refiner: &mut Refiner<'_>, point: DVec2) -> Result<(), Stop> {
        let seed = self.seed(refiner, point);
        if seed.is_some_and(|seed| refiner.propose_anywhere(point, seed).is_ok()) {
            refiner.insert_proposed()?;
            let star = refiner.proposal.prestar.faces();
            let gone = |f: &FaceId| !refiner.records.is_there(*f) || star.contains(f);
            self.made.retain(|f| !gone(f));
            self.made.extend_from_slice(star);
        } else {
            debug_assert!(false, "a vertex just removed can be inserted");
        }
        Ok(())
    }

    /// A triangle in the place of the two vertices in conflict with a point.
    fn seed(&self, refiner: &Refiner<'_>, point: DVec2) -> Option<FaceId> {
        let mut made = self.made.iter().copied();
        made.find(|&f| refiner.region.in_conflict(point, f))
    }

    /// Finds the best point to insert in the place of two, if one is worth it; `removed` is what their removal did.
    fn find_best(&mut self, refiner: &mut Refiner<'_>, [p, q]: [DVec2; 2], removed: Gain) {
        self.best_gain = None;
        self.candidates.clear();
        for share in [0.5, 0.3, 0.7] {
            let point = p.lerp(q, share);
            let seed = self.seed(refiner, point);
            self.candidates.extend(seed.map(|seed| (point, seed)));
        }
        self.add_candidates_of_low(refiner);
        for &(point, seed) in &self.candidates {
            if refiner.propose(point, seed, 0.0).is_ok() {
                let inserted = Gain::of(&refiner.region, &refiner.records, &refiner.proposal);
                let gain = removed + inserted;
                if gain.is_harmless() && self.best_gain.is_none_or(|best| gain.is_better(&best)) {
                    self.best_gain = Some(gain);
                    std::mem::swap(&mut self.best, &mut refiner.proposal);
                }
            }
        }
    }

    /// Sinks, circumcenters and off-centers of the worst triangles in the place of the two vertices.
    fn add_candidates_of_low(&mut self, refiner: &Refiner<'_>) {
        let (region, records) = (&refiner.region, &refiner.records);
        let mut low: Vec<FaceId> = self.made.clone();
        low.retain(|&f| records.is_low(f));
        let badness = |f: &FaceId| records.badness(*f);
        low.sort_by(|f, g| badness(g).total_cmp(&badness(f)).then(f.cmp(g)));
        for &f in low.iter().take(CASES) {
            let end = sink_triangle(region.mesh(), f, |f| records.exit(f));
            self.candidates.extend(end.map(|s| (sink(region, s), s)));
            let corners = region.triangle(f);
            let off = OffCenters::of_triangle(refiner, f).at(SHARE, records.bound());
            self.candidates
                .extend([circumcenter(corners), off].map(|p| (p, f)));
        }
    }
}
