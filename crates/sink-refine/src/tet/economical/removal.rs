//! Inserted vertices that are not needed go.
//!
//! A vertex may go when its neighbours fill its place with no more tetrahedra, no more of them of low quality, and none
//! that is too large.

use super::super::refiner::Refiner;
use super::gain::Gain;
use crate::stop::Stop;
use delaunay_core::VertexId;
use std::collections::BTreeSet;

/// Removes vertices from number `given` on.
pub(super) fn run(refiner: &mut Refiner<'_>, given: usize) -> Result<(), Stop> {
    let all = (given..refiner.solid.points().len()).map(VertexId::new);
    let mut waiting: BTreeSet<VertexId> = all.collect();
    while let Some(vertex) = waiting.pop_last() {
        let Some(patch) = refiner.solid.patch(vertex) else {
            continue;
        };
        let gain = Gain::of_removal(&refiner.solid, &refiner.records, &patch);
        if gain.is_harmless() && gain.tets <= 0 && refiner.remove(&patch)?.is_some() {
            let around = patch.made().iter().flatten();
            waiting.extend(around.filter(|v| v.index() >= given));
        }
    }
    Ok(())
}
