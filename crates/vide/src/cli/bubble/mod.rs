//! `vide bubble`: an outline in, a graded mesh of triangles out.

mod boundary;
mod report;

use std::io::Write;
use std::path::{Path, PathBuf};

use clap::Args;
use vide::bubble_mesh::graded::{GradedParams, Stop, mesh_sized};
use vide::bubble_mesh::paper;
use vide::convert::{region_mesh, triangles_mesh};
use vide::glam::DVec2;
use vide::mesh_io::{Format, Mesh, PlanarGraph};
use vide::picture::triangle_picture;
use vide::quality::measure_mesh;

use super::Common;
use super::failure::Failure;
use super::number;
use super::outline::{Given, read_given};
use super::output::{check_formats, check_places, write_marked, write_together};
use super::progress::Watch;
use super::report::Report;
use boundary::{AtBoundary, AtCrossings, Region, region};

pub(crate) use report::Bubbles;

#[derive(Args)]
pub(crate) struct BubbleArgs {
    /// A planar outline: .poly, with holes, regions side by side and loose segments as it has them; polygons of a .geojson or .json, a
    /// drawing in .svg, whose y points down and becomes -y, or faces of any number of corners of an .off; or another mesh at z = 0,
    /// whose outline is taken
    #[arg(value_name = "OUTLINE")]
    input: PathBuf,
    /// Triangles to write, by extension: .vtu .vtk .msh .mesh .off .ply .stl .obj .ele .node; may be repeated
    #[arg(short, long, value_name = "OUT", required = true)]
    output: Vec<PathBuf>,
    /// The method of the paper: nodes at centroids, then forces between bubbles
    #[arg(long, conflicts_with_all = ["size", "scale", "trials", "grade"])]
    paper: bool,
    /// How often bubbles move, with --paper
    #[arg(long, value_name = "N", requires = "paper")]
    iterations: Option<usize>,
    /// Edges inside are at most so long; otherwise the edges of the outline alone say how long
    #[arg(long, value_name = "H", value_parser = number::positive)]
    size: Option<f64>,
    /// Edges inside over those that the outline asks for; smaller values make more triangles
    #[arg(long, value_name = "S", value_parser = number::positive, default_value_t = GradedParams::default().scale)]
    scale: f64,
    /// Edges inside grow by at most G of the distance from the outline [default: 0.5]; with --boundary resample edges of the outline do as well
    /// [default: 0.2]
    #[arg(long, value_name = "G", value_parser = number::positive)]
    grade: Option<f64>,
    /// What happens to the nodes of the outline
    #[arg(long, value_enum, default_value_t = AtBoundary::Fixed)]
    boundary: AtBoundary,
    /// Nodes where the outline turns by more than DEG degrees are corners
    #[arg(long, value_name = "DEG", value_parser = number::crease, default_value_t = 30.0)]
    crease: f64,
    /// So many changes of connectivity are tried, the worst triangles first; a thousand for a thousand nodes make good meshes very
    /// good
    #[arg(long, value_name = "N", default_value_t = 0)]
    trials: usize,
    /// What to do with segments that cross
    #[arg(long, value_enum, default_value_t = AtCrossings::Refuse)]
    crossings: AtCrossings,
    /// Most nodes, those of the outline included
    #[arg(long, value_name = "N", default_value_t = 10_000_000)]
    max_nodes: usize,
    /// Picture to write: the triangles coloured by their radius ratio
    #[arg(long, value_name = "FILE.svg")]
    svg: Option<PathBuf>,
    #[command(flatten)]
    pub(super) common: Common,
}

const FORMATS: [Format; 10] = [
    Format::Vtu,
    Format::Vtk,
    Format::Msh,
    Format::Medit,
    Format::Off,
    Format::Ply,
    Format::Stl,
    Format::Obj,
    Format::TriangleNode,
    Format::TriangleEle,
];

/// What came out, ready to be written.
struct Meshed {
    mesh: Mesh,
    /// The mesh with the marked edges of its boundary, where there are any.
    with_edges: Option<Mesh>,
    stop: super::report::Stop,
}

