//! Planar straight-line graphs: what a constrained triangulation starts from.

use crate::cell::Cell;
use crate::mesh::{DataArray, Mesh};

/// Points of the plane and segments between them, with the seeds of holes and regions.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PlanarGraph {
    /// Coordinates of every point.
    pub points: Vec<[f64; 2]>,
    /// One boundary marker per point, where known.
    pub point_markers: Option<Vec<i32>>,
    /// Named numbers, one row per point.
    pub point_data: Vec<DataArray>,
    /// Segments as pairs of points, counted from 0.
    pub segments: Vec<[u32; 2]>,
    /// One boundary marker per segment, where known.
    pub segment_markers: Option<Vec<i32>>,
    /// A point inside every hole.
    pub holes: Vec<[f64; 2]>,
    /// Regions that the segments separate.
    pub regions: Vec<Region>,
}

/// A region of a planar graph, found from a point inside it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Region {
    /// A point inside the region.
    pub seed: [f64; 2],
    /// Number that the triangles of the region carry.
    pub attribute: f64,
    /// Largest area of a triangle in the region, where it is bounded.
    pub max_area: Option<f64>,
}

impl PlanarGraph {
    /// The points and segments as a mesh with `z = 0`; segment markers become cell markers. O(size of the graph).
    #[must_use]
    pub fn as_mesh(&self) -> Mesh {
        Mesh {
            points: self.points.iter().map(|&[x, y]| [x, y, 0.0]).collect(),
            cells: self.segments.iter().copied().map(Cell::Segment).collect(),
            point_markers: self.point_markers.clone(),
            cell_markers: self.segment_markers.clone(),
            point_data: self.point_data.clone(),
            cell_data: Vec::new(),
        }
    }
}
