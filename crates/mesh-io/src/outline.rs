//! Segments of the plane gathered place by place into a planar graph.

use std::collections::HashMap;
use std::collections::hash_map::Entry;

use crate::mesh::MeshDefect;
use crate::planar_graph::PlanarGraph;

/// A planar graph in the making: points at exactly one place are one point, a segment given twice is kept once.
#[derive(Default)]
pub(crate) struct Outline {
    points: Vec<[f64; 2]>,
    by_place: HashMap<[u64; 2], u32>,
    segments: Vec<Segment>,
    by_ends: HashMap<[u32; 2], usize>,
}

struct Segment {
    ends: [u32; 2],
    marker: Option<i32>,
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
        let Some(key) = undirected(ends) else {
            return;
        };
        match self.by_ends.entry(key) {
            Entry::Vacant(unknown) => {
                unknown.insert(self.segments.len());
                self.segments.push(Segment { ends, marker });
            }
            Entry::Occupied(known) => {
                if let Some(segment) = self.segments.get_mut(*known.get()) {
                    segment.marker = segment.marker.or(marker);
                }
            }
        }
    }

    /// Points and segments in the order of their coming, without the points that no segment ends in. O(points + segments).
    pub(crate) fn into_graph(self) -> PlanarGraph {
        let mut is_used = vec![false; self.points.len()];
        for end in self.segments.iter().flat_map(|segment| segment.ends) {
            is_used[end as usize] = true;
        }
        let mut new_number = Vec::with_capacity(self.points.len());
        let mut points = Vec::new();
        for (point, is_used) in self.points.into_iter().zip(is_used) {
            new_number.push(points.len() as u32);
            points.extend(is_used.then_some(point));
        }
        let segments = self.segments.iter();
        let has_markers = segments.clone().any(|segment| segment.marker.is_some());
        let markers = segments
            .clone()
            .map(|segment| segment.marker.unwrap_or_default());
        PlanarGraph {
            points,
            segment_markers: has_markers.then(|| markers.collect()),
            segments: segments
                .map(|segment| segment.ends.map(|end| new_number[end as usize]))
                .collect(),
            ..PlanarGraph::default()
        }
    }
}

/// The ends of a segment, the smaller number first; `None` when they are one point.
pub(crate) fn undirected([a, b]: [u32; 2]) -> Option<[u32; 2]> {
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
