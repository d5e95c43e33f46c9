//! The common point of three planes: its side of a fourth, and its place.
//!
//! Planes are given by what defines them exactly, not by rounded equations: so the corners of Voronoi cells, cut to a
//! window or to each other, are sorted without contradictions however nearly their planes coincide. Callers put their
//! own rounded tests first; here begins the exact stage.

use crate::in_ball::in_sphere;
use crate::orient::orient3d;
use crate::sign::Sign;
use crate::unbounded::{cross3, det3, dot, least_exponent, minus, scaled, sign};
use glam::DVec3;
use num_bigint::BigInt;
use num_traits::ToPrimitive;

/// A plane with a front and a back, the front being where its normal points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Plane {
    /// The points `x` with `x · normal = limit`; all numbers finite.
    Equation {
        /// Of any length but zero, and of any size.
        normal: DVec3,
        /// The inner product of the normal with each point of the plane.
        limit: f64,
    },
    /// The points as far from `back` as from `front`, which are two points of accepted coordinates.
    Bisector {
        /// The point on the back.
        back: DVec3,
        /// The point on the front.
        front: DVec3,
    },
}

/// On which side of `plane` the common point of three planes lies: `Positive` in front of it, `Zero` on it.
///
/// Also `Zero` when the three have no common point or more than one. Exact. Bisectors of one point with four others are
/// told by [`in_sphere`]; all else takes some microseconds, more when the coordinates are far apart in size.
#[must_use]
pub fn meet_in_front(planes: [Plane; 3], plane: Plane) -> Sign {
    let [a, b, c] = planes;
    if let Some((back, [a, b, c, d])) = bisectors_of_one_point([a, b, c, plane]) {
        return in_sphere(back, a, b, c, d) * orient3d(back, a, b, c);
    }
    let [a, b, c, plane] = Equation::of([a, b, c, plane], DVec3::ZERO).1;
    let Meet { point, weight } = Meet::of(&[a, b, c]);
    sign(&(dot(&plane.normal, &point) - plane.limit * &weight)) * sign(&weight)
}

/// The common point of three planes as seen from `origin`, each coordinate rounded to within one part in 2^52, or to within
/// the smallest normal double.
///
/// `None` when the three have no common point or more than one, or when it is beyond the range of doubles.
#[must_use]
pub fn meet_place(planes: [Plane; 3], origin: DVec3) -> Option<DVec3> {
    let (exponent, planes) = Equation::of(planes, origin);
    let Meet { point, weight } = Meet::of(&planes);
    if sign(&weight) == Sign::Zero {
        return None;
    }
    let place = point.map(|coordinate| quotient(&coordinate, &weight, exponent));
    Some(DVec3::from(place)).filter(|place| place.is_finite())
}

/// The point on the back of all planes, and those in front, if they are bisectors with a common back.
fn bisectors_of_one_point(planes: [Plane; 4]) -> Option<(DVec3, [DVec3; 4])> {
    let mut common = None;
    let mut fronts = [DVec3::ZERO; 4];
    for (place, plane) in fronts.iter_mut().zip(planes) {
        let Plane::Bisector { back, front } = plane else {
            return None;
        };
        if *common.get_or_insert(back) != back {
            return None;
        }
        *place = front;
    }
    common.map(|back| (back, fronts))
}

/// The points `x` with `x · normal = limit`, in integers.
struct Equation {
    normal: [BigInt; 3],
    limit: BigInt,
}

impl Equation {
    /// Equations of planes for coordinates relative to `origin` in units of a power of two, whose exponent comes with
    /// them.
    fn of<const N: usize>(planes: [Plane; N], origin: DVec3) -> (i32, [Self; N]) {
        let mut places = vec![origin];
        for plane in planes {
            if let Plane::Bisector { back, front } = plane {
                places.extend([back, front]);
            }
        }
        let places: Vec<[f64; 3]> = places.into_iter().map(DVec3::into).collect();
        let unit = least_exponent(places.as_flattened());
        let whole = |place: DVec3| place.to_array().map(|coordinate| scaled(coordinate, unit));
        let origin = whole(origin);
        let equations = planes.map(|plane| match plane {
            Plane::Bisector { back, front } => {
                let [back, front] = [back, front].map(|place| minus(&whole(place), &origin));
                Self {
                    limit: dot(&front, &front) - dot(&back, &back),
                    normal: minus(&front, &back).map(|difference| difference << 1),
                }
            }
            Plane::Equation { normal, limit } => {
                let steepness = least_exponent(&normal.to_array());
                let limit_unit = steepness + unit;
                // The equation times a power of two that makes its limit whole.
                let lift = (limit_unit - least_exponent(&[limit])).max(0);
                let whole = |part| scaled(part, steepness) << lift as usize;
                let normal = normal.to_array().map(whole);
                let limit = scaled(limit, limit_unit - lift) - dot(&normal, &origin);
                Self { normal, limit }
            }
        });
        (unit, equations)
    }
}

