//! A measure summed up over a mesh: extremes, percentiles, mean, histogram and the worst elements.
//!
//! The values are sorted once; every question is then a look-up, and no answer depends on the order in which
//! the elements came, not even in its last bit.

use super::histogram::Histogram;
use super::sum::Sum;

/// Statistics of one measure over at least one element; elements are named by ids of type `I`.
///
/// ```
/// use delaunay_core::measure::Statistics;
///
/// let quality = Statistics::of([(7, 0.9), (8, 0.2), (9, 0.4)]).unwrap();
/// assert_eq!((quality.count(), quality.min(), quality.max()), (3, 0.2, 0.9));
/// assert_eq!((quality.percentile(50.0), quality.mean()), (0.4, 0.5));
/// assert_eq!(quality.smallest(2).collect::<Vec<_>>(), [(8, 0.2), (9, 0.4)]);
/// assert_eq!(quality.histogram(0.0, 1.0, 2).counts, [2, 1]);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Statistics<I> {
    /// By value, equal values by id. Never empty.
    sorted: Vec<(I, f64)>,
    min: f64,
    max: f64,
    mean: f64,
}

impl<I: Copy + Ord> Statistics<I> {
    /// Statistics of `(id, value)` pairs; `None` for no values.
    ///
    /// Values may be infinite. Measures are never NaN; should a value be, it counts as larger than infinity.
    /// O(n log n) time, O(n) memory.
    #[must_use]
    pub fn of(values: impl IntoIterator<Item = (I, f64)>) -> Option<Self> {
        let mut sorted: Vec<(I, f64)> = values
            .into_iter()
            .map(|(id, value)| (id, canonical(value)))
            .collect();
        sorted.sort_unstable_by(|a, b| a.1.total_cmp(&b.1).then(a.0.cmp(&b.0)));
        let (&(_, min), &(_, max)) = (sorted.first()?, sorted.last()?);
        let mean = mean(&sorted)?;
        Some(Self {
            sorted,
            min,
            max,
            mean,
        })
    }

    /// Number of values, at least 1.
    #[must_use]
    pub fn count(&self) -> usize {
        self.sorted.len()
    }

    /// Smallest value.
    #[must_use]
    pub fn min(&self) -> f64 {
        self.min
    }

    /// Largest value.
    #[must_use]
    pub fn max(&self) -> f64 {
        self.max
    }

    /// Arithmetic mean; infinite if a value is, NaN if values are infinite in both directions.
    #[must_use]
    pub fn mean(&self) -> f64 {
        self.mean
    }

    /// The smallest value that at least `percent` % of all values do not exceed (nearest rank). O(1).
    ///
    /// Always a value that occurs: the median is `percentile(50.0)`, the smallest value `percentile(0.0)`.
    /// Percentages outside [0, 100] are taken as the nearest end, NaN as 0.
    #[must_use]
    pub fn percentile(&self, percent: f64) -> f64 {
        // First multiply, then divide: 7 % of 100 is rank 7, but 0.07 * 100 is above 7.
        let rank = (percent * self.sorted.len() as f64 / 100.0).ceil() as usize;
        self.sorted
            .get(rank.saturating_sub(1))
            .map_or(self.max, |&(_, value)| value)
    }

    /// Values per bin of `[low, high]` cut into `bins` of equal width. O(n).
    #[must_use]
    pub fn histogram(&self, low: f64, high: f64, bins: u16) -> Histogram {
        let mut histogram = Histogram::new(low, high, bins);
        self.sorted
            .iter()
            .for_each(|&(_, value)| histogram.add(value));
        histogram
    }

    /// The `count` smallest values with their ids, smallest first, equal values by id.
    ///
    /// These are the worst elements by a quality or a smallest angle. Fewer when there are fewer.
    pub fn smallest(&self, count: usize) -> impl Iterator<Item = (I, f64)> + '_ {
        self.sorted.iter().copied().take(count)
    }

    /// The `count` largest values with their ids, largest first, equal values by id.
    ///
    /// These are the worst elements by r/l or a largest angle. Fewer when there are fewer.
    pub fn largest(&self, count: usize) -> impl Iterator<Item = (I, f64)> + '_ {
        let equals = self.sorted.chunk_by(|a, b| a.1.total_cmp(&b.1).is_eq());
        equals.rev().flatten().copied().take(count)
    }
}

/// Arithmetic mean of the values, even of values so large that their sum is beyond the largest number.
fn mean<I>(values: &[(I, f64)]) -> Option<f64> {
    let scaled_mean = |scale: f64| {
        let mut sum = Sum::default();
        values.iter().for_each(|(_, value)| sum.add(value * scale));
        Some(sum.mean()? / scale)
    };
    // There are fewer than 2^64 values.
    scaled_mean(1.0)
        .filter(|mean| mean.is_finite())
        .or_else(|| scaled_mean(2f64.powi(-64)))
}

