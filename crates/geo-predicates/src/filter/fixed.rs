//! Static filters: one bound for all points of a bounding box, computed once.
//!
//! With `X`, `Y`, `Z` the extents of the box and `M` the greatest, the sum of the magnitudes of all
//! products of a determinant is at most `2 X Y`, `12 X Y M^2`, `6 X Y Z` and `72 X Y Z M^2` for
//! `orient2d`, `in_circle`, `orient3d` and `in_sphere`; its factors in [`filter`](super), rounded
//! up, give the bounds. A test costs one comparison beside the determinant; it fails far more often
//! than the other filters where points are dense, so use it before them, not instead.

use super::plane::{in_circle_determinant, orient2d_products};
use super::space::{below_hyperplane, volume, volumes_without};
use super::{Relative2, Relative3, certain};
use crate::sign::Sign;
use crate::statistics::Predicate;
use glam::{DVec2, DVec3};

/// Static filter for the points of a rectangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StaticFilter2 {
    orient: f64,
    circle: f64,
}

impl StaticFilter2 {
    /// For points in the rectangle from `least` to `greatest`, and no others.
    #[must_use]
    pub fn of_box(least: DVec2, greatest: DVec2) -> Self {
        let DVec2 { x, y } = (greatest - least).abs();
        let most = x.max(y);
        Self {
            orient: 8.9e-16 * (x * y),
            circle: 1.5e-14 * (x * y) * (most * most),
        }
    }

    /// `orient2d(a, b, c)`, or `None` when in doubt.
    #[inline(always)]
    #[must_use]
    pub fn orient2d(&self, a: DVec2, b: DVec2, c: DVec2) -> Option<Sign> {
        let (left, right) = orient2d_products(a - c, b - c);
        certain(Predicate::Orient2d, left - right, self.orient)
    }

    /// `in_circle(a, b, c, d)`, or `None` when in doubt.
    #[inline(always)]
    #[must_use]
    pub fn in_circle(&self, a: DVec2, b: DVec2, c: DVec2, d: DVec2) -> Option<Sign> {
        let [a, b, c] = [a, b, c].map(|corner| Relative2::new(corner, d));
        let crosses = [b.cross(&c), c.cross(&a), a.cross(&b)];
        let inside = in_circle_determinant([&a, &b, &c], crosses);
        certain(Predicate::InCircle, inside, self.circle)
    }
}

/// Static filter for the points of a box in space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StaticFilter3 {
    orient: f64,
    sphere: f64,
}

impl StaticFilter3 {
    /// For points in the box from `least` to `greatest`, and no others.
    #[must_use]
    pub fn of_box(least: DVec3, greatest: DVec3) -> Self {
        let DVec3 { x, y, z } = (greatest - least).abs();
        let most = x.max(y).max(z);
        Self {
            orient: 5.11e-15 * (x * y * z),
            sphere: 1.3e-13 * (x * y * z) * (most * most),
        }
    }

    /// `orient3d(a, b, c, d)`, or `None` when in doubt.
    #[inline(always)]
    #[must_use]
    pub fn orient3d(&self, a: DVec3, b: DVec3, c: DVec3, d: DVec3) -> Option<Sign> {
        certain(
            Predicate::Orient3d,
            -volume(a - d, b - d, c - d),
            self.orient,
        )
    }

    /// `in_sphere(a, b, c, d, e)`, or `None` when in doubt.
    #[inline(always)]
    #[must_use]
    pub fn in_sphere(&self, a: DVec3, b: DVec3, c: DVec3, d: DVec3, e: DVec3) -> Option<Sign> {
        let [a, b, c, d] = [a, b, c, d].map(|corner| Relative3::new(corner, e));
        certain(
            Predicate::InSphere,
            below_hyperplane([&a, &b, &c, &d], volumes_without([&a, &b, &c, &d])),
            self.sphere,
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{in_circle, in_sphere, orient2d, orient3d};
    use proptest::prelude::*;

    /// Coordinates on a tenths lattice a few units in the last place off, or anywhere.
    fn coordinate() -> impl Strategy<Value = f64> {
        prop_oneof![
            -1.0..1.0,
            (-3i32..=3, -4i32..=4)
                .prop_map(|(i, k)| f64::from(i) * 0.1 * (1.0 + f64::from(k) * f64::EPSILON)),
        ]
    }

    fn point() -> impl Strategy<Value = DVec3> {
        [coordinate(), coordinate(), coordinate()].prop_map(DVec3::from_array)
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(4000))]

        #[test]
        fn certain_answers_are_right([a, b, c, d, e] in [point(), point(), point(), point(), point()]) {
            let least = a.min(b).min(c).min(d).min(e);
            let greatest = a.max(b).max(c).max(d).max(e);
            let filter = StaticFilter3::of_box(least, greatest);
            let exact = orient3d(a, b, c, d);
            prop_assert!(filter.orient3d(a, b, c, d).is_none_or(|sign| sign == exact));
            let exact = in_sphere(a, b, c, d, e);
            prop_assert!(filter.in_sphere(a, b, c, d, e).is_none_or(|sign| sign == exact));
            let filter = StaticFilter2::of_box(least.truncate(), greatest.truncate());
            let [a, b, c, d] = [a, b, c, d].map(DVec3::truncate);
            let exact = orient2d(a, b, c);
            prop_assert!(filter.orient2d(a, b, c).is_none_or(|sign| sign == exact));
            let exact = in_circle(a, b, c, d);
            prop_assert!(filter.in_circle(a, b, c, d).is_none_or(|sign| sign == exact));
        }
    }

    #[test]
    fn clear_cases_are_certain_and_nan_is_not() {
        let filter = StaticFilter2::of_box(DVec2::ZERO, DVec2::ONE);
        let [a, b, c] = [DVec2::ZERO, DVec2::X, DVec2::Y];
        assert_eq!(filter.orient2d(a, b, c), Some(Sign::Positive));
        assert_eq!(
            filter.in_circle(a, b, c, DVec2::splat(0.4)),
            Some(Sign::Positive)
        );
        assert_eq!(filter.in_circle(a, b, c, DVec2::NAN), None);
        let filter = StaticFilter3::of_box(DVec3::ZERO, DVec3::ONE);
        let [a, b, c, d] = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z];
        assert_eq!(filter.orient3d(a, b, c, d), Some(Sign::Positive));
        assert_eq!(
            filter.in_sphere(a, b, c, d, DVec3::splat(0.4)),
            Some(Sign::Positive)
        );
        assert_eq!(filter.orient3d(a, b, c, DVec3::NAN), None);
    }
}
