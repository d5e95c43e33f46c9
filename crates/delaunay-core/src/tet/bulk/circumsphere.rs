//! Cached circumspheres: most in-sphere tests in ten instructions, with a proved tolerance.
//!
//! A cavity search asks some 85 times per point whether the point is inside a circumsphere. The
//! determinant loads four vertices; a stored center and squared radius load one record and no vertex,
//! and decide all but one in ten thousand tests on generic input. What they leave open goes to the exact
//! predicate.
//!
//! # The tolerance
//! Let `u = 2^-53`, the new vertex `p`, the others `A`, `B`, `C`, and `a = fl(A - p)` and so on. Stars
//! mark what the exact differences would give. With `P = |a| |b| |c|`,
//! ```text
//! D = a . (b x c)
//! V = |a|^2 (b x c) + |b|^2 (c x a) + |c|^2 (a x b)
//! N = V / D, twice the center relative to p
//! ```
//! Counting the roundings of each product (a fused multiply-add only saves some):
//! 1. The vector with the components `|b_y c_z| + |b_z c_y|` has length at most `sqrt(4/3) |b| |c|`.
//! 2. `D`: 3 differences, 2 in the minor, 1, 2 sums: `|D - D*| <= 8 sqrt(4/3) u P <= 9.3 u P`.
//! 3. `V`: 5 in `|a|^2`, 2 in `b` and `c`, 2 in the minor, 1, 2 sums:
//!    `|V - V*| <= 12 sqrt(4/3) u P (|a| + |b| + |c|) <= 41.7 u P |N*|`, as `p` and `A` lie on the sphere of
//!    diameter `|N*|`.
//! 4. `N - N* = ((V - V*) - N* (D - D*)) / D` up to the rounding of the quotient, so
//!    `|N - N*| <= rho |N*|` with `rho = 51 u P / |D| + 3 u`. `D` is the computed one: no circle.
//! 5. A sphere is kept if `|a|^2 |b|^2 |c|^2 <= 2^44 D^2`, hence `rho <= 2^-25.3`.
//! 6. The stored center is `fl(p + N / 2)`, off by another `u |c|_1`: it is kept if `|c|_1^2 <= 2^54 r^2`, so
//!    that center and radius are both within `eta R* <= 2^-24 R*` of the true ones.
//! 7. With `q = fl(|e - c|^2)`, off by `5 u`: `e` not inside means `|e - c| >= (1 - eta) R*`, and not outside
//!    means `|e - c| <= (1 + eta) R*`. So `q < r^2 (1 - tau)` proves inside and `q > r^2 (1 + tau)` outside
//!    for any `tau >= 4 eta + 2^-24 + 11 u`, where `2^-24` is the rounding of `r^2` to single precision.
//!    That is `3.0e-7`; [`TOLERANCE`] is `2^-21 = 4.8e-7`.
//!
//! Spheres out of the range of the single precision, or whose products would underflow, are not kept.
//! A sphere that is not kept has the radius NaN, and so has every ghost, whose vertex at infinity has
//! coordinates that are not numbers: no comparison with them holds.

use glam::DVec3;

/// Half-width of the shell round a cached sphere in which the exact predicate decides, over its squared
/// radius.
pub(super) const TOLERANCE: f64 = 1.0 / 2_097_152.0;

/// Greatest `P^2 / D^2` of a sphere that is kept.
pub(super) const MAX_CONDITION2: f64 = 17_592_186_044_416.0;
/// Greatest `|c|_1^2 / r^2` of a sphere that is kept.
pub(super) const MAX_OFFSET2: f64 = 18_014_398_509_481_984.0;
/// Least `P^2` of a sphere that is kept.
pub(super) const MIN_PRODUCT2: f64 = 1e-280;
/// Least and greatest squared radius of a sphere that is kept.
pub(super) const RADIUS2: [f64; 2] = [1e-30, 1e36];

/// The circumsphere of a tetrahedron, and a stamp for the cavity search.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(32))]
pub(super) struct Circumsphere {
    pub(super) center: [f64; 3],
    /// NaN when the sphere is not known well enough.
    pub(super) radius2: f32,
    /// Twice the number of the insertion that met the tetrahedron last, plus one if it was in the cavity.
    pub(super) stamp: u32,
}

/// A vertex relative to a new one, with its squared length.
pub(super) type Arm = [f64; 4];

impl Circumsphere {
    /// No sphere: every test goes to the exact predicate.
    pub(super) const UNKNOWN: Self = Self {
        center: [f64::NAN; 3],
        radius2: f32::NAN,
        stamp: 0,
    };

