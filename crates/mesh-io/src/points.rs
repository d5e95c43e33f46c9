//! Points of the plane or of space, as files of points hold them.

use crate::error::ReadProblem;

/// Points, each perhaps with a weight. Every reader answers finite numbers, and as many weights as points.
#[derive(Clone, Debug, PartialEq)]
pub struct Points {
    /// Where the points are.
    pub coordinates: Coordinates,
    /// One weight per point, where [`PointsWanted::weights`] asked for them: the square of a radius.
    pub weights: Option<Vec<f64>>,
}

/// Coordinates, in the dimension of the file.
#[derive(Clone, Debug, PartialEq)]
pub enum Coordinates {
    /// Two per point.
    Plane(Vec<[f64; 2]>),
    /// Three per point.
    Space(Vec<[f64; 3]>),
}

/// Number of coordinates per point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Dimension {
    /// Two.
    Plane,
    /// Three.
    Space,
}

/// What a reader of points is to look for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PointsWanted {
    /// Coordinates per point of a file that does not say: raw numbers under a name that tells nothing.
    pub dimension: Option<Dimension>,
    /// Whether every point has a weight: a further column, the first attribute, or what is called `weight`.
    pub weights: bool,
}

impl Points {
    /// Number of points.
    #[must_use]
    pub const fn len(&self) -> usize {
        self.coordinates.len()
    }

    /// Whether there are none.
    #[must_use]
    pub const fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Coordinates per point in the file.
    #[must_use]
    pub const fn dimension(&self) -> Dimension {
        match &self.coordinates {
            Coordinates::Plane(_) => Dimension::Plane,
            Coordinates::Space(_) => Dimension::Space,
        }
    }
}

impl Dimension {
    /// Coordinates per point, 2 or 3.
    #[must_use]
    pub const fn count(self) -> usize {
        match self {
            Self::Plane => 2,
            Self::Space => 3,
        }
    }
}

impl Coordinates {
    /// Number of points.
    #[must_use]
    pub const fn len(&self) -> usize {
        match self {
            Self::Plane(points) => points.len(),
            Self::Space(points) => points.len(),
        }
    }

    /// Whether there are none.
    #[must_use]
    pub const fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The same in space; points of the plane get `z = 0`.
    #[must_use]
    pub fn into_space(self) -> Vec<[f64; 3]> {
        match self {
            Self::Plane(points) => points.into_iter().map(|[x, y]| [x, y, 0.0]).collect(),
            Self::Space(points) => points,
        }
    }

    /// The same in the plane.
    ///
    /// # Errors
    /// Index and height of the first point with `z != 0`.
    pub fn into_plane(self) -> Result<Vec<[f64; 2]>, OffPlane> {
        match self {
            Self::Plane(points) => Ok(points),
            Self::Space(points) => match first_off_plane(&points) {
                Some(off_plane) => Err(off_plane),
                None => Ok(points.into_iter().map(|[x, y, _]| [x, y]).collect()),
            },
        }
    }

    /// Whether every point lies in the plane `z = 0`.
    #[must_use]
    pub fn are_planar(&self) -> bool {
        match self {
            Self::Plane(_) => true,
            Self::Space(points) => first_off_plane(points).is_none(),
        }
    }
}

/// A point of space where points of the plane are needed.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[error("point {index} lies at z = {z}, points of the plane are needed")]
pub struct OffPlane {
    /// The point, from 0.
    pub index: usize,
    /// Its height.
    pub z: f64,
}

fn first_off_plane(points: &[[f64; 3]]) -> Option<OffPlane> {
    let mut indexed = points.iter().enumerate();
    indexed
        .find(|(_, [_, _, z])| *z != 0.0)
        .map(|(index, &[_, _, z])| OffPlane { index, z })
}

/// The weight of a point, which must be finite.
pub(crate) fn checked_weight(index: usize, value: f64) -> Result<f64, ReadProblem> {
    if value.is_finite() {
        Ok(value)
    } else {
        Err(ReadProblem::WeightNotFinite { index, value })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_off_the_plane_are_named() {
        let points = Coordinates::Space(vec![[0.0; 3], [1.0, 2.0, -3.0]]);
        assert!(!points.are_planar());
        insta::assert_snapshot!(points.into_plane().unwrap_err(), @"point 1 lies at z = -3, points of the plane are needed");
    }

    #[test]
    fn the_plane_is_part_of_space_and_back() {
        let plane = vec![[1.0, 2.0], [3.0, -4.0]];
        let space = Coordinates::Plane(plane.clone()).into_space();
        assert_eq!(space, [[1.0, 2.0, 0.0], [3.0, -4.0, 0.0]]);
        assert_eq!(Coordinates::Space(space).into_plane(), Ok(plane));
    }
}
