//! One number for each place, whoever asks for it.

use rustc_hash::FxHashMap;

/// The numbers of places of so many coordinates, in the order in which they were asked for.
#[derive(Clone, Debug)]
pub struct Places<const N: usize> {
    /// By the bits of the coordinates.
    numbers: FxHashMap<[u64; N], usize>,
}

impl<const N: usize> Default for Places<N> {
    fn default() -> Self {
        let numbers = FxHashMap::default();
        Self { numbers }
    }
}

impl<const N: usize> Places<N> {
    /// The number of a place, and whether it is new.
    pub fn number(&mut self, place: [f64; N]) -> (usize, bool) {
        let next = self.numbers.len();
        // -0.0 + 0.0 is 0.0, so that both zeros are one place.
        let bits = place.map(|coordinate| (coordinate + 0.0).to_bits());
        let number = *self.numbers.entry(bits).or_insert(next);
        (number, number == next)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_zeros_are_one_place() {
        let mut places = Places::default();
        assert_eq!(places.number([0.0, 1.0]), (0, true));
        assert_eq!(places.number([0.5, 1.0]), (1, true));
        assert_eq!(places.number([-0.0, 1.0]), (0, false));
    }
}
