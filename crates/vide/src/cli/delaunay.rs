//! `vide delaunay`: points in, triangles out.

use std::path::PathBuf;

use clap::Args;
use vide::convert::{planar_points, triangle_mesh};
use vide::delaunay_core::Delaunay2;
use vide::mesh_io::{Format, Mesh, read_points, write_mesh};
use vide::quality::measure_mesh;

use super::Common;
use super::failure::Failure;
use super::output::{check_formats, check_places};
use super::progress::Watch;
use super::report::Report;

#[derive(Args)]
pub(crate) struct DelaunayArgs {
    /// Points of the plane: .xy .xyz .node, or the points of any mesh
    #[arg(value_name = "POINTS")]
    points: PathBuf,
    /// Triangles to write, by extension: .vtu .msh .ele .off; may be repeated
    #[arg(short, long, value_name = "OUT", required = true)]
    output: Vec<PathBuf>,
    #[command(flatten)]
    pub(super) common: Common,
}

const FORMATS: [Format; 5] = [
    Format::Vtu,
    Format::Msh,
    Format::TriangleNode,
    Format::TriangleEle,
    Format::Off,
];

pub(crate) fn run(args: &DelaunayArgs) -> Result<(), Failure> {
    check_formats(&args.output, &FORMATS, "triangles")?;
    check_places(&args.points, args.output.iter().chain(&args.common.report))?;
    let failed = |error: &dyn std::fmt::Display| Failure::input(&args.points, error);
    let mut watch = Watch::new(args.common.quiet);
    let points = watch.stage("read", |_| read_points(&args.points))?;
    let points = planar_points(&points).map_err(|error| failed(&error))?;
    let delaunay = watch
        .stage("triangulate", |watch| {
            Delaunay2::build_with(&points, &mut |progress| watch.report(progress))
        })
        .map_err(|error| failed(&error))?;
    let mesh = triangle_mesh(&delaunay);
    let mut report = watch.stage("measure", |_| report_of(&delaunay, &mesh));
    watch.stage("write", |_| {
        args.output
            .iter()
            .try_for_each(|path| write_mesh(path, &mesh))
    })?;
    report.seconds = watch.finish().into_iter().collect();
    let duplicates = report.duplicates.unwrap_or_default();
    args.common.say(&format!(
        "{} triangles, {} vertices, {duplicates} duplicates\n{}",
        report.elements,
        report.vertices,
        report.quality_table()
    ));
    report.write(args.common.report.as_deref())
}

fn report_of(delaunay: &Delaunay2, mesh: &Mesh) -> Report {
    let mut report = Report {
        vertices: delaunay.vertex_count(),
        elements: mesh.cells.kinds().len(),
        duplicates: Some(delaunay.duplicates().len()),
        ..Report::default()
    };
    report.measure(&measure_mesh(mesh));
    report
}
