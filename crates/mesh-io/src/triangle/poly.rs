//! `.poly`: a planar straight-line graph.

use std::io::Write;

use super::node::{Nodes, section};
use super::rows::{
    Rows, attribute_count, check_number, has_markers, point_index, write_attributes, write_marker,
};
use super::seeds::{RegionSeed, holes, regions};
use crate::error::{ReadError, ReadProblem, WriteError, WriteProblem};
use crate::format::Format;
use crate::lines::Lines;
use crate::mesh::first_not_finite;
use crate::planar_graph::{PlanarGraph, Region};

/// The graph of a `.poly`. When the file has no points of its own, they are those of the `.node` beside it, which `beside` answers.
///
/// A region of negative area bound, or without one, has none.
///
/// # Errors
/// Counts and numbers that do not hold, points that do not exist, coordinates that are not finite, points of space; each with its
/// line. What `beside` answers. O(file).
pub fn parse_poly(
    bytes: &[u8],
    beside: impl FnOnce() -> Result<Nodes, ReadError>,
) -> Result<PlanarGraph, ReadError> {
    let mut lines = Lines::new(bytes)?;
    let own = section(&mut lines)?;
    let nodes = if own.points.is_empty() {
        beside()?
    } else {
        own
    };
    if nodes.dimension == 3 {
        return Err(ReadProblem::Unsupported("a .poly with points of space".into()).into());
    }
    let (segments, segment_markers) = segments(&mut lines, &nodes)?;
    let holes = holes(&mut lines)?;
    let regions = regions(&mut lines, "area")?;
    lines.end()?;
    Ok(PlanarGraph {
        points: nodes.points.iter().map(|&[x, y, _]| [x, y]).collect(),
        point_markers: nodes.markers,
        point_data: nodes.data,
        segments,
        segment_markers,
        polygons: None,
        holes,
        regions: regions.into_iter().map(region).collect(),
    })
}

fn region(seed: RegionSeed<2>) -> Region {
    Region {
        seed: seed.place,
        attribute: seed.attribute,
        max_area: seed.bound,
    }
}

type Segments = (Vec<[u32; 2]>, Option<Vec<i32>>);

fn segments(lines: &mut Lines<'_>, nodes: &Nodes) -> Result<Segments, ReadError> {
    let mut header = lines.due(format_args!("the number of segments"))?;
    let count = header.number(format_args!("the number of segments"))?;
    let mut rows = Rows::new(0, has_markers(&mut header, "segment")?);
    header.end(format_args!("the counts of segments"))?;
    let mut segments = Vec::with_capacity(lines.room_for(count));
    for index in 0..count {
        let mut line = lines.due(format_args!("segment {index} of {count}"))?;
        check_number(&mut line, "segment", index, nodes.base)?;
        let mut end = |end| {
            point_index(
                &mut line,
                ("segment", index),
                end,
                (nodes.base, nodes.points.len()),
            )
        };
        segments.push([end(0)?, end(1)?]);
        rows.read(&mut line, "segment", index)?;
    }
    let (_, markers) = rows.finish();
    Ok((segments, markers))
}

/// Writes a graph, counted from 1. Point data become attributes, whose names the format does not keep.
///
/// # Errors
/// Points that do not exist or are not finite; lists of other lengths than what they describe.
pub fn write_poly(out: &mut impl Write, graph: &PlanarGraph) -> Result<(), WriteError> {
    check(graph)?;
    let (points, attributes) = (graph.points.len(), attribute_count(&graph.point_data));
    writeln!(
        out,
        "{points} 2 {attributes} {}",
        u8::from(graph.point_markers.is_some())
    )?;
    for (index, [x, y]) in graph.points.iter().enumerate() {
        write!(out, "{} {x:?} {y:?}", index + 1)?;
        write_attributes(out, &graph.point_data, index)?;
        write_marker(out, graph.point_markers.as_deref(), index)?;
    }
    writeln!(
        out,
        "{} {}",
        graph.segments.len(),
        u8::from(graph.segment_markers.is_some())
    )?;
    for (index, &[a, b]) in graph.segments.iter().enumerate() {
        write!(
            out,
            "{} {} {}",
            index + 1,
            u64::from(a) + 1,
            u64::from(b) + 1
        )?;
        write_marker(out, graph.segment_markers.as_deref(), index)?;
    }
    writeln!(out, "{}", graph.holes.len())?;
    for (index, [x, y]) in graph.holes.iter().enumerate() {
        writeln!(out, "{} {x:?} {y:?}", index + 1)?;
    }
    if !graph.regions.is_empty() {
        writeln!(out, "{}", graph.regions.len())?;
    }
    for (
        index,
        &Region {
            seed: [x, y],
            attribute,
            max_area,
        },
    ) in graph.regions.iter().enumerate()
    {
        writeln!(
            out,
            "{} {x:?} {y:?} {attribute:?} {:?}",
            index + 1,
            max_area.unwrap_or(-1.0)
        )?;
    }
    Ok(())
}

