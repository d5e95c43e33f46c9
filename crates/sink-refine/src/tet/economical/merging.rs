//! Two inserted vertices become one.
//!
//! A [forecast](Forecaster) tells where the one should be, and which tetrahedra there would be. It is done when there are fewer
//! of them then, no more of low quality, and none that comes is too large.
//!
//! It ends because no pair is tried twice. Near a vertex that has come in the place of two there are new pairs.

use super::super::refiner::Refiner;
use super::forecast::Forecaster;
use crate::stop::Stop;
use delaunay_core::VertexId;
use rustc_hash::FxHashSet;
use std::collections::BTreeSet;

/// Nearest neighbours that a vertex is merged with, at most.
const PARTNERS: usize = 3;

/// Merges vertices from number `given` on.
pub(super) fn run(refiner: &mut Refiner<'_>, given: usize) -> Result<(), Stop> {
    let mut forecaster = Forecaster::default();
    let ended = merge_all(refiner, given, &mut forecaster);
    refiner.counters.tested += forecaster.tested();
    ended
}

fn merge_all(
    refiner: &mut Refiner<'_>,
    given: usize,
    forecaster: &mut Forecaster,
) -> Result<(), Stop> {
    let all = (given..refiner.solid.points().len()).map(VertexId::new);
    let mut waiting: BTreeSet<VertexId> = all.collect();
    let mut tried: FxHashSet<[VertexId; 2]> = FxHashSet::default();
    while let Some(vertex) = waiting.pop_first() {
        refiner.pause()?;
        for partner in partners(refiner, vertex, given) {
            let pair = [vertex, partner];
            if !tried.insert([vertex.min(partner), vertex.max(partner)]) {
                continue;
            }
            let best = forecaster.best(&refiner.solid, &refiner.records, pair);
            if let Some(merge) = best
                && refiner.merge(pair, merge)?
            {
                let around = merge.made.iter().flatten();
                waiting.extend(around.filter(|v| v.index() >= given));
                break;
            }
        }
    }
    Ok(())
}

/// The nearest of the inserted neighbours of a vertex, nearest first.
fn partners(refiner: &Refiner<'_>, vertex: VertexId, given: usize) -> Vec<VertexId> {
    let solid = &refiner.solid;
    let corners = solid.mesh().star(vertex);
    let corners = corners.flat_map(|t| solid.mesh().tet_vertices(t));
    let inserted = |v: &VertexId| !v.is_ghost() && v.index() >= given;
    let mut partners: Vec<VertexId> = corners.filter(|v| *v != vertex && inserted(v)).collect();
    let distance = |v: &VertexId| solid.point(*v).distance_squared(solid.point(vertex));
    partners.sort_unstable_by(|u, v| distance(u).total_cmp(&distance(v)).then(u.cmp(v)));
    partners.dedup();
    partners.truncate(PARTNERS);
    partners
}
