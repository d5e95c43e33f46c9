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
    /// Empty histogram; without bins, or with `high` not above `low`, every value counts as outside.
    ///
    /// `u16` bounds the memory for whatever number of bins a user asks.
    #[must_use]
    pub fn new(low: f64, high: f64, bins: u16) -> Self {
        let bins = if high > low { usize::from(bins) } else { 0 };
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
        let position = (value - self.low) / (self.high - self.low) * self.counts.len() as f64;
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
