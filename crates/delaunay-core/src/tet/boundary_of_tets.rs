//! The surface round tetrahedra that somebody else made, and what can be wrong with them.
//!
//! Facets with one tetrahedron bound, those with two are inside. Whether all corners turn the same way is asked, which
//! way is not. Tetrahedra that overlap without a common facet show when the surface intersects itself, or not at all.

use super::mesh::FACET_CORNERS;
use super::surface::{Surface, SurfaceError, check_places, sorted, unused};
use crate::ids::VertexId;
use geo_predicates::{CoordinateError, Sign, check_points3, orient3d};
use glam::DVec3;
use thiserror::Error;

/// The surface round given tetrahedra.
#[derive(Clone, Debug, PartialEq)]
pub struct TetBoundary {
    /// The facets with one tetrahedron, counterclockwise seen from outside, and all vertices, those inside as
    /// [interior](Surface::interior). Ordered as the tetrahedra are.
    pub surface: Surface,
    /// The index of the tetrahedron behind each triangle.
    pub tets: Vec<usize>,
}

/// Why tetrahedra are no mesh.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum TetsError {
    /// A coordinate is not accepted.
    #[error(transparent)]
    Coordinate(#[from] CoordinateError),
    /// There are no tetrahedra.
    #[error("there are no tetrahedra")]
    Empty,
    /// A tetrahedron names a vertex that is not there.
    #[error("tetrahedron {tet} has the corner {vertex}, but there are {points} points")]
    NoSuchVertex {
        /// Index of the tetrahedron.
        tet: usize,
        /// The corner in question.
        vertex: VertexId,
        /// Points given.
        points: usize,
    },
    /// A tetrahedron names a vertex more than once.
    #[error("tetrahedron {tet} has {vertex} at more than one corner")]
    RepeatedCorner {
        /// Index of the tetrahedron.
        tet: usize,
        /// The vertex in question.
        vertex: VertexId,
    },
    /// A point is no corner of any tetrahedron.
    #[error("{vertex} is a corner of no tetrahedron")]
    UnusedVertex {
        /// The vertex in question.
        vertex: VertexId,
    },
    /// The corners of a tetrahedron are on one plane.
    #[error("tetrahedron {tet} is flat: its corners {}, {}, {} and {} are on one plane", .corners[0], .corners[1], .corners[2], .corners[3])]
    Flat {
        /// Index of the tetrahedron.
        tet: usize,
        /// Its corners.
        corners: [VertexId; 4],
    },
    /// The corners of a tetrahedron turn the other way than those of most.
    #[error("tetrahedron {tet} is inverted: its corners turn the other way than those of most")]
    Inverted {
        /// The first such tetrahedron.
        tet: usize,
    },
    /// Two tetrahedra lie on the same side of a facet.
    #[error("tetrahedra {first} and {second} overlap: both are on the same side of the facet {}, {}, {}", .facet[0], .facet[1], .facet[2])]
    Overlap {
        /// The smaller index.
        first: usize,
        /// The other.
        second: usize,
        /// The vertices of the facet, by id.
        facet: [VertexId; 3],
    },
    /// The facets that bound are no surface, or two vertices are at one place.
    #[error(transparent)]
    Surface(#[from] SurfaceError),
}

/// A facet as one tetrahedron has it.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct TetFacet {
    sorted: [VertexId; 3],
    /// Whether the corners, counterclockwise from outside, are an odd permutation of the sorted ones.
    odd: bool,
    tet: usize,
    corner: usize,
}

impl Surface {
    /// The surface round tetrahedra, whose corners count the points from 0. Takes n log n time.
    ///
    /// All may be right-handed or all left-handed.
    ///
    /// # Errors
    /// The first of these defects, by the element that has it: a coordinate that is not accepted, no tetrahedra, a corner
    /// that is no point, a tetrahedron with a corner twice, a point that is no corner, two points at one place, a flat
    /// tetrahedron (exactly), one turned the other way than most, two on the same side of a facet.
    ///
    /// ```
    /// use delaunay_core::{Surface, VertexId};
    /// use glam::DVec3;
    ///
    /// let points = vec![DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z, DVec3::ONE];
    /// let tets = [[0, 1, 2, 3], [1, 2, 3, 4]].map(|corners| corners.map(VertexId::new));
    /// let boundary = Surface::round_tets(points, &tets)?;
    /// assert_eq!(boundary.tets, [0, 0, 0, 1, 1, 1]);
    /// # Ok::<(), delaunay_core::TetsError>(())
    /// ```
    pub fn round_tets(
        points: Vec<DVec3>,
        tets: &[[VertexId; 4]],
    ) -> Result<TetBoundary, TetsError> {
        check_points3(&points)?;
        check_names(points.len(), tets)?;
        if let Some(&vertex) = unused(points.len(), tets).first() {
            return Err(TetsError::UnusedVertex { vertex });
        }
        check_places(&points)?;
        let left_handed = left_handed(&points, tets)?;
        let bounding = bounding(tets, left_handed)?;
        let triangles = bounding.iter().map(|(corners, _)| *corners).collect();
        Ok(TetBoundary {
            surface: Self::with_interior(points, triangles)?,
            tets: bounding.iter().map(|(_, tet)| *tet).collect(),
        })
    }
}

