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
//!
//! | step | file |
//! |---|---|
//! | points of the plane and of space | `spatial.rs` |
//! | the grid over their bounding box | `grid.rs` |
//! | round, place and index in a key | `key.rs` |
//! | sort the keys | `radix.rs` |
//! | crowded cells | `crowd.rs` |

mod crowd;
mod grid;
mod key;
mod radix;
mod spatial;

pub(crate) use key::scramble;
pub use spatial::Spatial;

use crate::memory::vec_of;
use crate::options::BuildOptions;
use crate::threads;
use crowd::order_crowds;
use grid::Grid;
use key::KeyLayout;
use radix::sort_by_bits;
use std::ops::Range;

/// Indices of `points`, of the plane or of space, in insertion order: one entry per point, each index once.
///
/// The order depends on the points and on nothing else. Takes n log n time. Points that are not finite
/// come in some order too.
///
/// # Panics
/// When there are 2^32 points or more.
///
/// ```
/// use delaunay_core::order::insertion_order;
/// use glam::DVec3;
///
/// let corners = [DVec3::ZERO, DVec3::ONE, DVec3::X];
/// let mut order = insertion_order(&corners);
/// order.sort_unstable();
/// assert_eq!(order, [0, 1, 2]);
/// ```
#[must_use]
pub fn insertion_order<P: Spatial>(points: &[P]) -> Vec<u32> {
    Order::of(points, BuildOptions::default()).indices
}

/// An insertion order and its structure.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Order {
    /// Indices of points in insertion order. A place in it is the *rank* of a point.
    pub(crate) indices: Vec<u32>,
    /// The ranks of each round, one after the other; a round may be empty.
    pub(crate) rounds: Vec<Range<usize>>,
    /// For each round, the rank at which it comes to each [stretch](Self::STRETCHES) of the curve.
    pub(crate) stretches: Vec<[u32; Self::STRETCHES]>,
}

/// Points whose places on the curve are found at the same time.
const LANES: usize = 8;

impl Order {
    /// The curve is cut into this many stretches, at the same places in all rounds, so that each holds
    /// an equal share of the last round (except where many points are in one cell of the grid); the first
    /// begins and the last ends with the curve.
    pub(crate) const STRETCHES: usize = 256;

    /// The order of `points`; it is the same for all options.
    ///
    /// # Panics
    /// When there are 2^32 points or more.
    pub(crate) fn of<P: Spatial>(points: &[P], options: BuildOptions) -> Self {
        let mut memory = vec_of(0, 2 * points.len(), options.huge_pages);
        Self::in_memory(points, &mut memory, options)
    }

    /// As [`of`](Self::of), in memory for two numbers per point, which the system need not clear for this alone.
    pub(crate) fn in_memory<P: Spatial>(
        points: &[P],
        memory: &mut [u64],
        options: BuildOptions,
    ) -> Self {
        assert!(
            u32::try_from(points.len()).is_ok(),
            "more points than 32 bits can number"
        );
        let layout = KeyLayout::new::<P>(points.len());
        let threads = options.threads.get();
        let (keys, rest) = memory.split_at_mut(points.len());
        fill_keys(keys, points, layout, threads);
        let width = layout.width();
        let leading = width - layout.leading_bits(points.len());
        let spare = &mut rest[..points.len()];
        let keys = sort_by_bits(keys, spare, leading..width, threads);
        finish_runs(keys, leading, threads);
        let rounds = rounds(keys, layout);
        let stretches = stretches(keys, &rounds, layout);
        order_crowds(points, keys, layout);
        let indices = keys.iter().map(|&key| layout.index(key) as u32);
        Self {
            indices: indices.collect(),
            rounds,
            stretches,
        }
    }

    /// The ranks at which equal parts of the curve begin in a round, and its end.
    pub(crate) fn cuts(&self, round: usize, parts: usize) -> Vec<usize> {
        let start = |part| self.start_of(round, part * Self::STRETCHES / parts);
        (0..=parts).map(start).collect()
    }

    /// A rank of the round before about as far along the curve as `rank`, which is on `stretch`, is in `round`.
    pub(crate) fn rank_before(&self, round: usize, rank: usize, stretch: usize) -> usize {
        let [ours, theirs] = [round, round - 1]
            .map(|round| [stretch, stretch + 1].map(|stretch| self.start_of(round, stretch)));
        let way = rank.saturating_sub(ours[0]) * (theirs[1] - theirs[0]);
        theirs[0] + way / (ours[1] - ours[0]).max(1)
    }

    /// The rank at which `round` comes to `stretch`, or its end.
    fn start_of(&self, round: usize, stretch: usize) -> usize {
        let start = self.stretches[round].get(stretch);
        start.map_or(self.rounds[round].end, |&rank| rank as usize)
    }
}

fn fill_keys<P: Spatial>(keys: &mut [u64], points: &[P], layout: KeyLayout, threads: usize) {
    let grid = Grid::around_all(points, layout.grid_bits, threads);
    let share = threads::share(points.len(), threads);
    let shares = points.chunks(share).zip(keys.chunks_mut(share)).enumerate();
    threads::for_each(shares.collect(), |(number, (points, keys))| {
        let (rows, rest) = points.as_chunks::<LANES>();
        let (key_rows, last_keys) = keys.as_chunks_mut::<LANES>();
        let indices = (number * share..).step_by(LANES);
        for ((index, row), keys) in indices.zip(rows).zip(key_rows) {
            let places = P::places(row, &grid);
            *keys = std::array::from_fn(|lane| layout.key(index + lane, places[lane]));
        }
        let indices = number * share + rows.len() * LANES..;
        for ((index, &p), key) in indices.zip(rest).zip(last_keys) {
            let [place] = P::places(&[p], &grid);
            *key = layout.key(index, place);
        }
    });
}

