//! Spatial insertion order: a biased random order (BRIO) whose rounds follow a Hilbert curve.
//!
//! Each point is put by a seeded coin into a round; every round is about seven times
//! larger than all before it together, and inside a round the points follow a Hilbert curve. So
//! every point lies near the one before it and the walk between them is short, while the random
//! rounds keep the expected work near n log n for any input (Amenta, Choi, Rote 2003: *Incremental
//! constructions con BRIO*).
//!
//! One `u64` per point carries round, place on the curve and index, so one sort of plain integers
//! does it all. Points that share a cell of the curve's grid in great number are sorted again along a
//! curve through their own bounding box: clusters at any scale keep short walks.

use crate::hilbert::{LEVEL_BITS, place};
use glam::DVec2;

/// Size of a round over the size of all rounds before it: 2 to this power.
///
/// Eight was measured best among 2, 4, 8, 16 and 32, all within 4 % from 8 on.
const ROUND_RATIO_LOG: u32 = 3;

/// About the size of the first round.
const FIRST_ROUND: usize = 1000;

/// Bits of the key that hold the round.
const ROUND_BITS: u32 = 4;

/// Finest grid for the curve, bits per axis.
const MAX_GRID_BITS: u32 = 20;

/// Points in one cell of the grid that are worth a curve of their own.
const CROWD: usize = 32;

/// Indices of `points` in insertion order: one entry per point, each index once.
///
/// The order depends on the points and on nothing else. Takes n log n time. Points that are not finite
/// come in some order too.
///
/// # Panics
/// When there are 2^32 points or more.
#[must_use]
pub fn insertion_order(points: &[DVec2]) -> Vec<u32> {
    assert!(
        u32::try_from(points.len()).is_ok(),
        "more points than 32 bits can number"
    );
    let layout = KeyLayout::new(points.len());
    let mut keys: Vec<u64> = (0..points.len() as u64)
        .map(|index| round_of(index, points.len()) << layout.round_shift() | index)
        .collect();
    add_places(points, &mut keys, layout);
    keys.sort_unstable();
    order_crowds(points, &mut keys, layout);
    keys.iter().map(|&key| layout.index(key) as u32).collect()
}

/// Where round, place and index sit in a key, from the highest bits to the lowest.
#[derive(Clone, Copy)]
struct KeyLayout {
    index_bits: u32,
    grid_bits: u32,
}

impl KeyLayout {
    fn new(count: usize) -> Self {
        let index_bits = (usize::BITS - count.leading_zeros()).max(1);
        let room = (64 - ROUND_BITS - index_bits) / 2;
        let grid_bits = room.min(MAX_GRID_BITS) / LEVEL_BITS * LEVEL_BITS;
        Self {
            index_bits,
            grid_bits,
        }
    }

    fn round_shift(self) -> u32 {
        self.index_bits + 2 * self.grid_bits
    }

    fn index(self, key: u64) -> usize {
        (key & ((1 << self.index_bits) - 1)) as usize
    }

    /// Round and place together: what points of one cell and round share.
    fn cell(self, key: u64) -> u64 {
        key >> self.index_bits
    }
}

/// The round of a point, 0 for the first: seven of eight points are in the last round, seven of
/// eight of the others in the last but one, and so on.
fn round_of(index: u64, count: usize) -> u64 {
    let doublings = (count / FIRST_ROUND).max(1).ilog2();
    let last = (doublings / ROUND_RATIO_LOG).min((1 << ROUND_BITS) - 1);
    let before_last = (hash(index).leading_zeros() / ROUND_RATIO_LOG).min(last);
    u64::from(last - before_last)
}

/// A fixed scrambling of the index (the finalizer of `SplitMix64`): the seed of the random order.
fn hash(index: u64) -> u64 {
    let mut z = index.wrapping_add(0x9E37_79B9_7F4A_7C15);
    z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    z ^ (z >> 31)
}

/// Writes into each key the place of its point on the curve through the bounding box of them all;
/// answers whether the box has a size, so that the places differ.
fn add_places(points: &[DVec2], keys: &mut [u64], layout: KeyLayout) -> bool {
    let grid = Grid::around(
        keys.iter().map(|&key| points[layout.index(key)]),
        layout.grid_bits,
    );
    for key in keys {
        let [x, y] = grid.cell(points[layout.index(*key)]);
        *key |= place(x, y, layout.grid_bits) << layout.index_bits;
    }
    grid.scale > 0.0
}

