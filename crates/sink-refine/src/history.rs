//! What a refinement did (§5): counts of work, and sizes and qualities round by round.

/// Counts of work done.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counters {
    /// Points whose prestar was searched and tested.
    pub tested: usize,
    /// Points that the boundary test rejected (§5.1).
    pub encroaching: usize,
    /// Points inserted, those on the boundary included.
    pub inserted: usize,
    /// Points inserted on the boundary.
    pub split: usize,
    /// Vertices removed.
    pub removed: usize,
}

/// The mesh before a round, and what the round did.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Round {
    /// Vertices, those of the boundary included.
    pub vertices: usize,
    /// Triangles or tetrahedra.
    pub elements: usize,
    /// Elements of low quality, those that are too large included.
    pub low: usize,
    /// Different candidates of those elements: their sinks, or circumcenters, also those that fail the boundary test.
    pub candidates: usize,
    /// Those of the candidates that pass the boundary test (§5.2): all of them in blocks in the plane. Else those that are tested,
    /// which are at least the points inserted; where there is no room for a candidate its prestar is not searched to the end.
    pub passed: usize,
    /// Points inserted: those of the block, or of the independent subset.
    pub inserted: usize,
    /// Smallest r/l of an element.
    pub min_ratio: f64,
    /// Mean of r/l.
    pub mean_ratio: f64,
    /// Largest r/l.
    pub max_ratio: f64,
}
