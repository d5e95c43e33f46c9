//! Planar straight-line graphs: what a constrained triangulation starts from.

use crate::cell::Cell;
use crate::mesh::{DataArray, Mesh, MeshDefect};
use crate::outline::Outline;

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
    /// By segment, the polygons whose rings run along it, where the graph was drawn as polygons.
    pub polygons: Option<Vec<Vec<u32>>>,
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

    /// The outline of the triangles and quads of a mesh, seen along z: the edges that an odd number of them has, which is closed
    /// whatever the cells are. Segments of the mesh stay, with the markers of these cells.
    ///
    /// Points at exactly one place are one; those without a segment are left out. O(size of the mesh).
    ///
    /// # Errors
    /// [`MeshDefect::TooManyPoints`] beyond 2^32.
    pub fn outline_of(mesh: &Mesh) -> Result<Self, MeshDefect> {
        let mut outline = Outline::default();
        let places = mesh.points.iter().map(|&[x, y, _]| outline.point([x, y]));
        let numbers: Vec<u32> = places.collect::<Result<_, _>>()?;
        let number = |v: &u32| numbers[*v as usize];
        for (index, cell) in mesh.cells.iter().enumerate() {
            let corners: &[u32] = match &cell {
                Cell::Segment(ends) => {
                    let marker = mesh.cell_markers.as_ref().map(|markers| markers[index]);
                    outline.segment([number(&ends[0]), number(&ends[1])], marker);
                    continue;
                }
                Cell::Triangle(corners) => corners,
                Cell::Quad(corners) => corners,
                _ => continue,
            };
            let corners: Vec<u32> = corners.iter().map(number).collect();
            outline.face(&corners);
        }
        Ok(outline.into_graph())
    }

    /// The graph without the points that no segment has; the others keep their order. Data of points are left out. O(size of
    /// the graph).
    #[must_use]
    pub fn without_loose_points(&self) -> Self {
        let kept = Kept::of(self.points.len(), &self.segments);
        let markers = self.point_markers.as_ref();
        Self {
            points: kept.points.iter().map(|&v| self.points[v]).collect(),
            point_markers: markers.map(|markers| kept.points.iter().map(|&v| markers[v]).collect()),
            point_data: Vec::new(),
            segments: kept.segments,
            segment_markers: self.segment_markers.clone(),
            polygons: self.polygons.clone(),
            holes: self.holes.clone(),
            regions: self.regions.clone(),
        }
    }
}

/// What is left of a graph without loose points.
pub(crate) struct Kept {
    /// The points with a segment, ascending.
    pub(crate) points: Vec<usize>,
    /// All segments, between the places of their ends in `points`.
    pub(crate) segments: Vec<[u32; 2]>,
}

impl Kept {
    pub(crate) fn of(point_count: usize, segments: &[[u32; 2]]) -> Self {
        let mut is_used = vec![false; point_count];
        for &end in segments.iter().flatten() {
            is_used[end as usize] = true;
        }
        let mut new_number = Vec::with_capacity(point_count);
        let mut points = Vec::new();
        for (point, is_used) in is_used.into_iter().enumerate() {
            new_number.push(points.len() as u32);
            points.extend(is_used.then_some(point));
        }
        let segments = segments.iter();
        let segments = segments.map(|ends| ends.map(|end| new_number[end as usize]));
        Self {
            points,
            segments: segments.collect(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cell::Cells;

    #[test]
    fn loose_points_go_and_the_others_keep_their_order() {
        let graph = PlanarGraph {
            points: [0.0, 1.0, 2.0, 3.0].map(|x| [x, 0.0]).to_vec(),
            point_markers: Some(vec![5, 6, 7, 8]),
            segments: vec![[3, 1], [1, 0]],
            segment_markers: Some(vec![1, 2]),
            ..PlanarGraph::default()
        };
        let kept = graph.without_loose_points();
        assert_eq!(kept.points, [[0.0, 0.0], [1.0, 0.0], [3.0, 0.0]]);
        assert_eq!(kept.point_markers, Some(vec![5, 6, 8]));
        assert_eq!(kept.segments, [[2, 1], [1, 0]]);
        assert_eq!(kept.segment_markers, Some(vec![1, 2]));
    }

    #[test]
    fn the_outline_of_cells_has_the_markers_of_segments_and_no_inner_edges() {
        let points = vec![
            [0.0; 3],
            [1.0, 0.0, 0.0],
            [1.0, 1.0, 0.0],
            [0.0, 1.0, 0.0],
            [9.0, 9.0, 0.0],
            [2.0, 0.0, 0.0],
        ];
        let cells = [
            Cell::Triangle([0, 1, 2]),
            Cell::Triangle([0, 2, 3]),
            Cell::Segment([2, 3]),
        ];
        let mut mesh = Mesh::new(points, Cells::from_iter(cells));
        mesh.cell_markers = Some(vec![0, 0, 7]);
        let outline = PlanarGraph::outline_of(&mesh).unwrap();
        assert_eq!(outline.points.len(), 4);
        assert_eq!(outline.segments, [[2, 3], [0, 1], [1, 2], [3, 0]]);
        assert_eq!(outline.segment_markers, Some(vec![7, 0, 0, 0]));
    }
}
