//! Reading points in the format that a path names.

use std::path::Path;

use crate::error::{ReadError, ReadProblem};
use crate::format::Format;
use crate::mesh::{DataArray, Mesh};
use crate::points::{Coordinates, Dimension, Points, PointsWanted, checked_weight};
use crate::read::{mesh_of, named};
use crate::triangle::{Nodes, parse_node};
use crate::{ply, raw, xy};

/// The points in a file of any format that holds some, in the dimension of the file.
///
/// An `.xy` is of the plane, an `.xyz` of space; a `.node`, a `.ply` and raw numbers tell themselves; the points of any mesh are of
/// space. Weights are a further column of text or raw numbers, the first attribute of a `.node`, and what is called `weight`
/// elsewhere.
///
/// # Errors
/// A [`ReadError`] that names the file, and the line or byte and the point where one is to blame. O(file).
pub fn read_points(path: &Path, wanted: PointsWanted) -> Result<Points, ReadError> {
    named(path, |format, bytes| match (format, wanted.weights) {
        (Format::Xy, false) => Ok(alone(Coordinates::Plane(xy::parse(bytes)?))),
        (Format::Xyz, false) => Ok(alone(Coordinates::Space(xy::parse(bytes)?))),
        (Format::Xy, true) => {
            let (points, weights) = xy::parse_weighted(bytes)?;
            Ok(weighted(Coordinates::Plane(points), weights))
        }
        (Format::Xyz, true) => {
            let (points, weights) = xy::parse_weighted(bytes)?;
            Ok(weighted(Coordinates::Space(points), weights))
        }
        (Format::Ply, weights) => ply::parse(bytes, weights),
        (Format::Raw, weights) => {
            let dimension = raw::dimension_of(path).or(wanted.dimension);
            raw::parse(bytes, dimension.ok_or(ReadProblem::NoDimension)?, weights)
        }
        (Format::TriangleNode, weights) => of_nodes(parse_node(bytes)?, weights),
        (_, weights) => of_mesh(mesh_of(path, format, bytes)?, weights),
    })
}

fn alone(coordinates: Coordinates) -> Points {
    Points {
        coordinates,
        weights: None,
    }
}

fn weighted(coordinates: Coordinates, weights: Vec<f64>) -> Points {
    Points {
        coordinates,
        weights: Some(weights),
    }
}

fn of_nodes(nodes: Nodes, weights: bool) -> Result<Points, ReadError> {
    let coordinates = if nodes.dimension == Dimension::Plane.count() {
        let planar = nodes.points.into_iter().map(|[x, y, _]| [x, y]);
        Coordinates::Plane(planar.collect())
    } else {
        Coordinates::Space(nodes.points)
    };
    if !weights {
        return Ok(alone(coordinates));
    }
    let weights = match nodes.data.into_iter().next() {
        Some(attribute) => attribute.values,
        // Without points there is no attribute either.
        None if coordinates.is_empty() => Vec::new(),
        None => return Err(no_weights("an attribute")),
    };
    Ok(weighted(coordinates, checked(weights)?))
}

fn of_mesh(mesh: Mesh, weights: bool) -> Result<Points, ReadError> {
    let coordinates = Coordinates::Space(mesh.points);
    if !weights {
        return Ok(alone(coordinates));
    }
    let is_weight = |array: &DataArray| array.name == "weight" && array.components == 1;
    let array = mesh.point_data.into_iter().find(is_weight);
    let array = array.ok_or_else(|| no_weights("point data called weight"))?;
    Ok(weighted(coordinates, checked(array.values)?))
}

fn no_weights(expected: &'static str) -> ReadError {
    ReadProblem::NoWeights { expected }.into()
}

fn checked(weights: Vec<f64>) -> Result<Vec<f64>, ReadError> {
    let mut indexed = weights.iter().enumerate();
    indexed.try_for_each(|(index, &weight)| checked_weight(index, weight).map(drop))?;
    Ok(weights)
}
