//! The two hottest loops on processors with AVX2 and FMA: four neighbours tested at a time, four
//! circumspheres made at a time. What they compute is what [`dig`](super::dig) and
//! [`star`](super::star) compute, up to the rounding that the tolerance of the spheres covers.

use super::circumsphere::{
    Circumsphere, MAX_CONDITION2, MAX_OFFSET2, MIN_PRODUCT2, RADIUS2, TOLERANCE,
};
use super::doubled;
use super::inserter::Inserter;
use super::pile::Pile;
use super::star::LINK;
use crate::ids::{FacetId, TetId};
use crate::tet::sight::Sight3;
use glam::DVec3;
use std::arch::x86_64::*;

/// Byte shuffles that move the 32-bit lanes named by the bits of the index to the front.
static TO_FRONT: [[u8; 16]; 16] = to_front();

const fn to_front() -> [[u8; 16]; 16] {
    let mut table = [[0x80; 16]; 16];
    let mut mask = 0;
    while mask < 16 {
        let (mut lane, mut front) = (0, 0);
        while lane < 4 {
            if mask >> lane & 1 == 1 {
                let mut byte = 0;
                while byte < 4 {
                    table[mask][4 * front + byte] = (4 * lane + byte) as u8;
                    byte += 1;
                }
                front += 1;
            }
            lane += 1;
        }
        mask += 1;
    }
    table
}

/// Whether this processor can run this file.
pub(super) fn is_supported() -> bool {
    is_x86_feature_detected!("avx2")
        && is_x86_feature_detected!("fma")
        && is_x86_feature_detected!("popcnt")
}

/// Rows to columns of four vectors of four doubles.
#[target_feature(enable = "avx2,fma,popcnt")]
#[inline]
pub(super) fn transposed([a, b, c, d]: [__m256d; 4]) -> [__m256d; 4] {
    let (ab_low, ab_high) = (_mm256_unpacklo_pd(a, b), _mm256_unpackhi_pd(a, b));
    let (cd_low, cd_high) = (_mm256_unpacklo_pd(c, d), _mm256_unpackhi_pd(c, d));
    [
        _mm256_permute2f128_pd::<0x20>(ab_low, cd_low),
        _mm256_permute2f128_pd::<0x20>(ab_high, cd_high),
        _mm256_permute2f128_pd::<0x31>(ab_low, cd_low),
        _mm256_permute2f128_pd::<0x31>(ab_high, cd_high),
    ]
}

/// Three coordinates of four points.
pub(super) type Points = [__m256d; 3];

#[target_feature(enable = "avx2,fma,popcnt")]
#[inline]
fn dot([ax, ay, az]: Points, [bx, by, bz]: Points) -> __m256d {
    _mm256_fmadd_pd(ax, bx, _mm256_fmadd_pd(ay, by, _mm256_mul_pd(az, bz)))
}

#[target_feature(enable = "avx2,fma,popcnt")]
#[inline]
fn cross([ax, ay, az]: Points, [bx, by, bz]: Points) -> Points {
    [
        _mm256_fmsub_pd(ay, bz, _mm256_mul_pd(az, by)),
        _mm256_fmsub_pd(az, bx, _mm256_mul_pd(ax, bz)),
        _mm256_fmsub_pd(ax, by, _mm256_mul_pd(ay, bx)),
    ]
}

#[target_feature(enable = "avx2,fma,popcnt")]
#[inline]
fn minus([ax, ay, az]: Points, [bx, by, bz]: Points) -> Points {
    [
        _mm256_sub_pd(ax, bx),
        _mm256_sub_pd(ay, by),
        _mm256_sub_pd(az, bz),
    ]
}

#[target_feature(enable = "avx2,fma,popcnt")]
#[inline]
pub(super) fn broadcast(p: DVec3) -> Points {
    [
        _mm256_set1_pd(p.x),
        _mm256_set1_pd(p.y),
        _mm256_set1_pd(p.z),
    ]
}

/// Four spheres, by coordinate of the center; radii in single precision and stamps.
struct Spheres {
    center: Points,
    radius2: __m128,
    stamp: __m128i,
}

