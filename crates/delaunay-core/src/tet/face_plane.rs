//! The plane of a face of a polyhedron: what defines it exactly, and rounded as seen from the origin of the polyhedron.
//!
//! Rounded numbers carry a bound on their error. They tell the sides of nearly all corners; where they cannot, the
//! [exact planes](geo_predicates::Plane) do.

use super::half_space::HalfSpace;
use super::polyhedron::Corner;
use geo_predicates::{Plane, Sign, meet_in_front, meet_place};
use glam::DVec3;

/// The points `x` with `x · normal = limit`, relative to the origin of a polyhedron; the polyhedron is at the back.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct FacePlane {
    /// Not relative to the origin.
    pub(super) exact: Plane,
    /// Each coordinate within half an ulp of one that belongs to the exact plane.
    pub(super) normal: DVec3,
    pub(super) limit: f64,
    /// Half a bound on the error of the limit for the exact normal, up to rounding of the bound itself.
    blur: f64,
}

/// The relative error of one rounded operation.
const ROUNDING: f64 = f64::EPSILON / 2.0;

/// More than the error of some operations on numbers so small that they have lost digits; part of every bound.
const UNDERFLOW: f64 = f64::MIN_POSITIVE;

impl FacePlane {
    /// The plane of a half-space as seen from `origin`.
    pub(super) fn of(half_space: &HalfSpace, origin: DVec3) -> Self {
        let HalfSpace { normal, limit } = *half_space;
        let sizes = limit.abs() + normal.abs().dot(origin.abs());
        Self {
            exact: Plane::Equation { normal, limit },
            normal,
            limit: limit - normal.dot(origin),
            blur: 4.0 * ROUNDING * sizes + UNDERFLOW,
        }
    }

    /// The bisector of two points as seen from `origin`, in front of it `front`.
    pub(super) fn bisector(back: DVec3, front: DVec3, origin: DVec3) -> Self {
        let normal = front - back;
        let (to_back, to_front) = (back - origin, front - origin);
        let sizes = (to_back.abs() + to_front.abs()).dot(normal.abs());
        Self {
            exact: Plane::Bisector { back, front },
            normal,
            limit: (to_back + to_front).dot(normal) / 2.0,
            blur: 4.0 * ROUNDING * sizes + UNDERFLOW,
        }
    }

    /// The same plane as seen from another origin.
    pub(super) fn seen_from(&self, origin: DVec3) -> Self {
        match self.exact {
            Plane::Equation { normal, limit } => Self::of(&HalfSpace { normal, limit }, origin),
            Plane::Bisector { back, front } => Self::bisector(back, front, origin),
        }
    }

    /// How far `x` is in front of the plane, in units of the length of the normal, rounded.
    #[inline]
    pub(super) fn height(&self, x: DVec3) -> f64 {
        x.dot(self.normal) - self.limit
    }

    /// Bound on the difference between the height of the place of a corner and that of its exact point.
    #[inline]
    pub(super) fn blur_of_height(&self, corner: &Corner) -> f64 {
        // The normal has one rounding, the inner product three more and the difference one.
        let slopes = self.normal.abs();
        let sizes = corner.place.abs().dot(slopes) + self.limit.abs();
        8.0 * ROUNDING * sizes + UNDERFLOW + 2.0 * (self.blur + slopes.element_sum() * corner.blur)
    }

    /// On which side of the plane the common point of three others lies, whose rounded place is `corner`.
    #[inline]
    pub(super) fn side_of(&self, corner: &Corner, planes: [&Self; 3]) -> Sign {
        let height = self.height(corner.place);
        // False also when a number is beyond the range of doubles.
        if height.abs() > self.blur_of_height(corner) {
            Sign::of(height)
        } else {
            self.exact_side_of(planes)
        }
    }

    #[cold]
    #[inline(never)]
    fn exact_side_of(&self, planes: [&Self; 3]) -> Sign {
        meet_in_front(planes.map(|plane| plane.exact), self.exact)
    }

    /// The common point of three planes as seen from `origin`, from which they are seen too, with a bound on the error
    /// of its coordinates: at most one part in 2^36 of `reach`, a size of coordinates.
    #[inline]
    pub(super) fn meet(planes: [&Self; 3], origin: DVec3, reach: f64) -> (DVec3, f64) {
        const FINE: f64 = 1.0 / (1_u64 << 36) as f64;
        let (place, blur) = Self::meet_rounded(planes);
        // False also when a number is beyond the range of doubles.
        if blur <= FINE * reach {
            (place, blur)
        } else {
            Self::meet_exactly(planes, origin)
        }
    }

