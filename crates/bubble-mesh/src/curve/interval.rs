//! Short parts of a stretch, whose arc lengths are known.

use super::stretch::Stretch;

/// Every stretch is divided into at least so many.
const LEAST: u32 = 4;

/// How far quadratures on a whole and on its halves may differ, as a part of the length of a stretch.
const PRECISION: f64 = 1e-11;

/// An interval of parameters is never divided below this.
const SHORTEST: f64 = 1e-10;

/// The part of a stretch between two parameters.
#[derive(Clone, Copy, Debug)]
pub(super) struct Interval<'a> {
    pub(super) stretch: &'a Stretch,
    pub(super) from: f64,
    pub(super) to: f64,
    /// The arc length.
    pub(super) length: f64,
}

impl<'a> Interval<'a> {
    /// A whole stretch in parts on which its length is known well.
    pub(super) fn of(stretch: &'a Stretch) -> Vec<Self> {
        let ends = |i: u32| [i, i + 1].map(|i| f64::from(i) / f64::from(LEAST));
        let parts = (0..LEAST).map(|i| Self::between(stretch, ends(i)));
        let mut parts: Vec<Self> = parts.rev().collect();
        let tolerance = PRECISION * parts.iter().map(|part| part.length).sum::<f64>();
        let mut good = Vec::with_capacity(parts.len());
        while let Some(part) = parts.pop() {
            let halves = part.halves();
            let missing = halves[0].length + halves[1].length - part.length;
            match missing.abs() > tolerance && part.is_divisible() {
                true => parts.extend([halves[1], halves[0]]),
                false => good.push(part),
            }
        }
        good
    }

    pub(super) fn middle(&self) -> f64 {
        0.5 * (self.from + self.to)
    }

    pub(super) fn is_divisible(&self) -> bool {
        self.to - self.from > SHORTEST
    }

    /// Both parts between its ends and the middle of its parameters.
    pub(super) fn halves(&self) -> [Self; 2] {
        let middle = self.middle();
        [[self.from, middle], [middle, self.to]].map(|ends| Self::between(self.stretch, ends))
    }

    /// The parameter at an arc length after its start.
    pub(super) fn at(&self, length: f64) -> f64 {
        self.stretch
            .advance([self.from, self.to], self.length, length)
    }

    fn between(stretch: &'a Stretch, [from, to]: [f64; 2]) -> Self {
        Self {
            stretch,
            from,
            to,
            length: stretch.length(from, to),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec2;

    fn length(control: [[f64; 2]; 4]) -> (f64, usize) {
        let stretch = Stretch::Cubic(control.map(DVec2::from));
        let parts = Interval::of(&stretch);
        assert!(parts.windows(2).all(|pair| pair[0].to == pair[1].from));
        assert_eq!((parts[0].from, parts[parts.len() - 1].to), (0.0, 1.0));
        (parts.iter().map(|part| part.length).sum(), parts.len())
    }

    #[test]
    fn lengths_are_good_even_through_a_cusp() {
        // The parabola y = x² from 0 to 1, as a cubic.
        let (parabola, _) = length([
            [0.0, 0.0],
            [1.0 / 3.0, 0.0],
            [2.0 / 3.0, 1.0 / 3.0],
            [1.0, 1.0],
        ]);
        let expected = 5.0_f64.sqrt() / 2.0 + 2.0_f64.asinh() / 4.0;
        assert!((parabola - expected).abs() < 1e-10);
        // x = t², y = t³ for t from -1 to 1, up to an affine change of t: its cusp is at t = 0.
        let (cusp, count) = length([
            [1.0, -1.0],
            [-1.0 / 3.0, 1.0],
            [-1.0 / 3.0, -1.0],
            [1.0, 1.0],
        ]);
        let expected = 2.0 * (13.0 * 13.0_f64.sqrt() - 8.0) / 27.0;
        assert!((cusp - expected).abs() < 1e-9, "{cusp} {expected}");
        assert!(count < 200);
    }
}
