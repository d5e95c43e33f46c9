//! Whether a surface is what every mesher must accept: closed, without degenerate triangles and without self-intersection.

use delaunay_core::geo_predicates::{Sign, check_points3, orient2d};
use delaunay_core::{VertexId, triangles_intersect};
use glam::{DVec2, DVec3};
use rustc_hash::{FxHashMap, FxHashSet};
use std::fmt;

use super::Solid;
use super::overlaps::{self, Extent};

/// What is wrong with a surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Defect {
    /// There are no triangles.
    Empty,
    /// A coordinate is not finite or beyond what signs are exact for.
    Coordinate,
    /// A triangle names a point that is not there, or one point twice.
    Corner {
        /// The triangle.
        triangle: usize,
    },
    /// Two points are at one place.
    Repeated {
        /// The second of them.
        point: usize,
    },
    /// A point is no corner.
    Unused {
        /// The point.
        point: usize,
    },
    /// The corners of a triangle are on one line.
    NoArea {
        /// The triangle.
        triangle: usize,
    },
    /// An edge has an odd number of triangles.
    Open {
        /// The ends of the edge.
        edge: [u32; 2],
    },
    /// Two triangles have more in common than what they share.
    Intersection {
        /// The triangles.
        triangles: [usize; 2],
    },
}

impl fmt::Display for Defect {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Empty => write!(f, "there are no triangles"),
            Self::Coordinate => write!(f, "a coordinate is not accepted"),
            Self::Corner { triangle } => write!(f, "triangle {triangle} has a wrong corner"),
            Self::Repeated { point } => write!(f, "point {point} is where another is"),
            Self::Unused { point } => write!(f, "point {point} is no corner"),
            Self::NoArea { triangle } => write!(f, "triangle {triangle} has no area"),
            Self::Open { edge: [a, b] } => write!(f, "edge {a} {b} is open"),
            Self::Intersection { triangles: [s, t] } => {
                write!(f, "triangles {s} and {t} intersect")
            }
        }
    }
}

/// The first defect that is found, `None` for a valid surface. Exact.
///
/// n log n and the number of pairs of triangles whose boxes overlap, which is quadratic for needles.
#[must_use]
pub fn defect(solid: &Solid) -> Option<Defect> {
    defect_but_intersection(solid).or_else(|| intersection(solid))
}

/// As [`defect`], but triangles may intersect. Linear.
#[must_use]
pub fn defect_but_intersection(solid: &Solid) -> Option<Defect> {
    let Solid {
        points, triangles, ..
    } = solid;
    if triangles.is_empty() {
        return Some(Defect::Empty);
    }
    if check_points3(points).is_err() {
        return Some(Defect::Coordinate);
    }
    wrong_corner(points.len(), triangles)
        .or_else(|| repeated(points))
        .or_else(|| unused(points.len(), triangles))
        .or_else(|| without_area(points, triangles))
        .or_else(|| open(triangles))
}

fn wrong_corner(points: usize, triangles: &[[u32; 3]]) -> Option<Defect> {
    let is_wrong = |[a, b, c]: [u32; 3]| {
        a == b || b == c || c == a || [a, b, c].into_iter().any(|v| v as usize >= points)
    };
    let triangle = triangles.iter().position(|&corners| is_wrong(corners))?;
    Some(Defect::Corner { triangle })
}

fn repeated(points: &[DVec3]) -> Option<Defect> {
    let mut places = FxHashSet::default();
    let is_new = |p: &DVec3| places.insert((*p + 0.0).to_array().map(f64::to_bits));
    let mut known = points.iter().map(is_new);
    let point = known.position(|is_new| !is_new)?;
    Some(Defect::Repeated { point })
}

fn unused(points: usize, triangles: &[[u32; 3]]) -> Option<Defect> {
    let mut is_used = vec![false; points];
    for &v in triangles.as_flattened() {
        is_used[v as usize] = true;
    }
    let point = is_used.iter().position(|is_used| !is_used)?;
    Some(Defect::Unused { point })
}

