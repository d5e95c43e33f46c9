//! Floating-point filters: determinants in doubles with a bound on their error.
//!
//! A kernel that inserts a point `p` meets each vertex as a vector from `p` with its squared
//! length ([`Relative2`], [`Relative3`]), computed once. [`Filter2`] and [`Filter3`] turn those
//! into signs; `None` means the doubles cannot tell, and the exact predicate of the crate root
//! must be asked. NaN coordinates (a vertex at infinity, say) always give `None`.
//!
//! # Bounds
//! With unit roundoff u = 2^-53, `l` the squared length of a vector from `p`:
//!
//! | determinant | error at most | why |
//! |---|---|---|
//! | orient2d | (3 + 16u) u (\|left\| + \|right\|) | Shewchuk 1997, bound A; both products of one sign, or no cancellation |
//! | `in_circle` | 3.71e-16 (la + lb + lc)^2 | bound A is (10 + 96u) u times the permanent, la (\|bx cy\| + \|by cx\|) + ...; by Cauchy the bracket is at most \|b\| \|c\| <= (lb + lc) / 2, so the permanent is at most la lb + lb lc + lc la <= (la + lb + lc)^2 / 3 |
//! | orient3d | 1.75e-16 (la + lb + lc)^(3/2) | bound A is (7 + 56u) u times the permanent of the absolute values, at most (2 / sqrt 3) \|a\| \|b\| \|c\|, and the geometric mean of la, lb, lc is at most their third |
//! | `in_sphere` | 2.6e-16 (la + lb + lc + ld)^(5/2) | bound A is (16 + 224u) u times the sum of l times the permanent of the other three, at most (2 / sqrt 3) \|a\| \|b\| \|c\| \|d\| (\|a\| + \|b\| + \|c\| + \|d\|) <= (2 / sqrt 3) (s / 4)^2 2 sqrt s |
//!
//! Each constant has slack for the rounding of the bound itself. Nothing underflows or overflows
//! for accepted coordinates.
//!
//! # Few bits
//! When all coordinates are small integers times one power of two, the doubles are exact and the
//! bound is 0 ([`Filter2::for_points`]): lattices, the worst case of the general filter, then
//! never reach the exact stage, and a determinant of 0 is a true tie.

use crate::few_bits::extent;
use crate::sign::Sign;
use crate::statistics::{Predicate, Stage, record};
use glam::{DVec2, DVec3};

const ORIENT2D: f64 = 3.330_669_073_875_472e-16;
const IN_CIRCLE: f64 = 3.71e-16;
const ORIENT3D: f64 = 7.78e-16;
const IN_SPHERE: f64 = 2.6e-16;
const DIAMETRAL_SPHERE: f64 = 5.6e-16;
/// Half of what the table says: it multiplies the doubled size.
const DIAMETRAL_BALL: f64 = 1.25e-15;
const POWER_CIRCLE: f64 = 4.6e-16;
const POWER_SPHERE: f64 = 3.3e-16;

/// Greatest extents, in units of the lowest bit, for which determinants stay below 2^53: with
/// differences of at most `e` they are at most 2 e^2, 12 e^4, 6 e^3 and 72 e^5, sums on the way
/// included.
const FEW_BITS_ORIENT2D: f64 = 67_108_864.0;
const FEW_BITS_IN_CIRCLE: f64 = 5_233.0;
const FEW_BITS_ORIENT3D: f64 = 114_503.0;
const FEW_BITS_IN_SPHERE: f64 = 659.0;

/// Vector from the query point to a vertex of the plane, with its squared length.
#[derive(Clone, Copy, Debug)]
pub struct Relative2 {
    vector: DVec2,
    lift: f64,
}

impl Relative2 {
    /// The vertex `point` seen from the query point `from`.
    #[inline(always)]
    #[must_use]
    pub fn new(point: DVec2, from: DVec2) -> Self {
        let vector = point - from;
        Self {
            vector,
            lift: vector.x * vector.x + vector.y * vector.y,
        }
    }