/// Corners are points, four different ones.
fn check_names(points: usize, tets: &[[VertexId; 4]]) -> Result<(), TetsError> {
    if tets.is_empty() {
        return Err(TetsError::Empty);
    }
    for (tet, corners) in tets.iter().enumerate() {
        // The ghost has an index beyond all.
        if let Some(&vertex) = corners.iter().find(|v| v.index() >= points) {
            return Err(TetsError::NoSuchVertex {
                tet,
                vertex,
                points,
            });
        }
        let ordered = sorted(*corners);
        if let Some(pair) = ordered.windows(2).find(|pair| pair[0] == pair[1]) {
            let vertex = pair[0];
            return Err(TetsError::RepeatedCorner { tet, vertex });
        }
    }
    Ok(())
}

/// Whether the corners of all tetrahedra turn the left-handed way, if they turn one way.
fn left_handed(points: &[DVec3], tets: &[[VertexId; 4]]) -> Result<bool, TetsError> {
    let sign = |corners: &[VertexId; 4]| {
        let [a, b, c, d] = corners.map(|v| points[v.index()]);
        orient3d(a, b, c, d)
    };
    let signs: Vec<Sign> = tets.iter().map(sign).collect();
    if let Some(tet) = signs.iter().position(|&sign| sign == Sign::Zero) {
        let corners = tets[tet];
        return Err(TetsError::Flat { tet, corners });
    }
    let negative = signs.iter().filter(|&&sign| sign == Sign::Negative);
    let left_handed = 2 * negative.count() > signs.len();
    let most = if left_handed {
        Sign::Negative
    } else {
        Sign::Positive
    };
    match signs.iter().position(|&sign| sign != most) {
        Some(tet) => Err(TetsError::Inverted { tet }),
        None => Ok(left_handed),
    }
}

/// The facets with one tetrahedron, each with its index.
fn bounding(
    tets: &[[VertexId; 4]],
    left_handed: bool,
) -> Result<Vec<([VertexId; 3], usize)>, TetsError> {
    let outward = |tet: usize, corner: usize| {
        let [a, b, c] = FACET_CORNERS[corner].map(|i| tets[tet][i]);
        if left_handed { [b, a, c] } else { [a, b, c] }
    };
    let all = (0..tets.len()).flat_map(|tet| (0..4).map(move |corner| (tet, corner)));
    let facet = |(tet, corner)| {
        let [a, b, c] = outward(tet, corner);
        TetFacet {
            sorted: sorted([a, b, c]),
            odd: (a > b) ^ (b > c) ^ (a > c),
            tet,
            corner,
        }
    };
    let mut facets: Vec<TetFacet> = all.map(facet).collect();
    facets.sort_unstable();
    check_sides(&facets)?;
    let shared = facets.chunk_by(|f, g| f.sorted == g.sorted);
    let single = shared.filter(|facets| facets.len() == 1).flatten();
    let mut single: Vec<_> = single.map(|f| (f.tet, f.corner)).collect();
    single.sort_unstable();
    let named = single.into_iter();
    Ok(named
        .map(|(tet, corner)| (outward(tet, corner), tet))
        .collect())
}