fn without_area(points: &[DVec3], triangles: &[[u32; 3]]) -> Option<Defect> {
    let views: [fn(DVec3) -> DVec2; 3] = [
        |p| DVec2::new(p.x, p.y),
        |p| DVec2::new(p.y, p.z),
        |p| DVec2::new(p.z, p.x),
    ];
    let is_line = |corners: &[u32; 3]| {
        let corners = corners.map(|v| points[v as usize]);
        views.iter().all(|view| {
            let [a, b, c] = corners.map(view);
            orient2d(a, b, c) == Sign::Zero
        })
    };
    let triangle = triangles.iter().position(is_line)?;
    Some(Defect::NoArea { triangle })
}

fn open(triangles: &[[u32; 3]]) -> Option<Defect> {
    let mut is_odd: FxHashMap<[u32; 2], bool> = FxHashMap::default();
    for &[a, b, c] in triangles {
        for [from, to] in [[a, b], [b, c], [c, a]] {
            *is_odd.entry([from.min(to), from.max(to)]).or_default() ^= true;
        }
    }
    // The least one, for the order in a map means nothing.
    let odd = is_odd.into_iter().filter(|&(_, is_odd)| is_odd);
    let edge = odd.map(|(edge, _)| edge).min()?;
    Some(Defect::Open { edge })
}

fn intersection(solid: &Solid) -> Option<Defect> {
    let place = |v: VertexId| solid.points[v.index()];
    let ids = |triangle: usize| solid.triangles[triangle].map(|v| VertexId::new(v as usize));
    let extents: Vec<Extent> = (0..solid.triangles.len())
        .map(|triangle| Extent::of(&ids(triangle).map(place)))
        .collect();
    let triangles = overlaps::find(&extents, |[first, second]| {
        triangles_intersect(place, ids(first), ids(second))
    })?;
    Some(Defect::Intersection { triangles })
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::dvec3;

    fn tetrahedron() -> Solid {
        Solid {
            name: String::new(),
            points: vec![DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z],
            triangles: vec![[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]],
        }
    }

    #[test]
    fn a_tetrahedron_has_no_defect_and_every_defect_is_found() {
        assert_eq!(defect(&tetrahedron()), None);
        let broken = |breaking: fn(&mut Solid)| {
            let mut solid = tetrahedron();
            breaking(&mut solid);
            defect(&solid)
        };
        assert_eq!(broken(|solid| solid.triangles.clear()), Some(Defect::Empty));
        assert_eq!(
            broken(|solid| solid.points[0].x = f64::NAN),
            Some(Defect::Coordinate)
        );
        assert_eq!(
            broken(|solid| solid.triangles[1][0] = 3),
            Some(Defect::Corner { triangle: 1 })
        );
        assert_eq!(
            broken(|solid| solid.points[2] = dvec3(1.0, -0.0, 0.0)),
            Some(Defect::Repeated { point: 2 })
        );
        assert_eq!(
            broken(|solid| solid.points.push(DVec3::ONE)),
            Some(Defect::Unused { point: 4 })
        );
        assert_eq!(
            broken(|solid| solid.points[2] = dvec3(2.0, 0.0, 0.0)),
            Some(Defect::NoArea { triangle: 0 })
        );
        assert_eq!(
            broken(|solid| solid.triangles.truncate(3)),
            Some(Defect::Open { edge: [0, 2] })
        );
    }

    #[test]
    fn two_tetrahedra_through_each_other_are_found() {
        let mut solid = tetrahedron();
        solid
            .points
            .extend(tetrahedron().points.iter().map(|p| *p + 0.1));
        solid.triangles.extend(
            tetrahedron()
                .triangles
                .iter()
                .map(|corners| corners.map(|v| v + 4)),
        );
        assert!(matches!(defect(&solid), Some(Defect::Intersection { .. })));
    }
}
