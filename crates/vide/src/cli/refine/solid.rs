//! Solids, given by surfaces or by tetrahedra.

use std::fmt::Display;

use vide::convert::solid_mesh;
use vide::delaunay_core::Subcomplex3;
use vide::glam::DVec3;
use vide::mesh_io::Mesh;
use vide::sink_refine::{Outcome3, Params, Sizing, refine3_sized};
use vide::solid::GivenSolid;

use super::improve;
use super::report::{Refinement, of_solid};
use super::{RefineArgs, Refined};
use crate::cli::Common;
use crate::cli::failure::Failure;
use crate::cli::progress::Watch;
use crate::cli::report::Report;

/// The usual ratio in space.
pub(super) const RATIO: f64 = 2.0;

/// Degrees by which usual triangulated surfaces turn at most where they stand for smooth ones.
pub(super) const CREASE: f64 = 30.0;

pub(super) fn refine(
    args: &RefineArgs,
    given: &Mesh,
    params: &Params,
    watch: &mut Watch,
) -> Result<Refined, Failure> {
    let solid = watch.stage("triangulate", |watch| tetrahedralize(args, given, watch))?;
    let before = [solid.vertex_count(), solid.tets().count()];
    let field = args.size.map(|size| move |_: DVec3| size);
    let sizing = Sizing {
        field: field.as_ref().map(|field| field as _),
        regions: &[],
    };
    let outcome = watch.stage("refine", |watch| {
        refine3_sized(solid, params, &sizing, &mut |progress| {
            watch.report(progress)
        })
    });
    let outcome = outcome.map_err(|error| failed(args, error))?;
    let refined = watch.stage("sort", |_| refined(args, params, before, &outcome));
    match args.min_dihedral {
        None => Ok(refined),
        Some(angle) => improved(args, angle, &outcome, refined, watch),
    }
}

fn tetrahedralize(
    args: &RefineArgs,
    given: &Mesh,
    watch: &mut Watch,
) -> Result<Subcomplex3, Failure> {
    let given = GivenSolid::of(given).map_err(|error| failed(args, error))?;
    let mut report = |progress| watch.report(progress);
    let solid = given.tetrahedralize(Common::build_options(), &mut report);
    solid.map_err(|error| failed(args, error))
}

fn refined(args: &RefineArgs, params: &Params, before: [usize; 2], outcome: &Outcome3) -> Refined {
    let (mesh, tets) = solid_mesh(&outcome.solid);
    let report = Report {
        dimension: Some(3),
        vertices: mesh.points.len(),
        elements: mesh.cells.len(),
        refinement: Some(of_solid(params, args.size, before, outcome, &tets)),
        stop: outcome.stop.into(),
        ..Report::default()
    };
    Refined {
        mesh,
        with_edges: None,
        report,
    }
}

/// The mesh refined, without slivers; its report keeps what refinement did.
fn improved(
    args: &RefineArgs,
    angle: f64,
    outcome: &Outcome3,
    refined: Refined,
    watch: &mut Watch,
) -> Result<Refined, Failure> {
    let improved = improve::run(&outcome.solid, angle, watch);
    let (mesh, improvement) = improved.map_err(|error| failed(args, error))?;
    let report = Report {
        vertices: mesh.points.len(),
        elements: mesh.cells.len(),
        refinement: refined.report.refinement.map(Refinement::without_elements),
        improvement: Some(improvement),
        ..refined.report
    };
    Ok(Refined {
        mesh,
        with_edges: None,
        report,
    })
}

fn failed(args: &RefineArgs, problem: impl Display) -> Failure {
    Failure::input(&args.input, problem)
}
