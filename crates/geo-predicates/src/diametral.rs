//! Diametral balls: the smallest ball through two points, or through the corners of a triangle.
//!
//! A tetrahedron's circumcenter lies beyond its facet `abc` exactly when its apex is strictly
//! inside the diametral ball of `abc`, so one exact sign serves both the flow relation and the
//! boundary test of sink insertion (Edelsbrunner & Guoy §3.3, §5.1).
//!
//! With `u`, `v`, `w` the vectors from `a` to `b`, `c`, `p`, and `n = u x v`, the power of `p` with
//! respect to the ball of `abc`, times `|n|^2`, is `n . (|u|^2 v x w + |v|^2 w x u + |w|^2 u x v)`.
//! Its degree is 6, so at the ends of the accepted range it leaves that of the doubles: then the
//! filter does not apply, and the exact stage works on integers, which have no such ends.

use crate::filter;
use crate::grid::{self, Grid};
use crate::sign::Sign;
use crate::statistics::{Predicate, Stage, record};
use crate::unbounded::{self, integers};
use crate::wide::Wide;
use glam::{DVec2, DVec3};
use num_bigint::BigInt;

/// Side of the circle with diameter `ab` on which `p` lies.
///
/// `Positive` when `p` is strictly inside: the angle `apb` is obtuse. `Zero` on the circle, for
/// instance at `a` and `b`; never `Positive` when `a == b`. Symmetric in `a` and `b`.
/// Exact for accepted coordinates (see [`coordinate`](crate::coordinate)).
#[inline]
#[must_use]
pub fn in_diametral_circle(a: DVec2, b: DVec2, p: DVec2) -> Sign {
    filter::in_diametral_circle(a - p, b - p).unwrap_or_else(|| {
        exact_obtuse(
            Predicate::InDiametralCircle,
            [a, b, p].map(|point| point.to_array()),
        )
    })
}

/// Side of the sphere with diameter `ab` on which `p` lies.
///
/// `Positive` when `p` is strictly inside: the angle `apb` is obtuse. `Zero` on the sphere, for
/// instance at `a` and `b`; never `Positive` when `a == b`. Symmetric in `a` and `b`.
/// Exact for accepted coordinates (see [`coordinate`](crate::coordinate)).
#[inline]
#[must_use]
pub fn in_diametral_sphere(a: DVec3, b: DVec3, p: DVec3) -> Sign {
    filter::in_diametral_sphere(a - p, b - p).unwrap_or_else(|| {
        exact_obtuse(
            Predicate::InDiametralSphere,
            [a, b, p].map(|point| point.to_array()),
        )
    })
}

/// Side of the diametral sphere of the triangle `abc` on which `p` lies.
///
/// That sphere has the circumcircle of `abc` as a great circle; it is the smallest through the
/// three corners. `Positive` when `p` is strictly inside, `Zero` on the sphere. The order of `a`,
/// `b`, `c` does not matter. Collinear corners have no circumcircle: the answer is `Zero` for
/// every `p`. Exact for accepted coordinates (see [`coordinate`](crate::coordinate)).
#[inline]
#[must_use]
pub fn in_diametral_ball(a: DVec3, b: DVec3, c: DVec3, p: DVec3) -> Sign {
    filter::in_diametral_ball(b - a, c - a, p - a)
        .unwrap_or_else(|| exact_in_diametral_ball(a, b, c, p))
}

/// Whether the angle `apb` is obtuse.
#[cold]
#[inline(never)]
fn exact_obtuse<const N: usize>(predicate: Predicate, points: [[f64; N]; 3]) -> Sign {
    if let Some([a, b, p]) = Grid::of_points(points) {
        record(predicate, Stage::Grid);
        return -Wide::from(grid::dot(grid::minus(a, p), grid::minus(b, p))).sign();
    }
    record(predicate, Stage::Unbounded);
    let [a, b, p] = integers(points);
    -unbounded::sign(&unbounded::dot(
        &unbounded::minus(&a, &p),
        &unbounded::minus(&b, &p),
    ))
}

#[cold]
#[inline(never)]
fn exact_in_diametral_ball(a: DVec3, b: DVec3, c: DVec3, p: DVec3) -> Sign {
    let points = [a, b, c, p].map(|point| point.to_array());
    if let Some([a, b, c, p]) = Grid::of_points(points) {
        record(Predicate::InDiametralBall, Stage::Grid);
        return ball_on_grid([b, c, p].map(|corner| grid::minus(corner, a)));
    }
    record(Predicate::InDiametralBall, Stage::Unbounded);
    ball_of_integers(&integers(points))
}

