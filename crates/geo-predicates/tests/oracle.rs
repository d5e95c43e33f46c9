//! A million signs per predicate against exact integers of any length, and a sample of those
//! against exact rationals.
//!
//! Doubles are integers times powers of two, so over one common power every query is a query of
//! integers, and the textbook determinant of those has the exact sign. The rational check divides
//! out circumcenters instead. Five families of input in turn: generic, small lattices at any
//! scale, tenths a few units in the last place off, coordinates of unrelated magnitudes over the
//! whole accepted range, and lattices at one end of the range whose zeros hold dust from the other.

#![allow(clippy::unwrap_used)]

use geo_predicates::filter::{Filter2, Filter3, Relative2, Relative3};
use geo_predicates::{
    DVec2, DVec3, Sign, WeightedPoint2, WeightedPoint3, check_points3, check_weights, in_circle,
    in_diametral_ball, in_diametral_circle, in_diametral_sphere, in_sphere, orient2d, orient3d,
    power_circle, power_sphere,
};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{Signed, Zero};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

const CASES: usize = 1_000_000;
const RATIONAL_CASES: usize = 5_000;

/// Points of space with weights; predicates of the plane ignore the last coordinate.
struct Query<const N: usize> {
    points: [[f64; 3]; N],
    weights: [f64; N],
}

impl<const N: usize> Query<N> {
    fn random(case: usize, rng: &mut ChaCha8Rng) -> Self {
        let step = 2f64.powi(rng.random_range(-141..=199));
        let mut query = Self {
            points: [[0.0; 3]; N],
            weights: [0.0; N],
        };
        for coordinate in query.points.as_flattened_mut() {
            *coordinate = match case % 5 {
                0 => rng.random_range(-1.0..1.0),
                1 => lattice(rng) * step,
                2 => lattice(rng) * 0.1 * (1.0 + lattice(rng) * f64::EPSILON),
                3 => any_magnitude(-142, 200, rng),
                _ => dusty(lattice(rng), 198, any_magnitude(-142, -139, rng)),
            };
        }
        for weight in &mut query.weights {
            *weight = match case % 5 {
                0 => rng.random_range(-1.0..1.0),
                1 => lattice(rng) * step * step,
                2 => lattice(rng) * 0.01 * (1.0 + lattice(rng) * f64::EPSILON),
                3 => any_magnitude(-284, 400, rng),
                _ => dusty(lattice(rng), 396, any_magnitude(-284, -278, rng)),
            };
        }
        assert_eq!(check_points3(&query.points.map(DVec3::from_array)), Ok(()));
        assert_eq!(check_weights(&query.weights), Ok(()));
        query
    }

    fn flat(&self) -> [DVec2; N] {
        self.points.map(|[x, y, _]| DVec2::new(x, y))
    }

    fn solid(&self) -> [DVec3; N] {
        self.points.map(DVec3::from_array)
    }

    /// The points' first `D` coordinates, as integers over one power of two.
    fn integers<const D: usize>(&self) -> [[BigInt; D]; N] {
        self.over(lowest(self.points.as_flattened()))
    }

    /// As [`Query::integers`], and the weights over the square of that power.
    fn weighted_integers<const D: usize>(&self) -> ([[BigInt; D]; N], [BigInt; N]) {
        let exponent = lowest(self.points.as_flattened()).min(lowest(&self.weights).div_euclid(2));
        (
            self.over(exponent),
            self.weights.map(|weight| scaled(weight, 2 * exponent)),
        )
    }

    fn over<const D: usize>(&self, exponent: i32) -> [[BigInt; D]; N] {
        self.points
            .map(|point| std::array::from_fn(|i| scaled(point[i], exponent)))
    }
}

/// Exponent of a common power of two.
fn lowest(values: &[f64]) -> i32 {
    values.iter().map(|&x| split(x).1).min().unwrap()
}

