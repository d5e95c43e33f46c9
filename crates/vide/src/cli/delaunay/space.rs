//! Points of space into tetrahedra.

use vide::convert::tetrahedron_mesh;
use vide::delaunay_core::{BuildError, Delaunay3, Flat, TriMesh};
use vide::glam::DVec3;
use vide::mesh_io::{Points, Polytopes};
use vide::voronoi::{voronoi_polyhedra, window_of_space};

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
    let is_planar = points.coordinates.are_planar();
    let points = points.coordinates.into_space().into_iter();
    let points: Vec<DVec3> = points.map(DVec3::from).collect();
    let delaunay = watch
        .stage("triangulate", |watch| {
            let mut report = |progress| watch.report(progress);
            Delaunay3::build_on(&points, Common::build_options(), &mut report)
        })
        .map_err(|error| match error {
            BuildError::Flat(flat) => Failure::input(&args.points, flat_text(&flat, is_planar)),
            error => Failure::input(&args.points, error),
        })?;
    drop(points);
    let voronoi = match &args.voronoi {
        Some(_) => Some(voronoi(args, &delaunay, watch)?),
        None => None,
    };
    let mesh = watch.stage("sort", |_| tetrahedron_mesh(&delaunay));
    let report = Report {
        dimension: Some(3),
        vertices: delaunay.vertex_count(),
        elements: mesh.cells.len(),
        duplicates: Some(delaunay.duplicates().len()),
        hull_vertices: Some(delaunay.hull_vertices().len()),
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

/// What points that span no tetrahedron are instead, and what can be done with them.
fn flat_text(flat: &Flat, is_planar: bool) -> String {
    let what = BuildError::Flat(Box::new(flat.clone()));
    let through_first = |plane: &TriMesh| {
        let real = plane.faces().filter(|&face| !plane.is_ghost_face(face));
        let mut corners: Vec<_> = real.map(|face| plane.face_vertices(face)).collect();
        corners
            .iter_mut()
            .for_each(|corners| corners.sort_unstable());
        let [a, b, c] = corners.into_iter().min()?;
        Some(format!(", that through {a}, {b} and {c}"))
    };
    let through = flat
        .plane
        .as_ref()
        .and_then(through_first)
        .unwrap_or_default();
    let hint = if is_planar && flat.plane.is_some() {
        "; --dim 2 triangulates the plane"
    } else {
        ""
    };
    format!("{what}{through}, and span no tetrahedron{hint}")
}
