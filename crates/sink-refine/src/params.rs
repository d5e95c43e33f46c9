//! What a refinement is asked for.

/// What a refinement is asked for. [`Params::default`] is the economical method with the ratio 2.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Params {
    /// Elements whose ratio r/l, circumradius over shortest edge, is larger are of low quality (ρ0 in §4.3): at least 1.
    ///
    /// In the plane 1 means angles of 30° at least. In space 2 is usual; slivers may have small ratios.
    pub ratio: f64,
    /// How points are chosen.
    pub method: Method,
    /// The most vertices that may be added.
    pub max_new_vertices: usize,
}

impl Default for Params {
    fn default() -> Self {
        Self {
            ratio: 2.0,
            method: Method::Economical(Coarsening::Removal),
            max_new_vertices: usize::MAX,
        }
    }
}

/// How points are chosen.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Method {
    /// As in the paper. What the boundary test rejects stays of low quality.
    Paper {
        /// Which point to insert.
        candidate: Candidate,
        /// In which order.
        schedule: Schedule,
    },
    /// Fewer points: for each element the best of several candidates; then other points where all were rejected.
    Economical(Coarsening),
}

/// Which point to insert for an element of low quality.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Candidate {
    /// The sinks of the element (§3.2): the paper's method.
    Sink,
    /// The circumcenter of the element: what the paper compares with.
    Circumcenter,
}

/// In which order points are inserted (§4.5).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Schedule {
    /// One element after the other, the worst first.
    Incremental,
    /// In blocks of points whose spheres are mutually orthogonal or farther apart.
    Block,
    /// In rounds of points with disjoint closed prestars, on all threads.
    Parallel,
}

/// What happens to inserted vertices that are not needed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Coarsening {
    /// They stay.
    None,
    /// They are removed one by one.
    Removal,
    /// Two at a time also become one: some tenth fewer elements for several times the time.
    Merging,
}