impl<const SHARED: bool> Inserter<SHARED> {
    /// As [`dig`](Self::dig).
    #[target_feature(enable = "avx2,fma,popcnt")]
    pub(super) fn dig_wide(&mut self, p: DVec3, seed: TetId) -> bool {
        if !self.open(seed) {
            return false;
        }
        let place = broadcast(p);
        let inside = _mm_set1_epi32((self.stamp + 1) as i32);
        let corners = _mm_set_epi32(3, 2, 1, 0);
        let mut next = 0;
        while next < self.dug.len() {
            self.make_room();
            let t = self.dug.at(next);
            next += 1;
            if SHARED && !self.owns(t) {
                return false;
            }
            let queued = if next < self.dug.len() {
                self.dug.at(next)
            } else {
                t
            };
            self.prefetch_neighbors(queued);
            let twins = self.arena.tet(t).twin;
            let across = twins.map(FacetId::tet);
            let twins = as_lanes(twins.map(FacetId::raw));
            let tets = _mm_srli_epi32::<2>(twins);
            let spheres = self.load_spheres(across);
            let arm = minus(place, spheres.center);
            let radius2 = _mm256_cvtps_pd(spheres.radius2);
            let depth = _mm256_sub_pd(radius2, dot(arm, arm));
            let tolerance = _mm256_mul_pd(radius2, _mm256_set1_pd(TOLERANCE));
            let kept = _mm256_cmp_pd::<_CMP_GT_OQ>(depth, tolerance);
            let outside = _mm256_cmp_pd::<_CMP_LT_OQ>(depth, negative(tolerance));
            let mut kept = _mm256_movemask_pd(kept) as u32;
            let doubt = !(kept | _mm256_movemask_pd(outside) as u32) & 15;
            let mut stamps = spheres.stamp;
            if doubt != 0 {
                kept |= self.ask_all(across, p, doubt, &mut stamps);
            }
            let met = _mm_cmpeq_epi32(stamps, inside);
            let is_new = kept & !(_mm_movemask_ps(_mm_castsi128_ps(met)) as u32);
            self.stamp_all(across, kept, stamps, inside);
            let first = _mm_set1_epi32(t.facet(0).raw() as i32);
            push_lanes(&mut self.dug, tets, is_new);
            push_lanes(&mut self.outer, twins, !kept & 15);
            push_lanes(&mut self.inner, _mm_or_si128(first, corners), !kept & 15);
        }
        true
    }

    /// Brings near what the next tetrahedron in the queue will ask for.
    #[inline(always)]
    fn prefetch_neighbors(&self, queued: TetId) {
        for twin in self.arena.tet(queued).twin {
            self.arena.prefetch(twin.tet());
        }
    }

    #[target_feature(enable = "avx2,fma,popcnt")]
    #[inline]
    fn load_spheres(&self, tets: [TetId; 4]) -> Spheres {
        let rows = tets.map(|t| {
            let sphere: *const Circumsphere = self.arena.sphere(t);
            // SAFETY: a sphere is a record of 32 bytes without padding, aligned to 32.
            unsafe { _mm256_load_pd(sphere.cast()) }
        });
        let [x, y, z, rest] = transposed(rows);
        let evens_first = _mm256_set_epi32(7, 5, 3, 1, 6, 4, 2, 0);
        let rest = _mm256_permutevar8x32_epi32(_mm256_castpd_si256(rest), evens_first);
        Spheres {
            center: [x, y, z],
            radius2: _mm_castsi128_ps(_mm256_castsi256_si128(rest)),
            stamp: _mm256_extracti128_si256::<1>(rest),
        }
    }

    /// Asks about the tetrahedra in `doubt`: which of them are in the cavity, their stamps updated.
    #[cold]
    #[inline(never)]
    #[target_feature(enable = "avx2,fma,popcnt")]
    fn ask_all(&self, tets: [TetId; 4], p: DVec3, doubt: u32, stamps: &mut __m128i) -> u32 {
        let stamped = |stamp: u32| {
            let known = _mm_cmpeq_epi32(*stamps, _mm_set1_epi32(stamp as i32));
            _mm_movemask_ps(_mm_castsi128_ps(known)) as u32
        };
        let (left_out, taken) = (stamped(self.stamp), stamped(self.stamp + 1));
        let mut kept = doubt & taken;
        let mut open = doubt & !(left_out | taken);
        let mut lanes = from_lanes(*stamps);
        while open != 0 {
            let i = open.trailing_zeros() as usize % 4;
            open &= open - 1;
            let inside = self.ask_in_doubled(tets[i], p);
            kept |= u32::from(inside) << i;
            lanes[i] = if inside { lanes[i] } else { self.stamp };
        }
        *stamps = as_lanes(lanes);
        kept
    }

