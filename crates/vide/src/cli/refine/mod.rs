//! `vide refine`: a mesh or a boundary in, a better mesh out.

mod improve;
mod method;
mod plane;
mod report;
mod size;
mod solid;

use std::path::{Path, PathBuf};

use clap::Args;
use vide::mesh_io::{Format, Mesh, companion};
use vide::quality::measure_mesh;
use vide::sink_refine::{Method, Params};

use super::Common;
use super::failure::Failure;
use super::number;
use super::outline::{Given, read_given};
use super::output::{check_formats, check_places, write_marked, write_together};
use super::progress::Watch;
use super::report::Report;

pub(crate) use improve::Improvement;
pub(crate) use report::Refinement;

#[derive(Args)]
pub(crate) struct RefineArgs {
    /// A closed surface of triangles: .off .ply .stl .obj .vtu .msh; or tetrahedra, whose boundary and vertices are kept:
    /// .vtu .msh .ele .node; or a closed outline in the plane: .poly .geojson .json .svg, polygons of an .off, or triangles at z = 0,
    /// whose outline is kept
    #[arg(value_name = "INPUT")]
    input: PathBuf,
    /// Tetrahedra or triangles to write, by extension: .vtu .vtk .msh .mesh .ele .node; may be repeated
    #[arg(short, long, value_name = "OUT", required = true)]
    output: Vec<PathBuf>,
    /// Elements whose circumradius is more than R times their shortest edge are of low quality; at least 1 [default: 2; in
    /// the plane 1]
    #[arg(long, value_name = "R")]
    ratio: Option<f64>,
    /// Elements whose circumradius is more than that of the regular one with edges of length H are too large and refined too; the
    /// number of elements grows as 1/H³, in the plane as 1/H². Areas that limit regions of a .poly are obeyed as well
    #[arg(long, value_name = "H", value_parser = number::positive)]
    size: Option<f64>,
    /// Which points to insert
    #[arg(long, value_enum, default_value_t = method::Candidate::Economical)]
    candidate: method::Candidate,
    /// In which order to insert sinks or circumcenters [default: incremental]
    #[arg(long, value_enum)]
    schedule: Option<method::Schedule>,
    /// What happens to inserted vertices that are not needed, of the economical method [default: removal]
    #[arg(long, value_enum)]
    coarsen: Option<method::Coarsen>,
    /// What may happen to the boundary
    #[arg(long, value_enum, default_value_t = method::AtBoundary::Keep)]
    boundary: method::AtBoundary,
    /// With --boundary split: where the boundary turns by up to DEG degrees it is smooth, and new vertices are put on a smooth
    /// curve or surface; elsewhere it has corners and creases, which stay [default: 30; in the plane 0: on the edges]
    #[arg(long, value_name = "DEG", value_parser = number::crease)]
    crease: Option<f64>,
    /// Afterwards make tetrahedra better whose smallest dihedral angle is below DEG degrees, or the largest above 180 - DEG, by
    /// exchanges, moves and new vertices inside: 20 is quick, 30 thorough. They need not be Delaunay then, and some may be above
    /// the ratio or the size
    #[arg(long, value_name = "DEG", value_parser = improve::parse)]
    min_dihedral: Option<f64>,
    /// Most vertices to add to those given
    #[arg(long, value_name = "N", default_value_t = usize::MAX, hide_default_value = true)]
    max_vertices: usize,
    #[command(flatten)]
    pub(super) common: Common,
}

/// What came out, ready to be written.
struct Refined {
    mesh: Mesh,
    /// The mesh with the marked edges of its boundary, where there are any.
    with_edges: Option<Mesh>,
    report: Report,
}

const FORMATS: [Format; 6] = [
    Format::Vtu,
    Format::Vtk,
    Format::Msh,
    Format::Medit,
    Format::TriangleNode,
    Format::TriangleEle,
];

/// Refines what the arguments name by the `method` that they name.
pub(crate) fn run(args: &RefineArgs, method: Method) -> Result<(), Failure> {
    check_formats(&args.output, &FORMATS, "tetrahedra")?;
    for read in [&args.input].into_iter().chain(&companion(&args.input)) {
        check_places(read, &args.output, &args.common.report)?;
    }
    let mut watch = Watch::new(args.common.quiet);
    let given = watch.stage("read", |_| read_given(&cells_of(&args.input)))?;
    let params = |usual: f64, crease: f64| Params {
        ratio: args.ratio.unwrap_or(usual),
        method,
        boundary: args.boundary(crease),
        max_new_vertices: args.max_vertices,
    };
    let refined = match &given {
        Given::Outline(outline) => plane::refine(
            args,
            outline,
            &params(plane::RATIO, plane::CREASE),
            &mut watch,
        )?,
        Given::Mesh(mesh) => {
            solid::refine(args, mesh, &params(solid::RATIO, solid::CREASE), &mut watch)?
        }
    };
    let Refined {
        mesh,
        with_edges,
        mut report,
    } = refined;
    watch.stage("measure", |_| report.measure(&measure_mesh(&mesh)));
    let said = format!("{}{}", report::summary(&report), report.quality_table());
    write_together(watch, report, args.common.report.as_deref(), |outputs| {
        let mut paths = args.output.iter();
        paths.try_for_each(|path| write_marked(outputs, path, &mesh, with_edges.as_ref()))
    })?;
    args.common.say(&said);
    Ok(())
}

/// The file with the cells: of the points in a `.node` they are in the `.ele` beside it.
fn cells_of(input: &Path) -> PathBuf {
    match Format::from_path(input) {
        Some(Format::TriangleNode) => input.with_extension("ele"),
        _ => input.to_owned(),
    }
}
