//! Ties broken by symbolic perturbation: one triangulation for cocircular and cospherical points.
//!
//! A point `p` is lifted to `|p|^2 + raise(p)`, where the raises are positive infinitesimals and
//! that of a greater key dominates any sum of those of smaller keys. A Delaunay triangulation of
//! points thus lifted is the lower hull of points in general position, so there is exactly one,
//! in whatever order they are inserted. Expanding the lifted determinant along the column of
//! heights shows what a tie leaves: the raise of the dominating point times the orientation of
//! the others; if those are degenerate the next key decides. Orientation is never perturbed.
//!
//! The key is the position ([`Lexicographic2`], [`Lexicographic3`]: the result depends on the
//! points alone) or anything else with a total order, such as the caller's ids.

use crate::in_ball::{in_circle, in_sphere};
use crate::orient::{orient2d, orient3d};
use crate::power::{WeightedPoint2, WeightedPoint3, power_circle, power_sphere};
use crate::sign::Sign;
use crate::statistics::{Predicate, Stage, record};
use glam::{DVec2, DVec3};
use std::cmp::Ordering;

/// Key of a point of the plane: compare `x`, then `y`. `-0.0` equals `0.0`.
#[derive(Clone, Copy, Debug)]
pub struct Lexicographic2(pub DVec2);

/// Key of a point of space: compare `x`, then `y`, then `z`. `-0.0` equals `0.0`.
#[derive(Clone, Copy, Debug)]
pub struct Lexicographic3(pub DVec3);

impl Ord for Lexicographic2 {
    #[inline]
    fn cmp(&self, other: &Self) -> Ordering {
        compare(self.0.x, other.0.x).then_with(|| compare(self.0.y, other.0.y))
    }
}

impl Ord for Lexicographic3 {
    #[inline]
    fn cmp(&self, other: &Self) -> Ordering {
        compare(self.0.x, other.0.x)
            .then_with(|| compare(self.0.y, other.0.y))
            .then_with(|| compare(self.0.z, other.0.z))
    }
}

/// Order of two coordinates with the two zeros equal (adding 0.0 turns -0.0 into 0.0).
#[inline]
fn compare(a: f64, b: f64) -> Ordering {
    (a + 0.0).total_cmp(&(b + 0.0))
}

macro_rules! order_follows_cmp {
    ($key:ty) => {
        impl PartialOrd for $key {
            #[inline]
            fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
                Some(self.cmp(other))
            }
        }

        impl PartialEq for $key {
            #[inline]
            fn eq(&self, other: &Self) -> bool {
                self.cmp(other).is_eq()
            }
        }

        impl Eq for $key {}
    };
}

order_follows_cmp!(Lexicographic2);
order_follows_cmp!(Lexicographic3);

/// Whether `d` is inside the circle of the counterclockwise `a`, `b`, `c`, ties broken by the
/// lexicographic key.
///
/// Swapping two of the first three negates the answer. When `d` is one of the corners, or all four
/// points are on a line, the answer is `false`. Exact for accepted coordinates.
#[inline]
#[must_use]
pub fn in_circle_perturbed(a: DVec2, b: DVec2, c: DVec2, d: DVec2) -> bool {
    in_circle_perturbed_by([a, b, c, d], [a, b, c, d].map(Lexicographic2))
}

/// Whether `e` is inside the sphere of the right-handed `a`, `b`, `c`, `d`, ties broken by the
/// lexicographic key.
///
/// Swapping two of the first four negates the answer. When `e` is one of the corners, or all five
/// points are on a plane, the answer is `false`. Exact for accepted coordinates.
#[inline]
#[must_use]
pub fn in_sphere_perturbed(a: DVec3, b: DVec3, c: DVec3, d: DVec3, e: DVec3) -> bool {
    in_sphere_perturbed_by([a, b, c, d, e], [a, b, c, d, e].map(Lexicographic3))
}

/// [`in_circle_perturbed`] of `[a, b, c, d]` with the caller's keys, such as ids.
///
/// Distinct points must have distinct keys for the triangulation to be unique.
#[inline]
#[must_use]
pub fn in_circle_perturbed_by<K: Copy + Ord>(points: [DVec2; 4], keys: [K; 4]) -> bool {
    let [a, b, c, d] = points;
    decide(Predicate::InCircle, in_circle(a, b, c, d), || {
        tie2(points, keys)
    })
}

/// [`in_sphere_perturbed`] of `[a, b, c, d, e]` with the caller's keys, such as ids.
///
/// Distinct points must have distinct keys for the triangulation to be unique.
#[inline]
#[must_use]
pub fn in_sphere_perturbed_by<K: Copy + Ord>(points: [DVec3; 5], keys: [K; 5]) -> bool {
    let [a, b, c, d, e] = points;
    decide(Predicate::InSphere, in_sphere(a, b, c, d, e), || {
        tie3(points, keys)
    })
}

