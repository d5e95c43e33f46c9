//! The in-sphere determinant in doubled precision, four lanes wide: for points near a common sphere, where
//! cached spheres and plain doubles decide nothing.
//!
//! A number is a pair of doubles whose sum it is, not normalised: the smaller one is at most `17 u` times
//! the magnitude `m` that the larger one could have without cancellation (`u = 2^-53`). Differences of
//! coordinates are exact. A product neglects the product of the smaller parts and rounds twice, a sum
//! rounds twice: both err by at most `68 u^2 m`. Forward error analysis of the same formula in plain
//! doubles, each operation erring by `u m`, gives `1104 u Mx My Mz M^2`, with `Mx`, `My`, `Mz` the greatest
//! differences and `M` the greatest of these; so here the bound is `1104 * 68 u^2 Mx My Mz M^2`, less than
//! [`BOUND`] times that. All numbers are multiples of 2^-970 and below 2^1018 for accepted coordinates, so
//! nothing underflows or overflows.

use super::wide::{Points, broadcast, transposed};
use geo_predicates::Sign;
use glam::DVec3;
use std::arch::x86_64::*;

/// `1104 * 68 * 2^-106 = 9.3e-28`, and slack for rounding the bound itself.
const BOUND: f64 = 1.0e-27;

/// Four numbers, each the sum of two doubles.
#[derive(Clone, Copy)]
struct Pair {
    high: __m256d,
    low: __m256d,
}

#[target_feature(enable = "avx2,fma,popcnt")]
#[inline]
fn exact_sum(a: __m256d, b: __m256d) -> Pair {
    let high = _mm256_add_pd(a, b);
    let part = _mm256_sub_pd(high, a);
    let low = _mm256_add_pd(
        _mm256_sub_pd(a, _mm256_sub_pd(high, part)),
        _mm256_sub_pd(b, part),
    );
    Pair { high, low }
}

#[target_feature(enable = "avx2,fma,popcnt")]
#[inline]
fn sum(a: Pair, b: Pair) -> Pair {
    let Pair { high, low } = exact_sum(a.high, b.high);
    let low = _mm256_add_pd(low, _mm256_add_pd(a.low, b.low));
    Pair { high, low }
}

#[target_feature(enable = "avx2,fma,popcnt")]
#[inline]
fn negative(a: Pair) -> Pair {
    let minus = _mm256_set1_pd(-0.0);
    Pair {
        high: _mm256_xor_pd(a.high, minus),
        low: _mm256_xor_pd(a.low, minus),
    }
}

#[target_feature(enable = "avx2,fma,popcnt")]
#[inline]
fn product(a: Pair, b: Pair) -> Pair {
    let high = _mm256_mul_pd(a.high, b.high);
    let rounding = _mm256_fmsub_pd(a.high, b.high, high);
    let low = _mm256_fmadd_pd(a.low, b.high, _mm256_fmadd_pd(a.high, b.low, rounding));
    Pair { high, low }
}

/// Lane `i` becomes lane `i - STEPS`, cyclically: with `ORDER` 0x39 one step, with 0x4E two.
#[target_feature(enable = "avx2,fma,popcnt")]
#[inline]
fn turned<const ORDER: i32>(a: Pair) -> Pair {
    Pair {
        high: _mm256_permute4x64_pd::<ORDER>(a.high),
        low: _mm256_permute4x64_pd::<ORDER>(a.low),
    }
}

/// `a x - b y` in each lane, of vectors `(a, y)` and `(b, x)`.
#[target_feature(enable = "avx2,fma,popcnt")]
#[inline]
fn minor([ax, ay]: [Pair; 2], [bx, by]: [Pair; 2]) -> Pair {
    sum(product(ax, by), negative(product(bx, ay)))
}

