//! What bounds a region of the plane: closed curves of segments, validated.
//!
//! ```text
//!    two segments at a vertex       four, where two parts touch
//!
//!          ____                        \ region /
//!         /    outside                  \      /
//!  region \                      outside ·      outside
//!          \____                        /      \
//!                                      / region \
//! ```
//!
//! The outline is closed when every vertex has an even number of segments. A path from infinity that avoids the vertices
//! then crosses it as often, odd or even, as any other path to the same place, which says whether that place is inside.
//! The way a segment runs is not asked.

use super::delaunay::Delaunay2;
use crate::ids::VertexId;
use geo_predicates::{CoordinateError, check_points2};
use glam::DVec2;
use std::cmp::Ordering;
use thiserror::Error;

/// Closed curves of segments in the plane, the boundary of a region.
///
/// The region may have several parts and holes, and parts may touch at a vertex. Whether segments cross is not known here
/// but to [`region`](Self::region).
///
/// ```
/// use delaunay_core::{BuildOptions, Outline, VertexId, progress::silent};
/// use glam::DVec2;
///
/// let corners = vec![DVec2::ZERO, DVec2::X, DVec2::Y];
/// let segments = [[0, 1], [1, 2], [2, 0]].map(|segment| segment.map(VertexId::new));
/// let outline = Outline::new(corners.clone(), segments.to_vec())?;
/// let region = outline.region(BuildOptions::default(), &mut silent)?;
/// assert_eq!(region.faces().count(), 1);
///
/// let open = Outline::new(corners, segments[1..].to_vec());
/// assert!(open.unwrap_err().to_string().starts_with("the outline is not closed"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Outline {
    points: Vec<DVec2>,
    segments: Vec<[VertexId; 2]>,
    /// Points that are no ends, by id.
    interior: Vec<VertexId>,
}

/// Why points and segments are no closed outline.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum OutlineError {
    /// A coordinate is not accepted.
    #[error(transparent)]
    Coordinate(#[from] CoordinateError),
    /// There are more points than a triangulation can hold.
    #[error("{count} points are more than the {limit} that a triangulation can hold")]
    TooManyPoints {
        /// Points given.
        count: usize,
        /// Points possible.
        limit: usize,
    },
    /// There are no segments.
    #[error("the outline has no segments")]
    Empty,
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
    /// A segment runs from a vertex to the same vertex.
    #[error("segment {segment} runs from {vertex} to itself")]
    RepeatedEnd {
        /// Index of the segment.
        segment: usize,
        /// The vertex in question.
        vertex: VertexId,
    },
    /// A point is the end of no segment.
    #[error("{vertex} is the end of no segment")]
    UnusedVertex {
        /// The vertex in question.
        vertex: VertexId,
    },
    /// Two vertices are at one place.
    #[error("{first} and {second} are at one place")]
    CoincidentVertices {
        /// The vertex with the smaller index.
        first: VertexId,
        /// The other.
        second: VertexId,
    },
    /// Two segments have the same ends.
    #[error("segments {first} and {second} have the same ends")]
    RepeatedSegment {
        /// The smaller index.
        first: usize,
        /// The other.
        second: usize,
    },
    /// A vertex has an odd number of segments.
    #[error("the outline is not closed: {}", open_text(*.vertex, *.segment, *.segments, *.open_vertices))]
    Open {
        /// The first such vertex.
        vertex: VertexId,
        /// The first segment at it.
        segment: usize,
        /// How many segments end there.
        segments: usize,
        /// How many such vertices there are.
        open_vertices: usize,
    },
}

impl Outline {
    /// The outline that the segments form.
    ///
    /// Segment ends count the points from 0, in either order. Time n log n.
    ///
    /// # Errors
    /// The first of these defects, by the element that has it: a coordinate that is not accepted, more points than
    /// [`Delaunay2::MAX_POINTS`], no segments, an end that is no point, a segment from a vertex to itself, two points
    /// at one place, a segment given twice, a vertex with an odd number of segments, a point that is no end.
    pub fn new(points: Vec<DVec2>, segments: Vec<[VertexId; 2]>) -> Result<Self, OutlineError> {
        let outline = Self::with_interior(points, segments)?;
        match outline.interior.first() {
            Some(&vertex) => Err(OutlineError::UnusedVertex { vertex }),
            None => Ok(outline),
        }
    }

