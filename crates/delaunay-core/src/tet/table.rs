//! A hash table that is emptied at once, for what is noted while one cavity is dug and filled, or one star drawn.
//!
//! A few dozen entries come and go for every insertion. Open addressing in one array keeps them within
//! a few cache lines, and a stamp tells the entries of this round from those of earlier ones, so that
//! emptying the table costs nothing. Nothing is ever listed, so the order of entries does not show.

/// Values by 64-bit keys.
#[derive(Clone, Debug, Default)]
pub(super) struct Table<V> {
    /// A power of two of them, at most half of which are in use; none at first.
    slots: Vec<Slot<V>>,
    stamp: u32,
    count: usize,
}

#[derive(Clone, Copy, Debug, Default)]
struct Slot<V> {
    key: u64,
    value: V,
    /// The round in which the entry was made.
    stamp: u32,
}

/// Slots of the first table.
const FIRST: usize = 256;

impl<V: Copy + Default> Table<V> {
    /// Forgets all entries.
    pub(super) fn clear(&mut self) {
        self.count = 0;
        self.stamp = self.stamp.wrapping_add(1);
        if self.slots.is_empty() || self.stamp == 0 {
            let len = self.slots.len().max(FIRST);
            self.slots = vec![Slot::default(); len];
            self.stamp = 1;
        }
    }

    /// The value of `key`, if there is one; if not, gives it `value`.
    ///
    /// The table must have been [cleared](Self::clear) once.
    #[inline]
    pub(super) fn meet(&mut self, key: u64, value: V) -> Option<V> {
        if 2 * self.count >= self.slots.len() {
            self.grow();
        }
        let stamp = self.stamp;
        let place = self.find(key)?;
        let slot = &mut self.slots[place];
        if slot.stamp == stamp {
            return Some(slot.value);
        }
        *slot = Slot { key, value, stamp };
        self.count += 1;
        None
    }

    /// The slot with the entry of `key`, or the free one where it belongs; `None` without slots.
    ///
    /// At least half of the slots are free, so the search ends.
    #[inline]
    fn find(&self, key: u64) -> Option<usize> {
        let last = self.slots.len().checked_sub(1)?;
        // The upper half of a product with an odd number is mixed well (Knuth, section 6.4).
        let mixed = key.wrapping_mul(0x9E37_79B9_7F4A_7C15) >> 32;
        let mut place = mixed as usize & last;
        loop {
            let slot = &self.slots[place];
            if slot.stamp != self.stamp || slot.key == key {
                return Some(place);
            }
            place = (place + 1) & last;
        }
    }

    #[cold]
    fn grow(&mut self) {
        let len = (2 * self.slots.len()).max(FIRST);
        let old = std::mem::replace(&mut self.slots, vec![Slot::default(); len]);
        let stamp = self.stamp;
        self.count = 0;
        for slot in old.into_iter().filter(|slot| slot.stamp == stamp) {
            self.meet(slot.key, slot.value);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::HashMap;

    #[test]
    fn it_answers_as_a_hash_map_round_after_round() {
        let mut table: Table<u32> = Table::default();
        for round in 0..20_u64 {
            table.clear();
            let mut expected = HashMap::new();
            for i in 0..(round * round * 7) {
                let key = i.wrapping_mul(i) % 500 + ((i % 3) << 33);
                let known = expected.get(&key).copied();
                assert_eq!(table.meet(key, i as u32), known);
                expected.entry(key).or_insert(i as u32);
            }
            assert_eq!(table.count, expected.len());
            assert!(expected.iter().all(|(&k, &v)| table.meet(k, 0) == Some(v)));
            assert_eq!(table.count, expected.len());
        }
    }

    #[test]
    fn entries_of_an_earlier_round_do_not_come_back_when_stamps_run_out() {
        let mut table: Table<u32> = Table::default();
        table.clear();
        table.meet(7, 1);
        table.stamp = u32::MAX;
        table.meet(8, 2);
        table.clear();
        assert_eq!(
            (table.stamp, table.meet(7, 3), table.meet(8, 4)),
            (1, None, None)
        );
    }
}
