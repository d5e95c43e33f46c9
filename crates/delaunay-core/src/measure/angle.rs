//! Angles in degrees, and the four figures that sum them up over a mesh.

use glam::DVec2;

use super::sum::Sum;
use super::{quad, triangle};

/// Angle in degrees, in (-180, 180], whose sine and cosine are `sin` and `cos` times one positive factor.
///
/// 0 when both are zero, which is the case of a collapsed edge.
pub(super) fn degrees(sin: f64, cos: f64) -> f64 {
    // Adding 0.0 turns -0.0 into 0.0: the sign of zero would decide between 0°, 180° and -180°.
    (sin + 0.0).atan2(cos + 0.0).to_degrees()
}

/// Smallest and largest angle over all elements, and their means per element; degrees.
///
/// These are the four figures by which the blocking paper (§5) judges its quadrilateral meshes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AngleSummary {
    /// Smallest angle of all elements.
    pub min: f64,
    /// Largest angle of all elements.
    pub max: f64,
    /// Mean over the elements of each element's smallest angle.
    pub mean_smallest: f64,
    /// Mean over the elements of each element's largest angle.
    pub mean_largest: f64,
}

impl AngleSummary {
    /// Summary of quadrilaterals as in [`quad::corner_angles`]; `None` without any. O(elements).
    ///
    /// ```
    /// use delaunay_core::measure::AngleSummary;
    /// use glam::DVec2;
    ///
    /// let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].map(DVec2::from);
    /// let skew = [[0.0, 0.0], [1.0, 0.0], [2.0, 1.0], [1.0, 1.0]].map(DVec2::from);
    /// let summary = AngleSummary::of_quads([square, skew]).unwrap();
    /// assert_eq!((summary.min, summary.mean_smallest), (45.0, 67.5));
    /// assert_eq!((summary.max, summary.mean_largest), (135.0, 112.5));
    /// ```
    #[must_use]
    pub fn of_quads(quads: impl IntoIterator<Item = [DVec2; 4]>) -> Option<Self> {
        Self::of(quads.into_iter().map(quad::corner_angles))
    }

    /// Summary of triangles as in [`triangle::angles`]; `None` without any. O(elements).
    #[must_use]
    pub fn of_triangles(triangles: impl IntoIterator<Item = [DVec2; 3]>) -> Option<Self> {
        Self::of(triangles.into_iter().map(triangle::angles))
    }

    /// Summary of elements with `N` angles each, in degrees; `None` without elements or angles.
    ///
    /// Same angles in the same order, same bits. O(elements).
    #[must_use]
    pub fn of<const N: usize>(elements: impl IntoIterator<Item = [f64; N]>) -> Option<Self> {
        let mut totals = Totals::default();
        elements.into_iter().for_each(|angles| totals.add(angles));
        totals.summary().filter(|_| N > 0)
    }
}

/// What [`AngleSummary`] needs to remember of the elements seen so far.
struct Totals {
    min: f64,
    max: f64,
    smallest: Sum,
    largest: Sum,
}

impl Default for Totals {
    fn default() -> Self {
        Self {
            min: f64::INFINITY,
            max: f64::NEG_INFINITY,
            smallest: Sum::default(),
            largest: Sum::default(),
        }
    }
}

impl Totals {
    fn add<const N: usize>(&mut self, angles: [f64; N]) {
        let smallest = angles.into_iter().fold(f64::INFINITY, f64::min);
        let largest = angles.into_iter().fold(f64::NEG_INFINITY, f64::max);
        self.min = self.min.min(smallest);
        self.max = self.max.max(largest);
        self.smallest.add(smallest);
        self.largest.add(largest);
    }

    fn summary(&self) -> Option<AngleSummary> {
        Some(AngleSummary {
            min: self.min,
            max: self.max,
            mean_smallest: self.smallest.mean()?,
            mean_largest: self.largest.mean()?,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_sign_of_zero_does_not_choose_the_angle() {
        for zero in [0.0, -0.0] {
            assert_eq!(degrees(zero, -1.0), 180.0);
            assert_eq!(degrees(zero, 1.0), 0.0);
            assert_eq!(degrees(zero, -0.0), 0.0);
        }
    }

    #[test]
    fn no_elements_have_no_summary() {
        assert_eq!(AngleSummary::of_quads([]), None);
        assert_eq!(AngleSummary::of_triangles([]), None);
        assert_eq!(AngleSummary::of([[0.0; 0]]), None);
    }

    #[test]
    fn triangles_are_summed_up_by_their_extreme_angles() {
        let right = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]].map(DVec2::from);
        let flat = [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0]].map(DVec2::from);
        let summary = AngleSummary::of_triangles([right, flat]).unwrap();
        assert_eq!((summary.min, summary.max), (0.0, 180.0));
        assert_eq!((summary.mean_smallest, summary.mean_largest), (22.5, 135.0));
    }
}