/// Sorts the points of every crowded cell along a curve of their own.
///
/// Ends because the bounding box of a crowd spreads over all cells along its longer side, so each
/// level splits it; equal points, which nothing splits, and points closer than accepted coordinates
/// can be are left alone.
fn order_crowds(points: &[DVec2], keys: &mut [u64], layout: KeyLayout) {
    let crowds = keys.chunk_by_mut(|&a, &b| layout.cell(a) == layout.cell(b));
    for crowd in crowds.filter(|crowd| crowd.len() > CROWD) {
        for key in crowd.iter_mut() {
            *key = layout.index(*key) as u64;
        }
        if add_places(points, crowd, layout) {
            crowd.sort_unstable();
            order_crowds(points, crowd, layout);
        }
    }
}

/// A square grid over a bounding box, 2^bits cells along the longer side.
struct Grid {
    corner: DVec2,
    scale: f64,
    last: f64,
}

impl Grid {
    fn around(points: impl Iterator<Item = DVec2>, bits: u32) -> Self {
        let nowhere = (DVec2::INFINITY, DVec2::NEG_INFINITY);
        let (low, high) = points.fold(nowhere, |(low, high), p| (low.min(p), high.max(p)));
        let side = (high - low).max_element();
        let cells = f64::from(1_u32 << bits);
        let scale = cells / side;
        // A box without a size, or too small for its cells to be counted per unit of length, has one cell.
        let divisible = side > 0.0 && scale.is_finite();
        let scale = if divisible { scale } else { 0.0 };
        Self {
            corner: low,
            scale,
            last: cells - 1.0,
        }
    }

    fn cell(&self, p: DVec2) -> [u32; 2] {
        let place = (p - self.corner) * self.scale;
        [place.x.min(self.last) as u32, place.y.min(self.last) as u32]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn spiral(count: usize) -> Vec<DVec2> {
        (0..count)
            .map(|i| {
                let t = i as f64 * 0.618_033_988_749_895;
                DVec2::new(t.fract(), (t * 1.324_717_957_244_746).fract())
            })
            .collect()
    }

    fn assert_permutation(order: &[u32]) {
        let mut sorted = order.to_vec();
        sorted.sort_unstable();
        assert!(
            sorted
                .iter()
                .enumerate()
                .all(|(i, &index)| i == index as usize)
        );
    }

    #[test]
    fn every_index_comes_once() {
        for count in [0, 1, 2, 31, 1000, 50_000] {
            let order = insertion_order(&spiral(count));
            assert_eq!(order.len(), count);
            assert_permutation(&order);
        }
    }

    #[test]
    fn the_last_round_holds_seven_eighths() {
        let count = 100_000;
        let last = (0..count).map(|i| round_of(i, 100_000)).max();
        let in_last = (0..count).filter(|&i| Some(round_of(i, 100_000)) == last);
        let share = in_last.count() as f64 / count as f64;
        assert!((share - 0.875).abs() < 0.01, "{share}");
    }

    #[test]
    fn steps_within_a_round_are_short_even_in_a_tiny_cluster() {
        let mut points: Vec<DVec2> = spiral(900).iter().map(|p| *p * 1e-9).collect();
        points.push(DVec2::splat(1.0));
        let order = insertion_order(&points);
        let steps = order.windows(2).map(|w| {
            let (a, b) = (points[w[0] as usize], points[w[1] as usize]);
            a.distance(b)
        });
        let length: f64 = steps.filter(|&step| step < 0.1).sum();
        assert!(length < 1e-9 * 3.0 * 30.0, "{length}");
    }

    #[test]
    fn points_that_are_not_finite_are_ordered_too() {
        let strange = [
            f64::NAN,
            f64::INFINITY,
            f64::NEG_INFINITY,
            0.0,
            1e308,
            -1e308,
        ];
        let mut points = Vec::new();
        for i in 0..5000 {
            points.push(DVec2::new(strange[i % 6], strange[i / 6 % 6]));
        }
        assert_permutation(&insertion_order(&points));
    }

    /// The grid over a box smaller than 2^-1004 once had infinitely many cells to a unit of length, so
    /// that no level of curves split the crowd.
    #[test]
    fn a_crowd_of_subnormal_size_is_ordered_too() {
        let points: Vec<DVec2> = (0..200)
            .map(|i| DVec2::new(f64::from_bits(i % 50), f64::from_bits(i % 3)))
            .collect();
        assert_permutation(&insertion_order(&points));
    }

    #[test]
    fn a_million_equal_points_are_ordered_at_once() {
        let order = insertion_order(&vec![DVec2::ONE; 1_000_000]);
        assert_permutation(&order);
    }
}
