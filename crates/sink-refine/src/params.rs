//! What a refinement is asked for.

use crate::boundary::PARTS;
use crate::error::RefineError;

/// What a refinement is asked for. [`Params::default`] is the economical method with the ratio 2.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Params {
    /// Elements whose ratio r/l, circumradius over shortest edge, is larger are of low quality (ρ0 in §4.3): at least 1.
    ///
    /// In the plane 1 means angles of 30° at least. In space 2 is usual; slivers may have small ratios.
    pub ratio: f64,
    /// How points are chosen.
    pub method: Method,
    /// What may happen to the boundary.
    pub boundary: Boundary,
    /// The most vertices that may be added.
    pub max_new_vertices: usize,
}

impl Default for Params {
    fn default() -> Self {
        Self {
            ratio: 2.0,
            method: Method::Economical(Coarsening::Removal),
            boundary: Boundary::Keep,
            max_new_vertices: usize::MAX,
        }
    }
}

impl Params {
    /// Whether they can be met.
    ///
    /// # Errors
    /// The first number that makes no sense.
    pub(crate) fn check(&self) -> Result<(), RefineError> {
        let ratio = self.ratio;
        if !(1.0..f64::INFINITY).contains(&ratio) {
            return Err(RefineError::Ratio { ratio });
        }
        match self.boundary {
            Boundary::Split { crease } if !(0.0..=180.0).contains(&crease) => {
                Err(RefineError::Crease { crease })
            }
            _ => Ok(()),
        }
    }
}

/// What may happen to the boundary.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Boundary {
    /// Nothing: no segment and no triangle of it is touched, as in the paper. What it is in the way of stays of low quality.
    Keep,
    /// After the method has done what it can, segments and triangles of the boundary that are in the way are divided.
    ///
    /// Then nothing of low quality is left, unless parts of the boundary meet at small angles or come very near to each other:
    /// no vertex is put nearer to others than an eighth of the shortest boundary edge given there, or of the circumradius that a
    /// smaller size allows.
    ///
    /// With ratios from 2 on in space, √2 in the plane, few vertices are enough (Ruppert 1995, Shewchuk 1998). With smaller
    /// ones divided edges may call for ever shorter ones, down to that eighth all over the domain: give a budget of vertices
    /// then.
    Split {
        /// The largest angle in degrees, from 0 to 180, by which a smooth boundary turns from one segment or triangle to the next.
        ///
        /// New vertices are put on a smooth curve or surface through the vertices given. Where the boundary turns by more it has a
        /// corner or a crease, which stays. With 0 new vertices are on the segments and in the planes of the triangles given, up to
        /// rounding, so the domain stays the same; turns of a billionth count as none.
        crease: f64,
    },
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
    /// Two at a time also become one: some tenth fewer elements for up to twice the time.
    Merging,
}

impl Boundary {
    /// How near the vertices of a refined mesh may be to each other when the shortest edge given has the length `given`.
    pub(crate) fn least_separation(self, given: f64) -> f64 {
        match self {
            Self::Keep => given,
            Self::Split { .. } => given / PARTS,
        }
    }
}