    /// Whether `t`, not met before, is in the cavity of `p`; with doubled precision before the exact predicate.
    #[target_feature(enable = "avx2,fma,popcnt")]
    #[inline]
    fn ask_in_doubled(&self, t: TetId, p: DVec3) -> bool {
        let corners = self.arena.tet(t).vertex;
        if corners[3].is_ghost() {
            return self.in_conflict(t, p);
        }
        let sight = Sight3::new(self.arena, self.filter, p);
        sight.in_real_conflict_or(corners, |corners, p| doubled::in_sphere(corners, p))
    }

    /// Stores `inside` for the tetrahedra that are `kept`, and the stamps they have for the others.
    #[target_feature(enable = "avx2,fma,popcnt")]
    #[inline]
    fn stamp_all(&self, tets: [TetId; 4], kept: u32, stamps: __m128i, inside: __m128i) {
        let bits = _mm_set_epi32(8, 4, 2, 1);
        let chosen = _mm_and_si128(_mm_set1_epi32(kept as i32), bits);
        let chosen = _mm_cmpeq_epi32(chosen, bits);
        let stamps = from_lanes(_mm_blendv_epi8(stamps, inside, chosen));
        for (t, stamp) in tets.into_iter().zip(stamps) {
            self.arena.set_stamp(t, stamp);
        }
    }

    /// As [`make_spheres`](Self::make_spheres).
    #[target_feature(enable = "avx2,fma,popcnt")]
    pub(super) fn make_spheres_wide(&mut self, p: DVec3, next: DVec3, count: usize) {
        let (place, next) = (broadcast(p), broadcast(next));
        let mut lanes = _mm256_set_pd(3.0, 2.0, 1.0, 0.0);
        let mut least = _mm256_set1_pd(f64::INFINITY);
        let mut nearest = lanes;
        // The last group reads numbers left over by an earlier star; what it makes of them is not used.
        for first in (0..count).step_by(4) {
            let [a, b, c] = [0, 1, 2].map(|corner| self.load_arms(first, corner));
            let (center, radius2) = circumspheres(place, a, b, c);
            let arm = minus(next, center);
            let power = _mm256_sub_pd(dot(arm, arm), radius2);
            let used = _mm256_cmp_pd::<_CMP_LT_OQ>(lanes, _mm256_set1_pd(count as f64));
            let closer = _mm256_and_pd(_mm256_cmp_pd::<_CMP_LT_OQ>(power, least), used);
            least = _mm256_blendv_pd(least, power, closer);
            nearest = _mm256_blendv_pd(nearest, lanes, closer);
            lanes = _mm256_add_pd(lanes, _mm256_set1_pd(4.0));
            self.store_spheres(first, center, radius2);
        }
        self.aim = least_of(least, nearest).min(count - 1);
    }

    /// The vertices at one corner of four new tetrahedra as seen from the new vertex, and their squared
    /// lengths.
    #[target_feature(enable = "avx2,fma,popcnt")]
    #[inline]
    fn load_arms(&self, first: usize, corner: usize) -> (Points, __m256d) {
        let rows = [0, 1, 2, 3].map(|i| {
            let local = self.star.locals[first + i][corner];
            let arm: *const f64 = self.star.arms[local as usize % LINK].as_ptr();
            // SAFETY: an arm is four doubles.
            unsafe { _mm256_loadu_pd(arm) }
        });
        let [x, y, z, lift] = transposed(rows);
        ([x, y, z], lift)
    }

    #[target_feature(enable = "avx2,fma,popcnt")]
    #[inline]
    fn store_spheres(&mut self, first: usize, [x, y, z]: Points, radius2: __m256d) {
        let radius2 = _mm_castps_si128(_mm256_cvtpd_ps(radius2));
        // The upper half of the last lane is the stamp: zero.
        let rest = _mm256_castsi256_pd(_mm256_cvtepu32_epi64(radius2));
        let rows = transposed([x, y, z, rest]);
        for (sphere, row) in self.star.spheres[first..first + 4].iter_mut().zip(rows) {
            let sphere: *mut Circumsphere = sphere;
            // SAFETY: a sphere is a record of 32 bytes without padding, aligned to 32.
            unsafe { _mm256_store_pd(sphere.cast(), row) };
        }
    }
}

