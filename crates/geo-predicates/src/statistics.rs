//! Which stage decided: counters per predicate, behind the feature `statistics`.
//!
//! Without the feature nothing is counted and nothing is paid. With it every decision is one
//! relaxed atomic addition, so counts are exact whatever the number of threads.

#[cfg(feature = "statistics")]
use std::sync::atomic::{AtomicU64, Ordering};

/// What was asked.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[expect(missing_docs, reason = "the names are those of the functions")]
pub enum Predicate {
    Orient2d,
    Orient3d,
    InCircle,
    InSphere,
    InDiametralCircle,
    InDiametralSphere,
    InDiametralBall,
    PowerCircle,
    PowerSphere,
}

/// How it was answered.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Stage {
    /// A determinant in doubles, with a bound on its error.
    Filter,
    /// Integers of a few words, on a common grid.
    Grid,
    /// Expansions, or integers of any length: coordinates too far apart for one grid.
    Unbounded,
    /// A tie, broken by perturbation after one of the other stages found zero.
    Tie,
}

impl Predicate {
    /// All of them, in the order of the counters.
    pub const ALL: [Self; 9] = [
        Self::Orient2d,
        Self::Orient3d,
        Self::InCircle,
        Self::InSphere,
        Self::InDiametralCircle,
        Self::InDiametralSphere,
        Self::InDiametralBall,
        Self::PowerCircle,
        Self::PowerSphere,
    ];
}

impl Stage {
    /// All of them, in the order of the counters.
    pub const ALL: [Self; 4] = [Self::Filter, Self::Grid, Self::Unbounded, Self::Tie];
}

#[cfg(feature = "statistics")]
static COUNTS: [[AtomicU64; Stage::ALL.len()]; Predicate::ALL.len()] =
    [const { [const { AtomicU64::new(0) }; Stage::ALL.len()] }; Predicate::ALL.len()];

/// Number of decisions of `predicate` by `stage` since the start or the last [`reset`].
#[cfg(feature = "statistics")]
#[must_use]
pub fn count(predicate: Predicate, stage: Stage) -> u64 {
    COUNTS[predicate as usize][stage as usize].load(Ordering::Relaxed)
}

/// Sets all counters to zero.
#[cfg(feature = "statistics")]
pub fn reset() {
    COUNTS
        .as_flattened()
        .iter()
        .for_each(|count| count.store(0, Ordering::Relaxed));
}

/// Counts one decision.
#[inline(always)]
pub(crate) fn record(predicate: Predicate, stage: Stage) {
    #[cfg(feature = "statistics")]
    COUNTS[predicate as usize][stage as usize].fetch_add(1, Ordering::Relaxed);
    #[cfg(not(feature = "statistics"))]
    let _ = (predicate, stage);
}
