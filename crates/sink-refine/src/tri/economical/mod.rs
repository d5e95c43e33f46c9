//! Fewer points than the paper needs, beyond it: an off-center for each triangle, or another point where it is rejected;
//! then what is left is cured, and vertices that are not needed go.
//!
//! The phases run once, in this order. [Insertion](cascade) ends because points keep the minimum separation;
//! [curing](leftovers) because the number of low triangles falls with each point, or dividing the [boundary]; [removal] and
//! [merging] because the number of vertices does.

mod cascade;
mod gain;
mod leftovers;
mod merging;
mod off_center;
mod removal;

use super::boundary;
use super::refiner::{Refiner, Urgency};
use crate::params::{Boundary, Coarsening};
use crate::stop::Stop;

/// Improves the mesh with few points.
///
/// # Errors
/// Why it ended before all phases were through.
pub(crate) fn run(
    refiner: &mut Refiner<'_>,
    coarsening: Coarsening,
    at: Boundary,
) -> Result<(), Stop> {
    let given = refiner.region.points().len();
    refiner.reorder(Urgency::ShortestEdge);
    cascade::run(refiner)?;
    if at == Boundary::Keep {
        leftovers::run(refiner)?;
    }
    boundary::run(refiner, at)?;
    if coarsening >= Coarsening::Removal {
        removal::run(refiner, given)?;
    }
    if coarsening >= Coarsening::Merging {
        merging::run(refiner, given)?;
        removal::run(refiner, given)?;
    }
    Ok(())
}
