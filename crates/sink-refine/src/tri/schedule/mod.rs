//! In which order points are inserted (§4.5).

mod block;
mod incremental;
mod parallel;

use super::refiner::Refiner;
use crate::params::{Candidate, Schedule};
use crate::stop::Stop;

/// Inserts candidates until none is left that passes the tests.
///
/// # Errors
/// Why it ended earlier.
pub(crate) fn run(
    refiner: &mut Refiner<'_>,
    candidate: Candidate,
    schedule: Schedule,
) -> Result<(), Stop> {
    match schedule {
        Schedule::Incremental => incremental::run(refiner, candidate),
        Schedule::Block => block::run(refiner, candidate),
        Schedule::Parallel => parallel::run(refiner, candidate),
    }
}
