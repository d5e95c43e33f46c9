//! Places on a Hilbert curve through a square grid, four levels per table look-up.

/// Levels of the curve that one look-up answers.
pub(crate) const LEVEL_BITS: u32 = 4;

const SIDE: usize = 1 << LEVEL_BITS;

/// What one look-up gives: eight bits of the place, and the state for the next look-up.
#[derive(Clone, Copy)]
struct Entry {
    digits: u8,
    state: u8,
}

/// The cell of a 16 × 16 block, in each of the four poses of the curve.
static TABLE: [[Entry; SIDE * SIDE]; 4] = table();

/// The place of cell `(x, y)` on the Hilbert curve through a grid of 2^bits × 2^bits cells.
///
/// `bits` is a multiple of [`LEVEL_BITS`]; neighbours on the curve share a side.
pub(crate) fn place(x: u32, y: u32, bits: u32) -> u64 {
    let mut place = 0;
    let mut state = 0;
    let mut shift = bits;
    while shift > 0 {
        shift -= LEVEL_BITS;
        let column = (x >> shift) as usize % SIDE;
        let row = (y >> shift) as usize % SIDE;
        let entry = TABLE[state % 4][column * SIDE + row];
        place = place << (2 * LEVEL_BITS) | u64::from(entry.digits);
        state = usize::from(entry.state);
    }
    place
}

const fn table() -> [[Entry; SIDE * SIDE]; 4] {
    let blank = Entry {
        digits: 0,
        state: 0,
    };
    let mut table = [[blank; SIDE * SIDE]; 4];
    let mut state = 0;
    while state < 4 {
        let mut cell = 0;
        while cell < SIDE * SIDE {
            table[state][cell] = descend(state as u8, cell / SIDE, cell % SIDE);
            cell += 1;
        }
        state += 1;
    }
    table
}

/// Four levels, one at a time. The pose of the curve is a swap of the axes (bit 0 of the state)
/// and a half turn (bit 1); the two commute.
const fn descend(mut state: u8, column: usize, row: usize) -> Entry {
    let mut digits = 0;
    let mut level = LEVEL_BITS;
    while level > 0 {
        level -= 1;
        let turn = state >> 1;
        let a = (column >> level & 1) as u8 ^ turn;
        let b = (row >> level & 1) as u8 ^ turn;
        let (x, y) = if state & 1 == 1 { (b, a) } else { (a, b) };
        digits = digits << 2 | (3 * x) ^ y;
        if y == 0 {
            state ^= 1 | x << 1;
        }
    }
    Entry { digits, state }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_curve_visits_every_cell_and_steps_to_a_neighbour() {
        let bits = 8;
        let side = 1_u32 << bits;
        let mut cells = vec![None; (side * side) as usize];
        for x in 0..side {
            for y in 0..side {
                let seat = &mut cells[place(x, y, bits) as usize];
                assert_eq!(seat.replace((x, y)), None);
            }
        }
        let cells: Vec<_> = cells.into_iter().map(Option::unwrap).collect();
        assert!(
            cells
                .windows(2)
                .all(|w| w[0].0.abs_diff(w[1].0) + w[0].1.abs_diff(w[1].1) == 1)
        );
    }
}
