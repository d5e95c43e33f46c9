//! Two inserted vertices become one.
//!
//! Both are removed, and the best point for the tetrahedra of low quality that appear is inserted, or one on the way between
//! the two. It is kept when there are fewer tetrahedra than before, no more of them of low quality, and none that
//! comes is too large; else the two come back, and with them, because the triangulation is unique, the tetrahedra that were there.

use super::super::flow::{FlowWalk, sink};
use super::super::proposal::Proposal;
use super::super::refiner::Refiner;
use super::gain::Gain;
use super::off_center::OffCenters;
use crate::stop::Stop;
use delaunay_core::measure::tetrahedron::circumcenter;
use delaunay_core::{TetId, VertexId};
use glam::DVec3;
use rustc_hash::FxHashMap;
use std::collections::BTreeSet;

/// Nearest neighbours that a vertex is merged with, at most.
const PARTNERS: usize = 6;

/// Tetrahedra of low quality whose candidates are tried, at most.
const CASES: usize = 3;

/// Merges vertices from number `given` on.
pub(super) fn run(refiner: &mut Refiner<'_>, given: usize) -> Result<(), Stop> {
    let all = (given..refiner.solid.points().len()).map(VertexId::new);
    let mut waiting: BTreeSet<VertexId> = all.collect();
    let mut merger = Merger::default();
    let mut tried = Tried::default();
    while let Some(vertex) = waiting.pop_first() {
        for partner in partners(refiner, vertex, given) {
            if !tried.is_new(vertex, partner) {
                continue;
            }
            if merger.merge(refiner, vertex, partner)? {
                let star = merger.best.prestar.tets().iter();
                let around = star.flat_map(|&t| refiner.solid.mesh().tet_vertices(t));
                let around = around.filter(|v| v.index() >= given);
                waiting.extend(around.inspect(|&v| tried.note_change(v)));
                break;
            }
        }
    }
    Ok(())
}

/// Pairs that have been tried in vain since the mesh round one of them has changed last.
#[derive(Default)]
struct Tried {
    changes: FxHashMap<VertexId, u32>,
    pairs: FxHashMap<[VertexId; 2], [u32; 2]>,
}

impl Tried {
    /// Whether the pair has not been tried since the last change; it has now.
    fn is_new(&mut self, u: VertexId, v: VertexId) -> bool {
        let pair = [u.min(v), u.max(v)];
        let changes = pair.map(|v| self.changes.get(&v).copied().unwrap_or(0));
        self.pairs.insert(pair, changes) != Some(changes)
    }

    fn note_change(&mut self, v: VertexId) {
        *self.changes.entry(v).or_insert(0) += 1;
    }
}

/// The nearest of the inserted neighbours of a vertex, nearest first.
fn partners(refiner: &Refiner<'_>, vertex: VertexId, given: usize) -> Vec<VertexId> {
    let solid = &refiner.solid;
    let neighbors = solid.mesh().neighbors(vertex);
    let mut partners: Vec<VertexId> = neighbors
        .filter(|v| !v.is_ghost() && v.index() >= given)
        .collect();
    let distance = |v: &VertexId| solid.point(*v).distance_squared(solid.point(vertex));
    partners.sort_by(|u, v| distance(u).total_cmp(&distance(v)).then(u.cmp(v)));
    partners.truncate(PARTNERS);
    partners
}

/// Room for merging.
#[derive(Default)]
struct Merger {
    walk: FlowWalk,
    /// The tetrahedra in the place of the two vertices.
    made: Vec<TetId>,
    candidates: Vec<(DVec3, TetId)>,
    best: Proposal,
    best_gain: Gain,
}

impl Merger {
    /// Merges two vertices if that pays; tells whether it did.
    fn merge(&mut self, refiner: &mut Refiner<'_>, u: VertexId, v: VertexId) -> Result<bool, Stop> {
        let points = [u, v].map(|vertex| refiner.solid.point(vertex));
        self.made.clear();
        let Some(first) = self.remove(refiner, u)? else {
            return Ok(false);
        };
        let Some(second) = self.remove(refiner, v)? else {
            self.restore(refiner, points[0])?;
            return Ok(false);
        };
        self.find_best(refiner, points, first + second);
        if self.best_gain.tets < 0 {
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
        let Some(patch) = refiner.solid.patch(vertex) else {
            return Ok(None);
        };
        let gain = Gain::of_removal(&refiner.solid, &refiner.records, &patch);
        let Some(tets) = refiner.remove(&patch)? else {
            return Ok(None);
        };
        self.made.retain(|t| !patch.star().contains(t));
        self.made.extend(tets);
        Ok(Some(gain))
    }

    /// Inserts a vertex again.
    fn restore(&mut self, refiner: &mut Refiner<'_>, point: DVec3) -> Result<(), Stop> {
        let seed = self.seed(refiner, point);
        if seed.is_some_and(|seed| refiner.propose_anywhere(point, seed).is_ok()) {
            refiner.insert_proposed()?;
            let star = refiner.proposal.prestar.tets();
            let gone = |t: &TetId| !refiner.records.is_there(*t) || star.contains(t);
            self.made.retain(|t| !gone(t));
            self.made.extend_from_slice(star);
        } else {
            debug_assert!(false, "a vertex just removed can be inserted");
        }
        Ok(())
    }

    /// A tetrahedron in the place of the two vertices in conflict with a point.
    fn seed(&self, refiner: &Refiner<'_>, point: DVec3) -> Option<TetId> {
        let mut made = self.made.iter().copied();
        made.find(|&t| refiner.solid.in_conflict(point, t))
    }

    /// Finds the best point to insert in the place of two, if one is worth it; `removed` is what their removal did.
    fn find_best(&mut self, refiner: &mut Refiner<'_>, [p, q]: [DVec3; 2], removed: Gain) {
        self.best_gain = Gain::default();
        self.candidates.clear();
        for share in [0.5, 0.3, 0.7] {
            let point = p.lerp(q, share);
            let seed = self.seed(refiner, point);
            self.candidates.extend(seed.map(|seed| (point, seed)));
        }
        self.add_candidates_of_low(refiner);
        for &(point, seed) in &self.candidates {
            if refiner.propose(point, seed, 0.0).is_ok() {
                let inserted = Gain::of(&refiner.solid, &refiner.records, &refiner.proposal);
                let gain = removed + inserted;
                if gain.is_harmless() && gain.tets < self.best_gain.tets {
                    self.best_gain = gain;
                    std::mem::swap(&mut self.best, &mut refiner.proposal);
                }
            }
        }
    }

    /// Sinks, circumcenters and off-centers of the worst tetrahedra in the place of the two vertices.
    fn add_candidates_of_low(&mut self, refiner: &Refiner<'_>) {
        let (solid, records) = (&refiner.solid, &refiner.records);
        let mut low: Vec<TetId> = self.made.clone();
        low.retain(|&t| records.is_low(t));
        let badness = |t: &TetId| records.badness(*t);
        low.sort_by(|s, t| badness(t).total_cmp(&badness(s)).then(s.cmp(t)));
        for &t in low.iter().take(CASES) {
            let corners = solid.tetrahedron(t);
            let sinks = self.walk.follow(solid, t, |t| records.flow(t)).iter();
            self.candidates.extend(sinks.map(|&s| (sink(solid, s), s)));
            let off = OffCenters::of_tetrahedron(refiner, t);
            self.candidates
                .extend([circumcenter(corners), off.at(0.6, records.bound())].map(|p| (p, t)));
        }
    }
}
