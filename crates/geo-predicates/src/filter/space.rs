//! Filters for space.

use super::{certain, exact_up_to};
use crate::few_bits::extent;
use crate::sign::Sign;
use crate::statistics::{Predicate, Stage, record};
use glam::DVec3;

const ORIENT3D: f64 = 7.78e-16;
const IN_SPHERE: f64 = 2.6e-16;
const DIAMETRAL_SPHERE: f64 = 5.6e-16;
/// Half of what the table says: it multiplies the doubled size.
const DIAMETRAL_BALL: f64 = 1.25e-15;
const POWER_SPHERE: f64 = 3.3e-16;

/// Greatest extents, in units of the lowest bit, for which the doubles are exact.
const FEW_BITS_ORIENT3D: f64 = 114_501.0;
const FEW_BITS_IN_SPHERE: f64 = 659.0;

/// Vector from the query point to a vertex of space, with its squared length.
#[derive(Clone, Copy, Debug)]
pub struct Relative3 {
    vector: DVec3,
    lift: f64,
    size: f64,
}

impl Relative3 {
    /// The vertex `point` seen from the query point `from`.
    #[inline(always)]
    #[must_use]
    pub fn new(point: DVec3, from: DVec3) -> Self {
        let vector = point - from;
        let DVec3 { x, y, z } = vector;
        let size = x.abs() + y.abs() + z.abs();
        Self {
            vector,
            lift: x * x + y * y + z * z,
            size,
        }
    }

    /// True when the two points are equal (the difference of distinct doubles is not zero).
    #[inline(always)]
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.vector == DVec3::ZERO
    }
}

/// Filters for space; see the [module](super).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Filter3 {
    orient: f64,
    sphere: f64,
}

impl Filter3 {
    /// Valid for all accepted coordinates.
    pub const GENERAL: Self = Self {
        orient: ORIENT3D,
        sphere: IN_SPHERE,
    };

    /// The best filter for `points`: exact where they have few bits. It holds for any subset of
    /// `points`, and for no other point. Linear, but stops early when the points have many bits.
    #[must_use]
    pub fn for_points(points: &[DVec3]) -> Self {
        let extent = extent(points.iter().map(DVec3::to_array), FEW_BITS_ORIENT3D);
        Self {
            orient: exact_up_to(FEW_BITS_ORIENT3D, extent, Self::GENERAL.orient),
            sphere: exact_up_to(FEW_BITS_IN_SPHERE, extent, Self::GENERAL.sphere),
        }
    }

    /// `orient3d(a, b, c, p)`.
    #[inline(always)]
    #[must_use]
    pub fn orient_relative(&self, a: &Relative3, b: &Relative3, c: &Relative3) -> Option<Sign> {
        let volume = volume(a.vector, b.vector, c.vector);
        certain(
            Predicate::Orient3d,
            -volume,
            self.orient * (a.size * b.size * c.size),
        )
    }

    /// `orient3d(a, b, c, d)`, by a tighter bound that costs a little more than the relative form.
    #[inline(always)]
    #[must_use]
    pub fn orient3d(&self, a: DVec3, b: DVec3, c: DVec3, d: DVec3) -> Option<Sign> {
        let [a, b, c] = [a - d, b - d, c - d];
        let [(bc, bc_size), (ca, ca_size), (ab, ab_size)] =
            [sized_minor(b, c), sized_minor(c, a), sized_minor(a, b)];
        let volume = a.z * bc + b.z * ca + c.z * ab;
        let permanent = a.z.abs() * bc_size + b.z.abs() * ca_size + c.z.abs() * ab_size;
        certain(Predicate::Orient3d, -volume, self.orient * permanent)
    }

    /// `in_sphere(a, b, c, d, p)`.
    #[inline(always)]
    #[must_use]
    pub fn in_sphere_relative(
        &self,
        a: &Relative3,
        b: &Relative3,
        c: &Relative3,
        d: &Relative3,
    ) -> Option<Sign> {
        let sum = (a.lift + b.lift) + (c.lift + d.lift);
        certain(
            Predicate::InSphere,
            below_hyperplane([a, b, c, d], volumes_without([a, b, c, d])),
            self.sphere * (sum * sum * sum.sqrt()),
        )
    }

