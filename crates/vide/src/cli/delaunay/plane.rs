//! Points of the plane into triangles.

use vide::convert::triangle_mesh;
use vide::delaunay_core::Delaunay2;
use vide::glam::DVec2;
use vide::mesh_io::{Points, Polytopes};
use vide::voronoi::{voronoi_polygons, window_of_plane};

use super::{DelaunayArgs, Triangulated, WINDOW};
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
    let voronoi = match &args.voronoi {
        Some(_) => Some(voronoi(args, &delaunay, watch)?),
        None => None,
    };
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
    Ok(Triangulated {
        mesh,
        voronoi,
        report,
    })
}

fn voronoi(
    args: &DelaunayArgs,
    delaunay: &Delaunay2,
    watch: &mut Watch,
) -> Result<Polytopes, Failure> {
    let window = window_of_plane(delaunay.points())
        .map_err(|error| Failure::input(&args.points, format_args!("{WINDOW}: {error}")))?;
    let sites = delaunay.vertex_count();
    Ok(watch.stage("voronoi", |watch| {
        voronoi_polygons(delaunay, &window, &mut |done| watch.voronoi(done, sites))
    }))
}