fn check(graph: &PlanarGraph) -> Result<(), WriteError> {
    graph.as_mesh().check()?;
    let holes = graph.holes.iter().map(|hole| ("hole", hole));
    let regions = graph.regions.iter().map(|region| ("region", &region.seed));
    for (index, (element, point)) in holes.enumerate().chain(regions.enumerate()) {
        if let Some((axis, value)) = first_not_finite(point) {
            return Err(WriteProblem::NotFinite {
                element,
                index,
                axis,
                value,
            }
            .into());
        }
    }
    let bounds = graph.regions.iter().map(|region| region.max_area);
    match bounds
        .enumerate()
        .find(|(_, area)| area.is_some_and(|area| !(0.0..f64::INFINITY).contains(&area)))
    {
        Some((index, Some(area))) => {
            let what = format!("region {index} with triangles of area {area} at most");
            Err(WriteProblem::Unsupported {
                format: Format::TrianglePoly,
                what,
            }
            .into())
        }
        _ => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::triangle::parse_node;

    const NODES: &[u8] = b"2 2 0 0\n0 0 0\n1 1 0\n";

    fn parse(text: &str) -> Result<PlanarGraph, ReadError> {
        parse_poly(text.as_bytes(), || parse_node(NODES))
    }

    #[test]
    fn holes_regions_and_points_from_beside_are_understood() {
        let graph =
            parse("0 2 0 0\n1 1\n0 0 1 9\n1\n1 0.5 0.25\n2\n1 2 3 4 -1\n2 2 3 5 0.5").unwrap();
        assert_eq!(graph.points, [[0.0, 0.0], [1.0, 0.0]]);
        assert_eq!(
            (graph.segments, graph.segment_markers),
            (vec![[0, 1]], Some(vec![9]))
        );
        assert_eq!(graph.holes, [[0.5, 0.25]]);
        let region = |attribute, max_area| Region {
            seed: [2.0, 3.0],
            attribute,
            max_area,
        };
        assert_eq!(graph.regions, [region(4.0, None), region(5.0, Some(0.5))]);
    }

    #[test]
    fn errors_name_line_and_element() {
        let error = |text: &str| parse(&format!("1 2 0 0\n1 5 5\n{text}")).unwrap_err();
        insta::assert_snapshot!(error(""), @"line 2: the file ends where the number of segments should follow");
        insta::assert_snapshot!(error("1 0\n1 1 2\n0"), @"line 4: segment 0: there is no point 2");
        insta::assert_snapshot!(error("1 0\n1 1 0\n0"), @"line 4: segment 0: there is no point 0");
        insta::assert_snapshot!(error("1 1\n1 1 1\n0"), @"line 4: expected the marker of segment 0, found the end of the line");
        insta::assert_snapshot!(error("1 0\n1 1 1"), @"line 4: the file ends where the number of holes should follow");
        insta::assert_snapshot!(error("0 0\n1\n1 0 inf"), @"line 5: hole 0: y is inf, which is not a finite number");
        insta::assert_snapshot!(error("0 0\n0\n1\n1 0 0"), @"line 6: expected the attribute of region 0, found the end of the line");
        insta::assert_snapshot!(error("0 0\n0\n1\n1 0 0 1 nan"), @"line 6: expected the largest area of region 0, found `nan`");
        insta::assert_snapshot!(error("0 0\n0\n0\n0"), @"line 6: expected the end of the file, found `0`");
        insta::assert_snapshot!(parse("1 3 0 0\n1 0 0 0\n0 0\n0").unwrap_err(), @"a .poly with points of space is not supported");
    }

    #[test]
    fn what_cannot_be_read_back_is_not_written() {
        let error = |seed, max_area| {
            let regions = vec![Region {
                seed,
                attribute: 0.0,
                max_area,
            }];
            write_poly(
                &mut Vec::new(),
                &PlanarGraph {
                    regions,
                    ..PlanarGraph::default()
                },
            )
            .unwrap_err()
        };
        insta::assert_snapshot!(error([0.0, f64::NAN], None), @"region 0: y is NaN, which is not a finite number");
        insta::assert_snapshot!(error([0.0, 0.0], Some(-2.0)), @"Triangle .poly cannot hold region 0 with triangles of area -2 at most");
    }
}
