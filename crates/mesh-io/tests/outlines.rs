//! Outlines in `GeoJSON` and OFF: a file as it comes from a map, and files that are spoiled.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

use mesh_io::{PlanarGraph, geojson, off};
use proptest::prelude::*;

/// A country with a lake and an island in it, an island off the coast, a river, and a neighbour that shares a border.
const COUNTRY: &str = r#"{"type": "FeatureCollection", "name": "countries", "features": [
  {"type": "Feature", "id": 1, "properties": {"name": "A", "marker": 1}, "bbox": [0, 0, 6, 4],
   "geometry": {"type": "MultiPolygon", "coordinates": [
     [[[0, 0, 12.5], [4, 0], [4, 4], [0, 4], [0, 0]], [[1, 1], [1, 3], [3, 3], [3, 1], [1, 1]]],
     [[[1.5, 1.5], [2.5, 1.5], [2.5, 2.5], [1.5, 2.5], [1.5, 1.5]]],
     [[[5, 0], [6, 0], [5.5, 1], [5, 0]]]]}},
  {"type": "Feature", "properties": {"marker": 2},
   "geometry": {"type": "Polygon", "coordinates": [[[4, 0], [4, 4], [-1, 5], [4, 0]]]}},
  {"type": "Feature", "properties": {}, "geometry": {"type": "LineString", "coordinates": [[0, 0], [0.5, 0.5], [1, 1]]}}]}"#;

const POLYGONS: &str =
    "OFF\n6 3 0\n0 0 0\n2 0 0\n3 1 0\n2 2 0\n0 2 0\n4 2 0\n5 0 1 2 3 4\n3 2 5 3\n2 0 5\n";

#[test]
fn a_map_becomes_loops_and_lines_with_markers() {
    let graph = geojson::parse(COUNTRY.as_bytes()).unwrap();
    assert_eq!((graph.points.len(), graph.segments.len()), (17, 19));
    let markers = graph.segment_markers.unwrap();
    let count = |marker| markers.iter().filter(|&&found| found == marker).count();
    // The border belongs to the first that draws it.
    assert_eq!([count(1), count(2), count(0)], [15, 2, 2]);
}

fn is_sound(graph: &PlanarGraph) {
    let points = graph.points.len();
    assert!(graph.points.iter().flatten().all(|x| x.is_finite()));
    let ends = graph.segments.iter().flatten();
    assert!(ends.clone().all(|&end| (end as usize) < points));
    assert!((0..points as u32).all(|point| ends.clone().any(|&end| end == point)));
}

proptest! {
    #[test]
    fn spoiled_files_are_read_or_refused(
        which in 0..2,
        changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 0..6),
        end in any::<prop::sample::Index>(),
        cut in any::<bool>(),
    ) {
        let text = if which == 0 { COUNTRY } else { POLYGONS };
        let mut bytes = text.as_bytes().to_vec();
        for (place, byte) in changes {
            let place = place.index(bytes.len());
            bytes[place] = byte;
        }
        if cut {
            bytes.truncate(end.index(bytes.len()));
        }
        let read = if which == 0 { geojson::parse(&bytes) } else { off::parse_outline(&bytes) };
        if let Ok(graph) = read {
            is_sound(&graph);
        }
    }
}
