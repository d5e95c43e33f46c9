//! What can be asked of nodes on curves.

use super::error::SamplingError;

/// How finely curves are sampled.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sampling {
    /// The longest edge, in units of length; finite, above 0.
    pub size: f64,
    /// The largest distance between a curve and the chord of an edge, in units of length; above 0, infinite for no limit.
    pub chord: f64,
    /// How fast sizes may grow with the distance, along curves and from one to another; finite, above 0.
    pub grade: f64,
    /// At most this many nodes.
    pub at_most: usize,
}

impl Sampling {
    /// Edges up to this size, chords within a fortieth of it, sizes that grow by 0.3 of the distance, a million nodes.
    ///
    /// A circle with a radius of five sizes or more then has edges of this size, a smaller one has shorter edges.
    #[must_use]
    pub fn new(size: f64) -> Self {
        Self {
            size,
            chord: size / 40.0,
            grade: 0.3,
            at_most: 1_000_000,
        }
    }

    /// The size that a curvature asks for: the edge of a circle that strays from it by `chord`, and at most `size`.
    ///
    /// Never below two `chord`s, because no curve of that length strays further from its chord.
    pub(super) fn of_curvature(&self, curvature: f64) -> f64 {
        let bent = (8.0 * self.chord / curvature).sqrt();
        // Infinity over infinity leaves the choice to the size.
        bent.max(2.0 * self.chord).min(self.size)
    }

    /// As [`Sampling::check`], but that the size may be infinite.
    pub(crate) fn check_or_free(&self) -> Result<(), SamplingError> {
        let size = self.size.min(f64::MAX);
        // A number that is none is the lesser of neither.
        let size = if self.size.is_nan() { self.size } else { size };
        Self { size, ..*self }.check()
    }

    pub(super) fn check(&self) -> Result<(), SamplingError> {
        let &Self {
            size, chord, grade, ..
        } = self;
        let is_positive = |number: f64| number > 0.0 && number < f64::INFINITY;
        if !is_positive(size) {
            return Err(SamplingError::Size { size });
        }
        if !is_positive(chord) && chord != f64::INFINITY {
            return Err(SamplingError::Chord { chord });
        }
        if !is_positive(grade) {
            return Err(SamplingError::Grade { grade });
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_can_not_be_asked_for_is_named() {
        let error = |sampling: Sampling| sampling.check().unwrap_err().to_string();
        let good = Sampling::new(1.0);
        assert_eq!(good.check(), Ok(()));
        for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            assert!(error(Sampling { size: bad, ..good }).starts_with("the size"));
            assert!(error(Sampling { grade: bad, ..good }).starts_with("the gradation"));
        }
        for bad in [0.0, -1.0, f64::NAN] {
            assert!(error(Sampling { chord: bad, ..good }).starts_with("the distance"));
        }
        let free = f64::INFINITY;
        assert_eq!(
            Sampling {
                chord: free,
                ..good
            }
            .check(),
            Ok(())
        );
    }

    #[test]
    fn curvature_asks_for_the_edge_whose_sagitta_is_the_tolerance() {
        let sampling = Sampling {
            size: 10.0,
            chord: 0.01,
            ..Sampling::new(1.0)
        };
        let edge: f64 = sampling.of_curvature(1.0);
        let sagitta = 1.0 - (edge / 2.0).cos();
        assert!((sagitta / 0.01 - 1.0).abs() < 0.01);
        assert_eq!(sampling.of_curvature(0.0), 10.0);
        assert_eq!(sampling.of_curvature(f64::INFINITY), 0.02);
        let free = Sampling {
            chord: f64::INFINITY,
            ..sampling
        };
        assert_eq!(free.of_curvature(5.0), 10.0);
        assert_eq!(free.of_curvature(f64::INFINITY), 10.0);
    }
}