/// A point in homogeneous coordinates: `point / weight`; weight 0 when there is none.
struct Meet {
    point: [BigInt; 3],
    weight: BigInt,
}

impl Meet {
    fn of([a, b, c]: &[Equation; 3]) -> Self {
        let parts = [
            (&a.limit, cross3(&b.normal, &c.normal)),
            (&b.limit, cross3(&c.normal, &a.normal)),
            (&c.limit, cross3(&a.normal, &b.normal)),
        ];
        let coordinate = |i: usize| {
            parts
                .iter()
                .map(|(limit, normal)| *limit * &normal[i])
                .sum()
        };
        Self {
            point: [coordinate(0), coordinate(1), coordinate(2)],
            weight: det3(&a.normal, &b.normal, &c.normal),
        }
    }
}

/// `dividend / divisor` times 2^`exponent`, rounded.
fn quotient(dividend: &BigInt, divisor: &BigInt, exponent: i32) -> f64 {
    /// Bits of a quotient: as many as a double has, and some.
    const BITS: i64 = 64;
    let shift = BITS + divisor.bits() as i64 - dividend.bits() as i64;
    let whole = if shift >= 0 {
        (dividend << shift as u64) / divisor
    } else {
        dividend / (divisor << shift.unsigned_abs())
    };
    let rounded = whole.to_f64().unwrap_or(f64::NAN);
    // In two steps, lest a power of two be out of range where the result is not.
    let exponent = i64::from(exponent) - shift;
    let half = (exponent / 2).clamp(-1000, 1000) as i32;
    let rest = (exponent - i64::from(half)).clamp(-1000, 1000) as i32;
    rounded * 2f64.powi(half) * 2f64.powi(rest)
}

#[cfg(test)]
mod tests {
    use super::*;
    use num_rational::BigRational;
    use num_traits::Zero;
    use proptest::prelude::*;

    fn equation(normal: [f64; 3], limit: f64) -> Plane {
        let normal = normal.into();
        Plane::Equation { normal, limit }
    }

    fn bisector(back: [f64; 3], front: [f64; 3]) -> Plane {
        let [back, front] = [back, front].map(DVec3::from);
        Plane::Bisector { back, front }
    }

    /// The planes x = 1, y = 2, z = 3, each in another way.
    fn corner() -> [Plane; 3] {
        [
            equation([0.5, 0.0, 0.0], 0.5),
            bisector([7.0, 1.0, 0.0], [7.0, 3.0, 0.0]),
            equation([0.0, 0.0, 1e-300], 3e-300),
        ]
    }

    #[test]
    fn a_corner_has_its_place() {
        let place = meet_place(corner(), DVec3::ZERO).unwrap();
        assert!(place.distance(DVec3::new(1.0, 2.0, 3.0)) < 1e-15);
        let place = meet_place(corner(), DVec3::splat(1e20)).unwrap();
        assert!((place / -1e20).distance(DVec3::ONE) < 1e-15);
        let [a, b, _] = corner();
        assert_eq!(meet_place([a, b, b], DVec3::ZERO), None);
    }

    #[test]
    fn the_last_bit_decides_the_side() {
        let a = equation([1.0, 1.0, 0.0], 0.3);
        let b = equation([1.0, -1.0, 0.0], 0.3);
        let c = equation([0.0, 0.0, 1.0], 0.0);
        let side = |limit: f64| meet_in_front([a, b, c], equation([1.0, 0.0, 0.0], limit));
        assert_eq!(side(0.3f64.next_down()), Sign::Positive);
        assert_eq!(side(0.3), Sign::Zero);
        assert_eq!(side(0.3f64.next_up()), Sign::Negative);
    }

    #[test]
    fn four_bisectors_of_one_point_are_an_in_sphere_test() {
        let tips = [[2.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 2.0]];
        let planes = tips.map(|tip| bisector([0.0; 3], tip));
        let side = |front: [f64; 3]| meet_in_front(planes, bisector([0.0; 3], front));
        assert_eq!(side([2.0, 2.0, 0.0]), Sign::Zero);
        assert_eq!(side([2.0, 2.0, 1.0]), Sign::Positive);
        assert_eq!(side([2.0, 2.0, -1.0]), Sign::Negative);
    }