/// [`power_circle`] with ties broken by the lexicographic key: whether `d` is in conflict.
#[must_use]
pub fn power_circle_perturbed(
    a: WeightedPoint2,
    b: WeightedPoint2,
    c: WeightedPoint2,
    d: WeightedPoint2,
) -> bool {
    power_circle_perturbed_by([a, b, c, d], [a, b, c, d].map(|p| Lexicographic2(p.point)))
}

/// [`power_sphere`] with ties broken by the lexicographic key: whether `e` is in conflict.
#[must_use]
pub fn power_sphere_perturbed(
    a: WeightedPoint3,
    b: WeightedPoint3,
    c: WeightedPoint3,
    d: WeightedPoint3,
    e: WeightedPoint3,
) -> bool {
    power_sphere_perturbed_by(
        [a, b, c, d, e],
        [a, b, c, d, e].map(|p| Lexicographic3(p.point)),
    )
}

/// [`power_circle_perturbed`] of `[a, b, c, d]` with the caller's keys, such as ids.
#[must_use]
pub fn power_circle_perturbed_by<K: Copy + Ord>(points: [WeightedPoint2; 4], keys: [K; 4]) -> bool {
    let [a, b, c, d] = points;
    decide(Predicate::PowerCircle, power_circle(a, b, c, d), || {
        tie2(points.map(|p| p.point), keys)
    })
}

/// [`power_sphere_perturbed`] of `[a, b, c, d, e]` with the caller's keys, such as ids.
#[must_use]
pub fn power_sphere_perturbed_by<K: Copy + Ord>(points: [WeightedPoint3; 5], keys: [K; 5]) -> bool {
    let [a, b, c, d, e] = points;
    decide(Predicate::PowerSphere, power_sphere(a, b, c, d, e), || {
        tie3(points.map(|p| p.point), keys)
    })
}

/// Whether the new point `p` is inside the circle of the counterclockwise triangle `a`, `b`,
/// `apex`, given that the four are on one circle and that `p` lies beyond the edge `ab`.
///
/// Agrees with [`in_circle_perturbed`] at the cost of three comparisons. The quadrilateral
/// `a p b apex` is convex; its diagonal is the one without the dominating point:
/// ```text
///        apex                   apex
///       /    \                 / |  \
///      a ---- b               a  |   b        max(a, b) > max(p, apex):
///       \    /                 \ |  /         the edge ab goes, p is inside
///         p                      p
/// ```
#[inline]
#[must_use]
pub fn cocircular_inside<K: Copy + Ord>(a: K, b: K, apex: K, p: K) -> bool {
    a.max(b) > p.max(apex)
}

#[inline]
fn decide(predicate: Predicate, sign: Sign, tie: impl FnOnce() -> bool) -> bool {
    match sign {
        Sign::Positive => true,
        Sign::Negative => false,
        Sign::Zero => {
            record(predicate, Stage::Tie);
            tie()
        }
    }
}

/// Answer for four lifted points on one plane.
#[cold]
fn tie2<K: Copy + Ord>([a, b, c, d]: [DVec2; 4], keys: [K; 4]) -> bool {
    first_nonzero(keys, |raised| match raised {
        0 => orient2d(d, b, c),
        1 => orient2d(a, d, c),
        2 => orient2d(a, b, d),
        _ => -orient2d(a, b, c),
    })
}

/// Answer for five lifted points on one hyperplane.
#[cold]
fn tie3<K: Copy + Ord>([a, b, c, d, e]: [DVec3; 5], keys: [K; 5]) -> bool {
    first_nonzero(keys, |raised| match raised {
        0 => orient3d(e, b, c, d),
        1 => orient3d(a, e, c, d),
        2 => orient3d(a, b, e, d),
        3 => orient3d(a, b, c, e),
        _ => -orient3d(a, b, c, d),
    })
}

/// Sign of the raise of the dominating point that matters: `coefficient` by index of the point,
/// from the greatest key down. Of equal keys the later point dominates, so that a query that
/// repeats a corner is outside.
fn first_nonzero<K: Copy + Ord, const N: usize>(
    keys: [K; N],
    coefficient: impl Fn(usize) -> Sign,
) -> bool {
    let mut order: [usize; N] = std::array::from_fn(|i| i);
    order.sort_unstable_by(|&i, &j| (&keys[j], j).cmp(&(&keys[i], i)));
    let signs = order.into_iter().map(coefficient);
    signs
        .into_iter()
        .find(|sign| !sign.is_zero())
        .is_some_and(Sign::is_positive)
}
