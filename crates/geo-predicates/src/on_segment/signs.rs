//! Orientation and in-sphere for points of either kind.

use std::cmp::Ordering;

use super::difference::{self, Difference};
use super::point::ExactPoint3;
use super::whole::whole;
use crate::orient::orient3d;
use crate::perturb::{in_sphere_perturbed, raised_first};
use crate::sign::Sign;
use crate::unbounded::{det3, dot, minus, sign};

/// [`orient3d`] of points of either kind. Exact.
///
/// Takes the time of a few products where the doubles are certain, some microseconds otherwise.
///
/// ```
/// use geo_predicates::{DVec3, ExactPoint3, SegmentPoint3, Sign, orient3d_exact};
///
/// let [a, b, c] = [DVec3::ZERO, DVec3::new(0.1, 0.7, 0.3), DVec3::new(0.9, 0.2, 0.4)];
/// // However long the digits of a point on a side of a triangle are, it is in the plane of the triangle.
/// let on_side = SegmentPoint3::new(b, c, 1.0 / 3.0);
/// let [a, b, c] = [a, b, c].map(ExactPoint3::Given);
/// assert_eq!(orient3d_exact([a, b, c, ExactPoint3::OnSegment(&on_side)]), Sign::Zero);
/// ```
#[must_use]
#[inline]
pub fn orient3d_exact(points: [ExactPoint3<'_>; 4]) -> Sign {
    if let [
        ExactPoint3::Given(a),
        ExactPoint3::Given(b),
        ExactPoint3::Given(c),
        ExactPoint3::Given(d),
    ] = points
    {
        return orient3d(a, b, c, d);
    }
    orient3d_mixed(points)
}

fn orient3d_mixed(points: [ExactPoint3<'_>; 4]) -> Sign {
    let [a, b, c, d] = &points;
    let [a, b, c] = [a, b, c].map(|corner| Difference::new(corner, d));
    difference::orient3d([&a, &b, &c]).unwrap_or_else(|| whole_orient3d(points))
}

/// [`in_sphere_perturbed`] of points of either kind: whether the last is inside the sphere of the right-handed others, ties
/// broken by the lexicographic order of the exact places.
#[must_use]
#[inline]
pub fn in_sphere_perturbed_exact(points: [ExactPoint3<'_>; 5]) -> bool {
    if let [
        ExactPoint3::Given(a),
        ExactPoint3::Given(b),
        ExactPoint3::Given(c),
        ExactPoint3::Given(d),
        ExactPoint3::Given(e),
    ] = points
    {
        return in_sphere_perturbed(a, b, c, d, e);
    }
    in_sphere_mixed(points)
}

fn in_sphere_mixed(points: [ExactPoint3<'_>; 5]) -> bool {
    let [a, b, c, d, e] = &points;
    let [ae, be, ce, de] = [a, b, c, d].map(|corner| Difference::new(corner, e));
    let sign = difference::in_sphere([&ae, &be, &ce, &de]);
    match sign.unwrap_or_else(|| whole_in_sphere(points)) {
        Sign::Positive => true,
        Sign::Negative => false,
        Sign::Zero => tie(points),
    }
}

/// Answer for five lifted points on one hyperplane.
#[cold]
fn tie(points: [ExactPoint3<'_>; 5]) -> bool {
    let [a, b, c, d, e] = points;
    let by_place = |i: usize, j: usize| -> Ordering {
        let order = points[i].cmp_lexicographic(&points[j]);
        order.then(i.cmp(&j))
    };
    raised_first::<5>(by_place, |raised| match raised {
        0 => orient3d_exact([e, b, c, d]),
        1 => orient3d_exact([a, e, c, d]),
        2 => orient3d_exact([a, b, e, d]),
        3 => orient3d_exact([a, b, c, e]),
        _ => -orient3d_exact([a, b, c, d]),
    })
}

#[cold]
fn whole_orient3d(points: [ExactPoint3<'_>; 4]) -> Sign {
    let [a, b, c, d] = whole(points);
    let [a, b, c] = [a, b, c].map(|corner| minus(&corner, &d));
    -sign(&det3(&a, &b, &c))
}

#[cold]
fn whole_in_sphere(points: [ExactPoint3<'_>; 5]) -> Sign {
    let [a, b, c, d, e] = whole(points);
    let [a, b, c, d] = [a, b, c, d].map(|corner| minus(&corner, &e));
    let lift = |corner| dot(corner, corner);
    let even = lift(&a) * det3(&b, &c, &d) + lift(&c) * det3(&d, &a, &b);
    let odd = lift(&b) * det3(&c, &d, &a) + lift(&d) * det3(&a, &b, &c);
    sign(&(even - odd))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::in_ball::in_sphere;
    use crate::on_segment::SegmentPoint3;
    use glam::DVec3;
    use proptest::prelude::*;

    /// Points of a small lattice, some of them moved off it by next to nothing.
    fn place() -> impl Strategy<Value = DVec3> {
        let coordinate = prop_oneof![
            (-3_i32..4).prop_map(f64::from),
            (-3_i32..4).prop_map(|x| f64::from(x) * 0.1),
            (-3_i32..4).prop_map(|x| f64::from(x) + 1e-15),
            -1.0..1.0_f64,
        ];
        prop::array::uniform3(coordinate).prop_map(DVec3::from)
    }

    fn point() -> impl Strategy<Value = SegmentPoint3> {
        let share = prop_oneof![
            Just(0.0),
            Just(0.5),
            Just(1.0),
            Just(1.0 / 3.0),
            Just(1e-9),
            0.0..1.0_f64
        ];
        (place(), place(), share).prop_map(|(from, to, share)| SegmentPoint3::new(from, to, share))
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(4000))]

        /// The filters say what integers say, also where points are ends of segments and given as such.
        #[test]
        fn filters_agree_with_integers(points in prop::array::uniform5(point())) {
            let all = points.each_ref().map(ExactPoint3::OnSegment);
            let [a, b, c, d, e] = all;
            prop_assert_eq!(orient3d_mixed([a, b, c, d]), whole_orient3d([a, b, c, d]));
            let [ae, be, ce, de] = [a, b, c, d].map(|corner| Difference::new(&corner, &e));
            let filtered = difference::in_sphere([&ae, &be, &ce, &de]);
            let exact = whole_in_sphere(all);
            prop_assert!(filtered.is_none_or(|sign| sign == exact));
            let order = a.cmp_lexicographic(&b);
            let integers = whole([a, b]);
            prop_assert_eq!(order, integers[0].cmp(&integers[1]));
            let same = |p: &SegmentPoint3| p.share() == 0.0 || p.ends()[0] == p.ends()[1];
            let known = all.map(|p| match p {
                ExactPoint3::OnSegment(point) if same(point) => ExactPoint3::Given(point.ends()[0]),
                other => other,
            });
            prop_assert_eq!(orient3d_exact([known[0], known[1], known[2], known[3]]), orient3d_mixed([a, b, c, d]));
            prop_assert_eq!(in_sphere_perturbed_exact(known), in_sphere_mixed(all));
        }

        #[test]
        fn ends_of_segments_are_given_points(points in prop::array::uniform5(place())) {
            let [a, b, c, d, e] = points;
            let ends = points.map(|p| SegmentPoint3::new(p, p + DVec3::X, 0.0));
            let all = ends.each_ref().map(ExactPoint3::OnSegment);
            prop_assert_eq!(in_sphere_mixed(all), in_sphere_perturbed(a, b, c, d, e));
            prop_assert_eq!(whole_in_sphere(all), in_sphere(a, b, c, d, e));
            prop_assert_eq!(orient3d_mixed([all[0], all[1], all[2], all[3]]), orient3d(a, b, c, d));
        }
    }

    #[test]
    fn a_point_is_on_all_planes_of_its_segment() {
        let [p, q, r] = [
            DVec3::new(0.1, 0.2, 0.3),
            DVec3::new(-7.3, 0.9, 1e-9),
            DVec3::new(3.0, 1e5, 0.7),
        ];
        for share in [0.3, 1e-12, 0.999_999_999_999, 1.0 / 3.0] {
            let [first, second] = [share, share / 2.0].map(|share| SegmentPoint3::new(p, q, share));
            let [p, q, r] = [p, q, r].map(ExactPoint3::Given);
            let [first, second] = [&first, &second].map(ExactPoint3::OnSegment);
            assert_eq!(orient3d_exact([p, q, r, first]), Sign::Zero);
            assert_eq!(orient3d_exact([p, first, r, second]), Sign::Zero);
        }
    }
}
