//! `GeoJSON` (RFC 7946): outlines of countries, lakes and rivers as JSON.
//!
//! Coordinates are plane x and y as they stand; nothing is projected. Numbers are rounded to the nearest double, and those
//! beyond the largest are refused with the syntax.

mod part;

use serde_json::Value;

use crate::error::{ReadError, ReadProblem};
use crate::outline::Outline;
use crate::planar_graph::PlanarGraph;
use part::Part;

/// Positions that a ring has at least, the last equal to the first (§3.1.6).
const FEWEST_IN_RING: usize = 4;

/// The segments of all rings and lines of a `GeoJSON` file: polygons, lines, collections, features and their collections.
///
/// Points at exactly one place are one point, so a segment given twice is kept once. An integer property `marker` of a
/// feature becomes the marker of its segments; others have marker 0. Altitudes and other properties are passed over. Each
/// segment knows the polygons whose rings run along it ([`PlanarGraph::polygons`]), so that borders which two of them share are
/// known from coasts.
///
/// # Errors
/// Malformed JSON with its line; unknown types, members of another form, rings that do not close or have fewer than 4
/// positions, lines of one position, positions of fewer than 2 numbers, markers that are no integers of 32 bits, points
/// (which make no segment): each with its feature, ring and position. O(file).
pub fn parse(bytes: &[u8]) -> Result<PlanarGraph, ReadError> {
    let document = document(bytes)?;
    let mut drawing = Drawing::default();
    drawing.document(&document)?;
    Ok(drawing.outline.into_graph())
}

fn document(bytes: &[u8]) -> Result<Value, ReadError> {
    let text = std::str::from_utf8(bytes)
        .map_err(|error| ReadError::at_byte(error.valid_up_to(), ReadProblem::NotText))?;
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    serde_json::from_str(text).map_err(|error| {
        let (line, column) = (error.line(), error.column());
        let message = error.to_string();
        let place = format!(" at line {line} column {column}");
        let what = message.strip_suffix(&place).unwrap_or(&message);
        let problem = ReadProblem::Syntax(format!("{what} at column {column}"));
        ReadError::at_line(line.max(1), problem)
    })
}

/// The outline so far, and the marker of the feature that is drawn. Objects nest no deeper than the JSON parser allows.
#[derive(Default)]
struct Drawing {
    outline: Outline,
    marker: Option<i32>,
    polygon_count: u32,
}

impl Drawing {
    fn document(&mut self, object: &Value) -> Result<(), ReadError> {
        let file = Part::FILE;
        match file.type_of(object)? {
            "FeatureCollection" => {
                for (index, feature) in file.list_in(object, "features")?.iter().enumerate() {
                    self.feature(feature, file.inner("feature", index))?;
                }
                Ok(())
            }
            "Feature" => self.feature(object, file.inner("feature", 0)),
            _ => self.geometry(object, file),
        }
    }

    fn feature(&mut self, feature: &Value, part: Part<'_>) -> Result<(), ReadError> {
        let found = part.type_of(feature)?;
        if found != "Feature" {
            return Err(part.unexpected("the type Feature", &found.into()));
        }
        self.marker = marker(feature, part)?;
        match part.member(feature, "geometry")? {
            // A feature without a place (§3.2).
            Value::Null => Ok(()),
            geometry => self.geometry(geometry, part),
        }
    }

    fn geometry(&mut self, geometry: &Value, part: Part<'_>) -> Result<(), ReadError> {
        let kind = part.type_of(geometry)?;
        let coordinates = || part.list_in(geometry, "coordinates");
        match kind {
            // No coordinates at all make no geometry (§3.1).
            "LineString" | "Polygon" if coordinates()?.is_empty() => Ok(()),
            "LineString" => self.line(coordinates()?, part),
            "Polygon" => self.polygon(coordinates()?, part),
            "MultiLineString" => {
                for (index, line) in coordinates()?.iter().enumerate() {
                    let part = part.inner("line", index);
                    self.line(part.list(line)?, part)?;
                }
                Ok(())
            }
            "MultiPolygon" => {
                for (index, polygon) in coordinates()?.iter().enumerate() {
                    let part = part.inner("polygon", index);
                    self.polygon(part.list(polygon)?, part)?;
                }
                Ok(())
            }
            "GeometryCollection" => {
                let geometries = part.list_in(geometry, "geometries")?;
                for (index, geometry) in geometries.iter().enumerate() {
                    self.geometry(geometry, part.inner("geometry", index))?;
                }
                Ok(())
            }
            "Point" | "MultiPoint" => {
                let what = format!("{part}: a geometry of type {kind}, which has no segments,");
                Err(ReadProblem::Unsupported(what).into())
            }
            _ => Err(part.unexpected("a type of geometry", &kind.into())),
        }
    }

