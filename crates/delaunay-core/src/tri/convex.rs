//! Convex polygons: the windows that Voronoi cells are clipped to, and the clipped cells.

use geo_predicates::{CoordinateError, Sign, check_points2, orient2d};
use glam::DVec2;
use thiserror::Error;

/// A convex polygon, possibly empty.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ConvexPolygon {
    corners: Vec<DVec2>,
}

/// Why corners do not bound a convex polygon.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum PolygonError {
    /// A coordinate is not accepted; the index in the error is that of the corner.
    #[error(transparent)]
    Coordinate(#[from] CoordinateError),
    /// There are fewer than three corners.
    #[error("{count} corners do not bound a polygon")]
    TooFewCorners {
        /// Corners given.
        count: usize,
    },
    /// The corner is not a strict left turn, or the polygon winds more than once.
    #[error("the polygon is not convex and counterclockwise at corner {corner}")]
    NotConvex {
        /// Index of the corner.
        corner: usize,
    },
}

impl ConvexPolygon {
    /// The polygon with these corners, counterclockwise, each a strict left turn.
    ///
    /// # Errors
    /// [`PolygonError`] names the first corner that is not accepted. Takes linear time.
    pub fn new(corners: Vec<DVec2>) -> Result<Self, PolygonError> {
        check_points2(&corners)?;
        let count = corners.len();
        if count < 3 {
            return Err(PolygonError::TooFewCorners { count });
        }
        let at = |i: usize| corners[i % count];
        // Left turns everywhere, and all on the left of the fan from corner 0: once around.
        let bent = |i: &usize| {
            orient2d(at(i + count - 1), at(*i), at(i + 1)) != Sign::Positive
                || (1..count - 1).contains(i)
                    && orient2d(at(0), at(*i), at(i + 1)) != Sign::Positive
        };
        match (0..count).find(bent) {
            Some(corner) => Err(PolygonError::NotConvex { corner }),
            None => Ok(Self { corners }),
        }
    }

    /// The axis-parallel rectangle between two opposite corners.
    ///
    /// # Errors
    /// [`PolygonError`] when a coordinate is not accepted or `low` is not strictly below and left of
    /// `high`.
    pub fn rectangle(low: DVec2, high: DVec2) -> Result<Self, PolygonError> {
        if low.cmplt(high).all() {
            Self::new(vec![
                low,
                DVec2::new(high.x, low.y),
                high,
                DVec2::new(low.x, high.y),
            ])
        } else {
            check_points2(&[low, high])?;
            Err(PolygonError::NotConvex { corner: 0 })
        }
    }

    /// The corners, counterclockwise; none when the polygon is empty.
    #[must_use]
    pub fn corners(&self) -> &[DVec2] {
        &self.corners
    }

    /// Whether nothing is left of it.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.corners.is_empty()
    }

    /// Whether `p` is inside or on the border.
    #[must_use]
    pub fn contains(&self, p: DVec2) -> bool {
        let ends = self.corners.iter().skip(1).chain(self.corners.first());
        let mut edges = self.corners.iter().zip(ends);
        p.is_finite()
            && !self.is_empty()
            && edges.all(|(&start, &end)| orient2d(start, end, p) != Sign::Negative)
    }

    /// The area, not negative beyond rounding; 0 when empty.
    #[must_use]
    pub fn area(&self) -> f64 {
        self.fan().map(|[b, c]| b.perp_dot(c)).sum::<f64>() / 2.0
    }

    /// The center of mass; `None` when the area is 0.
    #[must_use]
    pub fn centroid(&self) -> Option<DVec2> {
        let first = *self.corners.first()?;
        let (doubled, moment) = self
            .fan()
            .fold((0.0, DVec2::ZERO), |(sum, moment), [b, c]| {
                let doubled = b.perp_dot(c);
                (sum + doubled, moment + doubled * (b + c))
            });
        (doubled > 0.0).then(|| first + moment / (3.0 * doubled))
    }

    /// The edges that corner 0 does not touch, relative to corner 0.
    fn fan(&self) -> impl Iterator<Item = [DVec2; 2]> + '_ {
        self.corners
            .windows(2)
            .skip(1)
            .map(|edge| [edge[0] - self.corners[0], edge[1] - self.corners[0]])
    }

    /// A polygon whose corners are known to be those of a convex one, up to rounding.
    pub(super) fn from_rounded(mut corners: Vec<DVec2>) -> Self {
        corners.dedup();
        if corners.len() > 1 && corners.first() == corners.last() {
            corners.pop();
        }
        if corners.len() < 3 {
            corners.clear();
        }
        Self { corners }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn polygon(corners: &[[f64; 2]]) -> Result<ConvexPolygon, PolygonError> {
        ConvexPolygon::new(corners.iter().copied().map(DVec2::from).collect())
    }

    #[test]
    fn a_triangle_has_its_area_and_centroid() {
        let triangle = polygon(&[[1.0, 1.0], [4.0, 1.0], [1.0, 7.0]]).unwrap();
        assert_eq!(triangle.area(), 9.0);
        assert_eq!(triangle.centroid(), Some(DVec2::new(2.0, 3.0)));
    }

    #[test]
    fn corners_that_coincide_bound_nothing() {
        let [a, b] = [DVec2::ZERO, DVec2::ONE];
        let nothing = ConvexPolygon::from_rounded(vec![a, b, b, a]);
        assert_eq!((nothing.area(), nothing.centroid()), (0.0, None));
        assert!(nothing.is_empty());
    }

    #[test]
    fn a_polygon_contains_its_border_and_not_what_is_infinitely_far() {
        let triangle = polygon(&[[0.0, 0.0], [3.0, 0.0], [0.0, 3.0]]).unwrap();
        for inside in [[1.0, 1.0], [0.0, 0.0], [1.5, 1.5]] {
            assert!(triangle.contains(inside.into()));
        }
        for outside in [[1.5, 1.5_f64.next_up()], [-1.0, 0.0], [f64::NAN, 1.0]] {
            assert!(!triangle.contains(outside.into()));
        }
        assert!(!ConvexPolygon::default().contains(DVec2::ZERO));
    }

    #[test]
    fn what_is_not_convex_is_refused_with_the_corner() {
        let pentagram = [
            [0.0, -3.0],
            [2.0, 3.0],
            [-3.0, -1.0],
            [3.0, -1.0],
            [-2.0, 3.0],
        ];
        assert!(matches!(
            polygon(&pentagram),
            Err(PolygonError::NotConvex { .. })
        ));
        let clockwise = [[0.0, 0.0], [0.0, 1.0], [1.0, 0.0]];
        assert_eq!(
            polygon(&clockwise),
            Err(PolygonError::NotConvex { corner: 0 })
        );
        let straight = [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [0.0, 2.0]];
        assert_eq!(
            polygon(&straight),
            Err(PolygonError::NotConvex { corner: 1 })
        );
        assert_eq!(
            polygon(&[[0.0, 0.0]]),
            Err(PolygonError::TooFewCorners { count: 1 })
        );
        let infinite = ConvexPolygon::rectangle(DVec2::ZERO, DVec2::INFINITY);
        assert!(matches!(infinite, Err(PolygonError::Coordinate(_))));
    }

    #[test]
    fn polygon_errors_name_the_corner() {
        insta::assert_snapshot!(PolygonError::TooFewCorners { count: 2 }, @"2 corners do not bound a polygon");
        insta::assert_snapshot!(PolygonError::NotConvex { corner: 3 }, @"the polygon is not convex and counterclockwise at corner 3");
    }
}
