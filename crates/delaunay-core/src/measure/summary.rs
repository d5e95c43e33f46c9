//! Extremes and mean of a measure in one pass, for numbers taken down again and again while a mesh changes.

use super::sum::Sum;

/// Count, extremes and mean of at least one value. [`Statistics`](super::Statistics) knows more and takes longer.
///
/// ```
/// use delaunay_core::measure::Summary;
///
/// let quality = Summary::of([0.9, 0.2, 0.4]).unwrap();
/// assert_eq!((quality.count, quality.min, quality.mean, quality.max), (3, 0.2, 0.5, 0.9));
/// assert_eq!(Summary::of([]), None);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Summary {
    /// Number of values, at least 1.
    pub count: usize,
    /// Smallest value.
    pub min: f64,
    /// Arithmetic mean.
    pub mean: f64,
    /// Largest value.
    pub max: f64,
}

impl Summary {
    /// The summary of values, none of them NaN; `None` for no values. Linear.
    pub fn of(values: impl IntoIterator<Item = f64>) -> Option<Self> {
        let mut sum = Sum::default();
        let (mut count, mut min, mut max) = (0, f64::INFINITY, f64::NEG_INFINITY);
        for value in values {
            sum.add(value);
            count += 1;
            min = min.min(value);
            max = max.max(value);
        }
        let mean = sum.mean()?;
        Some(Self {
            count,
            min,
            mean,
            max,
        })
    }

    /// The summary of all values of some summaries; `None` for none. Linear.
    ///
    /// ```
    /// use delaunay_core::measure::Summary;
    ///
    /// let parts = [Summary::of([1.0, 2.0]), None, Summary::of([6.0])];
    /// assert_eq!(Summary::of_all(parts.into_iter().flatten()), Summary::of([1.0, 2.0, 6.0]));
    /// ```
    pub fn of_all(parts: impl IntoIterator<Item = Self>) -> Option<Self> {
        let mut sum = Sum::default();
        let (mut count, mut min, mut max) = (0, f64::INFINITY, f64::NEG_INFINITY);
        for part in parts {
            sum.add(part.mean * part.count as f64);
            count += part.count;
            min = min.min(part.min);
            max = max.max(part.max);
        }
        (count > 0).then(|| Self {
            count,
            min,
            mean: sum.total() / count as f64,
            max,
        })
    }
}
