//! Filters for the plane.

use super::{certain, exact_up_to};
use crate::few_bits::extent;
use crate::sign::Sign;
use crate::statistics::Predicate;
use glam::DVec2;
use std::ops::Neg;

const ORIENT2D: f64 = 3.330_669_073_875_472e-16;
const IN_CIRCLE: f64 = 3.71e-16;
const POWER_CIRCLE: f64 = 4.6e-16;

/// Greatest extents, in units of the lowest bit, for which the doubles are exact.
const FEW_BITS_ORIENT2D: f64 = 67_108_864.0;
const FEW_BITS_IN_CIRCLE: f64 = 5_233.0;

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

impl Neg for Cross {
    type Output = Self;

    /// The cross of the two vectors in the other order, rounding included.
    #[inline(always)]
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

/// Filters for the plane; see the [module](super).
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
            orient: exact_up_to(FEW_BITS_ORIENT2D, extent, Self::GENERAL.orient),
            circle: exact_up_to(FEW_BITS_IN_CIRCLE, extent, Self::GENERAL.circle),
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
        let (left, right) = orient2d_products(a, b);
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
        let sum = corners[0].lift + corners[1].lift + corners[2].lift;
        let inside = in_circle_determinant(corners, crosses);
        certain(Predicate::InCircle, inside, self.circle * (sum * sum))
    }
}

/// [`cocircular_inside`](crate::cocircular_inside) of the vertices `a`, `b`, `apex` and the query point, where a filter
/// [made for them](Filter2::for_points) has found a tie.
///
/// Made for lattices, where a tie is the rule: it needs neither the coordinates nor a branch.
#[inline(always)]
#[must_use]
pub fn raised_inside(a: &Relative2, b: &Relative2, apex: &Relative2) -> bool {
    // Greater than any difference of coordinates in units of their lowest bit, so that keys are ordered as vectors are.
    const BASE: f64 = 16_384.0;
    let [a, b, apex] = [a, b, apex].map(|seen| seen.vector.x * BASE + seen.vector.y);
    a.max(b) > apex.max(0.0)
}

/// The two products whose difference is the doubled area of the origin, `a`, `b`.
#[inline(always)]
pub(super) fn orient2d_products(a: DVec2, b: DVec2) -> (f64, f64) {
    (a.x * b.y, a.y * b.x)
}

/// How far the origin is below the plane of the lifted `[a, b, c]`, times their area, from the
/// crosses `[bc, ca, ab]`.
#[inline(always)]
pub(super) fn in_circle_determinant(corners: [&Relative2; 3], crosses: [Cross; 3]) -> f64 {
    let [a, b, c] = corners.map(|corner| corner.lift);
    let [bc, ca, ab] = crosses.map(|cross| cross.0);
    a * bc + b * ca + c * ab
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::in_ball::in_circle;
    use crate::orient::orient2d;

    fn lattice(width: i32, step: f64, corner: DVec2) -> Vec<DVec2> {
        let point = |i: i32| DVec2::new(f64::from(i % width), f64::from(i / width));
        (0..width * width)
            .map(|i| corner + point(i) * step)
            .collect()
    }

    #[test]
    fn nan_is_never_certain() {
        let ghost = Relative2::new(DVec2::NAN, DVec2::ZERO);
        let [a, b] = [DVec2::X, DVec2::Y].map(|v| Relative2::new(v, DVec2::ZERO));
        for filter in [Filter2::GENERAL, Filter2::for_points(&[DVec2::X, DVec2::Y])] {
            assert_eq!(filter.orient2d(DVec2::X, DVec2::Y, DVec2::NAN), None);
            assert_eq!(filter.orient_relative(&a, &ghost), None);
            assert_eq!(filter.in_circle_relative(&a, &b, &ghost), None);
            assert_eq!(filter.in_circle_relative(&ghost, &a, &b), None);
        }
    }

    #[test]
    fn lattices_of_few_bits_are_always_certain() {
        let points = lattice(4, 1.0 / 1024.0, DVec2::new(5000.0, -3.0));
        let filter = Filter2::for_points(&points);
        for &p in &points {
            for triangle in points.windows(3) {
                let [a, b, c] = [triangle[0], triangle[1], triangle[2]];
                let [ap, bp, cp] = [a, b, c].map(|corner| Relative2::new(corner, p));
                assert_eq!(filter.orient_relative(&ap, &bp), Some(orient2d(a, b, p)));
                let inside = filter.in_circle_relative(&ap, &bp, &cp);
                assert_eq!(inside, Some(in_circle(a, b, c, p)));
            }
        }
    }

    #[test]
    fn the_widest_exact_extent_is_exact() {
        let e = FEW_BITS_IN_CIRCLE;
        let points = [
            [0.0, 0.0],
            [e, 1.0],
            [e - 1.0, e],
            [1.0, e],
            [e, e],
            [0.0, e - 1.0],
        ]
        .map(DVec2::from_array);
        let filter = Filter2::for_points(&points);
        assert_eq!(filter.circle, 0.0);
        for [i, j, k, l] in [
            [0, 1, 2, 3],
            [0, 1, 4, 5],
            [1, 2, 5, 0],
            [5, 0, 1, 4],
            [3, 5, 0, 2],
        ] {
            let [a, b, c, d] = [i, j, k, l].map(|index: usize| points[index]);
            let [ad, bd, cd] = [a, b, c].map(|corner| Relative2::new(corner, d));
            let inside = filter.in_circle_relative(&ad, &bd, &cd);
            assert_eq!(inside, Some(in_circle(a, b, c, d)));
        }
    }

    #[test]
    fn many_bits_keep_the_general_filter() {
        assert_eq!(
            Filter2::for_points(&lattice(4, 0.1, DVec2::ZERO)),
            Filter2::GENERAL
        );
        let wide = Filter2::for_points(&[DVec2::ZERO, DVec2::new(1e6, 1.0)]);
        assert_eq!((wide.orient, wide.circle), (0.0, IN_CIRCLE));
    }

    #[test]
    fn the_crossed_form_is_the_relative_form() {
        let p = DVec2::new(0.3, 0.3);
        let [a, b, c] = [DVec2::ZERO, DVec2::X, DVec2::Y].map(|v| Relative2::new(v, p));
        assert!(a.cross(&b).seems_left());
        assert!(!b.cross(&a).seems_left());
        let filter = Filter2::GENERAL;
        assert_eq!(filter.in_circle_relative(&a, &b, &c), Some(Sign::Positive));
        let crosses = [b.cross(&c), c.cross(&a), a.cross(&b)];
        assert_eq!(
            filter.in_circle_crossed([&a, &b, &c], crosses),
            Some(Sign::Positive)
        );
    }
}