    fn polygon(&mut self, rings: &[Value], part: Part<'_>) -> Result<(), ReadError> {
        for (index, ring) in rings.iter().enumerate() {
            let part = part.inner("ring", index);
            let positions = positions(part.list(ring)?, part)?;
            if positions.len() < FEWEST_IN_RING {
                return Err(part.too_short(FEWEST_IN_RING, positions.len()));
            }
            if positions.first() != positions.last() {
                let last = part.inner("position", positions.len() - 1);
                let [x, y] = positions.last().copied().unwrap_or_default();
                return Err(last.unexpected("the first position again", &vec![x, y].into()));
            }
            self.path(&positions, Some(self.polygon_count))?;
        }
        self.polygon_count += 1;
        Ok(())
    }

    fn line(&mut self, line: &[Value], part: Part<'_>) -> Result<(), ReadError> {
        let positions = positions(line, part)?;
        if positions.len() < 2 {
            return Err(part.too_short(2, positions.len()));
        }
        self.path(&positions, None)
    }

    /// A segment from each position to the next.
    fn path(&mut self, positions: &[[f64; 2]], polygon: Option<u32>) -> Result<(), ReadError> {
        for pair in positions.windows(2) {
            if let &[from, to] = pair {
                let ends = [self.outline.point(from)?, self.outline.point(to)?];
                match polygon {
                    Some(polygon) => self.outline.ring_segment(ends, self.marker, polygon),
                    None => self.outline.segment(ends, self.marker),
                }
            }
        }
        Ok(())
    }
}

/// The property `marker` of a feature. Whole numbers written with a point count, as tables with gaps are exported so.
fn marker(feature: &Value, part: Part<'_>) -> Result<Option<i32>, ReadError> {
    let property = feature.get("properties").and_then(|all| all.get("marker"));
    let Some(marker) = property.filter(|marker| !marker.is_null()) else {
        return Ok(None);
    };
    let whole = marker.as_f64().filter(|number| {
        number.fract() == 0.0 && (f64::from(i32::MIN)..=f64::from(i32::MAX)).contains(number)
    });
    whole.map_or_else(
        || Err(part.unexpected("an integer of 32 bits as property `marker`", marker)),
        |number| Ok(Some(number as i32)),
    )
}

fn positions(list: &[Value], part: Part<'_>) -> Result<Vec<[f64; 2]>, ReadError> {
    let indexed = list.iter().enumerate();
    indexed
        .map(|(index, value)| position(value, part.inner("position", index)))
        .collect()
}