    /// The sphere through `p` and the ends of three arms from it.
    #[inline(always)]
    pub(super) fn through(p: DVec3, a: &Arm, b: &Arm, c: &Arm) -> Self {
        let minor = |b: &Arm, c: &Arm| {
            [
                b[1] * c[2] - b[2] * c[1],
                b[2] * c[0] - b[0] * c[2],
                b[0] * c[1] - b[1] * c[0],
            ]
        };
        let (bc, ca, ab) = (minor(b, c), minor(c, a), minor(a, b));
        let d = a[0] * bc[0] + a[1] * bc[1] + a[2] * bc[2];
        let half = 0.5 / d;
        let arm = [0, 1, 2].map(|k| half * (a[3] * bc[k] + b[3] * ca[k] + c[3] * ab[k]));
        let radius2 = arm[0] * arm[0] + arm[1] * arm[1] + arm[2] * arm[2];
        let center = [p.x + arm[0], p.y + arm[1], p.z + arm[2]];
        let offset = center[0].abs() + center[1].abs() + center[2].abs();
        let product2 = a[3] * (b[3] * c[3]);
        let known = product2 <= MAX_CONDITION2 * (d * d)
            && product2 >= MIN_PRODUCT2
            && offset * offset <= MAX_OFFSET2 * radius2
            && (RADIUS2[0]..=RADIUS2[1]).contains(&radius2);
        Self {
            center,
            radius2: if known { radius2 as f32 } else { f32::NAN },
            stamp: 0,
        }
    }

    /// The squared radius less the squared distance of `e` from the center, and the tolerance below
    /// which the sign of that says nothing.
    #[inline(always)]
    pub(super) fn depth(&self, e: DVec3) -> (f64, f64) {
        let [x, y, z] = self.center;
        let (x, y, z) = (e.x - x, e.y - y, e.z - z);
        let radius2 = f64::from(self.radius2);
        (radius2 - (x * x + y * y + z * z), TOLERANCE * radius2)
    }

    /// Whether `e` is certainly inside.
    #[inline(always)]
    pub(super) fn surely_contains(&self, e: DVec3) -> bool {
        let (depth, tolerance) = self.depth(e);
        depth > tolerance
    }
}

/// `v` as seen from `p`.
#[inline(always)]
pub(super) fn arm(v: DVec3, p: DVec3) -> Arm {
    let d = v - p;
    [d.x, d.y, d.z, d.x * d.x + d.y * d.y + d.z * d.z]
}

#[cfg(test)]
mod tests {
    use super::*;
    use geo_predicates::{Sign, in_sphere, orient3d};
    use proptest::prelude::*;

    /// Clusters, lattices, slivers, anything.
    fn coordinate() -> impl Strategy<Value = f64> {
        prop_oneof![
            -1.0..1.0,
            (-8i32..=8).prop_map(|i| f64::from(i) * 0.1),
            (-1.0..1.0).prop_map(|x: f64| 0.7 + x * 1e-7),
            (-4i32..=4).prop_map(|k| 0.5 * (1.0 + f64::from(k) * f64::EPSILON)),
        ]
    }

    fn point() -> impl Strategy<Value = DVec3> {
        [coordinate(), coordinate(), coordinate()].prop_map(DVec3::from_array)
    }

    /// `e` put next to the sphere of the others.
    fn near_sphere(corners: [DVec3; 4], direction: DVec3, ulps: f64) -> DVec3 {
        let [p, a, b, c] = corners;
        let sphere = Circumsphere::through(p, &arm(a, p), &arm(b, p), &arm(c, p));
        let radius = f64::from(sphere.radius2).sqrt() * (1.0 + ulps * 1e-8);
        DVec3::from_array(sphere.center) + direction.normalize_or(DVec3::X) * radius
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(20_000))]

        #[test]
        fn what_a_cached_sphere_decides_is_right(
            [p, a, b, c, e] in [point(), point(), point(), point(), point()],
            close: bool,
            ulps in -100.0..100.0,
        ) {
            let right = orient3d(p, a, b, c);
            prop_assume!(right != Sign::Zero);
            let sphere = Circumsphere::through(p, &arm(a, p), &arm(b, p), &arm(c, p));
            let e = if close { near_sphere([p, a, b, c], e, ulps) } else { e };
            prop_assume!(e.is_finite());
            let (depth, tolerance) = sphere.depth(e);
            if depth.abs() > tolerance {
                let inside = if right == Sign::Positive { in_sphere(p, a, b, c, e) } else { in_sphere(a, p, b, c, e) };
                prop_assert_eq!(inside, Sign::of(depth));
            }
        }
    }

    #[test]
    fn a_ghost_and_a_flat_tetrahedron_have_no_sphere() {
        let p = DVec3::ZERO;
        let [x, y, far] = [DVec3::X, DVec3::Y, DVec3::NAN].map(|v| arm(v, p));
        let flat = arm(DVec3::new(0.3, 0.4, 0.0), p);
        for last in [&far, &flat] {
            let sphere = Circumsphere::through(p, &x, &y, last);
            assert!(sphere.radius2.is_nan());
            assert!(!sphere.surely_contains(DVec3::splat(0.1)));
        }
    }
}
