//! Points of the plane into triangles.

use vide::convert::triangle_mesh;
use vide::delaunay_core::Delaunay2;
use vide::glam::DVec2;
use vide::mesh_io::Points;

use super::{DelaunayArgs, Triangulated};
use crate::cli::Common;
use crate::cli::failure::Failure;
use crate::cli::progress::Watch;
use crate::cli::report::Report;

pub(super) fn triangulate(
    args: &DelaunayArgs,
    points: Points,
    watch: &mut Watch,
) -> Result<Triangulated, Failure> {
    let points = points.coordinates.into_plane().map_err(|off_plane| {
        Failure::input(
            &args.points,
            format_args!("{off_plane}; --dim 3 takes points of space"),
        )
    })?;
    let points: Vec<DVec2> = points.into_iter().map(DVec2::from).collect();
    let delaunay = watch
        .stage("triangulate", |watch| {
            let mut report = |progress| watch.report(progress);
            Delaunay2::build_on(&points, Common::build_options(), &mut report)
        })
        .map_err(|error| Failure::input(&args.points, error))?;
    drop(points);
    let mesh = watch.stage("sort", |_| triangle_mesh(&delaunay));
    let report = Report {
        dimension: Some(2),
        vertices: delaunay.vertex_count(),
        elements: mesh.cells.len(),
        duplicates: Some(delaunay.duplicates().len()),
        hull_vertices: Some(delaunay.hull_vertices().count()),
        hull_sides: Some(delaunay.hull().count()),
        ..Report::default()
    };
    Ok(Triangulated { mesh, report })
}
