//! The curves of each shape, in its own coordinates.

use kurbo::{BezPath, Point, Vec2};

use super::arc::{Arc, push_arc};
use super::element::Element;
use super::path_data;
use crate::error::ReadProblem;

/// Whether an element is one that [`curves`] knows.
pub(super) fn is_shape(element: &Element) -> bool {
    matches!(
        element.name(),
        "path" | "polygon" | "polyline" | "rect" | "circle" | "ellipse" | "line"
    )
}

/// The curves of a shape before its transform; none for a shape without size, and for what is no shape.
pub(super) fn curves(element: &Element) -> Result<BezPath, ReadProblem> {
    match element.name() {
        "path" => path(element),
        "polygon" => Ok(polygon(&element.points("points")?, true)),
        "polyline" => Ok(polygon(&element.points("points")?, false)),
        "rect" => rect(element),
        "circle" => {
            let r = element.extent("r")?.unwrap_or(0.0);
            ellipse(element, Vec2::new(r, r))
        }
        "ellipse" => {
            let (rx, ry) = both(element.extent("rx")?, element.extent("ry")?);
            ellipse(element, Vec2::new(rx, ry))
        }
        "line" => {
            let end = |x, y| Ok::<_, ReadProblem>([element.coordinate(x)?, element.coordinate(y)?]);
            Ok(polygon(&[end("x1", "y1")?, end("x2", "y2")?], false))
        }
        _ => Ok(BezPath::new()),
    }
}

fn path(element: &Element) -> Result<BezPath, ReadProblem> {
    let data = element.attribute("d")?.unwrap_or_default();
    path_data::curves(&data).map_err(|error| element.fault("d", error.to_string()))
}

fn polygon(corners: &[[f64; 2]], closed: bool) -> BezPath {
    let mut curves = BezPath::new();
    let mut corners = corners.iter().map(|&[x, y]| Point::new(x, y));
    if let Some(first) = corners.next() {
        curves.move_to(first);
        corners.for_each(|corner| curves.line_to(corner));
        if closed {
            curves.close_path();
        }
    }
    curves
}

/// Two radii where the one that is not there equals the other.
fn both(rx: Option<f64>, ry: Option<f64>) -> (f64, f64) {
    let (rx, ry) = (rx.or(ry), ry.or(rx));
    (rx.unwrap_or(0.0), ry.unwrap_or(0.0))
}

/// Source: SVG 2, section 10.2, "the equivalent path of a rect".
fn rect(element: &Element) -> Result<BezPath, ReadProblem> {
    let (x, y) = (element.coordinate("x")?, element.coordinate("y")?);
    let width = element.extent("width")?.unwrap_or(0.0);
    let height = element.extent("height")?.unwrap_or(0.0);
    let (rx, ry) = both(element.extent("rx")?, element.extent("ry")?);
    let mut curves = BezPath::new();
    if width == 0.0 || height == 0.0 {
        return Ok(curves);
    }
    let (right, bottom) = (x + width, y + height);
    if rx == 0.0 || ry == 0.0 {
        return Ok(polygon(
            &[[x, y], [right, y], [right, bottom], [x, bottom]],
            true,
        ));
    }
    let radii = Vec2::new(rx.min(width / 2.0), ry.min(height / 2.0));
    let ([near_x, far_x], [near_y, far_y]) = (
        corners_end(x, width, radii.x),
        corners_end(y, height, radii.y),
    );
    let sides = [
        [(near_x, y), (far_x, y)],
        [(right, near_y), (right, far_y)],
        [(far_x, bottom), (near_x, bottom)],
        [(x, far_y), (x, near_y)],
    ];
    curves.move_to(sides[0][0]);
    for (index, &[_, end]) in sides.iter().enumerate() {
        let [next, _] = sides[(index + 1) % 4];
        curves.line_to(end);
        push_arc(&mut curves, end, &Arc::quarter(radii, next));
    }
    curves.close_path();
    Ok(curves)
}

/// Where the round corners of a side end. Corners that meet do so in one place, whatever the rounding.
fn corners_end(begin: f64, length: f64, radius: f64) -> [f64; 2] {
    let near = begin + radius;
    if radius < length / 2.0 {
        [near, begin + length - radius]
    } else {
        [near, near]
    }
}

/// Four quarters. Source: SVG 2, sections 10.3 and 10.4.
fn ellipse(element: &Element, radii: Vec2) -> Result<BezPath, ReadProblem> {
    let (cx, cy) = (element.coordinate("cx")?, element.coordinate("cy")?);
    let Vec2 { x: rx, y: ry } = radii;
    let mut curves = BezPath::new();
    if rx == 0.0 || ry == 0.0 {
        return Ok(curves);
    }
    let quarters = [(cx + rx, cy), (cx, cy + ry), (cx - rx, cy), (cx, cy - ry)];
    curves.move_to((cx + rx, cy));
    for (index, &from) in quarters.iter().enumerate() {
        let arc = Arc::quarter(radii, quarters[(index + 1) % 4]);
        push_arc(&mut curves, from, &arc);
    }
    curves.close_path();
    Ok(curves)
}