/// The first two numbers of a position; what follows is altitude.
fn position(value: &Value, part: Part<'_>) -> Result<[f64; 2], ReadError> {
    let numbers = match part.list(value)? {
        [x, y, ..] => x.as_f64().zip(y.as_f64()),
        _ => None,
    };
    let (x, y) = numbers.ok_or_else(|| part.unexpected("at least 2 numbers", value))?;
    Ok([x, y])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn error(text: &str) -> String {
        parse(text.as_bytes()).unwrap_err().to_string()
    }

    const RING: &str = "[[0,0],[1,0],[0,1],[0,0]]";

    #[test]
    fn a_ring_is_a_loop_of_segments_without_altitude_or_standstill() {
        let text = "\u{feff}{\"type\":\"Polygon\",\"coordinates\":[[[0,0,7],[1,0],[1,0,3],[0,1],[-0.0,0]]]}";
        let graph = parse(text.as_bytes()).unwrap();
        assert_eq!(graph.points, [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]);
        assert_eq!(graph.segments, [[0, 1], [1, 2], [2, 0]]);
        assert_eq!(graph.segment_markers, None);
        assert_eq!(graph.polygons, Some(vec![vec![0]; 3]));
    }

    #[test]
    fn borders_have_both_polygons_and_lines_have_none() {
        let ring = |places: &str| format!("[[{places}]]");
        let left = ring("[0,0],[1,0],[1,1],[0,0]");
        let right = ring("[1,0],[2,0],[1,1],[1,0]");
        let polygons = format!(r#"{{"type":"MultiPolygon","coordinates":[{left},{right}]}}"#);
        let line = r#"{"type":"LineString","coordinates":[[2,0],[3,0]]}"#;
        let text = format!(r#"{{"type":"GeometryCollection","geometries":[{polygons},{line}]}}"#);
        let graph = parse(text.as_bytes()).unwrap();
        assert_eq!(graph.segments[1], [1, 2]);
        let expected: [&[u32]; 6] = [&[0], &[0, 1], &[0], &[1], &[1], &[]];
        assert_eq!(graph.polygons, Some(expected.map(<[u32]>::to_vec).to_vec()));
    }

    #[test]
    fn markers_belong_to_the_segments_of_their_feature() {
        let feature = |marker: &str, geometry: &str| {
            format!(r#"{{"type":"Feature","properties":{marker},"geometry":{geometry}}}"#)
        };
        let line = r#"{"type":"LineString","coordinates":[[0,0],[2,2]]}"#;
        let lines = r#"{"type":"MultiLineString","coordinates":[[[0,0],[3,3]],[]]}"#;
        let lines = lines.replace(",[]", ",[[0,0],[4,4]]");
        let polygon = format!(r#"{{"type":"Polygon","coordinates":[{RING}]}}"#);
        let both = format!(r#"{{"type":"GeometryCollection","geometries":[{polygon},{line}]}}"#);
        let features = [
            feature("{\"marker\":-7}", &both),
            feature("null", &lines),
            feature("{\"marker\":3.0}", "null"),
            feature(
                "{\"marker\":null}",
                r#"{"type":"Polygon","coordinates":[]}"#,
            ),
        ];
        let text = format!(
            r#"{{"type":"FeatureCollection","features":[{}]}}"#,
            features.join(",")
        );
        let graph = parse(text.as_bytes()).unwrap();
        assert_eq!(
            graph.segments,
            [[0, 1], [1, 2], [2, 0], [0, 3], [0, 4], [0, 5]]
        );
        assert_eq!(graph.segment_markers, Some(vec![-7, -7, -7, -7, 0, 0]));
        assert_eq!(parse(features[1].as_bytes()).unwrap().segment_markers, None);
    }

    #[test]
    fn numbers_are_rounded_to_the_nearest_double() {
        let text = r#"{"type":"LineString","coordinates":[[0.30000000000000004,122.416294033786585],[5e-324,1e300]]}"#;
        let graph = parse(text.as_bytes()).unwrap();
        assert_eq!(
            graph.points,
            [
                [0.1 + 0.2, "122.416294033786585".parse().unwrap()],
                [5e-324, 1e300]
            ]
        );
    }

    #[test]
    fn errors_name_line_or_feature_ring_and_position() {
        let polygon = |ring: &str| {
            error(&format!(
                r#"{{"type":"Polygon","coordinates":[{RING},{ring}]}}"#
            ))
        };
        let feature = |geometry: &str, properties: &str| {
            error(&format!(
                r#"{{"type":"FeatureCollection","features":[{{"type":"Feature","geometry":null}},{{"type":"Feature","properties":{properties},"geometry":{geometry}}}]}}"#
            ))
        };
        let said = [
            error(""),
            error("{\n\"type\": \"Polygon\",\n\"coordinates\": [[[0, nan"),
            error("{\n\"type\": 1e999}"),
            error(&"[".repeat(1000)),
            parse(b"{\"type\": \"\xff\"}").unwrap_err().to_string(),
            error("[]"),
            error("{\"type\": 3}"),
            error("{\"type\": \"Topology\"}"),
            error("{\"type\": \"Point\", \"coordinates\": [0, 0]}"),
            error("{\"type\": \"Polygon\"}"),
            error("{\"type\": \"FeatureCollection\", \"features\": {}}"),
            error("{\"type\": \"FeatureCollection\", \"features\": [{\"type\": \"Polygon\"}]}"),
            error("{\"type\": \"Feature\"}"),
            polygon("[[0,0],[1,0],[0,0]]"),
            polygon("[[0,0],[1,0],[0,1],[0.5,0]]"),
            polygon("[[0,0],[1],[0,1],[0,0]]"),
            polygon("[[0,0],[1,\"0\"],[0,1],[0,0]]"),
            polygon("[[0,0],1,[0,1],[0,0]]"),
            polygon("7"),
            feature(
                "{\"type\":\"MultiPolygon\",\"coordinates\":[[],[[[0,0],[1,null]]]]}",
                "{}",
            ),
            feature(
                "{\"type\":\"MultiLineString\",\"coordinates\":[[[0,0]]]}",
                "{}",
            ),
            feature(
                "{\"type\":\"GeometryCollection\",\"geometries\":[{\"type\":\"Circle\"}]}",
                "{}",
            ),
            feature("null", "{\"marker\":1.5}"),
            feature("null", "{\"marker\":3000000000}"),
            feature("null", "{\"marker\":\"land\"}"),
        ];
        insta::assert_snapshot!(said.join("\n"));
    }
}
