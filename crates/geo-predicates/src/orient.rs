//! Which way points turn: orientation in the plane and in space.

use crate::coordinate::are_accepted;
use crate::filter::{Filter2, Filter3};
use crate::grid::{Grid, cross, minus};
use crate::sign::Sign;
use crate::statistics::{Predicate, Stage, record};
use crate::wide::Wide;
use glam::{DVec2, DVec3};
use robust::{Coord, Coord3D};

/// Sign of the signed area of the triangle `abc`.
///
/// `Positive` when `a`, `b`, `c` turn counterclockwise, `Zero` exactly when they are collinear.
/// Exact for accepted coordinates (see [`coordinate`](crate::coordinate)).
#[inline]
#[must_use]
pub fn orient2d(a: DVec2, b: DVec2, c: DVec2) -> Sign {
    Filter2::GENERAL
        .orient2d(a, b, c)
        .unwrap_or_else(|| exact_orient2d(a, b, c))
}

/// Sign of the signed volume of the tetrahedron `abcd`.
///
/// `Positive` when `abcd` is right-handed: seen from `d`, the corners `a`, `b`, `c` turn
/// counterclockwise. `Zero` exactly when the four points are coplanar.
/// Exact for accepted coordinates (see [`coordinate`](crate::coordinate)).
#[inline]
#[must_use]
pub fn orient3d(a: DVec3, b: DVec3, c: DVec3, d: DVec3) -> Sign {
    Filter3::GENERAL
        .orient3d(a, b, c, d)
        .unwrap_or_else(|| exact_orient3d(a, b, c, d))
}

#[cold]
#[inline(never)]
fn exact_orient2d(a: DVec2, b: DVec2, c: DVec2) -> Sign {
    let points = [a, b, c].map(|point| point.to_array());
    let Some([a, b, c]) = Grid::of_points(points) else {
        if !are_accepted(points.as_flattened()) {
            return Sign::Zero; // Expansions of what is no number grow to full length.
        }
        record(Predicate::Orient2d, Stage::Unbounded);
        return Sign::of(robust::orient2d(coord(a), coord(b), coord(c)));
    };
    record(Predicate::Orient2d, Stage::Grid);
    Wide::from(cross(minus(a, c), minus(b, c))).sign()
}

#[cold]
#[inline(never)]
fn exact_orient3d(a: DVec3, b: DVec3, c: DVec3, d: DVec3) -> Sign {
    let points = [a, b, c, d].map(|point| point.to_array());
    let Some([a, b, c, d]) = Grid::of_points(points) else {
        if !are_accepted(points.as_flattened()) {
            return Sign::Zero; // Expansions of what is no number grow to full length.
        }
        record(Predicate::Orient3d, Stage::Unbounded);
        return -Sign::of(robust::orient3d(coord3(a), coord3(b), coord3(c), coord3(d)));
    };
    record(Predicate::Orient3d, Stage::Grid);
    let [a, b, c] = [a, b, c].map(|corner| minus(corner, d));
    (-volume([a, b, c], [cross(b, c), cross(c, a), cross(a, b)])).sign()
}

/// Determinant of three rows, from the minors `[bc, ca, ab]` of their first two columns.
#[inline]
pub(crate) fn volume([a, b, c]: [[i64; 3]; 3], minors: [i128; 3]) -> Wide<3> {
    let [bc, ca, ab] = minors.map(Wide::from);
    let height = |row: [i64; 3]| Wide::from(row[2]);
    height(a).times(bc) + height(b).times(ca) + height(c).times(ab)
}

pub(crate) fn coord(p: DVec2) -> Coord<f64> {
    Coord { x: p.x, y: p.y }
}

pub(crate) fn coord3(p: DVec3) -> Coord3D<f64> {
    Coord3D {
        x: p.x,
        y: p.y,
        z: p.z,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counterclockwise_corners_are_positive() {
        let (a, b) = (DVec2::ZERO, DVec2::X);
        assert_eq!(orient2d(a, b, DVec2::Y), Sign::Positive);
        assert_eq!(orient2d(b, a, DVec2::Y), Sign::Negative);
        assert_eq!(orient2d(a, b, DVec2::new(3.0, 0.0)), Sign::Zero);
    }

    #[test]
    fn the_right_handed_unit_tetrahedron_is_positive() {
        let o = DVec3::ZERO;
        assert_eq!(orient3d(o, DVec3::X, DVec3::Y, DVec3::Z), Sign::Positive);
        assert_eq!(orient3d(DVec3::X, o, DVec3::Y, DVec3::Z), Sign::Negative);
        assert_eq!(
            orient3d(o, DVec3::X, DVec3::Y, DVec3::ONE - DVec3::Z),
            Sign::Zero
        );
    }
}