    /// True when the two points are equal (the difference of distinct doubles is not zero).
    #[inline(always)]
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.vector == DVec2::ZERO
    }

    /// Doubled area of the triangle of the query point, this vertex and `next`.
    #[inline(always)]
    #[must_use]
    pub fn cross(&self, next: &Self) -> Cross {
        Cross(self.vector.x * next.vector.y - self.vector.y * next.vector.x)
    }
}

/// Doubled signed area of a triangle at the query point, rounded; only the filters look inside.
#[derive(Clone, Copy, Debug)]
pub struct Cross(f64);

impl Cross {
    /// A guess of whether the second vertex is to the left of the first as seen from the query
    /// point. Rounded: good enough to choose where a walk starts, never to decide.
    #[inline(always)]
    #[must_use]
    pub fn seems_left(self) -> bool {
        self.0 >= 0.0
    }
}

/// Filters for the plane; see the [module](self).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Filter2 {
    orient: f64,
    circle: f64,
}

impl Filter2 {
    /// Valid for all accepted coordinates.
    pub const GENERAL: Self = Self {
        orient: ORIENT2D,
        circle: IN_CIRCLE,
    };

    /// The best filter for `points`: exact where they have few bits. It holds for any subset of
    /// `points`, and for no other point. Linear, but stops early when the points have many bits.
    #[must_use]
    pub fn for_points(points: &[DVec2]) -> Self {
        let extent = extent(points.iter().map(DVec2::to_array), FEW_BITS_ORIENT2D);
        Self {
            orient: if extent <= FEW_BITS_ORIENT2D {
                0.0
            } else {
                Self::GENERAL.orient
            },
            circle: if extent <= FEW_BITS_IN_CIRCLE {
                0.0
            } else {
                Self::GENERAL.circle
            },
        }
    }

    /// `orient2d(a, b, c)`.
    #[inline(always)]
    #[must_use]
    pub fn orient2d(&self, a: DVec2, b: DVec2, c: DVec2) -> Option<Sign> {
        self.orient(a - c, b - c)
    }

    /// `orient2d(p, a, b)`, and that of its rotations `(a, b, p)` and `(b, p, a)`.
    #[inline(always)]
    #[must_use]
    pub fn orient_relative(&self, a: &Relative2, b: &Relative2) -> Option<Sign> {
        self.orient(a.vector, b.vector)
    }

    #[inline(always)]
    fn orient(&self, a: DVec2, b: DVec2) -> Option<Sign> {
        let (left, right) = (a.x * b.y, a.y * b.x);
        certain(
            Predicate::Orient2d,
            left - right,
            self.orient * (left + right).abs(),
        )
    }

    /// `in_circle(a, b, c, p)`.
    #[inline(always)]
    #[must_use]
    pub fn in_circle_relative(&self, a: &Relative2, b: &Relative2, c: &Relative2) -> Option<Sign> {
        self.in_circle_crossed([a, b, c], [b.cross(c), c.cross(a), a.cross(b)])
    }

    /// `in_circle(a, b, c, p)` of `[a, b, c]` when the crosses `[bc, ca, ab]` are known.
    #[inline(always)]
    #[must_use]
    pub fn in_circle_crossed(&self, corners: [&Relative2; 3], crosses: [Cross; 3]) -> Option<Sign> {
        let [a, b, c] = corners.map(|corner| corner.lift);
        let [bc, ca, ab] = crosses.map(|cross| cross.0);
        let sum = a + b + c;
        certain(
            Predicate::InCircle,
            a * bc + b * ca + c * ab,
            self.circle * (sum * sum),
        )
    }
}

/// Vector from the query point to a vertex of space, with its squared length.
#[derive(Clone, Copy, Debug)]
pub struct Relative3 {
    vector: DVec3,
    lift: f64,
}

