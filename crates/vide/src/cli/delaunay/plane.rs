//! Points of the plane into triangles.

use std::fmt::Display;

use vide::convert::triangle_mesh;
use vide::delaunay_core::{Delaunay2, Regular2, TriMesh};
use vide::glam::DVec2;
use vide::mesh_io::{Mesh, Points, Polytopes};
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
    let Points {
        coordinates,
        weights,
    } = points;
    let points = coordinates
        .into_plane()
        .map_err(|off| failed(args, format_args!("{off}; --dim 3 takes points of space")))?;
    let points: Vec<DVec2> = points.into_iter().map(DVec2::from).collect();
    match weights {
        None => delaunay(args, points, watch),
        Some(weights) => regular(args, &points, &weights, watch),
    }
}

fn delaunay(
    args: &DelaunayArgs,
    points: Vec<DVec2>,
    watch: &mut Watch,
) -> Result<Triangulated, Failure> {
    let built = watch.stage("triangulate", |watch| {
        let mut report = |progress| watch.report(progress);
        Delaunay2::build_on(&points, Common::build_options(), &mut report)
    });
    let delaunay = built.map_err(|error| failed(args, error))?;
    drop(points);
    let voronoi = match &args.voronoi {
        Some(_) => Some(voronoi(args, &delaunay, watch)?),
        None => None,
    };
    let (mesh, report) = sorted(delaunay.points(), delaunay.mesh(), watch);
    let report = Report {
        vertices: delaunay.vertex_count(),
        duplicates: Some(delaunay.duplicates().len()),
        ..report
    };
    Ok(Triangulated {
        mesh,
        voronoi,
        report,
    })
}

fn regular(
    args: &DelaunayArgs,
    points: &[DVec2],
    weights: &[f64],
    watch: &mut Watch,
) -> Result<Triangulated, Failure> {
    let built = watch.stage("triangulate", |watch| {
        Regular2::build_with(points, weights, &mut |progress| watch.report(progress))
    });
    let regular = built.map_err(|error| failed(args, error))?;
    let (mesh, report) = sorted(regular.points(), regular.mesh(), watch);
    let report = Report {
        vertices: regular.vertex_count(),
        duplicates: Some(regular.duplicates().len()),
        hidden: Some(regular.hidden().len()),
        ..report
    };
    Ok(Triangulated {
        mesh,
        voronoi: None,
        report,
    })
}

/// The mesh for files, and what its ghosts tell of the hull.
fn sorted(points: &[DVec2], mesh: &TriMesh, watch: &mut Watch) -> (Mesh, Report) {
    let triangles = watch.stage("sort", |_| triangle_mesh(points, mesh));
    let ghosts = mesh.face_count() - triangles.cells.len();
    let report = Report {
        dimension: Some(2),
        elements: triangles.cells.len(),
        hull_vertices: Some(ghosts),
        hull_sides: Some(ghosts),
        ..Report::default()
    };
    (triangles, report)
}

fn voronoi(
    args: &DelaunayArgs,
    delaunay: &Delaunay2,
    watch: &mut Watch,
) -> Result<Polytopes, Failure> {
    let window = window_of_plane(delaunay.points())
        .map_err(|error| failed(args, format_args!("{WINDOW}: {error}")))?;
    let sites = delaunay.vertex_count();
    Ok(watch.stage("voronoi", |watch| {
        voronoi_polygons(delaunay, &window, &mut |done| watch.voronoi(done, sites))
    }))
}

fn failed(args: &DelaunayArgs, problem: impl Display) -> Failure {
    Failure::input(&args.points, problem)
}
