//! `vide block`: circles in, blocks out.

use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use std::io::Write;
use vide::convert::{domain_of, structured_blocks};
use vide::medial_blocking::{
    BlockMesh, Blocking, BlockingError, COLLAPSED, CellCounts, Domain, MAX_CELLS, NodeMatching,
    Params,
};
use vide::mesh_io::{Format, read_circles};
use vide::picture::block_picture;
use vide::quality::measure_quads;

use super::Common;
use super::failure::Failure;
use super::output::{check_formats, check_places, write_together};
use super::progress::Watch;
use super::report::Report;

#[derive(Args)]
pub(crate) struct BlockArgs {
    /// Circles in a bounding circle or in a periodic rectangle
    #[arg(value_name = "DOMAIN.toml")]
    domain: PathBuf,
    /// Mesh to write, by extension: .vtu .vtk .msh .mesh .p3d .p3b .off .ply .obj, or a file called
    /// blockMeshDict; may be repeated
    #[arg(short, long, value_name = "OUT")]
    output: Vec<PathBuf>,
    /// Cells along and across every block
    #[arg(long, value_name = "N", conflicts_with = "size", default_value_t = 16)]
    cells: u64,
    /// Longest edge of a cell along the curves of the blocks, instead of a number of cells
    #[arg(long, value_name = "H")]
    size: Option<f64>,
    /// How nodes of medial arcs and walls are matched
    #[arg(long, value_enum, default_value_t = Matching::Equal)]
    matching: Matching,
    /// Picture to write
    #[arg(long, value_name = "FILE.svg")]
    svg: Option<PathBuf>,
    #[command(flatten)]
    pub(super) common: Common,
}

#[derive(Clone, Copy, ValueEnum)]
enum Matching {
    /// Equal spacing along arc and wall, as in the paper
    Equal,
    /// Each node of the arc with the point where its empty circle touches the wall
    Circle,
}

const FORMATS: [Format; 10] = [
    Format::Vtu,
    Format::Vtk,
    Format::Msh,
    Format::Medit,
    Format::Plot3dAscii,
    Format::Plot3dBinary,
    Format::Off,
    Format::Ply,
    Format::Obj,
    Format::BlockMeshDict,
];

pub(crate) fn run(args: &BlockArgs) -> Result<(), Failure> {
    check_formats(&args.output, &FORMATS, "structured blocks")?;
    let others = args.svg.iter().chain(&args.common.report);
    check_places(&args.domain, &args.output, others)?;
    let mut watch = Watch::new(args.common.quiet);
    let domain = watch.stage("read", |_| read_domain(args))?;
    let mesh = blocked(args, &domain, &mut watch)?;
    let blocks = structured_blocks(&mesh);
    let merged = blocks
        .to_mesh()
        .map_err(|defect| Failure::input(&args.domain, defect))?;
    let report = watch.stage("measure", |_| report_of(&mesh, merged.points.len()));
    let said = summary(&report);
    let picture = picture(args, &mesh)?;
    write_together(watch, report, args.common.report.as_deref(), |outputs| {
        for path in &args.output {
            match Format::from_path(path) {
                Some(format) if format.holds_blocks() => outputs.blocks(path, &blocks)?,
                _ => outputs.mesh(path, &merged)?,
            }
        }
        picture.map_or(Ok(()), |(path, svg)| {
            outputs.file(path, |out| Ok(out.write_all(svg.as_bytes())?))
        })
    })?;
    args.common.say(&said);
    Ok(())
}

fn read_domain(args: &BlockArgs) -> Result<Domain, Failure> {
    let circles = read_circles(&args.domain)?;
    domain_of(&circles).map_err(|error| Failure::domain(&args.domain, &circles, &error))
}

fn blocked(args: &BlockArgs, domain: &Domain, watch: &mut Watch) -> Result<BlockMesh, Failure> {
    let failed = |error: BlockingError| Failure::input(&args.domain, error);
    let blocking = watch
        .stage("block", |watch| {
            Blocking::of_with(domain, &mut |progress| watch.report(progress))
        })
        .map_err(failed)?;
    let params = params(args, blocking.blocks().len()).map_err(failed)?;
    watch
        .stage("mesh", |watch| {
            BlockMesh::of_with(blocking, &params, &mut |progress| watch.report(progress))
        })
        .map_err(failed)
}

fn params(args: &BlockArgs, blocks: usize) -> Result<Params, BlockingError> {
    let cells = match (args.size, u32::try_from(args.cells)) {
        (Some(size), _) => CellCounts::Size(size),
        (None, Ok(cells)) => CellCounts::PerBlock(cells),
        (None, Err(_)) => {
            let cells = blocks as f64 * (args.cells as f64).powi(2);
            return Err(BlockingError::TooManyCells {
                cells,
                limit: MAX_CELLS,
            });
        }
    };
    let matching = match args.matching {
        Matching::Equal => NodeMatching::EqualSpacing,
        Matching::Circle => NodeMatching::EmptyCircle,
    };
    Ok(Params { cells, matching })
}

/// The picture asked for, and where it is to lie.
fn picture<'a>(
    args: &'a BlockArgs,
    mesh: &BlockMesh,
) -> Result<Option<(&'a Path, String)>, Failure> {
    let Some(path) = &args.svg else {
        return Ok(None);
    };
    let title = args
        .domain
        .file_stem()
        .map(|stem| stem.to_string_lossy())
        .unwrap_or_default();
    let svg = block_picture(mesh, &title)
        .to_svg()
        .map_err(|error| Failure::input(&args.domain, error))?;
    Ok(Some((path, svg)))
}

fn report_of(mesh: &BlockMesh, vertices: usize) -> Report {
    let blocking = mesh.blocking();
    let mut report = Report {
        vertices,
        elements: mesh.cell_count(),
        blocks: Some(blocking.blocks().len()),
        medial_vertices: Some(blocking.vertices().len()),
        medial_arcs: Some(blocking.arcs().len()),
        collapsed_arcs: Some(blocking.thin_arcs(COLLAPSED).count()),
        leaning_arcs: Some(mesh.leaning_arcs().len()),
        ..Report::default()
    };
    report.measure(&measure_quads(mesh.cells()));
    report.angle = report.angle_of_quads();
    report
}

fn summary(report: &Report) -> String {
    let count = |count: Option<usize>| count.unwrap_or_default();
    let (blocks, vertices, arcs) = (
        count(report.blocks),
        count(report.medial_vertices),
        count(report.medial_arcs),
    );
    let mut text = format!(
        "{blocks} blocks, {vertices} medial vertices, {arcs} medial arcs, {} cells, {} vertices\n",
        report.elements, report.vertices
    );
    if let Some(collapsed @ 1..) = report.collapsed_arcs {
        text += &format!(
            "{collapsed} arcs between co-circular holes have no length; their blocks are empty\n"
        );
    }
    if let Some(leaning @ 1..) = report.leaning_arcs {
        text +=
            &format!("{leaning} arcs are not equally spaced, because a cell would have folded\n");
    }
    text + &report.quality_table()
}
