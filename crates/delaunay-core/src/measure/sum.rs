//! Sums that lose no digits over millions of terms.

/// A running sum after Neumaier: what each addition rounds off is added up beside it.
///
/// ```
/// use delaunay_core::measure::Sum;
///
/// let mut sum = Sum::default();
/// [1.0, 1e100, 1.0, -1e100].into_iter().for_each(|term| sum.add(term));
/// assert_eq!(sum.total(), 2.0);
/// ```
#[derive(Clone, Copy, Debug, Default)]
pub struct Sum {
    count: u64,
    sum: f64,
    lost: f64,
}

impl Sum {
    /// Adds one term.
    pub fn add(&mut self, term: f64) {
        let sum = self.sum + term;
        self.lost += if self.sum.abs() >= term.abs() {
            (self.sum - sum) + term
        } else {
            (term - sum) + self.sum
        };
        self.sum = sum;
        self.count += 1;
    }

    /// The sum of the terms.
    #[must_use]
    pub fn total(&self) -> f64 {
        // An infinite term leaves NaN in `lost`, which must not spoil the infinite sum.
        if self.sum.is_finite() {
            self.sum + self.lost
        } else {
            self.sum
        }
    }

    /// The arithmetic mean of the terms; `None` without terms.
    pub(super) fn mean(&self) -> Option<f64> {
        (self.count > 0).then(|| self.total() / self.count as f64)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn mean(terms: &[f64]) -> Option<f64> {
        let mut sum = Sum::default();
        terms.iter().for_each(|&term| sum.add(term));
        sum.mean()
    }

    #[test]
    fn small_terms_survive_beside_large_ones() {
        assert_eq!(mean(&[1.0, 1e100, 1.0, -1e100]), Some(0.5));
    }

    #[test]
    fn an_infinite_term_makes_the_mean_infinite() {
        assert_eq!(mean(&[1.0, f64::INFINITY, 2.0]), Some(f64::INFINITY));
        assert_eq!(mean(&[]), None);
    }
}