fn scaled(value: f64, exponent: i32) -> BigInt {
    let (mantissa, own) = split(value);
    if mantissa == 0 {
        BigInt::ZERO
    } else {
        BigInt::from(mantissa) << (own - exponent)
    }
}

fn lattice(rng: &mut ChaCha8Rng) -> f64 {
    f64::from(rng.random_range(-2..=2))
}

/// Any 53 bits, now and then zero, at a magnitude of 2^`least` to 2^(`greatest` + 1).
fn any_magnitude(least: i32, greatest: i32, rng: &mut ChaCha8Rng) -> f64 {
    let sign = f64::from(rng.random_range(-4..=4).signum());
    sign * rng.random_range(1.0..2.0) * 2f64.powi(rng.random_range(least..=greatest))
}

fn dusty(integer: f64, exponent: i32, dust: f64) -> f64 {
    if integer == 0.0 {
        dust
    } else {
        integer * 2f64.powi(exponent)
    }
}

/// Mantissa and exponent of a normal number; a very large exponent for zero.
fn split(value: f64) -> (i64, i32) {
    if value == 0.0 {
        return (0, i32::MAX);
    }
    let bits = value.to_bits();
    let mantissa = (bits & ((1 << 52) - 1) | 1 << 52) as i64;
    (
        if value < 0.0 { -mantissa } else { mantissa },
        ((bits >> 52) & 0x7ff) as i32 - 1075,
    )
}

fn sign_of(value: &BigInt) -> Sign {
    match value.sign() {
        num_bigint::Sign::Minus => Sign::Negative,
        num_bigint::Sign::NoSign => Sign::Zero,
        num_bigint::Sign::Plus => Sign::Positive,
    }
}

fn minus<const D: usize>(a: &[BigInt; D], b: &[BigInt; D]) -> [BigInt; D] {
    std::array::from_fn(|i| &a[i] - &b[i])
}