impl Relative3 {
    /// The vertex `point` seen from the query point `from`.
    #[inline(always)]
    #[must_use]
    pub fn new(point: DVec3, from: DVec3) -> Self {
        let vector = point - from;
        let DVec3 { x, y, z } = vector;
        Self {
            vector,
            lift: x * x + y * y + z * z,
        }
    }

    /// True when the two points are equal (the difference of distinct doubles is not zero).
    #[inline(always)]
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.vector == DVec3::ZERO
    }
}

/// Filters for space; see the [module](self).
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
            orient: if extent <= FEW_BITS_ORIENT3D {
                0.0
            } else {
                Self::GENERAL.orient
            },
            sphere: if extent <= FEW_BITS_IN_SPHERE {
                0.0
            } else {
                Self::GENERAL.sphere
            },
        }
    }

    /// `orient3d(a, b, c, p)`.
    #[inline(always)]
    #[must_use]
    pub fn orient_relative(&self, a: &Relative3, b: &Relative3, c: &Relative3) -> Option<Sign> {
        let [(bc, bc_size), (ca, ca_size), (ab, ab_size)] =
            [sized_minor(b, c), sized_minor(c, a), sized_minor(a, b)];
        let [az, bz, cz] = [a.vector.z, b.vector.z, c.vector.z];
        let volume = az * bc + bz * ca + cz * ab;
        let permanent = az.abs() * bc_size + bz.abs() * ca_size + cz.abs() * ab_size;
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
            below_hyperplane(a, b, c, d),
            self.sphere * (sum * sum * sum.sqrt()),
        )
    }
}

