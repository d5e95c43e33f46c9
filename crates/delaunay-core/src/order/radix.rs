//! Stable sorting of integers by a range of their bits, on several threads.
//!
//! Each thread sorts a share digit by digit from the lowest (least significant digit first), moving keys
//! between two buffers; sorted shares are merged in pairs. The result does not depend on the number of
//! threads, because both steps keep keys with equal bits in order.

use crate::threads;
use std::mem::{swap, take};
use std::ops::Range;

/// Greatest width of a digit, in bits: its counters and as many ends of runs stay in the first cache.
const DIGIT_BITS: u32 = 9;

/// Sorts `keys` by the bits in `bits`, on `threads` threads; the result is in one of the two buffers.
///
/// `spare` is as long as `keys` and keeps nothing of value.
pub(super) fn sort_by_bits<'a>(
    mut keys: &'a mut [u64],
    mut spare: &'a mut [u64],
    bits: Range<u32>,
    threads: usize,
) -> &'a mut [u64] {
    let mut share = threads::share(keys.len(), threads);
    let passes = bits.len().div_ceil(DIGIT_BITS as usize) as u32;
    let shares = keys.chunks_mut(share).zip(spare.chunks_mut(share));
    threads::for_each(shares.collect(), |(keys, spare)| {
        sort_share(keys, spare, &bits, passes);
    });
    if passes % 2 == 1 {
        swap(&mut keys, &mut spare);
    }
    while share < keys.len() {
        let pairs = keys.chunks(2 * share).zip(spare.chunks_mut(2 * share));
        let pieces = threads.div_ceil(pairs.len());
        let merges = pairs.flat_map(|(pair, merged)| {
            let (left, right) = pair.split_at(share.min(pair.len()));
            cut_merge([left, right], merged, pieces, bits.start)
        });
        threads::for_each(merges.collect(), |merge| merge.run(bits.start));
        swap(&mut keys, &mut spare);
        share *= 2;
    }
    keys
}

/// Sorts `keys` in `passes` passes; an odd number of passes leaves the result in `spare`.
fn sort_share(keys: &mut [u64], spare: &mut [u64], bits: &Range<u32>, passes: u32) {
    let (mut from, mut to) = (keys, spare);
    let mut low = bits.start;
    for pass in 0..passes {
        let width = (bits.end - low).div_ceil(passes - pass);
        scatter(from, to, low, width);
        swap(&mut from, &mut to);
        low += width;
    }
}

/// Copies `from` to `to`, sorted by `width` bits from `low` on.
fn scatter(from: &[u64], to: &mut [u64], low: u32, width: u32) {
    let digit = |key: u64| (key >> low) as usize & ((1 << width) - 1);
    let mut ends = [0_u32; 1 << DIGIT_BITS];
    for &key in from {
        ends[digit(key)] += 1;
    }
    let mut start = 0;
    for end in &mut ends {
        start += std::mem::replace(end, start);
    }
    for &key in from {
        let end = &mut ends[digit(key)];
        to[*end as usize] = key;
        *end += 1;
    }
}

/// Two sorted runs and where they go when merged.
struct Merge<'a> {
    left: &'a [u64],
    right: &'a [u64],
    merged: &'a mut [u64],
}

impl Merge<'_> {
    fn run(self, low: u32) {
        let (mut l, mut r) = (0, 0);
        for place in self.merged {
            let from_left = match (self.left.get(l), self.right.get(r)) {
                (Some(a), Some(b)) => a >> low <= b >> low,
                (left, _) => left.is_some(),
            };
            *place = if from_left {
                self.left[l]
            } else {
                self.right[r]
            };
            l += usize::from(from_left);
            r += usize::from(!from_left);
        }
    }
}

/// Merging two runs, in several pieces that can be merged at the same time.
fn cut_merge<'a>(
    [left, right]: [&'a [u64]; 2],
    mut merged: &'a mut [u64],
    pieces: usize,
    low: u32,
) -> Vec<Merge<'a>> {
    let (mut l, mut r) = (0, 0);
    let total = merged.len();
    let cut = |piece| {
        let end = total * piece / pieces;
        let l_end = split(left, right, end, low);
        let r_end = end - l_end;
        let (target, rest) = take(&mut merged).split_at_mut(end - l - r);
        let merge = Merge {
            left: &left[l..l_end],
            right: &right[r..r_end],
            merged: target,
        };
        (l, r, merged) = (l_end, r_end, rest);
        merge
    };
    (1..=pieces).map(cut).collect()
}

/// How many of the first `total` merged keys come from `left`.
fn split(left: &[u64], right: &[u64], total: usize, low: u32) -> usize {
    let (mut few, mut many) = (total.saturating_sub(right.len()), total.min(left.len()));
    while few < many {
        let middle = few.midpoint(many);
        // The key left[middle] is among the first unless right[total - middle - 1] comes before it.
        if left[middle] >> low <= right[total - middle - 1] >> low {
            few = middle + 1;
        } else {
            many = middle;
        }
    }
    few
}

#[cfg(test)]
mod tests {
    use super::*;

    fn scrambled(count: usize, mask: u64) -> Vec<u64> {
        let step = |i: u64| i.wrapping_mul(0x9E37_79B9_7F4A_7C15) ^ (i << 7);
        (0..count as u64).map(|i| step(i) & mask).collect()
    }

    #[test]
    fn keys_are_sorted_by_the_given_bits_and_stable_for_any_number_of_threads() {
        for count in [0, 1, 2, 3, 10, 1000, 4097] {
            for (bits, mask) in [
                (0..8, 0xFF_FFFF),
                (13..40, u64::MAX),
                (3..4, 31),
                (5..5, 99),
            ] {
                let given = scrambled(count, mask);
                let digit = |key: &u64| (key >> bits.start) & ((1_u64 << bits.len()) - 1);
                let used = |key: &u64| key & ((1 << bits.end) - 1);
                let given: Vec<u64> = given.iter().map(used).collect();
                let mut expected = given.clone();
                expected.sort_by_key(digit);
                for threads in [1, 2, 3, 8, 5000] {
                    let mut keys = given.clone();
                    let mut spare = vec![0; keys.len()];
                    let sorted = sort_by_bits(&mut keys, &mut spare, bits.clone(), threads);
                    assert_eq!(sorted, expected, "{count} {bits:?} {threads}");
                }
            }
        }
    }
}
