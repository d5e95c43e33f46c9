//! How many values fall into each of equally wide bins.

/// Counts of values in equally wide bins of `[low, high]`, and outside.
#[derive(Clone, Debug, PartialEq)]
pub struct Histogram {
    /// Lower end of the first bin.
    pub low: f64,
    /// Upper end of the last bin, which contains it; the other bins do not contain their upper end.
    pub high: f64,
    /// One entry per bin.
    pub counts: Vec<usize>,
    /// Values below `low`.
    pub below: usize,
    /// Values above `high`, infinity and NaN included.
    pub above: usize,
}

impl Histogram {
    /// Empty histogram; without bins, or with `high` not above `low` or an end not finite, every value counts
    /// as outside.
    ///
    /// `u16` bounds the memory for whatever number of bins a user asks.
    #[must_use]
    pub fn new(low: f64, high: f64, bins: u16) -> Self {
        let has_width = low.is_finite() && high.is_finite() && high > low;
        let bins = if has_width { usize::from(bins) } else { 0 };
        Self {
            low,
            high,
            counts: vec![0; bins],
            below: 0,
            above: 0,
        }
    }

    /// Counts one value. O(1).
    pub fn add(&mut self, value: f64) {
        let bin = self.bin(value);
        if value < self.low {
            self.below += 1;
        } else if let Some(count) = self.counts.get_mut(bin).filter(|_| value <= self.high) {
            *count += 1;
        } else {
            self.above += 1;
        }
    }

    /// The bin of a value between `low` and `high`.
    fn bin(&self, value: f64) -> usize {
        // Halves, because the distance of two numbers may be beyond the largest.
        let [value, low, high] = [value, self.low, self.high].map(|end| end / 2.0);
        let position = (value - low) / (high - low) * self.counts.len() as f64;
        // Rounding, and the value `high` itself, may reach one bin too far.
        (position as usize).min(self.counts.len().saturating_sub(1))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_value_is_counted_once() {
        let mut histogram = Histogram::new(0.0, 1.0, 4);
        for value in [-1.0, 0.0, 0.25, 0.49, 1.0, 1.5, f64::INFINITY, f64::NAN] {
            histogram.add(value);
        }
        assert_eq!(histogram.counts, [1, 2, 0, 1]);
        assert_eq!((histogram.below, histogram.above), (1, 3));
    }

    #[test]
    fn bins_as_wide_as_numbers_go_tell_values_apart() {
        let mut histogram = Histogram::new(-f64::MAX, f64::MAX, 2);
        for value in [-f64::MAX, -1e308, 0.0, 1e308, f64::MAX] {
            histogram.add(value);
        }
        assert_eq!((histogram.counts, histogram.above), (vec![2, 3], 0));
        let mut endless = Histogram::new(0.0, f64::INFINITY, 2);
        endless.add(1.0);
        assert_eq!((endless.counts.len(), endless.above), (0, 1));
    }

    #[test]
    fn a_histogram_without_width_counts_everything_outside() {
        for (low, high, bins) in [(1.0, 1.0, 3), (f64::NAN, 2.0, 3), (0.0, 9.0, 0)] {
            let mut histogram = Histogram::new(low, high, bins);
            histogram.add(0.5);
            histogram.add(1.0);
            assert!(histogram.counts.is_empty());
            assert_eq!(histogram.below + histogram.above, 2);
        }
    }
}