/// Meshes what the arguments name.
pub(crate) fn run(args: &BubbleArgs) -> Result<(), Failure> {
    check_formats(&args.output, &FORMATS, "triangles")?;
    let others: Vec<&PathBuf> = args.svg.iter().chain(&args.common.report).collect();
    check_places(&args.input, &args.output, others)?;
    let mut watch = Watch::new(args.common.quiet);
    let outline = watch.stage("read", |_| read(&args.input))?;
    let region = watch.stage("triangulate", |watch| region(args, &outline, watch))?;
    let meshed = match args.paper {
        true => by_the_paper(args, &region, &mut watch)?,
        false => graded(args, &region, &mut watch)?,
    };
    let Meshed {
        mesh,
        with_edges,
        stop,
    } = meshed;
    let mut report = Report {
        dimension: Some(2),
        vertices: mesh.points.len(),
        elements: mesh.cells.len(),
        bubbles: Some(Bubbles::of(args.paper, &region.domain, &mesh)),
        stop,
        ..Report::default()
    };
    watch.stage("measure", |_| report.measure(&measure_mesh(&mesh)));
    let picture = args.svg.as_ref().map(|path| picture(args, path, &mesh));
    let picture = picture.transpose()?;
    let said = format!("{}{}", report::summary(&report), report.quality_table());
    write_together(watch, report, args.common.report.as_deref(), |outputs| {
        let mut paths = args.output.iter();
        paths.try_for_each(|path| write_marked(outputs, path, &mesh, with_edges.as_ref()))?;
        picture.map_or(Ok(()), |(path, svg)| {
            outputs.file(path, |out| Ok(out.write_all(svg.as_bytes())?))
        })
    })?;
    args.common.say(&said);
    Ok(())
}

/// The outline in a file. Of triangles that are given only the boundary counts; of a `.poly` all points do.
fn read(input: &Path) -> Result<PlanarGraph, Failure> {
    match read_given(input)? {
        Given::Outline(outline) if Format::from_path(input) == Some(Format::TrianglePoly) => {
            Ok(outline)
        }
        Given::Outline(outline) => Ok(outline.without_loose_points()),
        Given::Mesh(_) => Err(Failure::input(
            input,
            "there is no outline in the plane z = 0",
        )),
    }
}

fn graded(args: &BubbleArgs, region: &Region, watch: &mut Watch) -> Result<Meshed, Failure> {
    let Region { domain, marks } = region;
    let usual = GradedParams::default();
    let crease = args.crease.to_radians();
    let params = GradedParams {
        scale: args.scale,
        trials: args.trials,
        grade: args.grade.unwrap_or(usual.grade),
        sliding: (args.boundary == AtBoundary::Slide).then_some(crease),
        nodes: args.max_nodes,
        ..usual
    };
    let size = args.size.map(|size| move |_: DVec2| size);
    let sizing = size.as_ref().map(|size| size as _);
    let meshed = watch.stage("mesh", |watch| {
        mesh_sized(domain, &params, sizing, &mut |progress| {
            watch.report(progress)
        })
    });
    let meshed = meshed.map_err(|error| Failure::input(&args.input, error))?;
    let (mut mesh, faces) = triangles_mesh(&meshed.complex);
    Ok(Meshed {
        with_edges: marks.mark(&mut mesh, &faces, meshed.complex.mesh()),
        mesh,
        stop: stop(meshed.stop),
    })
}

fn stop(stop: Stop) -> super::report::Stop {
    match stop {
        Stop::Done => super::report::Stop::Finished,
        Stop::OutOfNodes => super::report::Stop::OutOfVertices,
        Stop::Cancelled => super::report::Stop::Cancelled,
    }
}

fn by_the_paper(args: &BubbleArgs, region: &Region, watch: &mut Watch) -> Result<Meshed, Failure> {
    let Region { domain, marks } = region;
    let usual = paper::Params::paper();
    let params = paper::Params {
        nodes: args.max_nodes,
        iterations: args.iterations.unwrap_or(usual.iterations),
        ..usual
    };
    let generated = watch.stage("generate", |watch| {
        paper::generate(domain, &params, &mut |progress| watch.report(progress))
    });
    let optimized = watch.stage("optimize", |watch| {
        paper::optimize(&generated, &params, &mut |progress| watch.report(progress))
    });
    let optimized = optimized.map_err(|error| Failure::input(&args.input, error))?;
    let stop = match generated.stop() {
        paper::Stop::Filled => super::report::Stop::Finished,
        paper::Stop::OutOfNodes => super::report::Stop::OutOfVertices,
        paper::Stop::OutOfRoom => super::report::Stop::NothingToInsert,
        paper::Stop::Cancelled => super::report::Stop::Cancelled,
    };
    let (mut mesh, faces) = region_mesh(&optimized.region);
    Ok(Meshed {
        with_edges: marks.mark(&mut mesh, &faces, optimized.region.mesh()),
        mesh,
        stop,
    })
}

fn picture<'a>(
    args: &BubbleArgs,
    path: &'a Path,
    mesh: &Mesh,
) -> Result<(&'a Path, String), Failure> {
    let title = args
        .input
        .file_name()
        .map_or_else(String::new, |name| name.to_string_lossy().into_owned());
    let svg = triangle_picture(mesh, &title).to_svg();
    Ok((
        path,
        svg.map_err(|error| Failure::input(&args.input, error))?,
    ))
}