fn dot<const D: usize>(a: &[BigInt; D], b: &[BigInt; D]) -> BigInt {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

/// Determinant by expansion along the first column left.
fn determinant(rows: &[&[BigInt]]) -> BigInt {
    let [first, rest @ ..] = rows else {
        return BigInt::from(1);
    };
    if let [second] = rest {
        let (i, j) = (first.len() - 2, first.len() - 1);
        return &first[i] * &second[j] - &first[j] * &second[i];
    }
    let column = first.len() - rows.len();
    let mut sum = BigInt::zero();
    for i in 0..rows.len() {
        let minor: Vec<&[BigInt]> = rows
            .iter()
            .enumerate()
            .filter(|(k, _)| *k != i)
            .map(|(_, row)| *row)
            .collect();
        let term = &rows[i][column] * determinant(&minor);
        sum += if i % 2 == 0 { term } else { -term };
    }
    sum
}

/// Determinant of the vectors from the last of `N` points to the others.
fn orientation<const D: usize>(points: &[[BigInt; D]]) -> BigInt {
    let (last, others) = points.split_last().unwrap();
    let rows: Vec<[BigInt; D]> = others.iter().map(|point| minus(point, last)).collect();
    determinant(&rows.iter().map(<[BigInt; D]>::as_slice).collect::<Vec<_>>())
}

/// Determinant of the lifted vectors from the last point to the others, lifts in the last column:
/// positive for a point inside in the plane, negative in space.
fn lifted<const D: usize>(points: &[[BigInt; D]], weights: &[BigInt]) -> BigInt {
    let (last, others) = points.split_last().unwrap();
    let rows: Vec<Vec<BigInt>> = others
        .iter()
        .zip(weights)
        .map(|(point, weight)| {
            let row = minus(point, last);
            let lift = dot(&row, &row) - (weight - &weights[others.len()]);
            row.into_iter().chain([lift]).collect()
        })
        .collect();
    determinant(&rows.iter().map(Vec::as_slice).collect::<Vec<_>>())
}

/// Angle `apb` obtuse?
fn obtuse<const D: usize>([a, b, p]: &[[BigInt; D]; 3]) -> BigInt {
    -dot(&minus(a, p), &minus(b, p))
}

/// Power of `p` in terms of the inner products of the edges, times the squared double area.
fn in_ball([a, b, c, p]: &[[BigInt; 3]; 4]) -> BigInt {
    let (u, v, w) = (minus(b, a), minus(c, a), minus(p, a));
    let (uu, uv, vv) = (dot(&u, &u), dot(&u, &v), dot(&v, &v));
    let (uw, vw, ww) = (dot(&u, &w), dot(&v, &w), dot(&w, &w));
    &uu * (&uw * &vv - &vw * &uv) + &vv * (&vw * &uu - &uw * &uv) - (&uu * &vv - &uv * &uv) * ww
}

/// A filter may be in doubt, but not wrong.
fn agree(filtered: Option<Sign>, exact: Sign) {
    assert!(
        filtered.is_none_or(|sign| sign == exact),
        "{filtered:?}, not {exact:?}"
    );
}

/// Compares `CASES` signs, and demands that each of the three occurs often.
fn compare<const N: usize>(ours: impl Fn(&Query<N>) -> Sign, exact: impl Fn(&Query<N>) -> BigInt) {
    let mut rng = ChaCha8Rng::seed_from_u64(N as u64);
    let mut seen = [0; 3];
    for case in 0..CASES {
        let query = Query::random(case, &mut rng);
        let sign = ours(&query);
        assert_eq!(
            sign,
            sign_of(&exact(&query)),
            "case {case}: {:?} {:?}",
            query.points,
            query.weights
        );
        seen[(sign as i8 + 1) as usize] += 1;
    }
    assert!(seen.iter().all(|&count| count > CASES / 1000), "{seen:?}");
}

#[test]
fn orient2d_has_no_wrong_sign() {
    compare::<3>(
        |query| {
            let [a, b, c] = query.flat();
            let sign = orient2d(a, b, c);
            let filter = Filter2::for_points(&query.flat());
            let [ac, bc] = [a, b].map(|corner| Relative2::new(corner, c));
            agree(filter.orient2d(a, b, c), sign);
            agree(filter.orient_relative(&ac, &bc), sign);
            sign
        },
        |query| orientation(&query.integers::<2>()),
    );
}

#[test]
fn orient3d_has_no_wrong_sign() {
    compare::<4>(
        |query| {
            let [a, b, c, d] = query.solid();
            let sign = orient3d(a, b, c, d);
            let [ad, bd, cd] = [a, b, c].map(|corner| Relative3::new(corner, d));
            for filter in [Filter3::GENERAL, Filter3::for_points(&query.solid())] {
                agree(filter.orient3d(a, b, c, d), sign);
                agree(filter.orient_relative(&ad, &bd, &cd), sign);
            }
            sign
        },
        |query| -orientation(&query.integers::<3>()),
    );
}

#[test]
fn in_circle_has_no_wrong_sign() {
    compare::<4>(
        |query| {
            let [a, b, c, d] = query.flat();
            let sign = in_circle(a, b, c, d);
            let filter = Filter2::for_points(&query.flat());
            let [ad, bd, cd] = [a, b, c].map(|corner| Relative2::new(corner, d));
            agree(filter.in_circle_relative(&ad, &bd, &cd), sign);
            sign
        },
        |query| lifted(&query.integers::<2>(), &[const { BigInt::ZERO }; 4]),
    );
}

#[test]
fn in_sphere_has_no_wrong_sign() {
    compare::<5>(
        |query| {
            let [a, b, c, d, e] = query.solid();
            let sign = in_sphere(a, b, c, d, e);
            let filter = Filter3::for_points(&query.solid());
            let [ae, be, ce, de] = [a, b, c, d].map(|corner| Relative3::new(corner, e));
            agree(filter.in_sphere_relative(&ae, &be, &ce, &de), sign);
            sign
        },
        |query| -lifted(&query.integers::<3>(), &[const { BigInt::ZERO }; 5]),
    );
}

#[test]
fn in_diametral_circle_has_no_wrong_sign() {
    compare::<3>(
        |query| {
            let [a, b, p] = query.flat();
            in_diametral_circle(a, b, p)
        },
        |query| obtuse(&query.integers::<2>()),
    );
}

#[test]
fn in_diametral_sphere_has_no_wrong_sign() {
    compare::<3>(
        |query| {
            let [a, b, p] = query.solid();
            in_diametral_sphere(a, b, p)
        },
        |query| obtuse(&query.integers::<3>()),
    );
}

#[test]
fn in_diametral_ball_has_no_wrong_sign() {
    compare::<4>(
        |query| {
            let [a, b, c, p] = query.solid();
            in_diametral_ball(a, b, c, p)
        },
        |query| in_ball(&query.integers()),
    );
}

#[test]
fn power_circle_has_no_wrong_sign() {
    compare::<4>(
        |query| {
            let [a, b, c, d] = std::array::from_fn(|i| WeightedPoint2 {
                point: query.flat()[i],
                weight: query.weights[i],
            });
            power_circle(a, b, c, d)
        },
        |query| {
            let (points, weights) = query.weighted_integers::<2>();
            lifted(&points, &weights)
        },
    );
}

#[test]
fn power_sphere_has_no_wrong_sign() {
    compare::<5>(
        |query| {
            let [a, b, c, d, e] = std::array::from_fn(|i| WeightedPoint3 {
                point: query.solid()[i],
                weight: query.weights[i],
            });
            power_sphere(a, b, c, d, e)
        },
        |query| {
            let (points, weights) = query.weighted_integers::<3>();
            -lifted(&points, &weights)
        },
    );
}

/// The ball of `abc` by its circumcenter, in rationals; `None` for collinear corners.
fn in_ball_by_center([a, b, c, p]: [[f64; 3]; 4]) -> Option<Sign> {
    let point = |p: [f64; 3]| p.map(|x| BigRational::from_float(x).unwrap());
    let minus = |p: &[BigRational; 3], q: &[BigRational; 3]| -> [BigRational; 3] {
        std::array::from_fn(|i| &p[i] - &q[i])
    };
    let dot = |p: &[BigRational; 3], q: &[BigRational; 3]| -> BigRational {
        p.iter().zip(q).map(|(x, y)| x * y).sum()
    };
    let [a, b, c, p] = [a, b, c, p].map(point);
    let (u, v) = (minus(&b, &a), minus(&c, &a));
    let (uu, uv, vv) = (dot(&u, &u), dot(&u, &v), dot(&v, &v));
    let gram = (&uu * &vv - &uv * &uv) * BigRational::from_float(2.0).unwrap();
    if gram.is_zero() {
        return None;
    }
    let (s, t) = (&vv * (&uu - &uv) / &gram, &uu * (&vv - &uv) / &gram);
    let center: [BigRational; 3] = std::array::from_fn(|i| &a[i] + &s * &u[i] + &t * &v[i]);
    let [radius, distance] = [&a, &p].map(|q| minus(q, &center)).map(|r| dot(&r, &r));
    let power = radius - distance;
    Some(if power.is_zero() {
        Sign::Zero
    } else if power.is_positive() {
        Sign::Positive
    } else {
        Sign::Negative
    })
}

#[test]
fn the_ball_of_a_triangle_agrees_with_its_rational_circumcenter() {
    let mut rng = ChaCha8Rng::seed_from_u64(9);
    for case in 0..RATIONAL_CASES {
        let query = Query::<4>::random(case, &mut rng);
        let [a, b, c, p] = query.solid();
        let expected = in_ball_by_center(query.points).unwrap_or(Sign::Zero);
        assert_eq!(
            in_diametral_ball(a, b, c, p),
            expected,
            "case {case}: {:?}",
            query.points
        );
    }
}
