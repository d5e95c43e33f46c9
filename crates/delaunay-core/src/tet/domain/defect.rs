//! What can be wrong with a triangle, a point, an edge or a patch: one struct for each kind, with ids and places.
//!
//! Triangles and vertices are numbered as they were given.

use crate::ids::VertexId;
use geo_predicates::CoordinateError;
use glam::DVec3;
use std::fmt;
use thiserror::Error;

/// A vertex and where it is. Prints as `v3 (0.0, 1.0, 0.0)`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placed {
    /// The vertex, as given.
    pub vertex: VertexId,
    /// Its place.
    pub place: DVec3,
}

impl fmt::Display for Placed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {}", self.vertex, At(self.place))
    }
}

/// A place, with as many digits as it takes to tell it from others.
struct At(DVec3);

impl fmt::Display for At {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let DVec3 { x, y, z } = self.0;
        // The plain format of f64 would write 1e308 with 309 digits.
        write!(f, "({x:?}, {y:?}, {z:?})")
    }
}

/// A triangle names a vertex that is not there.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[error("triangle {triangle} has the corner {vertex}, but there are {points} points")]
pub struct NoSuchCorner {
    /// Index of the triangle.
    pub triangle: usize,
    /// Which of its corners, from 0.
    pub corner: usize,
    /// The vertex in question.
    pub vertex: VertexId,
    /// Points given.
    pub points: usize,
}

/// A triangle names a vertex more than once.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[error("triangle {triangle} has {corner} at more than one corner")]
pub struct RepeatedCorner {
    /// Index of the triangle.
    pub triangle: usize,
    /// The vertex in question.
    pub corner: Placed,
}

/// The corners of a triangle are on one line, or two of them at one place. Exact.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[error("triangle {triangle} has no area: its corners {}, {} and {} are on one line", .corners[0], .corners[1], .corners[2])]
pub struct NoArea {
    /// Index of the triangle.
    pub triangle: usize,
    /// Its corners.
    pub corners: [Placed; 3],
}

/// Two points are at exactly the same place.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[error("{second} is where {} is", .first)]
pub struct Coincident {
    /// The first vertex at the place.
    pub first: VertexId,
    /// The other, and the place.
    pub second: Placed,
}

/// A point is no corner of any triangle.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[error("{point} is a corner of no triangle")]
pub struct UnusedPoint {
    /// The point.
    pub point: Placed,
}

/// A triangle has the same corners, or corners at the same places, as an earlier one.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[error("triangle {second} has the same corners as triangle {first}: {}, {} and {}", .corners[0], .corners[1], .corners[2])]
pub struct RepeatedTriangle {
    /// The first triangle with these corners.
    pub first: usize,
    /// The other.
    pub second: usize,
    /// The corners of the first.
    pub corners: [Placed; 3],
}

/// An edge has one triangle only.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[error("the edge from {} to {} has triangle {triangle} alone", .ends[0], .ends[1])]
pub struct OpenEdge {
    /// The ends of the edge, the smaller id first.
    pub ends: [Placed; 2],
    /// The triangle.
    pub triangle: usize,
}

/// An edge has an odd number of triangles, more than one, so that it does not bound a body.
#[derive(Clone, Debug, PartialEq, Error)]
#[error("the edge from {} to {} has {} triangles, {}", .ends[0], .ends[1], .triangles.len(), list(.triangles))]
pub struct OddEdge {
    /// The ends of the edge, the smaller id first.
    pub ends: [Placed; 2],
    /// The triangles, in order.
    pub triangles: Vec<usize>,
}

/// A patch of triangles, which hang together across edges with two triangles, has no two sides.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[error(
    "the patch of {triangles} triangles round triangle {first} has one side: they cannot be turned to agree, as at the edge from {} to {}",
    .ends[0], .ends[1]
)]
pub struct OneSided {
    /// Its first triangle.
    pub first: usize,
    /// How many triangles it has.
    pub triangles: usize,
    /// The ends of an edge at which two of them disagree when all others agree.
    pub ends: [Placed; 2],
}

/// Two triangles have more in common than the corners and the edge that they share. Exact.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[error("triangles {first} and {second} intersect near {}", At(*.near))]
pub struct Intersection {
    /// The smaller index.
    pub first: usize,
    /// The other.
    pub second: usize,
    /// The middle of what the boxes round the two triangles have in common: where to look.
    pub near: DVec3,
}

