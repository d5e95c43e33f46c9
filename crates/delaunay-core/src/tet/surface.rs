//! What bounds a solid: a closed surface of triangles, validated.
//!
//! ```text
//!    two triangles on an edge       four, where two bodies touch
//!
//!           ____                         \  body  /
//!          /   outside                    \      /
//!    body /                        outside ·────·  outside
//!         \                               /      \
//!          \____                         /  body  \
//! ```
//!
//! The surface is closed when every edge has an even number of triangles. A path from infinity that avoids the edges
//! then crosses it as often, odd or even, as any other path to the same place, which says whether that place is inside.
//! The way a triangle is turned is not asked.

use super::delaunay::Delaunay3;
use super::places::Places;
use super::projection::View;
use crate::ids::VertexId;
use geo_predicates::{CoordinateError, check_points3};
use glam::DVec3;
use thiserror::Error;

/// A closed surface of triangles in space, the boundary of a solid.
///
/// The solid may have several bodies, voids and handles, and bodies may touch at a corner or along an edge; what has space on both
/// sides, as a wall inside a body, is no boundary of it. Whether triangles intersect is not known here but to
/// [`solid`](Self::solid).
///
/// ```
/// use delaunay_core::{BuildOptions, Surface, VertexId, progress::silent};
/// use glam::DVec3;
///
/// let corners = vec![DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z];
/// let facets = [[1, 2, 3], [2, 0, 3], [0, 1, 3], [2, 1, 0]].map(|facet| facet.map(VertexId::new));
/// let surface = Surface::new(corners.clone(), facets.to_vec())?;
/// let solid = surface.solid(BuildOptions::default(), &mut silent)?;
/// assert_eq!(solid.tets().count(), 1);
///
/// let open = Surface::new(corners, facets[1..].to_vec());
/// assert!(open.unwrap_err().to_string().starts_with("the surface is not closed"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Surface {
    points: Vec<DVec3>,
    triangles: Vec<[VertexId; 3]>,
    /// Points that are no corners, by id.
    interior: Vec<VertexId>,
}

/// Why points and triangles are no closed surface.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum SurfaceError {
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
    /// There are no triangles.
    #[error("the surface has no triangles")]
    Empty,
    /// A triangle names a vertex that is not there.
    #[error("triangle {triangle} has the corner {vertex}, but there are {points} points")]
    NoSuchVertex {
        /// Index of the triangle.
        triangle: usize,
        /// The corner in question.
        vertex: VertexId,
        /// Points given.
        points: usize,
    },
    /// A triangle names a vertex more than once.
    #[error("triangle {triangle} has {vertex} at more than one corner")]
    RepeatedCorner {
        /// Index of the triangle.
        triangle: usize,
        /// The vertex in question.
        vertex: VertexId,
    },
    /// A point is no corner of any triangle.
    #[error("{vertex} is a corner of no triangle")]
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
    /// The corners of a triangle are on one line.
    #[error("triangle {triangle} has no area: its corners {}, {} and {} are on one line", .corners[0], .corners[1], .corners[2])]
    NoArea {
        /// Index of the triangle.
        triangle: usize,
        /// Its corners.
        corners: [VertexId; 3],
    },
    /// Two triangles have the same corners.
    #[error("triangles {first} and {second} have the same corners")]
    RepeatedTriangle {
        /// The smaller index.
        first: usize,
        /// The other.
        second: usize,
    },
    /// An edge has an odd number of triangles.
    #[error("the surface is not closed: {}", open_text(*.edge, *.triangle, *.triangles, *.open_edges))]
    Open {
        /// The ends of the first such edge.
        edge: [VertexId; 2],
        /// The first triangle on it.
        triangle: usize,
        /// How many triangles are on it.
        triangles: usize,
        /// How many such edges there are.
        open_edges: usize,
    },
}

impl Surface {
    /// The surface that the triangles form.
    ///
    /// Triangle corners count the points from 0 and may go round either way. Time n log n.
    ///
    /// # Errors
    /// The first of these defects, by the element that has it: a coordinate that is not accepted, more points than
    /// [`Delaunay3::MAX_POINTS`], no triangles, a corner that is no point, a triangle with a corner twice, a point
    /// that is no corner, two points at one place, a triangle without area (exactly), a triangle given twice, an edge with an odd
    /// number of triangles.
    pub fn new(points: Vec<DVec3>, triangles: Vec<[VertexId; 3]>) -> Result<Self, SurfaceError> {
        check_form(&points, &triangles)?;
        let interior = unused(points.len(), &triangles);
        if let Some(&vertex) = interior.first() {
            return Err(SurfaceError::UnusedVertex { vertex });
        }
        check_shape(&points, &triangles)?;
        Ok(Self {
            points,
            triangles,
            interior,
        })
    }

