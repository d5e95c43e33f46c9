//! Piecewise linear complexes: what a constrained tetrahedralisation starts from.

use crate::cell::Cells;
use crate::mesh::{
    Axis, DataArray, Mesh, MeshDefect, check_data, check_markers, check_points, first_not_finite,
};

/// Points of space and flat facets between them, with the seeds of holes and regions.
///
/// Nothing is said here about geometry: whether facets are flat and meet only in common points and segments is up to who made them.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PiecewiseComplex {
    /// Coordinates of every point.
    pub points: Vec<[f64; 3]>,
    /// One boundary marker per point, where known.
    pub point_markers: Option<Vec<i32>>,
    /// Named numbers, one row per point.
    pub point_data: Vec<DataArray>,
    /// The facets.
    pub facets: Vec<Facet>,
    /// One boundary marker per facet, where known.
    pub facet_markers: Option<Vec<i32>>,
    /// A point inside every hole.
    pub holes: Vec<[f64; 3]>,
    /// Regions that the facets separate.
    pub regions: Vec<SolidRegion>,
}

/// A flat piece of the boundary or of an interface.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Facet {
    /// Its polygons, each with the points of its corners in cyclic order: outlines of the facet and of its holes, and, with two corners
    /// or one, segments and points in it.
    pub polygons: Vec<Vec<u32>>,
    /// A point inside every hole of the facet.
    pub holes: Vec<[f64; 3]>,
}

/// A region of a piecewise linear complex, found from a point inside it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SolidRegion {
    /// A point inside the region.
    pub seed: [f64; 3],
    /// Number that the tetrahedra of the region carry.
    pub attribute: f64,
    /// Largest volume of a tetrahedron in the region, where it is bounded.
    pub max_volume: Option<f64>,
}

/// The first contradiction in a [`PiecewiseComplex`].
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ComplexDefect {
    /// Points, their markers or data, or the markers of facets contradict each other.
    #[error(transparent)]
    Lists(#[from] MeshDefect),
    /// A polygon has no corners.
    #[error("facet {facet}: polygon {polygon} has no corners")]
    NoCorners {
        /// Index of the facet.
        facet: usize,
        /// Index of the polygon in it.
        polygon: usize,
    },
    /// A facet names a point that does not exist.
    #[error("facet {facet}: there is no point {found}")]
    NoSuchPoint {
        /// Index of the facet.
        facet: usize,
        /// The index found.
        found: u32,
    },
    /// The seed of a hole or region is infinite or NaN.
    #[error("{element} {index}: {axis} is {value}, which is not a finite number")]
    NotFinite {
        /// A hole, a region, or a facet in which a hole is.
        element: &'static str,
        /// Its index.
        index: usize,
        /// Which coordinate.
        axis: Axis,
        /// The offending value.
        value: f64,
    },
    /// A bound that is no volume.
    #[error("region {region}: tetrahedra of volume {volume} at most")]
    Bound {
        /// Index of the region.
        region: usize,
        /// The bound found.
        volume: f64,
    },
}

/// Why a facet is no triangle.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum NoTriangle {
    /// There are more polygons than one, or none.
    #[error("facet {facet} is no triangle: it has {polygons} polygons")]
    Polygons {
        /// Index of the facet.
        facet: usize,
        /// Number of its polygons.
        polygons: usize,
    },
    /// There are holes.
    #[error("facet {facet} is no triangle: it has a hole")]
    Hole {
        /// Index of the facet.
        facet: usize,
    },
    /// There are other than three corners.
    #[error("facet {facet} is no triangle: it has {corners} corners")]
    Corners {
        /// Index of the facet.
        facet: usize,
        /// Number of its corners.
        corners: usize,
    },
    /// A point is a corner twice.
    #[error("facet {facet} is no triangle: point {point} is a corner twice")]
    Twice {
        /// Index of the facet.
        facet: usize,
        /// Index of the point.
        point: u32,
    },
}

impl PiecewiseComplex {
    /// Whether the fields agree with each other. O(size of the complex).
    ///
    /// # Errors
    /// The first contradiction.
    pub fn check(&self) -> Result<(), ComplexDefect> {
        let (points, facets) = (self.points.len(), self.facets.len());
        check_points(&self.points)?;
        check_markers("point markers", self.point_markers.as_deref(), points)?;
        check_data("point data", &self.point_data, points)?;
        check_markers("facet markers", self.facet_markers.as_deref(), facets)?;
        for (index, facet) in self.facets.iter().enumerate() {
            facet.check(index, points)?;
        }
        for (index, hole) in self.holes.iter().enumerate() {
            check_place("hole", index, hole)?;
        }
        for (region, found) in self.regions.iter().enumerate() {
            check_place("region", region, &found.seed)?;
            match found.max_volume {
                Some(volume) if !(0.0..f64::INFINITY).contains(&volume) => {
                    return Err(ComplexDefect::Bound { region, volume });
                }
                _ => {}
            }
        }
        Ok(())
    }

    /// The corners of every facet, when all are triangles. A polygon with more corners is not cut: which triangles it is made of is a
    /// question of geometry. O(facets).
    ///
    /// # Errors
    /// The first facet that is other than one polygon with three different corners and without holes.
    pub fn triangles(&self) -> Result<Vec<[u32; 3]>, NoTriangle> {
        let facets = self.facets.iter().enumerate();
        facets.map(|(facet, found)| found.triangle(facet)).collect()
    }

