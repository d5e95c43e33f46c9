//! Diametral balls: the smallest ball through two points, or through the corners of a triangle.
//!
//! A tetrahedron's circumcenter lies beyond its facet `abc` exactly when its apex is strictly
//! inside the diametral ball of `abc`, so one exact sign serves both the flow relation and the
//! boundary test of sink insertion (Edelsbrunner & Guoy §3.3, §5.1).

use crate::sign::Sign;
use crate::unbounded::{dot, integers, minus, sign};
use glam::{DVec2, DVec3};

/// Side of the circle with diameter `ab` on which `p` lies.
///
/// `Positive` when `p` is strictly inside: the angle `apb` is obtuse. `Zero` on the circle, for
/// instance at `a` and `b`; never `Positive` when `a == b`. Symmetric in `a` and `b`.
/// Exact for accepted coordinates (see [`coordinate`](crate::coordinate)).
#[must_use]
pub fn in_diametral_circle(a: DVec2, b: DVec2, p: DVec2) -> Sign {
    let [ax, ay, bx, by, px, py] = integers([a.x, a.y, b.x, b.y, p.x, p.y]);
    let p = [px, py];
    -sign(&dot(&minus(&[ax, ay], &p), &minus(&[bx, by], &p)))
}

/// Side of the sphere with diameter `ab` on which `p` lies.
///
/// `Positive` when `p` is strictly inside: the angle `apb` is obtuse. `Zero` on the sphere, for
/// instance at `a` and `b`; never `Positive` when `a == b`. Symmetric in `a` and `b`.
/// Exact for accepted coordinates (see [`coordinate`](crate::coordinate)).
#[must_use]
pub fn in_diametral_sphere(a: DVec3, b: DVec3, p: DVec3) -> Sign {
    let [ax, ay, az, bx, by, bz, px, py, pz] =
        integers([a.x, a.y, a.z, b.x, b.y, b.z, p.x, p.y, p.z]);
    let p = [px, py, pz];
    -sign(&dot(&minus(&[ax, ay, az], &p), &minus(&[bx, by, bz], &p)))
}

/// Side of the diametral sphere of the triangle `abc` on which `p` lies.
///
/// That sphere has the circumcircle of `abc` as a great circle; it is the smallest through the
/// three corners. `Positive` when `p` is strictly inside, `Zero` on the sphere. The order of `a`,
/// `b`, `c` does not matter. Collinear corners have no circumcircle: the answer is `Zero` for
/// every `p`. Exact for accepted coordinates (see [`coordinate`](crate::coordinate)).
#[must_use]
pub fn in_diametral_ball(a: DVec3, b: DVec3, c: DVec3, p: DVec3) -> Sign {
    let [ax, ay, az, bx, by, bz, cx, cy, cz, px, py, pz] =
        integers([a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z, p.x, p.y, p.z]);
    let a = [ax, ay, az];
    let u = minus(&[bx, by, bz], &a);
    let v = minus(&[cx, cy, cz], &a);
    let w = minus(&[px, py, pz], &a);
    let (uu, uv, vv) = (dot(&u, &u), dot(&u, &v), dot(&v, &v));
    let (uw, vw, ww) = (dot(&u, &w), dot(&v, &w), dot(&w, &w));
    let inside = &uu * (&uw * &vv - &vw * &uv) + &vv * (&vw * &uu - &uw * &uv)
        - (&uu * &vv - &uv * &uv) * ww;
    sign(&inside)
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