    /// The outline that the segments form, and points that are to be strictly inside: those that are no ends.
    ///
    /// The points inside are vertices of [`region`](Self::region), which finds out whether they are there.
    ///
    /// # Errors
    /// As [`new`](Self::new), but that a point may be no end.
    pub fn with_interior(
        points: Vec<DVec2>,
        segments: Vec<[VertexId; 2]>,
    ) -> Result<Self, OutlineError> {
        check_points2(&points)?;
        check_counts(points.len(), segments.len())?;
        check_ends(points.len(), &segments)?;
        let degrees = degrees(points.len(), &segments);
        check_places(&points)?;
        check_repetition(&segments)?;
        check_closed(&degrees, &segments)?;
        let unused = (0..points.len()).filter(|&index| degrees[index] == 0);
        let interior = unused.map(VertexId::new).collect();
        Ok(Self {
            points,
            segments,
            interior,
        })
    }

    /// The points that are to be inside, by id: none but after [`with_interior`](Self::with_interior).
    #[must_use]
    pub fn interior(&self) -> &[VertexId] {
        &self.interior
    }

    /// The points, by vertex index.
    #[must_use]
    pub fn points(&self) -> &[DVec2] {
        &self.points
    }

    /// The ends of the segments, as they were given.
    #[must_use]
    pub fn segments(&self) -> &[[VertexId; 2]] {
        &self.segments
    }
}

fn check_counts(points: usize, segments: usize) -> Result<(), OutlineError> {
    if points > Delaunay2::MAX_POINTS {
        let (count, limit) = (points, Delaunay2::MAX_POINTS);
        return Err(OutlineError::TooManyPoints { count, limit });
    }
    if segments == 0 {
        return Err(OutlineError::Empty);
    }
    Ok(())
}

/// Ends are points, two different ones.
fn check_ends(points: usize, segments: &[[VertexId; 2]]) -> Result<(), OutlineError> {
    for (segment, &[a, b]) in segments.iter().enumerate() {
        // The ghost has an index beyond all.
        if let Some(vertex) = [a, b].into_iter().find(|v| v.index() >= points) {
            return Err(OutlineError::NoSuchVertex {
                segment,
                vertex,
                points,
            });
        }
        if a == b {
            return Err(OutlineError::RepeatedEnd { segment, vertex: a });
        }
    }
    Ok(())
}

/// By vertex, how many segments end there.
fn degrees(points: usize, segments: &[[VertexId; 2]]) -> Vec<usize> {
    let mut degrees = vec![0; points];
    for v in segments.as_flattened() {
        degrees[v.index()] += 1;
    }
    degrees
}

/// No two points are at one place.
fn check_places(points: &[DVec2]) -> Result<(), OutlineError> {
    // Coordinates are numbers, so any two can be compared, and -0.0 equals 0.0.
    let by_place = |v: &VertexId, w: &VertexId| {
        let [p, q] = [v, w].map(|v| points[v.index()].to_array());
        p.partial_cmp(&q).unwrap_or(Ordering::Equal)
    };
    let mut vertices: Vec<VertexId> = (0..points.len()).map(VertexId::new).collect();
    vertices.sort_by(by_place);
    let pairs = vertices.windows(2).map(|pair| (pair[0], pair[1]));
    match pairs.filter(|(v, w)| by_place(v, w).is_eq()).min() {
        Some((first, second)) => Err(OutlineError::CoincidentVertices { first, second }),
        None => Ok(()),
    }
}

/// No two segments have the same ends.
fn check_repetition(segments: &[[VertexId; 2]]) -> Result<(), OutlineError> {
    let indexed = segments.iter().enumerate();
    let mut ends: Vec<_> = indexed.map(|(i, &ends)| (sorted(ends), i)).collect();
    ends.sort_unstable();
    let repeated = ends.windows(2).filter(|pair| pair[0].0 == pair[1].0);
    match repeated.map(|pair| (pair[0].1, pair[1].1)).min() {
        Some((first, second)) => Err(OutlineError::RepeatedSegment { first, second }),
        None => Ok(()),
    }
}