    /// The points and triangles as a mesh; facet markers become cell markers. Seeds are left out. O(size of the complex).
    ///
    /// # Errors
    /// As [`PiecewiseComplex::triangles`].
    pub fn into_mesh(self) -> Result<Mesh, NoTriangle> {
        Ok(Mesh {
            cells: Cells::of_triangles(self.triangles()?),
            points: self.points,
            point_markers: self.point_markers,
            cell_markers: self.facet_markers,
            point_data: self.point_data,
            cell_data: Vec::new(),
        })
    }
}

impl Facet {
    fn check(&self, facet: usize, points: usize) -> Result<(), ComplexDefect> {
        for (polygon, corners) in self.polygons.iter().enumerate() {
            if corners.is_empty() {
                return Err(ComplexDefect::NoCorners { facet, polygon });
            }
            if let Some(&found) = corners.iter().find(|&&corner| corner as usize >= points) {
                return Err(ComplexDefect::NoSuchPoint { facet, found });
            }
        }
        let mut holes = self.holes.iter();
        holes.try_for_each(|hole| check_place("a hole of facet", facet, hole))
    }

    fn triangle(&self, facet: usize) -> Result<[u32; 3], NoTriangle> {
        let [corners] = self.polygons.as_slice() else {
            let polygons = self.polygons.len();
            return Err(NoTriangle::Polygons { facet, polygons });
        };
        if !self.holes.is_empty() {
            return Err(NoTriangle::Hole { facet });
        }
        let &[a, b, c] = corners.as_slice() else {
            let corners = corners.len();
            return Err(NoTriangle::Corners { facet, corners });
        };
        let twice = [(a, b), (b, c), (c, a)].into_iter().find(|(v, w)| v == w);
        twice.map_or(Ok([a, b, c]), |(point, _)| {
            Err(NoTriangle::Twice { facet, point })
        })
    }
}

fn check_place(element: &'static str, index: usize, place: &[f64; 3]) -> Result<(), ComplexDefect> {
    first_not_finite(place).map_or(Ok(()), |(axis, value)| {
        Err(ComplexDefect::NotFinite {
            element,
            index,
            axis,
            value,
        })
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn complex(facets: &[&[&[u32]]]) -> PiecewiseComplex {
        let polygons = |facet: &[&[u32]]| facet.iter().map(|polygon| polygon.to_vec()).collect();
        let facets = facets.iter().map(|facet| Facet {
            polygons: polygons(facet),
            holes: Vec::new(),
        });
        PiecewiseComplex {
            points: vec![[0.0; 3]; 5],
            facets: facets.collect(),
            ..PiecewiseComplex::default()
        }
    }

    #[test]
    fn triangles_are_answered_as_they_are_and_nothing_is_cut() {
        let mut all = complex(&[&[&[0, 1, 2]], &[&[4, 2, 1]]]);
        all.facet_markers = Some(vec![7, 8]);
        assert_eq!(all.triangles(), Ok(vec![[0, 1, 2], [4, 2, 1]]));
        let mesh = all.clone().into_mesh().unwrap();
        assert_eq!(mesh.cell_markers, Some(vec![7, 8]));
        assert_eq!(mesh.check(), Ok(()));
        let error = |facet: &[&[u32]]| complex(&[&[&[0, 1, 2]], facet]).triangles().unwrap_err();
        insta::assert_snapshot!(error(&[&[0, 1, 2, 3]]), @"facet 1 is no triangle: it has 4 corners");
        insta::assert_snapshot!(error(&[&[0, 1, 2], &[3]]), @"facet 1 is no triangle: it has 2 polygons");
        insta::assert_snapshot!(error(&[]), @"facet 1 is no triangle: it has 0 polygons");
        insta::assert_snapshot!(error(&[&[0, 1, 0]]), @"facet 1 is no triangle: point 0 is a corner twice");
        all.facets[0].holes.push([0.5; 3]);
        insta::assert_snapshot!(all.triangles().unwrap_err(), @"facet 0 is no triangle: it has a hole");
    }

    #[test]
    fn each_contradiction_is_named() {
        let sound = complex(&[&[&[0, 1, 2, 3], &[4]]]);
        assert_eq!(sound.check(), Ok(()));
        let error = |change: fn(&mut PiecewiseComplex)| {
            let mut complex = sound.clone();
            change(&mut complex);
            complex.check().unwrap_err()
        };
        insta::assert_snapshot!(error(|c| c.points[2][0] = f64::NAN), @"point 2: x is NaN, which is not a finite number");
        insta::assert_snapshot!(error(|c| c.facet_markers = Some(vec![])), @"facet markers: 0 values for 1");
        insta::assert_snapshot!(error(|c| c.facets[0].polygons[1].clear()), @"facet 0: polygon 1 has no corners");
        insta::assert_snapshot!(error(|c| c.facets[0].polygons[1][0] = 5), @"facet 0: there is no point 5");
        insta::assert_snapshot!(error(|c| c.facets[0].holes.push([f64::INFINITY; 3])), @"a hole of facet 0: x is inf, which is not a finite number");
        insta::assert_snapshot!(error(|c| c.holes.push([f64::INFINITY; 3])), @"hole 0: x is inf, which is not a finite number");
        let region = |c: &mut PiecewiseComplex| {
            c.regions.push(SolidRegion {
                seed: [0.0; 3],
                attribute: 1.0,
                max_volume: Some(-1.0),
            });
        };
        insta::assert_snapshot!(error(region), @"region 0: tetrahedra of volume -1 at most");
    }
}
