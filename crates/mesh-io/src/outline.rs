//! Segments of the plane gathered place by place into a planar graph.

use std::collections::HashMap;
use std::collections::hash_map::Entry;

use crate::mesh::MeshDefect;
use crate::planar_graph::{Kept, PlanarGraph};

/// A planar graph in the making: points at exactly one place are one point, a segment given twice is kept once.
#[derive(Default)]
pub(crate) struct Outline {
    points: Vec<[f64; 2]>,
    by_place: HashMap<[u64; 2], u32>,
    segments: Vec<Segment>,
    by_ends: HashMap<[u32; 2], usize>,
    /// Edges of faces in the order of their coming, and how often each came.
    edges: Vec<([u32; 2], usize)>,
    edge_by_ends: HashMap<[u32; 2], usize>,
}

struct Segment {
    ends: [u32; 2],
    marker: Option<i32>,
    /// The polygons whose rings run along it.
    polygons: Vec<u32>,
}

impl Outline {
    /// The number of the point at a place, new or not. -0.0 becomes 0.0.
    ///
    /// # Errors
    /// [`MeshDefect::TooManyPoints`] beyond the 2^32nd.
    pub(crate) fn point(&mut self, place: [f64; 2]) -> Result<u32, MeshDefect> {
        let place = place.map(|coordinate| coordinate + 0.0);
        match self.by_place.entry(place.map(f64::to_bits)) {
            Entry::Occupied(known) => Ok(*known.get()),
            Entry::Vacant(unknown) => {
                let count = self.points.len();
                let point = u32::try_from(count).map_err(|_| MeshDefect::TooManyPoints(count + 1));
                self.points.push(place);
                Ok(*unknown.insert(point?))
            }
        }
    }

    /// The number of points so far.
    pub(crate) fn point_count(&self) -> usize {
        self.points.len()
    }

    /// Keeps a segment, whichever way it runs, with the first marker that it is given. Ends that are one point make none.
    pub(crate) fn segment(&mut self, ends: [u32; 2], marker: Option<i32>) {
        self.keep(ends, marker);
    }

    /// Keeps a segment of a polygon's ring, as [`Outline::segment`] does.
    pub(crate) fn ring_segment(&mut self, ends: [u32; 2], marker: Option<i32>, polygon: u32) {
        if let Some(segment) = self.keep(ends, marker) {
            segment.polygons.push(polygon);
        }
    }

    fn keep(&mut self, ends: [u32; 2], marker: Option<i32>) -> Option<&mut Segment> {
        let key = undirected(ends)?;
        let number = *self.by_ends.entry(key).or_insert(self.segments.len());
        if number == self.segments.len() {
            let polygons = Vec::new();
            self.segments.push(Segment {
                ends,
                marker: None,
                polygons,
            });
        }
        let segment = self.segments.get_mut(number)?;
        segment.marker = segment.marker.or(marker);
        Some(segment)
    }

    /// Counts the edges of a face; those that an odd number of faces has become segments, after all others.
    pub(crate) fn face(&mut self, corners: &[u32]) {
        let next = corners.iter().cycle().skip(1);
        for (&a, &b) in corners.iter().zip(next) {
            let Some(edge) = undirected([a, b]) else {
                continue;
            };
            let number = *self.edge_by_ends.entry(edge).or_insert(self.edges.len());
            if number == self.edges.len() {
                self.edges.push(([a, b], 0));
            }
            self.edges[number].1 += 1;
        }
    }

    /// Points and segments in the order of their coming, without the points that no segment ends in. O(points + segments).
    pub(crate) fn into_graph(mut self) -> PlanarGraph {
        for (ends, count) in std::mem::take(&mut self.edges) {
            if count % 2 == 1 {
                self.segment(ends, None);
            }
        }
        let ends: Vec<[u32; 2]> = self.segments.iter().map(|segment| segment.ends).collect();
        let kept = Kept::of(self.points.len(), &ends);
        let segments = self.segments.iter();
        let has_markers = segments.clone().any(|segment| segment.marker.is_some());
        let markers = segments.map(|segment| segment.marker.unwrap_or_default());
        let segment_markers = has_markers.then(|| markers.collect());
        let mut segments = self.segments.iter();
        let has_polygons = segments.any(|segment| !segment.polygons.is_empty());
        let polygons = self.segments.into_iter().map(|segment| segment.polygons);
        PlanarGraph {
            points: kept.points.iter().map(|&v| self.points[v]).collect(),
            segment_markers,
            polygons: has_polygons.then(|| polygons.collect()),
            segments: kept.segments,
            ..PlanarGraph::default()
        }
    }
}

/// The ends of a segment, the smaller number first; `None` when they are one point.
fn undirected([a, b]: [u32; 2]) -> Option<[u32; 2]> {
    (a != b).then(|| [a.min(b), a.max(b)])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_are_points_and_points_without_a_segment_are_dropped() {
        let mut outline = Outline::default();
        let places = [[5.0, 5.0], [0.0, -0.0], [1.0, 0.0], [-0.0, 0.0]];
        let [_, a, b, c] = places.map(|place| outline.point(place).unwrap());
        assert_eq!(a, c);
        outline.segment([b, a], None);
        outline.segment([a, c], Some(7));
        let graph = outline.into_graph();
        assert_eq!(format!("{:?}", graph.points), "[[0.0, 0.0], [1.0, 0.0]]");
        assert_eq!(
            (graph.segments, graph.segment_markers),
            (vec![[1, 0]], None)
        );
    }

    #[test]
    fn a_segment_given_again_keeps_its_first_marker() {
        let mut outline = Outline::default();
        let [a, b, c] = [0.0, 1.0, 2.0].map(|x| outline.point([x, 0.0]).unwrap());
        outline.segment([a, b], None);
        outline.segment([b, a], Some(3));
        outline.segment([a, b], Some(4));
        outline.segment([b, c], None);
        let graph = outline.into_graph();
        assert_eq!(graph.segments, [[0, 1], [1, 2]]);
        assert_eq!(graph.segment_markers, Some(vec![3, 0]));
    }
}