/// The sign for the vectors `[u, v, w]`.
fn ball_on_grid([u, v, w]: [[i64; 3]; 3]) -> Sign {
    let [uu, vv, ww] = [u, v, w].map(|vector| Wide::from(grid::dot(vector, vector)));
    let outside = [[1, 2], [2, 0], [0, 1]].map(|axes| {
        let project = |vector: [i64; 3]| axes.map(|axis| vector[axis]);
        let [u, v, w] = [u, v, w].map(project);
        let [vw, wu, uv] = [(v, w), (w, u), (u, v)].map(|(s, t)| Wide::from(grid::cross(s, t)));
        let lifted: Wide<4> = uu.times(vw) + vv.times(wu) + ww.times(uv);
        uv.times::<4, 6>(lifted)
    });
    let [x, y, z] = outside;
    -(x + y + z).sign()
}

fn ball_of_integers([a, b, c, p]: &[[BigInt; 3]; 4]) -> Sign {
    let [u, v, w] = [b, c, p].map(|corner| unbounded::minus(corner, a));
    let [uu, vv, ww] = [&u, &v, &w].map(|vector| unbounded::dot(vector, vector));
    let outside = [[1, 2], [2, 0], [0, 1]].map(|[i, j]| {
        let area = |s: &[BigInt; 3], t: &[BigInt; 3]| &s[i] * &t[j] - &s[j] * &t[i];
        let uv = area(&u, &v);
        (&uu * area(&v, &w) + &vv * area(&w, &u) + &ww * &uv) * uv
    });
    -unbounded::sign(&outside.into_iter().sum())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_middle_of_the_diameter_is_inside() {
        let (a, b) = (DVec2::ZERO, DVec2::new(2.0, 0.0));
        assert_eq!(in_diametral_circle(a, b, DVec2::X), Sign::Positive);
        assert_eq!(in_diametral_circle(a, b, DVec2::ONE), Sign::Zero);
        assert_eq!(in_diametral_circle(a, b, a), Sign::Zero);
        assert_eq!(
            in_diametral_circle(a, b, DVec2::new(1.0, -1.1)),
            Sign::Negative
        );
        assert_eq!(in_diametral_circle(a, a, DVec2::X), Sign::Negative);
    }

    #[test]
    fn the_sphere_of_a_segment_is_round() {
        let (a, b) = (DVec3::ZERO, DVec3::new(2.0, 0.0, 0.0));
        assert_eq!(in_diametral_sphere(a, b, DVec3::X), Sign::Positive);
        assert_eq!(
            in_diametral_sphere(a, b, DVec3::new(1.0, 0.0, 1.0)),
            Sign::Zero
        );
        assert_eq!(in_diametral_sphere(a, b, DVec3::ONE), Sign::Negative);
    }

    #[test]
    fn the_ball_of_a_triangle_has_its_circumcircle_as_great_circle() {
        let [a, b, c] = [DVec3::ZERO, DVec3::X * 2.0, DVec3::Y * 2.0];
        let center = DVec3::new(1.0, 1.0, 0.0);
        for corners in [[a, b, c], [b, a, c], [c, b, a]] {
            let [a, b, c] = corners;
            assert_eq!(in_diametral_ball(a, b, c, center), Sign::Positive);
            assert_eq!(
                in_diametral_ball(a, b, c, center + DVec3::Z * 1.4),
                Sign::Positive
            );
            assert_eq!(
                in_diametral_ball(a, b, c, center - DVec3::Z * 1.5),
                Sign::Negative
            );
            assert_eq!(
                in_diametral_ball(a, b, c, DVec3::new(2.0, 2.0, 0.0)),
                Sign::Zero
            );
            assert_eq!(in_diametral_ball(a, b, c, c), Sign::Zero);
        }
    }

    #[test]
    fn collinear_corners_have_no_ball() {
        let p = DVec3::new(0.1, 0.2, 0.3);
        assert_eq!(
            in_diametral_ball(DVec3::ZERO, DVec3::X, DVec3::X * 2.0, p),
            Sign::Zero
        );
        assert_eq!(in_diametral_ball(p, p, p, DVec3::X), Sign::Zero);
    }
}