    /// The surface that the triangles form, and points that are to be strictly inside: those that are no corners.
    ///
    /// The points inside are vertices of [`solid`](Self::solid), which finds out whether they are there.
    ///
    /// # Errors
    /// As [`new`](Self::new), but that a point may be no corner.
    ///
    /// ```
    /// use delaunay_core::{BuildOptions, Surface, VertexId, progress::silent};
    /// use glam::DVec3;
    ///
    /// let corners = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z];
    /// let facets = [[1, 2, 3], [2, 0, 3], [0, 1, 3], [2, 1, 0]].map(|facet| facet.map(VertexId::new));
    /// let solid_with = |point| -> Result<_, Box<dyn std::error::Error>> {
    ///     let points = corners.into_iter().chain([point]).collect();
    ///     Ok(Surface::with_interior(points, facets.to_vec())?.solid(BuildOptions::default(), &mut silent)?)
    /// };
    /// assert_eq!(solid_with(DVec3::splat(0.2))?.tets().count(), 4);
    /// assert_eq!(solid_with(DVec3::splat(3.0)).unwrap_err().to_string(), "v4 is not inside the surface");
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn with_interior(
        points: Vec<DVec3>,
        triangles: Vec<[VertexId; 3]>,
    ) -> Result<Self, SurfaceError> {
        check_form(&points, &triangles)?;
        let interior = unused(points.len(), &triangles);
        check_shape(&points, &triangles)?;
        Ok(Self {
            points,
            triangles,
            interior,
        })
    }

    /// The points, by vertex index.
    #[must_use]
    pub fn points(&self) -> &[DVec3] {
        &self.points
    }

    /// The corners of the triangles, as they were given.
    #[must_use]
    pub fn triangles(&self) -> &[[VertexId; 3]] {
        &self.triangles
    }

    /// The points that are to be inside, by id: none but after [`with_interior`](Self::with_interior).
    #[must_use]
    pub fn interior(&self) -> &[VertexId] {
        &self.interior
    }
}

/// Numbers are accepted, and corners are points.
fn check_form(points: &[DVec3], triangles: &[[VertexId; 3]]) -> Result<(), SurfaceError> {
    check_points3(points)?;
    check_counts(points.len(), triangles.len())?;
    check_corners(points.len(), triangles)
}

/// Points and triangles are different, triangles have an area, and the surface is closed.
fn check_shape(points: &[DVec3], triangles: &[[VertexId; 3]]) -> Result<(), SurfaceError> {
    check_places(points)?;
    check_areas(points, triangles)?;
    check_repetition(triangles)?;
    check_edges(triangles)
}

fn check_counts(points: usize, triangles: usize) -> Result<(), SurfaceError> {
    if points > Delaunay3::MAX_POINTS {
        let (count, limit) = (points, Delaunay3::MAX_POINTS);
        return Err(SurfaceError::TooManyPoints { count, limit });
    }
    if triangles == 0 {
        return Err(SurfaceError::Empty);
    }
    Ok(())
}

/// Corners are points, three different ones.
fn check_corners(points: usize, triangles: &[[VertexId; 3]]) -> Result<(), SurfaceError> {
    for (triangle, &[a, b, c]) in triangles.iter().enumerate() {
        // The ghost has an index beyond all.
        if let Some(vertex) = [a, b, c].into_iter().find(|v| v.index() >= points) {
            return Err(SurfaceError::NoSuchVertex {
                triangle,
                vertex,
                points,
            });
        }
        if let Some((vertex, _)) = [(a, b), (b, c), (c, a)].into_iter().find(|(v, w)| v == w) {
            return Err(SurfaceError::RepeatedCorner { triangle, vertex });
        }
    }
    Ok(())
}

