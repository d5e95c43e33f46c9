//! One `u64` for each point: round, place on the curve, index.

use super::spatial::OnCurve;

/// Size of a round over the size of all rounds before it: 2 to this power.
///
/// Eight was measured best among 2, 4, 8, 16 and 32, all within 4 % from 8 on.
const ROUND_RATIO_LOG: u32 = 3;

/// Where round, place and index sit in a key, from the highest bits in use to the lowest.
#[derive(Clone, Copy)]
pub(super) struct KeyLayout {
    pub(super) index_bits: u32,
    pub(super) grid_bits: u32,
    place_bits: u32,
    round_bits: u32,
    last_round: u32,
}

impl KeyLayout {
    /// The layout for this many points.
    pub(super) fn new<P: OnCurve>(count: usize) -> Self {
        let last_round = (count / P::FIRST_ROUND).max(1).ilog2() / ROUND_RATIO_LOG;
        let round_bits = u32::BITS - last_round.leading_zeros();
        let index_bits = (usize::BITS - count.leading_zeros()).max(1);
        let room = (u64::BITS - round_bits - index_bits) / P::AXES;
        let grid_bits = room.min(P::MAX_GRID_BITS) / P::LEVELS * P::LEVELS;
        Self {
            index_bits,
            grid_bits,
            place_bits: P::AXES * grid_bits,
            round_bits,
            last_round,
        }
    }

    /// How many bits of a key, from the highest in use, put `count` evenly spread points nearly in order.
    pub(super) fn leading_bits(self, count: usize) -> u32 {
        let spare = 2;
        let wanted = usize::BITS - count.leading_zeros() + spare;
        self.round_bits + wanted.min(self.place_bits)
    }

    /// The highest bit in use, plus one.
    pub(super) fn width(self) -> u32 {
        self.round_bits + self.place_bits + self.index_bits
    }

    /// The rounds are `0..=last_round`.
    pub(super) fn last_round(self) -> u32 {
        self.last_round
    }

    /// The key of point `index` at `place`.
    #[inline(always)]
    pub(super) fn key(self, index: usize, place: u64) -> u64 {
        let round = u64::from(self.round_of(index as u64));
        (round << self.place_bits | place) << self.index_bits | index as u64
    }

    pub(super) fn index(self, key: u64) -> usize {
        (key & ((1 << self.index_bits) - 1)) as usize
    }

    /// Round and place together: what points of one cell and round share.
    pub(super) fn cell(self, key: u64) -> u64 {
        key >> self.index_bits
    }

    /// The place alone.
    pub(super) fn place(self, key: u64) -> u64 {
        self.cell(key) & ((1 << self.place_bits) - 1)
    }

    /// The least key of a round.
    pub(super) fn start_of_round(self, round: u32) -> u64 {
        u64::from(round) << self.place_bits << self.index_bits
    }

    /// The round of a point, 0 for the first: seven of eight points are in the last round, seven of
    /// eight of the others in the last but one, and so on.
    #[inline(always)]
    pub(super) fn round_of(self, index: u64) -> u32 {
        let before_last = scramble(index).leading_zeros() / ROUND_RATIO_LOG;
        self.last_round - before_last.min(self.last_round)
    }
}

/// A fixed scrambling of an index (the finalizer of `SplitMix64`): the seed of the random order.
#[inline(always)]
pub(crate) fn scramble(index: u64) -> u64 {
    let mut z = index.wrapping_add(0x9E37_79B9_7F4A_7C15);
    z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    z ^ (z >> 31)
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::{DVec2, DVec3};

    #[test]
    fn the_last_round_holds_seven_eighths() {
        let count = 100_000;
        let layout = KeyLayout::new::<DVec2>(count);
        let in_last = (0..count as u64).filter(|&i| layout.round_of(i) == layout.last_round);
        let share = in_last.count() as f64 / count as f64;
        assert!((share - 0.875).abs() < 0.01, "{share}");
    }

    #[test]
    fn keys_fit_and_give_their_parts_back() {
        for count in [0, 1, 7, 1000, 123_456, 10_000_000, u32::MAX as usize] {
            for layout in [
                KeyLayout::new::<DVec2>(count),
                KeyLayout::new::<DVec3>(count),
            ] {
                assert!(layout.width() <= u64::BITS && layout.grid_bits >= 8);
                let (index, place) = (count.saturating_sub(1), (1 << layout.place_bits) - 1);
                let key = layout.key(index, place);
                assert_eq!((layout.index(key), layout.place(key)), (index, place));
                let round = layout.round_of(index as u64);
                assert!(layout.start_of_round(round) <= key);
            }
        }
    }
}
