//! Empty circles and empty spheres: which points lie inside the ball through others.

use crate::coordinate::are_accepted;
use crate::filter::{Filter2, Filter3, Relative2, Relative3};
use crate::grid::{Grid, cross, dot, minus};
use crate::orient::{coord, coord3, volume};
use crate::sign::Sign;
use crate::statistics::{Predicate, Stage, record};
use crate::wide::Wide;
use glam::{DVec2, DVec3};

/// Side of the circle through `a`, `b`, `c` on which `d` lies.
///
/// `Positive` when `d` is strictly inside the circle of the counterclockwise `a`, `b`, `c`; swapping
/// two of them flips the sign. `Zero` exactly when the four points are on one circle or line.
/// Exact for accepted coordinates (see [`coordinate`](crate::coordinate)).
#[inline]
#[must_use]
pub fn in_circle(a: DVec2, b: DVec2, c: DVec2, d: DVec2) -> Sign {
    let [ad, bd, cd] = [a, b, c].map(|corner| Relative2::new(corner, d));
    Filter2::GENERAL
        .in_circle_relative(&ad, &bd, &cd)
        .unwrap_or_else(|| exact_in_circle(a, b, c, d))
}

/// Side of the sphere through `a`, `b`, `c`, `d` on which `e` lies.
///
/// `Positive` when `e` is strictly inside the sphere of the right-handed `a`, `b`, `c`, `d`;
/// swapping two of them flips the sign. `Zero` exactly when the five points are on one sphere or
/// plane. Exact for accepted coordinates (see [`coordinate`](crate::coordinate)).
#[inline]
#[must_use]
pub fn in_sphere(a: DVec3, b: DVec3, c: DVec3, d: DVec3, e: DVec3) -> Sign {
    let [ae, be, ce, de] = [a, b, c, d].map(|corner| Relative3::new(corner, e));
    Filter3::GENERAL
        .in_sphere_relative(&ae, &be, &ce, &de)
        .unwrap_or_else(|| exact_in_sphere(a, b, c, d, e))
}

#[cold]
#[inline(never)]
fn exact_in_circle(a: DVec2, b: DVec2, c: DVec2, d: DVec2) -> Sign {
    let points = [a, b, c, d].map(|point| point.to_array());
    let Some([a, b, c, d]) = Grid::of_points(points) else {
        if !are_accepted(points.as_flattened()) {
            return Sign::Zero; // Expansions of what is no number grow to full length.
        }
        record(Predicate::InCircle, Stage::Unbounded);
        return Sign::of(robust::incircle(coord(a), coord(b), coord(c), coord(d)));
    };
    record(Predicate::InCircle, Stage::Grid);
    let rows = [a, b, c].map(|corner| minus(corner, d));
    below_plane(rows, rows.map(|row| dot(row, row)))
}

#[cold]
#[inline(never)]
fn exact_in_sphere(a: DVec3, b: DVec3, c: DVec3, d: DVec3, e: DVec3) -> Sign {
    let points = [a, b, c, d, e].map(|point| point.to_array());
    let Some([a, b, c, d, e]) = Grid::of_points(points) else {
        if !are_accepted(points.as_flattened()) {
            return Sign::Zero; // Expansions of what is no number grow to full length.
        }
        record(Predicate::InSphere, Stage::Unbounded);
        let [a, b, c, d, e] = [a, b, c, d, e].map(coord3);
        return -Sign::of(robust::insphere(a, b, c, d, e));
    };
    record(Predicate::InSphere, Stage::Grid);
    let rows = [a, b, c, d].map(|corner| minus(corner, e));
    below_hyperplane(rows, rows.map(|row| dot(row, row)))
}

/// Whether the origin is below the plane of three points of the plane, lifted.
pub(crate) fn below_plane([a, b, c]: [[i64; 2]; 3], lifts: [i128; 3]) -> Sign {
    let [la, lb, lc] = lifts.map(Wide::from);
    let [bc, ca, ab] = [cross(b, c), cross(c, a), cross(a, b)].map(Wide::from);
    (la.times::<2, 4>(bc) + lb.times(ca) + lc.times(ab)).sign()
}

/// Whether the origin is below the hyperplane of four points of space, lifted.
pub(crate) fn below_hyperplane([a, b, c, d]: [[i64; 3]; 4], lifts: [i128; 4]) -> Sign {
    let [la, lb, lc, ld] = lifts.map(Wide::from);
    let (ab, bc, cd, da) = (cross(a, b), cross(b, c), cross(c, d), cross(d, a));
    let (ac, bd) = (cross(a, c), cross(b, d));
    let abc = volume([a, b, c], [bc, -ac, ab]);
    let bcd = volume([b, c, d], [cd, -bd, bc]);
    let cda = volume([c, d, a], [da, ac, cd]);
    let dab = volume([d, a, b], [ab, bd, da]);
    let one = la.times::<3, 5>(bcd) + lc.times(dab);
    (one - (lb.times(cda) + ld.times(abc))).sign()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_inside_of_a_counterclockwise_circle_is_positive() {
        let [a, b, c] = [DVec2::ZERO, DVec2::X, DVec2::Y];
        assert_eq!(in_circle(a, b, c, DVec2::splat(0.5)), Sign::Positive);
        assert_eq!(in_circle(b, a, c, DVec2::splat(0.5)), Sign::Negative);
        assert_eq!(in_circle(a, b, c, DVec2::ONE), Sign::Zero);
        assert_eq!(in_circle(a, b, c, DVec2::splat(1.5)), Sign::Negative);
    }

    #[test]
    fn the_inside_of_a_right_handed_sphere_is_positive() {
        let [a, b, c, d] = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z];
        assert_eq!(in_sphere(a, b, c, d, DVec3::splat(0.5)), Sign::Positive);
        assert_eq!(in_sphere(b, a, c, d, DVec3::splat(0.5)), Sign::Negative);
        assert_eq!(in_sphere(a, b, c, d, DVec3::ONE), Sign::Zero);
        assert_eq!(in_sphere(a, b, c, d, DVec3::splat(1.5)), Sign::Negative);
    }
}
