//! Regions of the plane, given by outlines or by triangles.

use std::fmt::Display;

use vide::convert::region_mesh;
use vide::delaunay_core::{Crossings, Subcomplex2};
use vide::glam::DVec2;
use vide::marks::Marks;
use vide::mesh_io::PlanarGraph;
use vide::plane::GivenRegion;
use vide::sink_refine::{Outcome2, Params, Sizing, refine2_sized};

use super::report::of_region;
use super::{RefineArgs, Refined, size};
use crate::cli::Common;
use crate::cli::failure::Failure;
use crate::cli::progress::Watch;
use crate::cli::report::Report;

/// The ratio that means angles of 30 degrees at least.
pub(super) const RATIO: f64 = 1.0;

/// All vertices of an outline are corners.
pub(super) const CREASE: f64 = 0.0;

pub(super) fn refine(
    args: &RefineArgs,
    outline: &PlanarGraph,
    params: &Params,
    watch: &mut Watch,
) -> Result<Refined, Failure> {
    if args.min_dihedral.is_some() {
        return Err(failed(
            args,
            "triangles have no dihedral angles: --min-dihedral is for solids",
        ));
    }
    let (region, marks) = watch.stage("triangulate", |watch| triangulate(args, outline, watch))?;
    let before = [region.vertex_count(), region.faces().count()];
    let limits = size::of_regions(outline);
    let field = args.size.map(|size| move |_: DVec2| size);
    let sizing = Sizing {
        field: field.as_ref().map(|field| field as _),
        regions: &limits,
    };
    let outcome = watch.stage("refine", |watch| {
        refine2_sized(region, params, &sizing, &mut |progress| {
            watch.report(progress)
        })
    });
    let outcome = outcome.map_err(|error| failed(args, error))?;
    Ok(watch.stage("sort", |_| refined(args, params, before, &outcome, &marks)))
}

fn triangulate(
    args: &RefineArgs,
    outline: &PlanarGraph,
    watch: &mut Watch,
) -> Result<(Subcomplex2, Marks), Failure> {
    let mut report = |progress| watch.report(progress);
    let options = Common::build_options();
    let region = GivenRegion::of(outline, Crossings::Refuse, options, &mut report);
    let region = region.map_err(|error| failed(args, error))?;
    let marks = Marks::of(outline, &region);
    let marks = marks.map_err(|error| failed(args, error))?;
    Ok((region.subcomplex(), marks))
}

fn refined(
    args: &RefineArgs,
    params: &Params,
    before: [usize; 2],
    outcome: &Outcome2,
    marks: &Marks,
) -> Refined {
    let (mut mesh, faces) = region_mesh(&outcome.region);
    let with_edges = marks.mark(&mut mesh, &faces, outcome.region.mesh());
    let report = Report {
        dimension: Some(2),
        vertices: mesh.points.len(),
        elements: mesh.cells.len(),
        refinement: Some(of_region(params, args.size, before, outcome, &faces)),
        stop: outcome.stop.into(),
        ..Report::default()
    };
    Refined {
        mesh,
        with_edges,
        report,
    }
}

fn failed(args: &RefineArgs, problem: impl Display) -> Failure {
    Failure::input(&args.input, problem)
}
