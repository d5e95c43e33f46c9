//! Places of several cells of the plane at once, without tables: a processor does the same step for all.
//!
//! One level of the curve visits the four quarters of a square from the lower left to the lower right, left ones in
//! between first. The curves through the lower quarters are mirrored at a diagonal, which swaps the axes, and
//! the one through the lower right is turned by half a circle as well, which flips both. Swaps and flips
//! commute, so two bits say what has become of the axes after any number of levels.

/// The finest grid: 2^16 cells along each axis.
pub(crate) const MAX_BITS_IN_PLANE: u32 = 16;

/// The places of the cells in column `x[i]` and row `y[i]` of a grid of 2^bits columns and rows.
///
/// `bits` is at most [`MAX_BITS_IN_PLANE`], and columns and rows are below 2^bits.
#[inline(always)]
pub(crate) fn places_in_plane<const LANES: usize>(
    x: [u32; LANES],
    y: [u32; LANES],
    bits: u32,
) -> [u32; LANES] {
    let differ: [u32; LANES] = std::array::from_fn(|lane| x[lane] ^ y[lane]);
    let mut swapped = [0; LANES];
    let mut flipped = [0; LANES];
    let mut rights = [0; LANES];
    // All numbers keep the bit of a level at its place; what is above it has no meaning any more.
    for level in (0..bits).rev() {
        for lane in 0..LANES {
            let right = x[lane] ^ (differ[lane] & swapped[lane]) ^ flipped[lane];
            let lower = !(right ^ differ[lane]);
            rights[lane] |= right & 1 << level;
            swapped[lane] = (swapped[lane] ^ lower) >> 1;
            flipped[lane] = (flipped[lane] ^ lower & right) >> 1;
        }
    }
    // Quarters come in the order left below, left above, right above, right below.
    std::array::from_fn(|lane| spread(rights[lane]) << 1 | spread(differ[lane]))
}

/// Moves bit i to bit 2 i, for the lowest sixteen.
#[inline(always)]
fn spread(bits: u32) -> u32 {
    let mut wide = bits;
    for (by, mask) in [
        (8, 0x00FF_00FF),
        (4, 0x0F0F_0F0F),
        (2, 0x3333_3333),
        (1, 0x5555_5555),
    ] {
        wide = (wide | wide << by) & mask;
    }
    wide
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_curve_visits_every_cell_and_steps_to_a_neighbour() {
        for bits in [1, 2, 3, 7] {
            let side = 1_u32 << bits;
            let mut cells = vec![None; 1 << (2 * bits)];
            for x in 0..side {
                for y in 0..side {
                    let [place, again] = places_in_plane([x, x], [y, y], bits);
                    assert_eq!(place, again);
                    assert_eq!(cells[place as usize].replace([x, y]), None);
                }
            }
            let cells: Vec<[u32; 2]> = cells.into_iter().map(Option::unwrap).collect();
            assert_eq!((cells[0], cells[cells.len() - 1]), ([0, 0], [side - 1, 0]));
            for pair in cells.windows(2) {
                let [[x, y], [u, v]] = [pair[0], pair[1]];
                assert_eq!(x.abs_diff(u) + y.abs_diff(v), 1, "{pair:?}");
            }
        }
    }

    /// The curve enters a coarse cell once, so the place in a finer grid begins with that in a coarse one.
    #[test]
    fn finer_grids_refine_the_curve_up_to_the_finest() {
        let number = |i: u32| (i.wrapping_mul(2_654_435_761) >> 16) & 0xFFFF;
        for i in 0..1000 {
            let (x, y) = (number(2 * i), number(2 * i + 1));
            let [fine] = places_in_plane([x], [y], MAX_BITS_IN_PLANE);
            for level in (0..MAX_BITS_IN_PLANE).step_by(2) {
                let [coarse] =
                    places_in_plane([x >> level], [y >> level], MAX_BITS_IN_PLANE - level);
                assert_eq!(u64::from(fine) >> (2 * level), u64::from(coarse));
            }
        }
    }
}
