//! Fewer points than the paper needs, beyond it: several candidates for each tetrahedron, judged by what they would do;
//! then what is left is cured, and vertices that are not needed go.
//!
//! The phases run once, in this order. [Greedy insertion](greedy) ends because points keep the minimum separation;
//! [curing](leftovers) because the number of low tetrahedra falls with each point, or dividing the [boundary]; [removal] and
//! [merging] because the number of vertices does.

mod forecast;
mod gain;
mod greedy;
mod hole;
mod hole_cavity;
mod leftovers;
mod merging;
mod off_center;
mod removal;

use super::boundary;
use super::refiner::Refiner;
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
    let given = refiner.solid.points().len();
    greedy::run(refiner)?;
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