/// One thing that is wrong with triangles. Says what and where.
#[derive(Clone, Debug, PartialEq, Error)]
#[error(transparent)]
pub enum DomainDefect {
    /// A coordinate is not accepted; of a point that has several such, the first.
    Coordinate(#[from] CoordinateError),
    /// A triangle names a vertex that is not there.
    NoSuchCorner(#[from] NoSuchCorner),
    /// A triangle names a vertex more than once.
    RepeatedCorner(#[from] RepeatedCorner),
    /// A triangle has no area.
    NoArea(#[from] NoArea),
    /// Two points are at one place.
    Coincident(#[from] Coincident),
    /// A point is no corner.
    Unused(#[from] UnusedPoint),
    /// A triangle has the corners of another.
    RepeatedTriangle(#[from] RepeatedTriangle),
    /// An edge has one triangle.
    OpenEdge(#[from] OpenEdge),
    /// An edge has an odd number of triangles, but not one.
    OddEdge(#[from] OddEdge),
    /// A patch has one side.
    OneSided(#[from] OneSided),
    /// Two triangles intersect.
    Intersection(#[from] Intersection),
}

impl DomainDefect {
    /// The vertices that the defect names, as they were given. For a coordinate the point that has it.
    #[must_use]
    pub fn vertices(&self) -> Vec<VertexId> {
        match self {
            Self::Coordinate(of) => {
                let index = Some(of.index).filter(|&index| index < VertexId::LIMIT);
                index.map(VertexId::new).into_iter().collect()
            }
            Self::NoSuchCorner(of) => vec![of.vertex],
            Self::Coincident(of) => vec![of.first, of.second.vertex],
            _ => self.placed().iter().map(|placed| placed.vertex).collect(),
        }
    }

    /// Where the defect is: the places of the vertices that it names, or a place near it. None for a vertex that is not there
    /// and for a coordinate that is no number to go by.
    #[must_use]
    pub fn places(&self) -> Vec<DVec3> {
        match self {
            Self::Intersection(of) => vec![of.near],
            _ => self.placed().iter().map(|placed| placed.place).collect(),
        }
    }

    /// The triangles that the defect names, by index; of a patch with one side the first.
    #[must_use]
    pub fn triangles(&self) -> Vec<usize> {
        match self {
            Self::Coordinate(_) | Self::Coincident(_) | Self::Unused(_) => Vec::new(),
            Self::NoSuchCorner(of) => vec![of.triangle],
            Self::RepeatedCorner(of) => vec![of.triangle],
            Self::NoArea(of) => vec![of.triangle],
            Self::RepeatedTriangle(of) => vec![of.first, of.second],
            Self::OpenEdge(of) => vec![of.triangle],
            Self::OddEdge(of) => of.triangles.clone(),
            Self::OneSided(of) => vec![of.first],
            Self::Intersection(of) => vec![of.first, of.second],
        }
    }

    fn placed(&self) -> Vec<Placed> {
        match self {
            Self::Coordinate(_) | Self::NoSuchCorner(_) | Self::Intersection(_) => Vec::new(),
            Self::RepeatedCorner(of) => vec![of.corner],
            Self::NoArea(of) => of.corners.to_vec(),
            Self::Coincident(of) => vec![of.second],
            Self::Unused(of) => vec![of.point],
            Self::RepeatedTriangle(of) => of.corners.to_vec(),
            Self::OpenEdge(of) => of.ends.to_vec(),
            Self::OddEdge(of) => of.ends.to_vec(),
            Self::OneSided(of) => of.ends.to_vec(),
        }
    }
}

/// `3, 4 and 9`; of many the first few.
fn list(numbers: &[usize]) -> String {
    const SHOWN: usize = 5;
    let mut shown: Vec<String> = numbers.iter().take(SHOWN).map(usize::to_string).collect();
    if numbers.len() > SHOWN {
        shown.push(format!("{} more", numbers.len() - SHOWN));
    }
    match shown.as_slice() {
        [before @ .., last] if !before.is_empty() => format!("{} and {last}", before.join(", ")),
        _ => shown.concat(),
    }
}
