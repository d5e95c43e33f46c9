//! The section of facets.

use crate::error::ReadError;
use crate::lines::{Line, Lines};
use crate::piecewise_complex::Facet;
use crate::triangle::Nodes;
use crate::triangle::rows::{has_markers, point_index};
use crate::triangle::seeds::hole;

/// The facets, and a marker for each where the file has markers.
pub(super) type Facets = (Vec<Facet>, Option<Vec<i32>>);

/// Facets of any number of polygons and holes.
pub(super) fn poly_facets(lines: &mut Lines<'_>, nodes: &Nodes) -> Result<Facets, ReadError> {
    facets(lines, |lines, mut line, index, marked| {
        let polygons: usize =
            line.number(format_args!("the number of polygons of facet {index}"))?;
        let holes: usize = if line.is_done() {
            0
        } else {
            line.number(format_args!("the number of holes of facet {index}"))?
        };
        let marker = marker(&mut line, index, marked)?;
        let mut facet = Facet::default();
        for polygon in 0..polygons {
            let line = lines.due(format_args!("polygon {polygon} of facet {index}"))?;
            let (corners, mut line) = polygon_at(lines, line, index, nodes)?;
            line.end(format_args!("polygon {polygon} of facet {index}"))?;
            facet.polygons.push(corners);
        }
        for number in 0..holes {
            let mut line = lines.due(format_args!("hole {number} of facet {index}"))?;
            facet.holes.push(hole(&mut line, number)?);
        }
        Ok((facet, marker))
    })
}

/// Facets of one polygon each.
pub(super) fn smesh_facets(lines: &mut Lines<'_>, nodes: &Nodes) -> Result<Facets, ReadError> {
    facets(lines, |lines, line, index, marked| {
        let (corners, mut line) = polygon_at(lines, line, index, nodes)?;
        let marker = marker(&mut line, index, marked)?;
        let facet = Facet {
            polygons: vec![corners],
            holes: Vec::new(),
        };
        Ok((facet, marker))
    })
}

/// The header of the section, and the facets that `read` reads from their first lines on; it hears whether they have markers.
fn facets<'a>(
    lines: &mut Lines<'a>,
    mut read: impl FnMut(&mut Lines<'a>, Line<'a>, usize, bool) -> Result<(Facet, i32), ReadError>,
) -> Result<Facets, ReadError> {
    let mut header = lines.due(format_args!("the number of facets"))?;
    let count: usize = header.number(format_args!("the number of facets"))?;
    let marked = has_markers(&mut header, "facet")?;
    header.end(format_args!("the counts of facets"))?;
    let mut facets = Vec::new();
    let mut markers = Vec::new();
    for index in 0..count {
        let line = lines.due(format_args!("facet {index} of {count}"))?;
        let (facet, marker) = read(lines, line, index, marked)?;
        facets.push(facet);
        markers.push(marker);
    }
    Ok((facets, marked.then_some(markers)))
}

/// The corners of a polygon that begins on `line`, and the line on which it ends.
fn polygon_at<'a>(
    lines: &mut Lines<'a>,
    mut line: Line<'a>,
    facet: usize,
    nodes: &Nodes,
) -> Result<(Vec<u32>, Line<'a>), ReadError> {
    let count: usize = line.number(format_args!("the number of corners in facet {facet}"))?;
    if count == 0 {
        return Err(line.unexpected(format_args!("a polygon with corners in facet {facet}"), "0"));
    }
    let mut corners = Vec::new();
    for corner in 0..count {
        if line.is_done() {
            line = lines.due(format_args!("point {corner} of facet {facet}"))?;
        }
        let known = (nodes.base, nodes.points.len());
        corners.push(point_index(&mut line, ("facet", facet), corner, known)?);
    }
    Ok((corners, line))
}

/// The marker at the end of a line: 0 where none is or should be.
fn marker(line: &mut Line<'_>, facet: usize, marked: bool) -> Result<i32, ReadError> {
    let marker = if marked && !line.is_done() {
        line.number(format_args!("the marker of facet {facet}"))?
    } else {
        0
    };
    line.end(format_args!("facet {facet}"))?;
    Ok(marker)
}
