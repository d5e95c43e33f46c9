//! Why points and segments have no constrained triangulation.

use crate::error::BuildError;
use crate::ids::VertexId;
use crate::progress::Cancelled;
use glam::DVec2;
use thiserror::Error;

/// Two segments that have a point in common that is an end of neither.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crossing {
    /// The segments, the smaller number first.
    pub segments: [usize; 2],
    /// Where they meet, rounded.
    pub place: DVec2,
}

/// Why points and segments have no constrained triangulation.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum ConstrainError {
    /// The points have no triangulation, or the report closure stopped the work.
    #[error(transparent)]
    Build(#[from] BuildError),
    /// A segment names a vertex that is not there.
    #[error("segment {segment} ends at {vertex}, but there are {points} points")]
    NoSuchVertex {
        /// Index of the segment.
        segment: usize,
        /// The end in question.
        vertex: VertexId,
        /// Points given.
        points: usize,
    },
    /// The ends of a segment are one vertex, or two at one place.
    #[error("segment {segment} from {start} to {end} has no length")]
    NoLength {
        /// Index of the segment.
        segment: usize,
        /// Its first end.
        start: VertexId,
        /// Its second end.
        end: VertexId,
    },
    /// Segments cross, and that is refused.
    #[error("{}", crossings_text(.crossings))]
    Crossing {
        /// In order, at least one: for each segment that could not be laid, the first that was in its way from its first end on.
        crossings: Vec<Crossing>,
    },
    /// Two segments cross, and there is no place for a vertex there in rounded numbers.
    #[error("segments {first} and {second} cross where they are too close to be divided")]
    TooClose {
        /// The smaller index.
        first: usize,
        /// The other.
        second: usize,
    },
    /// Segments would have to be divided too often.
    #[error("segments cross in more than the {limit} places allowed")]
    TooManyDivisions {
        /// Divisions allowed.
        limit: usize,
    },
}

impl From<Cancelled> for ConstrainError {
    fn from(cancelled: Cancelled) -> Self {
        Self::Build(cancelled.into())
    }
}

fn crossings_text(crossings: &[Crossing]) -> String {
    let Some((first, rest)) = crossings.split_first() else {
        return "segments cross".to_owned();
    };
    let [s, t] = first.segments;
    let DVec2 { x, y } = first.place;
    let rest = match rest.len() {
        0 => String::new(),
        1 => "; there is 1 more crossing".to_owned(),
        more => format!("; there are {more} more crossings"),
    };
    format!("segments {s} and {t} cross near ({x}, {y}){rest}")
}