    fn rational(x: f64) -> BigRational {
        BigRational::from_float(x).unwrap_or_else(BigRational::zero)
    }

    /// Normal and limit of a plane.
    fn exactly(plane: Plane) -> [BigRational; 4] {
        match plane {
            Plane::Equation { normal, limit } => {
                [normal.x, normal.y, normal.z, limit].map(rational)
            }
            Plane::Bisector { back, front } => {
                let [back, front] = [back, front].map(|p| p.to_array().map(rational));
                let half = rational(0.5);
                let square = |p: &[BigRational; 3]| p.iter().map(|x| x * x).sum::<BigRational>();
                let limit = (square(&front) - square(&back)) * half;
                let [x, y, z] = [0, 1, 2].map(|i| &front[i] - &back[i]);
                [x, y, z, limit]
            }
        }
    }

    fn determinant(rows: [&[BigRational]; 3], columns: [usize; 3]) -> BigRational {
        let at = |row: usize, column: usize| &rows[row][columns[column]];
        let minor = |i, j| at(1, i) * at(2, j) - at(1, j) * at(2, i);
        at(0, 0) * minor(1, 2) - at(0, 1) * minor(0, 2) + at(0, 2) * minor(0, 1)
    }

    /// By Cramer's rule in rational numbers.
    fn oracle([a, b, c]: [Plane; 3]) -> Option<[BigRational; 3]> {
        let rows = [a, b, c].map(exactly);
        let rows = [&rows[0][..], &rows[1][..], &rows[2][..]];
        let divisor = determinant(rows, [0, 1, 2]);
        let part = |columns| determinant(rows, columns) / divisor.clone();
        (!divisor.is_zero()).then(|| [part([3, 1, 2]), part([0, 3, 2]), part([0, 1, 3])])
    }

    fn number() -> impl Strategy<Value = f64> {
        prop_oneof![
            (-3..=3_i32).prop_map(f64::from),
            -1.0..1.0,
            (0.5..1.0_f64, -140..200_i32).prop_map(|(x, e)| x * 2f64.powi(e)),
            (0.5..1.0_f64, -140..200_i32).prop_map(|(x, e)| -x * 2f64.powi(e)),
            (0..4_i32).prop_map(|ulps| 1.0 + f64::from(ulps) * f64::EPSILON),
        ]
    }

    /// Also numbers that have lost their digits, which coordinates may not be.
    fn limit() -> impl Strategy<Value = f64> {
        prop_oneof![4 => number(), 1 => (0..30_u64).prop_map(f64::from_bits)]
    }

    fn plane() -> impl Strategy<Value = Plane> {
        let triple = || [number(), number(), number()];
        prop_oneof![
            (triple(), limit()).prop_map(|(normal, limit)| equation(normal, limit)),
            (triple(), triple()).prop_map(|(back, front)| bisector(back, front)),
            triple().prop_map(|front| bisector([0.0; 3], front)),
        ]
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(2000))]
        #[test]
        fn sides_and_places_agree_with_rational_numbers(
            planes in [plane(), plane(), plane()], fourth in plane(), origin in [number(), number(), number()],
        ) {
            let origin = DVec3::from(origin);
            let Some(point) = oracle(planes) else {
                prop_assert_eq!(meet_in_front(planes, fourth), Sign::Zero);
                prop_assert_eq!(meet_place(planes, origin), None);
                return Ok(());
            };
            let [x, y, z, limit] = exactly(fourth);
            let height = x * &point[0] + y * &point[1] + z * &point[2] - limit;
            let expected = match height.cmp(&BigRational::zero()) {
                std::cmp::Ordering::Less => Sign::Negative,
                std::cmp::Ordering::Equal => Sign::Zero,
                std::cmp::Ordering::Greater => Sign::Positive,
            };
            prop_assert_eq!(meet_in_front(planes, fourth), expected);
            if let Some(place) = meet_place(planes, origin) {
                for i in 0..3 {
                    let exact = &point[i] - rational(origin[i]);
                    let error = (rational(place[i]) - &exact) * rational(2f64.powi(52));
                    let tiny = rational(f64::MIN_POSITIVE) * rational(2f64.powi(52));
                    let abs = |x: BigRational| if x < BigRational::zero() { -x } else { x };
                    prop_assert!(abs(error) <= abs(exact) + tiny);
                }
            }
        }
    }
}