/// Every vertex has an even number of segments.
fn check_closed(degrees: &[usize], segments: &[[VertexId; 2]]) -> Result<(), OutlineError> {
    let odd = |&index: &usize| degrees[index] % 2 == 1;
    let mut open = (0..degrees.len()).filter(odd).map(VertexId::new);
    let Some(vertex) = open.next() else {
        return Ok(());
    };
    let at_vertex = segments.iter().position(|ends| ends.contains(&vertex));
    Err(OutlineError::Open {
        vertex,
        segment: at_vertex.unwrap_or(0),
        segments: degrees[vertex.index()],
        open_vertices: 1 + open.count(),
    })
}

/// Ends in the order of their ids: one name for a segment, whichever way it runs.
pub(super) fn sorted([a, b]: [VertexId; 2]) -> [VertexId; 2] {
    [a.min(b), a.max(b)]
}

fn open_text(vertex: VertexId, segment: usize, segments: usize, vertices: usize) -> String {
    let at_vertex = match segments {
        1 => format!("segment {segment} alone"),
        _ => format!("{segments} segments, segment {segment} the first"),
    };
    let vertices = match vertices {
        1 => "no other vertex has".to_owned(),
        2 => "1 other vertex has".to_owned(),
        _ => format!("{} other vertices have", vertices - 1),
    };
    format!("{vertex} has {at_vertex}, and {vertices} an odd number of segments")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ids(segments: &[[usize; 2]]) -> Vec<[VertexId; 2]> {
        let named = segments.iter().map(|ends| ends.map(VertexId::new));
        named.collect()
    }

    fn error(points: &[[f64; 2]], segments: &[[usize; 2]]) -> String {
        let points = points.iter().copied().map(DVec2::from).collect();
        let outline = Outline::new(points, ids(segments));
        outline.unwrap_err().to_string()
    }

    const CORNERS: [[f64; 2]; 3] = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
    const TRIANGLE: [[usize; 2]; 3] = [[0, 1], [1, 2], [2, 0]];

    #[test]
    fn segments_may_run_either_way() {
        let turned = [[1, 0], [1, 2], [0, 2]];
        let outline = Outline::new(CORNERS.map(DVec2::from).to_vec(), ids(&turned)).unwrap();
        assert_eq!(outline.points(), CORNERS.map(DVec2::from));
        assert_eq!(outline.segments(), ids(&turned));
    }

    #[test]
    fn defects_of_points_are_named() {
        let with = |more: [f64; 2]| [CORNERS.as_slice(), &[more]].concat();
        insta::assert_snapshot!(
            error(&with([0.0, f64::NAN]), &TRIANGLE),
            @"point 3 has y = NaN, which is neither zero nor of magnitude 2^-142 to 2^201 (about 1.8e-43 to 3.2e60)"
        );
        insta::assert_snapshot!(error(&with([1.0, 1.0]), &TRIANGLE), @"v3 is the end of no segment");
        let quadrangle = [[0, 1], [1, 2], [2, 3], [3, 0]];
        insta::assert_snapshot!(error(&with([1.0, -0.0]), &quadrangle), @"v1 and v3 are at one place");
    }

    #[test]
    fn defects_of_segments_are_named() {
        insta::assert_snapshot!(error(&[], &[]), @"the outline has no segments");
        insta::assert_snapshot!(error(&CORNERS, &[[0, 1], [1, 3]]), @"segment 1 ends at v3, but there are 3 points");
        insta::assert_snapshot!(error(&CORNERS, &[[0, 1], [1, 1]]), @"segment 1 runs from v1 to itself");
        let ghost = [VertexId::GHOST, VertexId::new(0)];
        let ghost = Outline::new(vec![DVec2::ZERO], vec![ghost]).unwrap_err();
        insta::assert_snapshot!(ghost, @"segment 0 ends at v∞, but there are 1 points");
        let repeated = [TRIANGLE.as_slice(), &[[0, 2]]].concat();
        insta::assert_snapshot!(error(&CORNERS, &repeated), @"segments 2 and 3 have the same ends");
    }

    #[test]
    fn an_open_outline_names_a_vertex() {
        insta::assert_snapshot!(error(&CORNERS, &TRIANGLE[..2]), @"the outline is not closed: v0 has segment 0 alone, and 1 other vertex has an odd number of segments");
        let tail = [TRIANGLE.as_slice(), &[[0, 3]]].concat();
        let points = [CORNERS.as_slice(), &[[-1.0, 0.0]]].concat();
        insta::assert_snapshot!(error(&points, &tail), @"the outline is not closed: v0 has 3 segments, segment 0 the first, and 1 other vertex has an odd number of segments");
    }
}
