//! Inserted vertices that are not needed go.
//!
//! A vertex may go when its neighbours fill its place with no more tetrahedra, no more of them of low quality, and none
//! that is too large.

use super::super::refiner::Refiner;
use super::gain::Gain;
use crate::stop::Stop;
use delaunay_core::{Patch, VertexId};
use std::collections::BTreeSet;

/// Removes vertices from number `given` on.
pub(super) fn run(refiner: &mut Refiner<'_>, given: usize) -> Result<(), Stop> {
    let all = (given..refiner.solid.points().len()).map(VertexId::new);
    let mut waiting: BTreeSet<VertexId> = all.collect();
    while let Some(vertex) = waiting.pop_last() {
        refiner.pause()?;
        let Some(patch) = patch(refiner, vertex) else {
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

/// What would come in the place of a vertex; `None` as soon as more tetrahedra are of low quality than before.
fn patch(refiner: &Refiner<'_>, vertex: VertexId) -> Option<Patch> {
    let (solid, records) = (&refiner.solid, &refiner.records);
    let home = solid.mesh().home(vertex)?;
    let star = solid.mesh().star(vertex);
    let low_before = star.filter(|&t| records.is_low(t)).count();
    let mut low = 0;
    solid.patch_within(vertex, |corners| {
        let quality = records.measure(corners.map(|v| solid.point(v)), &[home]);
        low += usize::from(quality.is_low(records.bound()));
        low <= low_before
    })
}