    /// By Cramer's rule.
    #[inline]
    fn meet_rounded(planes: [&Self; 3]) -> (DVec3, f64) {
        let [a, b, c] = planes.map(|plane| plane.normal);
        let [p, q, r] = planes.map(|plane| plane.limit);
        let (bc, ca, ab) = (b.cross(c), c.cross(a), a.cross(b));
        let volume = a.dot(bc);
        let place = (p * bc + q * ca + r * ab) / volume;
        // Sums of products of few factors: no term has more than eight roundings.
        let [steep_a, steep_b, steep_c] = [a, b, c].map(|normal| normal.abs().max_element());
        let [p, q, r] = planes.map(|plane| 32.0 * ROUNDING * plane.limit.abs() + 4.0 * plane.blur);
        let blur_of_sum =
            p * steep_b * steep_c + q * steep_c * steep_a + r * steep_a * steep_b + UNDERFLOW;
        let blur_of_volume = 64.0 * ROUNDING * steep_a * steep_b * steep_c + UNDERFLOW;
        let size = place.abs().max_element();
        let blur = 2.0 * (blur_of_sum + size * blur_of_volume) / volume.abs()
            + ROUNDING * size
            + UNDERFLOW;
        if blur_of_volume < volume.abs() / 2.0 {
            (place, blur)
        } else {
            (place, f64::INFINITY)
        }
    }

    #[cold]
    #[inline(never)]
    fn meet_exactly(planes: [&Self; 3], origin: DVec3) -> (DVec3, f64) {
        match meet_place(planes.map(|plane| plane.exact), origin) {
            Some(place) => (place, f64::EPSILON * place.abs().max_element() + UNDERFLOW),
            None => (DVec3::ZERO, f64::INFINITY),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::polyhedron::End;
    use super::*;
    use proptest::prelude::*;

    fn plane(normal: [f64; 3], limit: f64, origin: DVec3) -> FacePlane {
        FacePlane::of(&HalfSpace::new(normal.into(), limit).unwrap(), origin)
    }

    fn corner_at(place: DVec3, blur: f64) -> Corner {
        Corner {
            place,
            blur,
            faces: [0; 3],
            twins: [End::new(0, 0); 3],
        }
    }

    /// Numbers near 1 and a few ulps from it, so that planes all but coincide.
    fn number() -> impl Strategy<Value = f64> {
        let near = (-4..5_i32).prop_map(|ulps| 1.0 + f64::from(ulps) * f64::EPSILON);
        prop_oneof![near, -1.0..1.0_f64, (-2..3_i32).prop_map(f64::from)]
    }

    fn point() -> impl Strategy<Value = DVec3> {
        [number(), number(), number()].prop_map(DVec3::from)
    }

    fn face_plane() -> impl Strategy<Value = (bool, DVec3, DVec3, f64)> {
        (any::<bool>(), point(), point(), number())
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(4000))]
        #[test]
        fn rounded_numbers_keep_their_bounds(
            planes in [face_plane(), face_plane(), face_plane(), face_plane()], origin in point(),
        ) {
            let made = |(is_bisector, a, b, limit): (bool, DVec3, DVec3, f64)| {
                let half_space = HalfSpace::new(a, limit);
                match half_space {
                    Ok(half_space) if !is_bisector => FacePlane::of(&half_space, origin),
                    _ => FacePlane::bisector(a, b, origin),
                }
            };
            let [a, b, c, d] = planes.map(made);
            let (place, blur) = FacePlane::meet_rounded([&a, &b, &c]);
            let Some(exact) = meet_place([a.exact, b.exact, c.exact], origin) else {
                prop_assert!(blur.is_nan() || blur.is_infinite());
                return Ok(());
            };
            let slack = f64::EPSILON * exact.abs().max_element();
            prop_assert!(blur.is_infinite() || (place - exact).abs().max_element() <= blur + slack);
            let corner = corner_at(place, blur);
            let side = d.side_of(&corner, [&a, &b, &c]);
            prop_assert_eq!(side, meet_in_front([a.exact, b.exact, c.exact], d.exact));
        }
    }

    #[test]
    fn planes_that_all_but_coincide_meet_exactly() {
        let origin = DVec3::ZERO;
        let a = plane([1.0, 0.0, 0.0], 1.0, origin);
        let b = plane([1.0, f64::EPSILON, 0.0], 1.0 + f64::EPSILON, origin);
        let c = plane([0.0, 0.0, 1.0], 1.0, origin);
        let (place, blur) = FacePlane::meet([&a, &b, &c], origin, 1.0);
        assert_eq!((place, blur), (DVec3::ONE, f64::EPSILON + UNDERFLOW));
    }

    #[test]
    fn planes_beyond_all_numbers_are_judged_exactly() {
        let far = |limit| plane([1e-300, 0.0, 0.0], limit, DVec3::ZERO);
        let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let planes = axes.map(|axis| plane(axis, 1e60, DVec3::ZERO));
        let [a, b, c] = [&planes[0], &planes[1], &planes[2]];
        let corner = corner_at(DVec3::splat(1e60), 0.0);
        assert_eq!(far(1e100).side_of(&corner, [a, b, c]), Sign::Negative);
        assert_eq!(far(-1e100).side_of(&corner, [a, b, c]), Sign::Positive);
    }
}
