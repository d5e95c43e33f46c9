//! Points of space into tetrahedra.

use vide::convert::tetrahedron_mesh;
use vide::delaunay_core::{BuildError, Delaunay3, Regular3, RegularError, TetMesh};
use vide::glam::DVec3;
use vide::mesh_io::{Mesh, Points, Polytopes};
use vide::voronoi::{voronoi_polyhedra, window_of_space};

use super::flat::flat_text;
use super::{DelaunayArgs, Triangulated, WINDOW};
use crate::cli::Common;
use crate::cli::failure::Failure;
use crate::cli::progress::Watch;
use crate::cli::report::Report;

pub(super) fn tetrahedralize(
    args: &DelaunayArgs,
    points: Points,
    watch: &mut Watch,
) -> Result<Triangulated, Failure> {
    let Points {
        coordinates,
        weights,
    } = points;
    let points = coordinates.into_space().into_iter();
    let points: Vec<DVec3> = points.map(DVec3::from).collect();
    match weights {
        None => delaunay(args, points, watch),
        Some(weights) => regular(args, &points, &weights, watch),
    }
}

fn delaunay(
    args: &DelaunayArgs,
    points: Vec<DVec3>,
    watch: &mut Watch,
) -> Result<Triangulated, Failure> {
    let built = watch.stage("triangulate", |watch| {
        let mut report = |progress| watch.report(progress);
        Delaunay3::build_on(&points, Common::build_options(), &mut report)
    });
    let delaunay = built.map_err(|error| failed(args, &points, error))?;
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
    points: &[DVec3],
    weights: &[f64],
    watch: &mut Watch,
) -> Result<Triangulated, Failure> {
    let built = watch.stage("triangulate", |watch| {
        Regular3::build_with(points, weights, &mut |progress| watch.report(progress))
    });
    let regular = built.map_err(|error| match error {
        RegularError::Build(error) => failed(args, points, error),
        error => Failure::input(&args.points, error),
    })?;
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
fn sorted(points: &[DVec3], mesh: &TetMesh, watch: &mut Watch) -> (Mesh, Report) {
    let tetrahedra = watch.stage("sort", |_| tetrahedron_mesh(points, mesh));
    let ghosts = mesh.tet_count() - tetrahedra.cells.len();
    let report = Report {
        dimension: Some(3),
        elements: tetrahedra.cells.len(),
        // Euler: a sphere of f triangles has f / 2 + 2 vertices.
        hull_vertices: Some(ghosts / 2 + 2),
        hull_sides: Some(ghosts),
        ..Report::default()
    };
    (tetrahedra, report)
}

fn voronoi(
    args: &DelaunayArgs,
    delaunay: &Delaunay3,
    watch: &mut Watch,
) -> Result<Polytopes, Failure> {
    let window = window_of_space(delaunay.points())
        .map_err(|error| Failure::input(&args.points, format_args!("{WINDOW}: {error}")))?;
    let sites = delaunay.vertex_count();
    Ok(watch.stage("voronoi", |watch| {
        voronoi_polyhedra(delaunay, &window, &mut |done| watch.voronoi(done, sites))
    }))
}

fn failed(args: &DelaunayArgs, points: &[DVec3], error: BuildError) -> Failure {
    match error {
        BuildError::Flat(flat) => Failure::input(&args.points, flat_text(*flat, points)),
        error => Failure::input(&args.points, error),
    }
}
