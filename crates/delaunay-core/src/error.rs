//! Everything that can go wrong, by the element it goes wrong with.

use crate::ids::VertexId;
use crate::progress::Cancelled;
use crate::tri::{Extent, Flat};
use geo_predicates::{CoordinateError, WeightError};
use thiserror::Error;

/// Why there is no triangulation of the given points.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum BuildError {
    /// A coordinate is not accepted.
    #[error(transparent)]
    Coordinate(#[from] CoordinateError),
    /// There are more points than 32-bit ids can serve.
    #[error("{count} points are more than the {limit} that a triangulation can hold")]
    TooManyPoints {
        /// Points given.
        count: usize,
        /// Points possible.
        limit: usize,
    },
    /// There are more tetrahedra than 32-bit facet ids can serve, or than memory holds.
    #[error(
        "the points have more tetrahedra than fit: {tets} were made and there was no room for more"
    )]
    TooManyTets {
        /// Tetrahedra made before room ran out.
        tets: usize,
    },
    /// The points span no triangle, or in space no tetrahedron; what they are instead.
    #[error("{}", flat_text(.0))]
    Flat(Box<Flat>),
    /// The report closure stopped the work.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
}

/// Why there is no regular triangulation of the given points and weights.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum RegularError {
    /// There are not as many weights as points.
    #[error("{points} points have {weights} weights")]
    Count {
        /// Points given.
        points: usize,
        /// Weights given.
        weights: usize,
    },
    /// A weight is not accepted.
    #[error(transparent)]
    Weight(#[from] WeightError),
    /// The points have no triangulation.
    #[error(transparent)]
    Build(#[from] BuildError),
}

/// Why a point was not inserted; the triangulation is as before.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum InsertError {
    /// A coordinate is not accepted; the index in the error is 0.
    #[error(transparent)]
    Coordinate(#[from] CoordinateError),
    /// All ids are in use.
    #[error("the triangulation holds all the {limit} points that it can")]
    TooManyPoints {
        /// Points possible.
        limit: usize,
    },
    /// All tetrahedron ids are in use.
    #[error("the triangulation holds all the {limit} tetrahedra that it can")]
    TooManyTets {
        /// Tetrahedra possible.
        limit: usize,
    },
}

/// Why a vertex was not moved; the triangulation is as before.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum MoveError {
    /// A coordinate of the new place is not accepted; the index in the error is 0.
    #[error(transparent)]
    Coordinate(#[from] CoordinateError),
    /// The vertex cannot be taken from its old place.
    #[error(transparent)]
    Remove(#[from] RemoveError),
    /// Another vertex is at the new place.
    #[error("{vertex} cannot move to where {other} is")]
    Occupied {
        /// The vertex to move.
        vertex: VertexId,
        /// The vertex at the new place.
        other: VertexId,
    },
    /// Ids of points or tetrahedra are used up.
    #[error(transparent)]
    Insert(#[from] InsertError),
}

/// Why a vertex was not removed; the triangulation is as before.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum RemoveError {
    /// The id is the ghost, a duplicate, removed already or was never given out.
    #[error("{vertex} is not a vertex of the triangulation")]
    NoSuchVertex {
        /// The id in question.
        vertex: VertexId,
    },
    /// The other vertices lie on one line and span no triangle, or in space on one plane.
    #[error("without {vertex} all vertices would lie on one line or plane")]
    RestIsFlat {
        /// The vertex that holds the triangulation up.
        vertex: VertexId,
    },
    /// In space, the rest has more tetrahedra than there are ids.
    #[error("without that vertex there would be more than the {limit} tetrahedra that fit")]
    TooManyTets {
        /// Tetrahedra possible.
        limit: usize,
    },
}

fn flat_text(flat: &Flat) -> String {
    match (flat.extent(), flat.vertices.as_slice()) {
        (Extent::Point, [v, ..]) => format!("all points are in one place, that of {v}"),
        (Extent::Line, [first, .., last]) => {
            let count = flat.vertices.len();
            format!("the {count} distinct points lie on one line, from {first} to {last}")
        }
        (Extent::Plane, vertices) => {
            let count = vertices.len();
            format!("the {count} distinct points lie on one plane")
        }
        _ => "there are no points".to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Delaunay2;
    use glam::DVec2;

    fn text(points: &[[f64; 2]]) -> String {
        let points: Vec<DVec2> = points.iter().copied().map(DVec2::from).collect();
        Delaunay2::build(&points).unwrap_err().to_string()
    }

    #[test]
    fn flat_input_is_described() {
        insta::assert_snapshot!(text(&[]), @"there are no points");
        insta::assert_snapshot!(text(&[[1.0, 2.0], [1.0, 2.0]]), @"all points are in one place, that of v0");
        insta::assert_snapshot!(
            text(&[[0.0, 0.0], [3.0, 3.0], [1.0, 1.0], [3.0, 3.0]]),
            @"the 3 distinct points lie on one line, from v0 to v1"
        );
    }

    #[test]
    fn a_bad_coordinate_is_named() {
        insta::assert_snapshot!(
            text(&[[0.0, 0.0], [1.0, f64::NAN]]),
            @"point 1 has y = NaN, which is neither zero nor of magnitude 2^-142 to 2^201 (about 1.8e-43 to 3.2e60)"
        );
    }

    #[test]
    fn removal_errors_name_the_vertex() {
        let vertex = VertexId::new(3);
        insta::assert_snapshot!(RemoveError::NoSuchVertex { vertex }, @"v3 is not a vertex of the triangulation");
        insta::assert_snapshot!(RemoveError::RestIsFlat { vertex }, @"without v3 all vertices would lie on one line or plane");
    }

    #[test]
    fn too_many_points_are_counted() {
        let (count, limit) = (1 << 30, Delaunay2::MAX_POINTS);
        insta::assert_snapshot!(BuildError::TooManyPoints { count, limit }, @"1073741824 points are more than the 536870912 that a triangulation can hold");
        insta::assert_snapshot!(InsertError::TooManyPoints { limit }, @"the triangulation holds all the 536870912 points that it can");
    }
}
