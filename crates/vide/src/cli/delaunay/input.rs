//! Which points are triangulated, and in which dimension.

use vide::mesh_io::{Dimension, Points, PointsWanted, read_points};

use super::DelaunayArgs;
use crate::cli::failure::Failure;

pub(super) fn read(args: &DelaunayArgs) -> Result<Points, Failure> {
    let wanted = PointsWanted {
        dimension: args.dim.map(Dimension::from),
        weights: args.weighted,
    };
    Ok(read_points(&args.points, wanted)?)
}

/// The dimension asked for, else that of the points.
pub(super) fn dimension(args: &DelaunayArgs, points: &Points) -> Dimension {
    let found = || {
        if points.coordinates.are_planar() {
            Dimension::Plane
        } else {
            Dimension::Space
        }
    };
    args.dim.map_or_else(found, Dimension::from)
}