/// `in_diametral_circle(a, b, p)` of the vectors from `p` to `a` and `b`.
#[inline(always)]
pub(crate) fn in_diametral_circle(a: DVec2, b: DVec2) -> Option<Sign> {
    let (x, y) = (a.x * b.x, a.y * b.y);
    certain(
        Predicate::InDiametralCircle,
        -(x + y),
        ORIENT2D * (x - y).abs(),
    )
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

/// `power_circle(a, b, c, d)` of the vectors from `d` to `[a, b, c]` and the differences of their
/// weights to that of `d`.
#[inline(always)]
pub(crate) fn power_circle(corners: [(DVec2, f64); 3]) -> Option<Sign> {
    let [a, b, c] = corners.map(|(vector, _)| vector);
    let lifts = corners.map(|(vector, weight)| (vector.dot(vector), weight));
    let [la, lb, lc] = lifts.map(|(length, weight)| length - weight);
    let [sa, sb, sc] = lifts.map(|(length, weight)| length + weight.abs());
    let sum = sa + sb + sc;
    let below = la * b.perp_dot(c) + lb * c.perp_dot(a) + lc * a.perp_dot(b);
    certain(Predicate::PowerCircle, below, POWER_CIRCLE * (sum * sum))
}

/// `power_sphere(a, b, c, d, e)` of the vectors from `e` to `[a, b, c, d]` and the differences of
/// their weights to that of `e`.
#[inline(always)]
pub(crate) fn power_sphere(corners: [(DVec3, f64); 4]) -> Option<Sign> {
    let [a, b, c, d] = corners.map(|(vector, weight)| Relative3 {
        vector,
        lift: vector.dot(vector) - weight,
    });
    let sizes = corners.map(|(vector, weight)| vector.dot(vector) + weight.abs());
    let sum = (sizes[0] + sizes[1]) + (sizes[2] + sizes[3]);
    certain(
        Predicate::PowerSphere,
        below_hyperplane(&a, &b, &c, &d),
        POWER_SPHERE * (sum * sum * sum.sqrt()),
    )
}

/// How far the origin is below the hyperplane of the lifted vectors, times their volume.
#[inline(always)]
fn below_hyperplane(a: &Relative3, b: &Relative3, c: &Relative3, d: &Relative3) -> f64 {
    let (ab, bc, cd, da) = (minor(a, b), minor(b, c), minor(c, d), minor(d, a));
    let (ac, bd) = (minor(a, c), minor(b, d));
    let [az, bz, cz, dz] = [a.vector.z, b.vector.z, c.vector.z, d.vector.z];
    let abc = az * bc - bz * ac + cz * ab;
    let bcd = bz * cd - cz * bd + dz * bc;
    let cda = cz * da + dz * ac + az * cd;
    let dab = dz * ab + az * bd + bz * da;
    (c.lift * dab - d.lift * abc) + (a.lift * bcd - b.lift * cda)
}

/// `a.x b.y - a.y b.x`.
#[inline(always)]
fn minor(a: &Relative3, b: &Relative3) -> f64 {
    a.vector.x * b.vector.y - a.vector.y * b.vector.x
}

#[inline(always)]
fn sized_minor(a: &Relative3, b: &Relative3) -> (f64, f64) {
    let (left, right) = (a.vector.x * b.vector.y, a.vector.y * b.vector.x);
    (left - right, left.abs() + right.abs())
}

/// Sign of a number known up to an error of at most `bound`, if certain. A bound of 0 says that
/// it is exact. NaN anywhere is never certain.
#[inline(always)]
fn certain(predicate: Predicate, value: f64, bound: f64) -> Option<Sign> {
    let sign = sign_within(value, bound);
    if sign.is_some() {
        record(predicate, Stage::Filter);
    }
    sign
}

#[inline(always)]
fn sign_within(value: f64, bound: f64) -> Option<Sign> {
    if value > bound {
        Some(Sign::Positive)
    } else if value < -bound {
        Some(Sign::Negative)
    } else if bound == 0.0 {
        Some(Sign::Zero)
    } else {
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nan_is_never_certain() {
        let ghost = Relative2::new(DVec2::NAN, DVec2::ZERO);
        let [a, b] = [DVec2::X, DVec2::Y].map(|v| Relative2::new(v, DVec2::ZERO));
        let exact = Filter2 {
            orient: 0.0,
            circle: 0.0,
        };
        for filter in [Filter2::GENERAL, exact] {
            assert_eq!(filter.orient_relative(&a, &ghost), None);
            assert_eq!(filter.in_circle_relative(&a, &b, &ghost), None);
            assert_eq!(filter.in_circle_relative(&ghost, &a, &b), None);
        }
        let ghost = Relative3::new(DVec3::NAN, DVec3::ZERO);
        let [a, b, c] = [DVec3::X, DVec3::Y, DVec3::Z].map(|v| Relative3::new(v, DVec3::ZERO));
        let exact = Filter3 {
            orient: 0.0,
            sphere: 0.0,
        };
        for filter in [Filter3::GENERAL, exact] {
            assert_eq!(filter.orient_relative(&a, &b, &ghost), None);
            assert_eq!(filter.in_sphere_relative(&a, &b, &ghost, &c), None);
        }
    }

    #[test]
    fn clear_cases_agree_with_the_predicates() {
        let p = DVec2::new(0.3, 0.3);
        let [a, b, c] = [DVec2::ZERO, DVec2::X, DVec2::Y].map(|v| Relative2::new(v, p));
        assert_eq!(
            Filter2::GENERAL.orient_relative(&a, &b),
            Some(Sign::Positive)
        );
        assert_eq!(
            Filter2::GENERAL.in_circle_relative(&a, &b, &c),
            Some(Sign::Positive)
        );
        let p = DVec3::new(0.3, 0.3, 0.4);
        let corners = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z];
        let [a, b, c, d] = corners.map(|v| Relative3::new(v, p));
        assert_eq!(
            Filter3::GENERAL.orient_relative(&a, &b, &c),
            Some(Sign::Positive)
        );
        assert_eq!(
            Filter3::GENERAL.in_sphere_relative(&a, &b, &c, &d),
            Some(Sign::Positive)
        );
        assert_eq!(
            Filter3::GENERAL.in_sphere_relative(&b, &a, &c, &d),
            Some(Sign::Negative)
        );
    }
}