/// The points that are no corners.
pub(super) fn unused<const N: usize>(points: usize, elements: &[[VertexId; N]]) -> Vec<VertexId> {
    let mut used = vec![false; points];
    for v in elements.as_flattened() {
        used[v.index()] = true;
    }
    let all = (0..points).map(VertexId::new);
    all.filter(|v| !used[v.index()]).collect()
}

/// No two points are at one place.
pub(super) fn check_places(points: &[DVec3]) -> Result<(), SurfaceError> {
    match Places::of(points, |_| true).doubles().min() {
        Some([first, second]) => Err(SurfaceError::CoincidentVertices { first, second }),
        None => Ok(()),
    }
}

/// No triangle is a segment.
fn check_areas(points: &[DVec3], triangles: &[[VertexId; 3]]) -> Result<(), SurfaceError> {
    let flat =
        |corners: &[VertexId; 3]| View::of_area(corners.map(|v| points[v.index()])).is_none();
    match triangles.iter().position(flat) {
        Some(triangle) => Err(SurfaceError::NoArea {
            triangle,
            corners: triangles[triangle],
        }),
        None => Ok(()),
    }
}

/// No two triangles have the same corners.
fn check_repetition(triangles: &[[VertexId; 3]]) -> Result<(), SurfaceError> {
    let indexed = triangles.iter().enumerate();
    let mut corners: Vec<_> = indexed.map(|(i, &corners)| (sorted(corners), i)).collect();
    corners.sort_unstable();
    let repeated = corners.windows(2).filter(|pair| pair[0].0 == pair[1].0);
    match repeated.map(|pair| (pair[0].1, pair[1].1)).min() {
        Some((first, second)) => Err(SurfaceError::RepeatedTriangle { first, second }),
        None => Ok(()),
    }
}

/// Every edge has an even number of triangles.
fn check_edges(triangles: &[[VertexId; 3]]) -> Result<(), SurfaceError> {
    let sides = |(i, &[a, b, c]): (usize, &[VertexId; 3])| {
        [[a, b], [b, c], [c, a]].map(|edge| (sorted(edge), i))
    };
    let mut sides: Vec<_> = triangles.iter().enumerate().flat_map(sides).collect();
    sides.sort_unstable();
    let edges = sides.chunk_by(|(edge, _), (next, _)| edge == next);
    let mut open = edges.filter(|on_edge| on_edge.len() % 2 == 1);
    match open.next() {
        Some(on_edge) => Err(SurfaceError::Open {
            edge: on_edge[0].0,
            triangle: on_edge[0].1,
            triangles: on_edge.len(),
            open_edges: 1 + open.count(),
        }),
        None => Ok(()),
    }
}

/// Vertices in the order of their ids: one name for an edge or a triangle, however it is turned.
pub(super) fn sorted<const N: usize>(mut vertices: [VertexId; N]) -> [VertexId; N] {
    vertices.sort_unstable();
    vertices
}

fn open_text([a, b]: [VertexId; 2], triangle: usize, triangles: usize, edges: usize) -> String {
    let on_edge = match triangles {
        1 => format!("triangle {triangle} alone"),
        _ => format!("{triangles} triangles, triangle {triangle} the first"),
    };
    let edges = match edges {
        1 => "no other edge has".to_owned(),
        2 => "1 other edge has".to_owned(),
        _ => format!("{} other edges have", edges - 1),
    };
    format!("the edge from {a} to {b} has {on_edge}, and {edges} an odd number of triangles")
}

#[cfg(test)]
mod tests {
    use super::*;

    const TETRAHEDRON: [[usize; 3]; 4] = [[1, 2, 3], [2, 0, 3], [0, 1, 3], [2, 1, 0]];

    fn ids(triangles: &[[usize; 3]]) -> Vec<[VertexId; 3]> {
        let named = triangles.iter().map(|corners| corners.map(VertexId::new));
        named.collect()
    }

    fn corners() -> Vec<DVec3> {
        vec![DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z]
    }

    fn error(points: Vec<DVec3>, triangles: &[[usize; 3]]) -> String {
        Surface::new(points, ids(triangles))
            .unwrap_err()
            .to_string()
    }

    #[test]
    fn the_triangles_may_be_turned_either_way() {
        let mut triangles = TETRAHEDRON;
        triangles[1].reverse();
        let surface = Surface::new(corners(), ids(&triangles)).unwrap();
        assert_eq!(surface.points(), corners());
        assert_eq!(surface.triangles(), ids(&triangles));
    }