/// Sorts keys that are sorted but for their lowest `low` bits.
fn finish_runs(keys: &mut [u64], low: u32, threads: usize) {
    let shares = cut_between_runs(keys, threads::share(keys.len(), threads), low);
    threads::for_each(shares, |share| {
        let runs = share.chunk_by_mut(|&a, &b| a >> low == b >> low);
        runs.filter(|run| run.len() > 1)
            .for_each(<[u64]>::sort_unstable);
    });
}

/// Pieces of about `share` keys in which runs of keys that agree above the `low` lowest bits are whole.
fn cut_between_runs(mut keys: &mut [u64], share: usize, low: u32) -> Vec<&mut [u64]> {
    let mut pieces = Vec::new();
    while let Some(&last) = keys.get(share - 1) {
        let end = keys.partition_point(|&key| key >> low <= last >> low);
        let (piece, rest) = keys.split_at_mut(end);
        pieces.push(piece);
        keys = rest;
    }
    pieces.push(keys);
    pieces
}

fn rounds(keys: &[u64], layout: KeyLayout) -> Vec<Range<usize>> {
    let start = |round| keys.partition_point(|&key| key < layout.start_of_round(round));
    let last = layout.last_round();
    let starts: Vec<usize> = (0..=last).map(start).chain([keys.len()]).collect();
    starts.windows(2).map(|pair| pair[0]..pair[1]).collect()
}

fn stretches(
    keys: &[u64],
    rounds: &[Range<usize>],
    layout: KeyLayout,
) -> Vec<[u32; Order::STRETCHES]> {
    let last = rounds.last().map_or(&keys[..0], |last| &keys[last.clone()]);
    // The first stretch begins where the curve does, which may be before the first point of the last round.
    let cuts: [u64; Order::STRETCHES] = std::array::from_fn(|stretch| match stretch {
        0 => 0,
        _ => last
            .get(last.len() * stretch / Order::STRETCHES)
            .map_or(0, |&key| layout.place(key)),
    });
    let rank = |round: &Range<usize>, cut| {
        let before = keys[round.clone()].partition_point(|&key| layout.place(key) < cut);
        (round.start + before) as u32
    };
    let of_round = |round| cuts.map(|cut| rank(round, cut));
    rounds.iter().map(of_round).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::{DVec2, DVec3};

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

    fn in_space(count: usize) -> Vec<DVec3> {
        let plane = spiral(count);
        let height = |i| (i as f64 * 0.569_840_290_998).fract();
        plane
            .iter()
            .enumerate()
            .map(|(i, p)| p.extend(height(i)))
            .collect()
    }

    #[test]
    fn points_of_space_come_once_each_in_short_steps() {
        let points = in_space(30_000);
        let order = Order::of(&points, BuildOptions::default());
        assert_permutation(&order.indices);
        let last = order.rounds.last().unwrap().clone();
        let steps = order.indices[last].windows(2).map(|w| {
            let [a, b] = [w[0], w[1]].map(|index| points[index as usize]);
            a.distance(b)
        });
        let mean = steps.sum::<f64>() / 26_250.0;
        assert!(mean < 1.3 * 26_250_f64.powf(-1.0 / 3.0), "{mean}");
    }

    #[test]
    fn the_order_is_the_same_for_any_number_of_threads() {
        let mut points = spiral(20_000);
        let cluster: Vec<DVec2> = points.iter().map(|p| *p * 1e-12).collect();
        points.extend(cluster);
        points.extend(vec![DVec2::ONE; 3000]);
        let space = in_space(20_000);
        let expected = (
            Order::of(&points, BuildOptions::default()),
            Order::of(&space, BuildOptions::default()),
        );
        for threads in [2, 3, 8, 16] {
            let options = BuildOptions::on_threads(threads);
            let found = (Order::of(&points, options), Order::of(&space, options));
            assert_eq!(found, expected, "{threads}");
        }
    }

    /// Stretches once began where the last round does: points of other rounds before that were on none, and
    /// builds on several threads left them out.
    #[test]
    fn every_rank_is_on_a_stretch() {
        for turn in 0..12 {
            let points: Vec<DVec2> = spiral(70_000)
                .into_iter()
                .map(|p| DVec2::from_angle(f64::from(turn)).rotate(p))
                .collect();
            let order = Order::of(&points, BuildOptions::default());
            assert_eq!(order.rounds.len(), 3);
            for (round, ranks) in order.rounds.iter().enumerate() {
                let cuts = order.cuts(round, 2);
                assert_eq!([cuts[0], cuts[2]], [ranks.start, ranks.end], "{turn}");
            }
        }
    }

    #[test]
    fn rounds_follow_each_other_and_stretches_cut_them_at_the_same_places() {
        let points = spiral(100_000);
        let order = Order::of(&points, BuildOptions::default());
        assert_eq!(order.rounds.len(), 3);
        let ends: Vec<usize> = order.rounds.iter().map(|round| round.end).collect();
        assert_eq!((order.rounds[0].start, ends[2]), (0, 100_000));
        for (round, stretches) in order.rounds.iter().zip(&order.stretches) {
            assert_eq!(stretches[0] as usize, round.start);
            assert!(stretches.is_sorted() && stretches[255] as usize <= round.end);
            // Even stretches of an even cloud: the middle of the curve is the middle of every round.
            let before_middle = stretches[128] as usize - round.start;
            let half = round.len() as f64 / 2.0;
            assert!((before_middle as f64 - half).abs() < 0.1 * half + 50.0);
        }
    }
}