/// No two tetrahedra are on the same side of a facet.
fn check_sides(sorted: &[TetFacet]) -> Result<(), TetsError> {
    let pairs = sorted.windows(2).map(|pair| (pair[0], pair[1]));
    let same_side = pairs.filter(|(f, g)| (f.sorted, f.odd) == (g.sorted, g.odd));
    match same_side.min_by_key(|(f, g)| (f.tet, g.tet)) {
        Some((f, g)) => Err(TetsError::Overlap {
            first: f.tet,
            second: g.tet,
            facet: f.sorted,
        }),
        None => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Delaunay3;
    use crate::options::BuildOptions;
    use crate::progress::silent;

    fn points() -> Vec<DVec3> {
        let places = [[0, 0, 0], [4, 0, 0], [0, 4, 0], [0, 0, 4], [4, 4, 4]];
        places.map(|p| DVec3::from(p.map(f64::from))).to_vec()
    }

    fn around(points: Vec<DVec3>, tets: &[[usize; 4]]) -> Result<TetBoundary, TetsError> {
        let named: Vec<_> = tets
            .iter()
            .map(|corners| corners.map(VertexId::new))
            .collect();
        Surface::round_tets(points, &named)
    }

    fn error(points: Vec<DVec3>, tets: &[[usize; 4]]) -> String {
        around(points, tets).unwrap_err().to_string()
    }

    /// A lattice is all ties, and has vertices inside and on the sides.
    #[test]
    fn the_surface_round_a_triangulation_gives_it_back() {
        let place = |i: usize| DVec3::new((i % 4) as f64, (i / 4 % 4) as f64, (i / 16) as f64);
        let lattice: Vec<DVec3> = (0..64).map(place).collect();
        let delaunay = Delaunay3::build(&lattice).unwrap();
        let mut tets: Vec<_> = delaunay
            .tets()
            .map(|t| delaunay.mesh().tet_vertices(t))
            .collect();
        let right = Surface::round_tets(lattice.clone(), &tets).unwrap();
        assert_eq!(right.surface.interior().len(), 8);
        assert_eq!(right.surface.triangles().len(), 6 * 9 * 2);
        let solid = right.surface.solid(BuildOptions::default(), &mut silent);
        assert_eq!(solid.unwrap().tets().count(), tets.len());
        for corners in &mut tets {
            corners.swap(1, 3);
        }
        let left = Surface::round_tets(lattice, &tets).unwrap();
        let ways = |boundary: &TetBoundary| {
            let turned = boundary.surface.triangles().iter().map(|&[a, b, c]| {
                let first = a.min(b).min(c);
                if first == a {
                    [a, b, c]
                } else if first == b {
                    [b, c, a]
                } else {
                    [c, a, b]
                }
            });
            let mut turned: Vec<_> = turned.collect();
            turned.sort_unstable();
            turned
        };
        assert_eq!(ways(&left), ways(&right));
    }

    #[test]
    fn defects_name_the_elements() {
        let two = [[0, 1, 2, 3], [1, 2, 3, 4]];
        assert_eq!(around(points(), &two).unwrap().surface.triangles().len(), 6);
        insta::assert_snapshot!(error(points(), &[]), @"there are no tetrahedra");
        insta::assert_snapshot!(error(points(), &[two[0], [1, 2, 3, 5]]), @"tetrahedron 1 has the corner v5, but there are 5 points");
        insta::assert_snapshot!(error(points(), &[two[0], [4, 2, 3, 4]]), @"tetrahedron 1 has v4 at more than one corner");
        insta::assert_snapshot!(error(points(), &two[..1]), @"v4 is a corner of no tetrahedron");
        insta::assert_snapshot!(error(points(), &[two[0], [2, 1, 3, 4], [1, 2, 3, 4]]), @"tetrahedron 1 is inverted: its corners turn the other way than those of most");
        insta::assert_snapshot!(error(points(), &[two[0], two[1], two[1]]), @"tetrahedra 1 and 2 overlap: both are on the same side of the facet v1, v2, v3");
        insta::assert_snapshot!(error(points(), &[two[0], [0, 1, 2, 4]]), @"tetrahedra 0 and 1 overlap: both are on the same side of the facet v0, v1, v2");
        let mut flat = points();
        flat[4] = DVec3::new(1.0, 1.0, 2.0);
        insta::assert_snapshot!(error(flat, &two), @"tetrahedron 1 is flat: its corners v1, v2, v3 and v4 are on one plane");
        let mut twice = points();
        twice[4] = twice[1];
        insta::assert_snapshot!(error(twice, &two), @"v1 and v4 are at one place");
        let mut nan = points();
        nan[1].x = f64::NAN;
        insta::assert_snapshot!(error(nan, &two), @"point 1 has x = NaN, which is neither zero nor of magnitude 2^-142 to 2^201 (about 1.8e-43 to 3.2e60)");
    }
}
