//! Inserted vertices that are not needed go.
//!
//! A vertex may go when no more triangles of low quality fill its place, nor worse ones, nor any that is too
//! large. It takes two triangles with it.

use super::super::refiner::Refiner;
use super::gain::Gain;
use crate::stop::Stop;
use delaunay_core::VertexId;
use std::collections::BTreeSet;

/// Removes vertices from number `given` on.
pub(super) fn run(refiner: &mut Refiner<'_>, given: usize) -> Result<(), Stop> {
    let all = (given..refiner.region.points().len()).map(VertexId::new);
    let mut waiting: BTreeSet<VertexId> = all.collect();
    while let Some(vertex) = waiting.pop_last() {
        refiner.pause()?;
        let Some(patch) = refiner.region.patch(vertex) else {
            continue;
        };
        let gain = Gain::of_removal(&refiner.region, &refiner.records, &patch);
        if gain.is_harmless() {
            refiner.remove(&patch)?;
            let around = patch.made().iter().flatten();
            waiting.extend(around.filter(|v| v.index() >= given));
        }
    }
    Ok(())
}
