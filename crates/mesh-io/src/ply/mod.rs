//! PLY: the vertices and faces of a polygon file, from text or from binary of either byte order.
//!
//! Read are the properties `x` and `y` of a vertex, `z` where there is one, and `weight` where it is asked for, and the list of the
//! corners of a face and the two ends of an edge where the faces are asked for. Everything else is passed over, but
//! passed it must be: a file that ends early is refused even when its vertices are whole.
//!
//! Own code: the readers at hand hold every property of every element in a map, and believe the counts of the header.

mod body;
mod edges;
mod faces;
mod header;
mod number;
mod write;

pub use write::write;

use body::Body;
use edges::edges;
use faces::faces;
use header::{Element, Header, Kind};

use crate::cell::Cells;
use crate::error::{ReadError, ReadProblem};
use crate::mesh::{Axis, Mesh, first_not_finite};
use crate::points::{Coordinates, Points, checked_weight};

/// The vertices of a file, each with the property `weight` if `weighted`; of the plane when they have no `z`.
///
/// # Errors
/// A header that makes no sense, vertices without `x` or `y` (or a weight that is asked for), a file that ends early or goes on, and
/// coordinates that are not finite; each with its line or byte. O(file).
pub fn parse(bytes: &[u8], weighted: bool) -> Result<Points, ReadError> {
    parse_with(bytes, weighted, pass)
}

/// The vertices and faces of a file; faces are called `face` and have 1 to 4 corners in the list `vertex_indices` or
/// `vertex_index`; edges are called `edge`, have the ends `vertex1` and `vertex2` and become segments. `z` is 0 when the vertices have none.
///
/// # Errors
/// As [`parse`], and faces that are not as said, have more corners or name a vertex that does not exist. O(file).
pub fn parse_mesh(bytes: &[u8]) -> Result<Mesh, ReadError> {
    let mut cells = Cells::new();
    let points = parse_with(bytes, false, |body, element| match element.name.as_str() {
        "face" => faces(body, element, &mut cells),
        "edge" => edges(body, element, &mut cells),
        _ => pass(body, element),
    })?;
    let mesh = Mesh::new(points.coordinates.into_space(), cells);
    mesh.check()?;
    Ok(mesh)
}

