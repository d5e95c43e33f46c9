//! Marks on tetrahedra that are taken off all at once.

use delaunay_core::TetId;

/// Marks by tetrahedron.
#[derive(Clone, Debug, Default)]
pub(crate) struct Marks {
    /// The round of the last mark of each tetrahedron.
    rounds: Vec<u32>,
    round: u32,
}

impl Marks {
    /// Takes all marks off; tetrahedra have numbers less than `slots`. Constant time, unless there are more of them than before.
    pub(crate) fn clear(&mut self, slots: usize) {
        self.round = self.round.wrapping_add(1);
        if self.round == 0 {
            self.rounds.fill(0);
            self.round = 1;
        }
        if self.rounds.len() < slots {
            self.rounds.resize(slots, 0);
        }
    }

    /// Marks a tetrahedron; tells whether it had no mark.
    #[inline]
    pub(crate) fn mark(&mut self, t: TetId) -> bool {
        std::mem::replace(&mut self.rounds[t.index()], self.round) != self.round
    }

    #[inline]
    pub(crate) fn is_marked(&self, t: TetId) -> bool {
        self.rounds[t.index()] == self.round
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn marks_are_taken_off_even_when_rounds_run_out() {
        let mut marks = Marks::default();
        let [s, t] = [0, 1].map(TetId::new);
        for round in [0, u32::MAX - 1, u32::MAX] {
            marks.round = round;
            marks.clear(2);
            assert!(!marks.is_marked(s) && marks.mark(s) && !marks.mark(s));
            assert!(marks.is_marked(s) && !marks.is_marked(t));
        }
    }
}