    #[test]
    fn defects_of_points_are_named() {
        let with = |more: DVec3| corners().into_iter().chain([more]).collect::<Vec<_>>();
        insta::assert_snapshot!(
            error(with(DVec3::new(0.0, f64::NAN, 0.0)), &TETRAHEDRON),
            @"point 4 has y = NaN, which is neither zero nor of magnitude 2^-142 to 2^201 (about 1.8e-43 to 3.2e60)"
        );
        insta::assert_snapshot!(error(with(DVec3::ONE), &TETRAHEDRON), @"v4 is a corner of no triangle");
        let twice: Vec<_> = TETRAHEDRON
            .into_iter()
            .chain(TETRAHEDRON.map(|facet| facet.map(|i| i + 4)))
            .collect();
        let mut points = [
            corners(),
            corners().iter().map(|p| p + DVec3::splat(5.0)).collect(),
        ]
        .concat();
        points[6] = DVec3::new(-0.0, 1.0, 0.0);
        insta::assert_snapshot!(error(points, &twice), @"v2 and v6 are at one place");
    }

    #[test]
    fn points_inside_may_be_no_corners_but_must_differ() {
        let with = |more: DVec3| corners().into_iter().chain([more]).collect::<Vec<_>>();
        let surface = |point| Surface::with_interior(with(point), ids(&TETRAHEDRON));
        assert_eq!(
            surface(DVec3::splat(0.2)).unwrap().interior(),
            [VertexId::new(4)]
        );
        insta::assert_snapshot!(surface(DVec3::X).unwrap_err(), @"v1 and v4 are at one place");
        let plain = Surface::new(corners(), ids(&TETRAHEDRON)).unwrap();
        assert_eq!(
            plain,
            Surface::with_interior(corners(), ids(&TETRAHEDRON)).unwrap()
        );
        assert!(plain.interior().is_empty());
    }

    #[test]
    fn defects_of_triangles_are_named() {
        insta::assert_snapshot!(error(Vec::new(), &[]), @"the surface has no triangles");
        insta::assert_snapshot!(error(corners(), &[[0, 1, 2], [1, 2, 4]]), @"triangle 1 has the corner v4, but there are 4 points");
        insta::assert_snapshot!(error(corners(), &[[0, 1, 2], [3, 1, 3]]), @"triangle 1 has v3 at more than one corner");
        let ghost = Surface::new(corners(), vec![[VertexId::GHOST; 3]]).unwrap_err();
        insta::assert_snapshot!(ghost, @"triangle 0 has the corner v∞, but there are 4 points");
        let line = vec![DVec3::ZERO, DVec3::ONE, DVec3::splat(3.0), DVec3::Z];
        insta::assert_snapshot!(error(line, &TETRAHEDRON), @"triangle 3 has no area: its corners v2, v1 and v0 are on one line");
        let repeated = [TETRAHEDRON.as_slice(), &[[3, 2, 1]]].concat();
        insta::assert_snapshot!(error(corners(), &repeated), @"triangles 0 and 4 have the same corners");
    }

    #[test]
    fn an_open_surface_names_an_edge() {
        insta::assert_snapshot!(error(corners(), &TETRAHEDRON[..3]), @"the surface is not closed: the edge from v0 to v1 has triangle 2 alone, and 2 other edges have an odd number of triangles");
        let flap = [TETRAHEDRON.as_slice(), &[[0, 1, 4]]].concat();
        let points = [corners(), vec![DVec3::NEG_Z]].concat();
        insta::assert_snapshot!(error(points, &flap), @"the surface is not closed: the edge from v0 to v1 has 3 triangles, triangle 2 the first, and 2 other edges have an odd number of triangles");
    }

    /// A strip of five triangles with a half twist has one side, and a rim.
    #[test]
    fn a_moebius_strip_is_open_along_its_rim() {
        let strip = [0, 1, 2, 3, 4].map(|i| [i, (i + 1) % 5, (i + 2) % 5]);
        let places = [[0, 0, 0], [2, 0, 1], [3, 2, 0], [1, 4, 2], [-1, 2, 1]];
        let points = places.map(|p| DVec3::from(p.map(f64::from)));
        insta::assert_snapshot!(error(points.to_vec(), &strip), @"the surface is not closed: the edge from v0 to v2 has triangle 0 alone, and 4 other edges have an odd number of triangles");
    }
}
