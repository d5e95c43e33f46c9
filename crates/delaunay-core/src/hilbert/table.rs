//! Places of cells one by one, several levels of the curve per table look-up, in any number of dimensions.
//!
//! One level of the curve in `n` dimensions visits the 2^n cells of a block in the order of a Gray code,
//! turned so that it starts at the corner `entry` and leaves along the axis `exit`; these two are the *pose*
//! of the block. Each cell holds a block in a pose of its own, so that the whole is one path (Butz 1971;
//! Hamilton 2006, *Compact Hilbert indices*). A table gives digits and pose after two levels at once.

/// A table for `AXES` dimensions with `ENTRIES` entries: every pose with every block of cells.
pub(crate) struct Curve<const AXES: usize, const ENTRIES: usize> {
    /// Levels that one look-up answers.
    levels: u32,
    entries: [Entry; ENTRIES],
}

/// The curve through space.
pub(crate) static SPACE: Curve<3, { 24 << 6 }> = Curve::new(2);

/// What one look-up gives: the next bits of the place, and the pose for the next look-up.
#[derive(Clone, Copy)]
struct Entry {
    digits: u8,
    pose: u8,
}

impl<const AXES: usize, const ENTRIES: usize> Curve<AXES, ENTRIES> {
    /// Levels that one look-up answers.
    pub(crate) const fn levels(&self) -> u32 {
        self.levels
    }

    /// The place of a cell on the curve through a grid of 2^bits cells along each axis.
    ///
    /// `bits` is a multiple of [`levels`](Self::levels); coordinates of the cell are below 2^bits. Neighbours
    /// on the curve share a side.
    #[inline(always)]
    pub(crate) fn place(&self, cell: [u32; AXES], bits: u32) -> u64 {
        let width = AXES as u32 * self.levels;
        let mut place = 0;
        let mut pose = 0;
        let mut shift = bits;
        while shift > 0 {
            shift -= self.levels;
            let mut block = pose;
            for coordinate in cell {
                let digits = (coordinate >> shift) as usize & ((1 << self.levels) - 1);
                block = block << self.levels | digits;
            }
            let entry = self.entries[block % ENTRIES];
            place = place << width | u64::from(entry.digits);
            pose = usize::from(entry.pose);
        }
        place
    }

    const fn new(levels: u32) -> Self {
        assert!(ENTRIES == (AXES << AXES) << (AXES as u32 * levels));
        let blank = Entry { digits: 0, pose: 0 };
        let mut entries = [blank; ENTRIES];
        let mut index = 0;
        while index < ENTRIES {
            entries[index] = Self::descend(index, levels);
            index += 1;
        }
        Self { levels, entries }
    }

    /// Several levels, one at a time. `index` holds the pose above the coordinates, the last axis lowest.
    const fn descend(index: usize, levels: u32) -> Entry {
        let first = index >> (AXES as u32 * levels);
        let (mut entry, mut exit) = (first / AXES, first % AXES);
        let mut digits = 0;
        let mut level = levels;
        while level > 0 {
            level -= 1;
            let mut corner = 0;
            let mut axis = 0;
            while axis < AXES {
                let coordinate = index >> ((AXES - 1 - axis) as u32 * levels);
                corner |= (coordinate >> level & 1) << axis;
                axis += 1;
            }
            let digit = Self::rank(Self::turn_right(corner ^ entry, exit + 1));
            digits = digits << AXES | digit;
            entry ^= Self::turn_right(Self::entry_of(digit), 2 * AXES - exit - 1);
            exit = (exit + Self::axis_of(digit) + 1) % AXES;
        }
        Entry {
            digits: digits as u8,
            pose: (entry * AXES + exit) as u8,
        }
    }

    /// The bits of a corner, turned right by `by` axes.
    const fn turn_right(corner: usize, by: usize) -> usize {
        let by = by % AXES;
        (corner >> by | corner << (AXES - by)) & ((1 << AXES) - 1)
    }

    /// Where a corner comes in the Gray code.
    const fn rank(corner: usize) -> usize {
        let mut rank = corner;
        let mut shift = 1;
        while shift < AXES {
            rank ^= corner >> shift;
            shift += 1;
        }
        rank
    }

    /// The corner at which the curve enters the cell of rank `digit`.
    const fn entry_of(digit: usize) -> usize {
        let even = if digit == 0 { 0 } else { (digit - 1) / 2 * 2 };
        even ^ (even >> 1)
    }

    /// The axis along which the curve passes through the cell of rank `digit`.
    const fn axis_of(digit: usize) -> usize {
        let odd = if digit == 0 { 0 } else { digit - 1 + digit % 2 };
        odd.trailing_ones() as usize % AXES
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn assert_one_path<const AXES: usize, const ENTRIES: usize>(
        curve: &Curve<AXES, ENTRIES>,
        bits: u32,
    ) {
        let count = 1_u32 << (bits * AXES as u32);
        let mut cells = vec![None; count as usize];
        for index in 0..count {
            let cell =
                std::array::from_fn(|axis| index >> (axis as u32 * bits) & ((1 << bits) - 1));
            let seat = &mut cells[curve.place(cell, bits) as usize];
            assert_eq!(seat.replace(cell), None);
        }
        let cells: Vec<[u32; AXES]> = cells.into_iter().map(Option::unwrap).collect();
        for pair in cells.windows(2) {
            let step: u32 = (0..AXES).map(|i| pair[0][i].abs_diff(pair[1][i])).sum();
            assert_eq!(step, 1, "{pair:?}");
        }
    }

    #[test]
    fn the_curve_visits_every_cell_of_the_plane_and_steps_to_a_neighbour() {
        let plane: Curve<2, { 8 << 8 }> = Curve::new(4);
        assert_one_path(&plane, 4);
        assert_one_path(&plane, 8);
    }

    #[test]
    fn the_curve_visits_every_cell_of_space_and_steps_to_a_neighbour() {
        assert_one_path(&SPACE, 2);
        assert_one_path(&SPACE, 6);
    }
}