/// As [`Circumsphere::through`], for four: centers, and squared radii that are NaN where unknown.
#[target_feature(enable = "avx2,fma,popcnt")]
#[inline]
fn circumspheres(
    place: Points,
    (a, a_lift): (Points, __m256d),
    (b, b_lift): (Points, __m256d),
    (c, c_lift): (Points, __m256d),
) -> (Points, __m256d) {
    let (bc, ca, ab) = (cross(b, c), cross(c, a), cross(a, b));
    let d = dot(a, bc);
    let half = _mm256_div_pd(_mm256_set1_pd(0.5), d);
    let lifts = [a_lift, b_lift, c_lift];
    let arm = [0, 1, 2].map(|k| _mm256_mul_pd(half, dot(lifts, [bc[k], ca[k], ab[k]])));
    let radius2 = dot(arm, arm);
    let center = [0, 1, 2].map(|k| _mm256_add_pd(place[k], arm[k]));
    let [x, y, z] = center.map(|x| _mm256_andnot_pd(_mm256_set1_pd(-0.0), x));
    let offset = _mm256_add_pd(x, _mm256_add_pd(y, z));
    let product2 = _mm256_mul_pd(a_lift, _mm256_mul_pd(b_lift, c_lift));
    let d2 = _mm256_mul_pd(d, d);
    let offset2 = _mm256_mul_pd(offset, offset);
    let at_most = |a: __m256d, b: __m256d| _mm256_cmp_pd::<_CMP_LE_OQ>(a, b);
    let all = |a: __m256d, b: __m256d| _mm256_and_pd(a, b);
    let times = |factor: f64, x: __m256d| _mm256_mul_pd(_mm256_set1_pd(factor), x);
    let conditioned = all(
        at_most(product2, times(MAX_CONDITION2, d2)),
        at_most(_mm256_set1_pd(MIN_PRODUCT2), product2),
    );
    let in_range = all(
        at_most(_mm256_set1_pd(RADIUS2[0]), radius2),
        at_most(radius2, _mm256_set1_pd(RADIUS2[1])),
    );
    let near = at_most(offset2, times(MAX_OFFSET2, radius2));
    let known = all(conditioned, all(in_range, near));
    let unknown = _mm256_set1_pd(f64::NAN);
    (center, _mm256_blendv_pd(unknown, radius2, known))
}

/// The number beside the least of four values.
#[target_feature(enable = "avx2,fma,popcnt")]
#[inline]
fn least_of(values: __m256d, numbers: __m256d) -> usize {
    let (mut value, mut number) = ([0.0; 4], [0.0; 4]);
    // SAFETY: both arrays hold four doubles.
    unsafe {
        _mm256_storeu_pd(value.as_mut_ptr(), values);
        _mm256_storeu_pd(number.as_mut_ptr(), numbers);
    }
    let mut best = 0;
    for i in 1..4 {
        best = if value[i] < value[best] { i } else { best };
    }
    number[best] as usize
}

#[target_feature(enable = "avx2,fma,popcnt")]
#[inline]
fn negative(x: __m256d) -> __m256d {
    _mm256_xor_pd(x, _mm256_set1_pd(-0.0))
}

#[target_feature(enable = "avx2,fma,popcnt")]
#[inline]
fn as_lanes(numbers: [u32; 4]) -> __m128i {
    // SAFETY: 16 bytes are read from an array of 16 bytes.
    unsafe { _mm_loadu_si128(numbers.as_ptr().cast()) }
}

#[target_feature(enable = "avx2,fma,popcnt")]
#[inline]
fn from_lanes(lanes: __m128i) -> [u32; 4] {
    let mut numbers = [0; 4];
    // SAFETY: 16 bytes are written to an array of 16 bytes.
    unsafe { _mm_storeu_si128(numbers.as_mut_ptr().cast(), lanes) };
    numbers
}

/// Pushes the lanes that `chosen` has bits for.
#[target_feature(enable = "avx2,fma,popcnt")]
#[inline]
fn push_lanes<T: Copy>(pile: &mut Pile<T>, lanes: __m128i, chosen: u32) {
    const { assert!(size_of::<T>() == 4) };
    let order = &TO_FRONT[chosen as usize & 15];
    // SAFETY: the table has 16 bytes per entry; the piles have room for eight ids of four bytes, for
    // which any bits are valid.
    unsafe {
        let order = _mm_loadu_si128(order.as_ptr().cast());
        _mm_storeu_si128(pile.end().cast(), _mm_shuffle_epi8(lanes, order));
    }
    pile.advance((chosen & 15).count_ones() as usize);
}