    /// Whether the query point is inside the sphere of the right-handed `corners`, ties broken as by
    /// [`in_sphere_perturbed`](crate::in_sphere_perturbed), when the doubles are exact for `in_sphere`; `None` when they are not
    /// or a corner is not a number.
    ///
    /// The corners are distinct points, none of them the query. A tie costs nothing: raising the lift of a corner adds
    /// to the determinant a multiple of the volume of the other three, which is at hand.
    #[inline(always)]
    #[must_use]
    pub fn in_exact_sphere(&self, corners: [&Relative3; 4]) -> Option<bool> {
        if self.sphere != 0.0 {
            return None;
        }
        let volumes = volumes_without(corners);
        let below = below_hyperplane(corners, volumes);
        if below.is_nan() {
            return None;
        }
        let stage = if below == 0.0 {
            Stage::Tie
        } else {
            Stage::Filter
        };
        record(Predicate::InSphere, stage);
        Some(below > 0.0 || (below == 0.0 && raised_inside(corners, volumes)))
    }
}

/// The answer to a tie: that of the greatest of the four corners and the query in lexicographic order whose raise
/// changes anything. The raise of the query lifts it out of the sphere.
///
/// Made for lattices, where a tie is the rule: no branch depends on the order of the corners.
#[inline(always)]
fn raised_inside(corners: [&Relative3; 4], volumes: [f64; 4]) -> bool {
    // Greater than any difference of coordinates in units of their lowest bit, so that keys are ordered as vectors are.
    const BASE: f64 = 2048.0;
    let mut greatest = 0;
    let mut inside = 0;
    for (corner, volume) in corners.into_iter().zip(volumes) {
        let DVec3 { x, y, z } = corner.vector;
        // Bits of doubles that are not negative are in the order of the doubles, and those of negative ones below.
        let key = ((x * BASE + y) * BASE + z).to_bits() as i64;
        let key = key * i64::from(volume != 0.0);
        let answer = i64::from(volume > 0.0);
        inside = if key > greatest { answer } else { inside };
        greatest = greatest.max(key);
    }
    inside != 0
}

/// `in_diametral_sphere(a, b, p)` of the vectors from `p` to `a` and `b`.
#[inline(always)]
pub(crate) fn in_diametral_sphere(a: DVec3, b: DVec3) -> Option<Sign> {
    let (x, y, z) = (a.x * b.x, a.y * b.y, a.z * b.z);
    certain(
        Predicate::InDiametralSphere,
        -(x + y + z),
        DIAMETRAL_SPHERE * (x.abs() + y.abs() + z.abs()),
    )
}

/// `in_diametral_ball(a, b, c, p)` of the vectors `u`, `v`, `w` from `a` to `b`, `c`, `p`.
///
/// The only determinant that can leave the range of the doubles: underflow loses less than the
/// least normal number, and before anything overflows the bound is infinite.
#[inline(always)]
pub(crate) fn in_diametral_ball(u: DVec3, v: DVec3, w: DVec3) -> Option<Sign> {
    let (uu, vv, ww) = (u.dot(u), v.dot(v), w.dot(w));
    let normal = u.cross(v);
    let outside = normal.dot(v.cross(w) * uu + w.cross(u) * vv + normal * ww);
    let size = 2.0 * (uu * vv * (uu + vv + 4.0 * ww));
    certain(
        Predicate::InDiametralBall,
        -outside,
        DIAMETRAL_BALL * size + f64::MIN_POSITIVE,
    )
}

/// `power_sphere(a, b, c, d, e)` of the vectors from `e` to `[a, b, c, d]` and the differences of
/// their weights to that of `e`.
#[inline(always)]
pub(crate) fn power_sphere(corners: [(DVec3, f64); 4]) -> Option<Sign> {
    let [a, b, c, d] = corners.map(|(vector, weight)| Relative3 {
        vector,
        lift: vector.dot(vector) - weight,
        size: f64::NAN,
    });
    let sizes = corners.map(|(vector, weight)| vector.dot(vector) + weight.abs());
    let sum = (sizes[0] + sizes[1]) + (sizes[2] + sizes[3]);
    certain(
        Predicate::PowerSphere,
        below_hyperplane([&a, &b, &c, &d], volumes_without([&a, &b, &c, &d])),
        POWER_SPHERE * (sum * sum * sum.sqrt()),
    )
}

/// Determinant of three rows.
#[inline(always)]
pub(super) fn volume(a: DVec3, b: DVec3, c: DVec3) -> f64 {
    let minor = |a: DVec3, b: DVec3| a.x * b.y - a.y * b.x;
    a.z * minor(b, c) + b.z * minor(c, a) + c.z * minor(a, b)
}