/// One zero and one NaN, so that equal values are equal in the order as well.
fn canonical(value: f64) -> f64 {
    if value.is_nan() {
        f64::NAN
    } else {
        value + 0.0
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn nothing_has_no_statistics() {
        assert_eq!(Statistics::<u32>::of([]), None);
    }

    #[test]
    fn one_value_is_every_statistic() {
        let one = Statistics::of([(7, 0.3)]).unwrap();
        assert_eq!([one.min(), one.max(), one.mean()], [0.3; 3]);
        assert_eq!([0.0, 1.0, 50.0, 100.0].map(|p| one.percentile(p)), [0.3; 4]);
        assert_eq!(one.largest(5).collect::<Vec<_>>(), [(7, 0.3)]);
    }

    #[test]
    fn the_numbers_to_a_hundred_are_their_own_percentiles() {
        let numbers = Statistics::of((1..=100u32).rev().map(|i| (i, f64::from(i)))).unwrap();
        for i in 1..=100u32 {
            assert_eq!(numbers.percentile(f64::from(i)), f64::from(i));
        }
        assert_eq!(numbers.mean(), 50.5);
        assert_eq!(
            [-5.0, 0.0, f64::NAN].map(|p| numbers.percentile(p)),
            [1.0; 3]
        );
        assert_eq!(
            [100.1, f64::INFINITY].map(|p| numbers.percentile(p)),
            [100.0; 2]
        );
    }

    #[test]
    fn equal_values_are_listed_by_id() {
        let values = Statistics::of([(9, 0.5), (2, 0.5), (4, 0.1), (3, 0.5)]).unwrap();
        assert_eq!(
            values.smallest(3).collect::<Vec<_>>(),
            [(4, 0.1), (2, 0.5), (3, 0.5)]
        );
        assert_eq!(values.largest(2).collect::<Vec<_>>(), [(2, 0.5), (3, 0.5)]);
        let zeros = Statistics::of([(2, -0.0), (1, 0.0), (3, -0.0)]).unwrap();
        assert_eq!(
            zeros.largest(3).map(|(id, _)| id).collect::<Vec<_>>(),
            [1, 2, 3]
        );
    }

    #[test]
    fn infinite_values_stay_visible() {
        let ratios = Statistics::of([(0, 0.6), (1, f64::INFINITY)]).unwrap();
        assert_eq!(
            (ratios.min(), ratios.max(), ratios.mean()),
            (0.6, f64::INFINITY, f64::INFINITY)
        );
        assert_eq!(ratios.histogram(0.0, 5.0, 5).above, 1);
    }

    #[test]
    fn values_whose_sum_overflows_have_a_finite_mean() {
        let mean = |values: &[f64]| {
            Statistics::of(values.iter().copied().enumerate())
                .unwrap()
                .mean()
        };
        assert_eq!(mean(&[f64::MAX; 3]), f64::MAX);
        assert_eq!(mean(&[-f64::MAX, -f64::MAX, f64::MAX, f64::MAX]), 0.0);
    }

    #[test]
    fn what_is_no_number_counts_as_the_largest() {
        let values = Statistics::of([(0, -f64::NAN), (1, f64::INFINITY), (2, 0.0)]).unwrap();
        assert_eq!(
            (values.min(), values.largest(1).map(|(id, _)| id).next()),
            (0.0, Some(0))
        );
    }

    #[test]
    fn an_absurd_count_of_worst_elements_lists_them_all() {
        let values = Statistics::of([(0, 0.2), (1, 0.1)]).unwrap();
        assert_eq!(
            values.smallest(usize::MAX).collect::<Vec<_>>(),
            [(1, 0.1), (0, 0.2)]
        );
        assert_eq!(values.largest(usize::MAX).count(), 2);
    }

    proptest! {
        #[test]
        fn the_order_of_the_elements_changes_nothing(
            values in prop::collection::vec(-1.0..1.0f64, 1..100),
        ) {
            let pairs = values.iter().copied().enumerate();
            let [forth, back] = [pairs.clone().collect::<Vec<_>>(), pairs.rev().collect()]
                .map(|pairs| Statistics::of(pairs).unwrap());
            prop_assert_eq!(forth.mean().to_bits(), back.mean().to_bits());
            prop_assert_eq!(&forth, &back);
        }

        #[test]
        fn a_percentile_splits_the_values(
            values in prop::collection::vec(0.0..1.0f64, 1..100),
            percent in 0.0..100.0f64,
        ) {
            let statistics = Statistics::of(values.iter().copied().enumerate()).unwrap();
            let bound = statistics.percentile(percent);
            let share = |count: usize| 100.0 * count as f64 / values.len() as f64;
            prop_assert!(share(values.iter().filter(|&&v| v <= bound).count()) >= percent - 1e-9);
            prop_assert!(share(values.iter().filter(|&&v| v < bound).count()) <= percent + 1e-9);
        }
    }
}