/// The vertices of a file, the other elements of which `rest` reads.
fn parse_with(
    bytes: &[u8],
    weighted: bool,
    mut rest: impl FnMut(&mut Body<'_>, &Element) -> Result<(), ReadError>,
) -> Result<Points, ReadError> {
    let header = Header::parse(bytes)?;
    let mut body = Body::behind(&header, bytes);
    let mut points = None;
    for element in &header.elements {
        match element.name.as_str() {
            "vertex" if points.is_some() => {
                let what = "a PLY with two lists of vertices";
                return Err(ReadProblem::Unsupported(what.into()).into());
            }
            "vertex" => points = Some(vertices(&mut body, element, weighted)?),
            _ => rest(&mut body, element)?,
        }
    }
    body.end()?;
    points.ok_or_else(|| missing("vertices"))
}

/// Passes over all elements of a kind that is not read.
fn pass(body: &mut Body<'_>, element: &Element) -> Result<(), ReadError> {
    // Of elements without properties nothing is stored, however many there are.
    if element.properties.is_empty() {
        return Ok(());
    }
    (0..element.count).try_for_each(|_| {
        let mut properties = element.properties.iter();
        properties.try_for_each(|property| body.pass(property, &element.name))
    })
}

/// What a property of a vertex is read as.
#[derive(Clone, Copy)]
enum Role {
    Coordinate(Axis),
    Weight,
    Other,
}

fn vertices(body: &mut Body<'_>, element: &Element, weighted: bool) -> Result<Points, ReadError> {
    let roles = roles(element, weighted)?;
    let has = |axis| {
        let is_axis = |role: &Role| matches!(role, Role::Coordinate(found) if *found == axis);
        roles.iter().any(is_axis)
    };
    for (axis, property) in [
        (Axis::X, "coordinate x of its vertices"),
        (Axis::Y, "coordinate y of its vertices"),
    ] {
        if !has(axis) {
            return Err(missing(property));
        }
    }
    let room = body.room_for(element.count, &element.properties);
    let mut weights = Vec::with_capacity(if weighted { room } else { 0 });
    let coordinates = if has(Axis::Z) {
        let mut points = Vec::with_capacity(room);
        each_vertex(body, element, &roles, &mut weights, |point| {
            points.push(point);
        })?;
        Coordinates::Space(points)
    } else {
        let mut points = Vec::with_capacity(room);
        each_vertex(body, element, &roles, &mut weights, |[x, y, _]| {
            points.push([x, y]);
        })?;
        Coordinates::Plane(points)
    };
    Ok(Points {
        coordinates,
        weights: weighted.then_some(weights),
    })
}

/// The role of every property of the vertices.
fn roles(element: &Element, weighted: bool) -> Result<Vec<Role>, ReadError> {
    let mut seen: Vec<&str> = Vec::new();
    let mut roles = Vec::with_capacity(element.properties.len());
    for property in &element.properties {
        let role = match property.name.as_str() {
            "x" => Role::Coordinate(Axis::X),
            "y" => Role::Coordinate(Axis::Y),
            "z" => Role::Coordinate(Axis::Z),
            "weight" if weighted => Role::Weight,
            _ => Role::Other,
        };
        if !matches!(role, Role::Other) {
            let is_list = matches!(property.kind, Kind::List { .. });
            if is_list || seen.contains(&property.name.as_str()) {
                let how = if is_list { "as a list" } else { "twice" };
                let what = format!("property {} of the vertices {how}", property.name);
                return Err(ReadProblem::Unsupported(what).into());
            }
            seen.push(&property.name);
        }
        roles.push(role);
    }
    if weighted && !seen.contains(&"weight") {
        let expected = "property weight of the vertices";
        return Err(ReadProblem::NoWeights { expected }.into());
    }
    Ok(roles)
}

/// Reads every vertex: hands on its coordinates (`z = 0` where there is none) and gathers its weight.
fn each_vertex(
    body: &mut Body<'_>,
    element: &Element,
    roles: &[Role],
    weights: &mut Vec<f64>,
    mut push: impl FnMut([f64; 3]),
) -> Result<(), ReadError> {
    for (index, _) in (0..element.count).enumerate() {
        let start = body.at();
        let mut point = [0.0; 3];
        for (property, role) in element.properties.iter().zip(roles) {
            match (role, property.kind) {
                (Role::Coordinate(axis), Kind::Scalar(number)) => {
                    let expected = format_args!("coordinate {axis} of point {index}");
                    let value = body.real(number, expected)?;
                    if let Some(coordinate) = point.get_mut(*axis as usize) {
                        *coordinate = value;
                    }
                }
                (Role::Weight, Kind::Scalar(number)) => {
                    let expected = format_args!("the weight of point {index}");
                    let weight = checked_weight(index, body.real(number, expected)?);
                    weights.push(weight.map_err(|problem| body.problem(start, problem))?);
                }
                _ => body.pass(property, "vertex")?,
            }
        }
        check(body, start, index, &point)?;
        push(point);
    }
    Ok(())
}

/// Refuses coordinates that are infinite or NaN.
fn check(body: &Body<'_>, start: usize, index: usize, point: &[f64; 3]) -> Result<(), ReadError> {
    first_not_finite(point).map_or(Ok(()), |(axis, value)| {
        let problem = ReadProblem::NotFinite {
            element: "point",
            index,
            axis,
            value,
        };
        Err(body.problem(start, problem))
    })
}

fn missing(what: &str) -> ReadError {
    ReadProblem::Unsupported(format!("a PLY without {what}")).into()
}