/// How far the origin is below the hyperplane of the lifted `corners`, times their volume, from the
/// [volumes](volumes_without).
#[inline(always)]
pub(super) fn below_hyperplane(corners: [&Relative3; 4], volumes: [f64; 4]) -> f64 {
    let [a, b, c, d] = std::array::from_fn(|i| corners[i].lift * volumes[i]);
    (c + d) + (a + b)
}

/// For each of four vectors the volume of the other three, with the sign it has in the determinant of the lifted four.
#[inline(always)]
pub(super) fn volumes_without([a, b, c, d]: [&Relative3; 4]) -> [f64; 4] {
    let (ab, bc, cd, da) = (minor(a, b), minor(b, c), minor(c, d), minor(d, a));
    let (ac, bd) = (minor(a, c), minor(b, d));
    let [az, bz, cz, dz] = [a.vector.z, b.vector.z, c.vector.z, d.vector.z];
    let abc = az * bc - bz * ac + cz * ab;
    let bcd = bz * cd - cz * bd + dz * bc;
    let cda = cz * da + dz * ac + az * cd;
    let dab = dz * ab + az * bd + bz * da;
    [bcd, -cda, dab, -abc]
}

/// `a.x b.y - a.y b.x`.
#[inline(always)]
fn minor(a: &Relative3, b: &Relative3) -> f64 {
    a.vector.x * b.vector.y - a.vector.y * b.vector.x
}

/// `a.x b.y - a.y b.x`, and the same with absolute values and a plus.
#[inline(always)]
fn sized_minor(a: DVec3, b: DVec3) -> (f64, f64) {
    let (left, right) = (a.x * b.y, a.y * b.x);
    (left - right, left.abs() + right.abs())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::in_ball::in_sphere;
    use crate::orient::orient3d;

    fn lattice(step: f64) -> Vec<DVec3> {
        let point = |i: i32| DVec3::from_array([i % 3, i / 3 % 3, i / 9].map(f64::from));
        (0..27).map(|i| point(i) * step).collect()
    }

    #[test]
    fn nan_is_never_certain() {
        let ghost = Relative3::new(DVec3::NAN, DVec3::ZERO);
        let [a, b, c] = [DVec3::X, DVec3::Y, DVec3::Z].map(|v| Relative3::new(v, DVec3::ZERO));
        for filter in [Filter3::GENERAL, Filter3::for_points(&[DVec3::X, DVec3::Y])] {
            assert_eq!(
                filter.orient3d(DVec3::X, DVec3::Y, DVec3::Z, DVec3::NAN),
                None
            );
            assert_eq!(filter.orient_relative(&a, &b, &ghost), None);
            assert_eq!(filter.in_sphere_relative(&a, &b, &ghost, &c), None);
        }
    }

    #[test]
    fn lattices_of_few_bits_are_always_certain() {
        let points = lattice(1.0 / 64.0);
        let filter = Filter3::for_points(&points);
        for &p in &points {
            for corners in points.windows(4) {
                let [a, b, c, d] = [corners[0], corners[1], corners[2], corners[3]];
                let [ap, bp, cp, dp] = [a, b, c, d].map(|corner| Relative3::new(corner, p));
                let above = Some(orient3d(a, b, c, p));
                assert_eq!(filter.orient_relative(&ap, &bp, &cp), above);
                assert_eq!(filter.orient3d(a, b, c, p), above);
                let inside = filter.in_sphere_relative(&ap, &bp, &cp, &dp);
                assert_eq!(inside, Some(in_sphere(a, b, c, d, p)));
            }
        }
    }

    #[test]
    fn many_bits_keep_the_general_filter() {
        assert_eq!(Filter3::for_points(&lattice(0.1)), Filter3::GENERAL);
        let wide = Filter3::for_points(&[DVec3::ZERO, DVec3::new(1e4, 1.0, 0.0)]);
        assert_eq!((wide.orient, wide.sphere), (0.0, IN_SPHERE));
    }

    #[test]
    fn clear_cases_are_certain() {
        let p = DVec3::new(0.3, 0.3, 0.4);
        let corners = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z];
        let [a, b, c, d] = corners.map(|v| Relative3::new(v, p));
        let filter = Filter3::GENERAL;
        assert_eq!(filter.orient_relative(&a, &b, &c), Some(Sign::Positive));
        assert_eq!(
            filter.in_sphere_relative(&a, &b, &c, &d),
            Some(Sign::Positive)
        );
        assert_eq!(
            filter.in_sphere_relative(&b, &a, &c, &d),
            Some(Sign::Negative)
        );
    }
}