/// `in_sphere(a, b, c, d, e)` if doubled precision can tell.
///
/// The lanes are the corners `a`, `b`, `c`, `d` and what belongs to them in turn.
#[target_feature(enable = "avx2,fma,popcnt")]
pub(super) fn in_sphere(corners: [DVec3; 4], e: DVec3) -> Option<Sign> {
    const ONE: i32 = 0x39;
    const TWO: i32 = 0x4E;
    let rows = corners.map(|p| _mm256_set_pd(0.0, p.z, p.y, p.x));
    let [x, y, z, _] = transposed(rows);
    let minus = broadcast(-e);
    let [x, y, z] = [
        exact_sum(x, minus[0]),
        exact_sum(y, minus[1]),
        exact_sum(z, minus[2]),
    ];
    let lift = sum(sum(product(x, x), product(y, y)), product(z, z));
    // ab, bc, cd, da; then ac, bd, ca, db.
    let near = minor([x, y], [turned::<ONE>(x), turned::<ONE>(y)]);
    let far = minor([x, y], [turned::<TWO>(x), turned::<TWO>(y)]);
    // abc, bcd, cda, dab; then bcd, cda, dab, abc.
    let volume = sum(
        sum(
            product(z, turned::<ONE>(near)),
            negative(product(turned::<ONE>(z), far)),
        ),
        product(turned::<TWO>(z), near),
    );
    let opposite = turned::<ONE>(volume);
    let terms = product(lift, opposite);
    let alternate = _mm256_set_pd(-0.0, 0.0, -0.0, 0.0);
    let terms = Pair {
        high: _mm256_xor_pd(terms.high, alternate),
        low: _mm256_xor_pd(terms.low, alternate),
    };
    let halves = sum(terms, turned::<ONE>(terms));
    let whole = sum(halves, turned::<TWO>(halves));
    let value = _mm256_cvtsd_f64(_mm256_add_pd(whole.high, whole.low));
    let bound = bound([x.high, y.high, z.high]);
    let certain = value.abs() > bound;
    certain.then(|| Sign::of(value))
}

/// What the determinant may be wrong by, from the differences.
#[target_feature(enable = "avx2,fma,popcnt")]
#[inline]
fn bound(differences: Points) -> f64 {
    let [x, y, z] = differences.map(|lanes| {
        let size = _mm256_andnot_pd(_mm256_set1_pd(-0.0), lanes);
        let pairs = _mm256_max_pd(size, _mm256_permute4x64_pd::<0x4E>(size));
        let most = _mm256_max_pd(pairs, _mm256_permute4x64_pd::<0x39>(pairs));
        _mm256_cvtsd_f64(most)
    });
    let most = x.max(y).max(z);
    BOUND * (x * y * z) * (most * most)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn coordinate() -> impl Strategy<Value = f64> {
        prop_oneof![
            -1.0..1.0,
            (-3i32..=3).prop_map(|i| f64::from(i) * 0.1),
            (-3i32..=3, -2i32..=2)
                .prop_map(|(i, k)| f64::from(i) * 0.1 * (1.0 + f64::from(k) * f64::EPSILON)),
            (-1.0..1.0).prop_map(|x: f64| x * 1e-9),
        ]
    }

    fn point() -> impl Strategy<Value = DVec3> {
        let anywhere = [coordinate(), coordinate(), coordinate()].prop_map(DVec3::from_array);
        let on_sphere = [-1.0..1.0, -1.0..1.0, -1.0..1.0]
            .prop_map(|p| DVec3::from_array(p).normalize_or(DVec3::X));
        prop_oneof![anywhere, on_sphere.clone(), on_sphere]
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(20_000))]

        #[test]
        fn what_doubled_precision_decides_is_right(
            [a, b, c, d, e] in [point(), point(), point(), point(), point()],
            exponent in prop_oneof![Just(0), Just(-90), Just(198)],
        ) {
            prop_assume!(super::super::wide::is_supported());
            let scale = 2f64.powi(exponent);
            let [a, b, c, d, e] = [a, b, c, d, e].map(|p| p * scale);
            prop_assume!(geo_predicates::check_points3(&[a, b, c, d, e]).is_ok());
            // SAFETY: the processor was asked.
            let found = unsafe { in_sphere([a, b, c, d], e) };
            let exact = geo_predicates::in_sphere(a, b, c, d, e);
            prop_assert!(found.is_none_or(|sign| sign == exact));
        }
    }

    /// Points rounded to a sphere are within a few units in the last place of it: plain doubles say
    /// nothing, doubled ones nearly always do.
    #[test]
    fn points_rounded_to_a_sphere_are_told_apart() {
        if !super::super::wide::is_supported() {
            return;
        }
        let place = |i: u64| {
            let part = |k: u64| ((3 * i + k).wrapping_mul(0x9E37_79B9_7F4A_7C15) >> 20) as f64;
            (DVec3::new(part(0), part(1), part(2)) - (1u64 << 43) as f64).normalize()
        };
        let told = (0..200).filter(|i| {
            let [a, b, c, d, e] = [0, 1, 2, 3, 4].map(|k| place(5 * i + k));
            // SAFETY: the processor was asked.
            unsafe { in_sphere([a, b, c, d], e) }.is_some()
        });
        assert!(told.count() > 195);
    }
}
