//! The kinds of defects, in the order in which they are listed, and their names.

use super::defect::DomainDefect;

/// A kind of [`DomainDefect`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum DefectKind {
    /// Coordinates that are not accepted.
    Coordinate,
    /// Corners that are no points.
    NoSuchCorner,
    /// Triangles with a corner twice.
    RepeatedCorner,
    /// Triangles without area.
    NoArea,
    /// Points where another is.
    Coincident,
    /// Points that are no corners.
    Unused,
    /// Triangles with the corners of another.
    RepeatedTriangle,
    /// Edges with one triangle.
    OpenEdge,
    /// Edges with an odd number of triangles, but not one.
    OddEdge,
    /// Patches with one side.
    OneSided,
    /// Pairs of triangles that intersect.
    Intersection,
}

impl DefectKind {
    /// All kinds, in the order in which they are listed.
    pub const ALL: [Self; 11] = [
        Self::Coordinate,
        Self::NoSuchCorner,
        Self::RepeatedCorner,
        Self::NoArea,
        Self::Coincident,
        Self::Unused,
        Self::RepeatedTriangle,
        Self::OpenEdge,
        Self::OddEdge,
        Self::OneSided,
        Self::Intersection,
    ];

    /// A name for programs, such as `open_edge`.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Coordinate => "coordinate",
            Self::NoSuchCorner => "no_such_corner",
            Self::RepeatedCorner => "repeated_corner",
            Self::NoArea => "no_area",
            Self::Coincident => "coincident_points",
            Self::Unused => "unused_point",
            Self::RepeatedTriangle => "repeated_triangle",
            Self::OpenEdge => "open_edge",
            Self::OddEdge => "odd_edge",
            Self::OneSided => "one_sided",
            Self::Intersection => "intersection",
        }
    }

    /// The kind in words for so many, such as `open edges`.
    #[must_use]
    pub const fn words(self, count: usize) -> &'static str {
        let [one, many] = match self {
            Self::Coordinate => [
                "point with a coordinate out of range",
                "points with a coordinate out of range",
            ],
            Self::NoSuchCorner => ["corner that is no point", "corners that are no points"],
            Self::RepeatedCorner => [
                "triangle with a corner twice",
                "triangles with a corner twice",
            ],
            Self::NoArea => ["triangle without area", "triangles without area"],
            Self::Coincident => ["point where another is", "points where another is"],
            Self::Unused => ["point that is no corner", "points that are no corners"],
            Self::RepeatedTriangle => [
                "triangle with the corners of another",
                "triangles with the corners of another",
            ],
            Self::OpenEdge => ["open edge", "open edges"],
            Self::OddEdge => [
                "edge with an odd number of triangles",
                "edges with an odd number of triangles",
            ],
            Self::OneSided => ["patch with one side", "patches with one side"],
            Self::Intersection => [
                "pair of triangles that intersect",
                "pairs of triangles that intersect",
            ],
        };
        if count == 1 { one } else { many }
    }
}

impl DomainDefect {
    /// Which kind of defect this is.
    #[must_use]
    pub const fn kind(&self) -> DefectKind {
        match self {
            Self::Coordinate(_) => DefectKind::Coordinate,
            Self::NoSuchCorner(_) => DefectKind::NoSuchCorner,
            Self::RepeatedCorner(_) => DefectKind::RepeatedCorner,
            Self::NoArea(_) => DefectKind::NoArea,
            Self::Coincident(_) => DefectKind::Coincident,
            Self::Unused(_) => DefectKind::Unused,
            Self::RepeatedTriangle(_) => DefectKind::RepeatedTriangle,
            Self::OpenEdge(_) => DefectKind::OpenEdge,
            Self::OddEdge(_) => DefectKind::OddEdge,
            Self::OneSided(_) => DefectKind::OneSided,
            Self::Intersection(_) => DefectKind::Intersection,
        }
    }
}
