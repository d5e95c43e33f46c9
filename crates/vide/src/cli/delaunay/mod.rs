//! `vide delaunay`: points in, triangles or tetrahedra out.

mod flat;
mod input;
mod plane;
mod space;

use std::path::PathBuf;

use clap::{Args, ValueEnum};
use vide::mesh_io::{Dimension, Format, Mesh, Polytopes, vtu};
use vide::quality::measure_mesh;

use super::Common;
use super::failure::Failure;
use super::output::{check_formats, check_places, write_together};
use super::progress::Watch;
use super::report::Report;

#[derive(Args)]
pub(crate) struct DelaunayArgs {
    /// Points, by extension: .xy .xyz .node .ply .2d.f64 .3d.f64, or those of a mesh: .off .stl .obj .vtu
    /// .msh
    #[arg(value_name = "POINTS")]
    points: PathBuf,
    /// Triangles or tetrahedra to write, by extension: .vtu .vtk .msh .mesh .ele, triangles also .off .ply
    /// .stl .obj; may be repeated
    #[arg(short, long, value_name = "OUT", required = true)]
    output: Vec<PathBuf>,
    /// Triangles of the plane or tetrahedra of space; else as the points say, those with z = 0
    /// everywhere being of the plane
    #[arg(long, value_enum, value_name = "2|3")]
    dim: Option<Dim>,
    /// Regular triangulation: every point has a weight, the square of a radius, in a further column, the
    /// first attribute of a .node, or what a .ply or .vtu calls weight
    #[arg(long)]
    weighted: bool,
    /// Voronoi cells to write, clipped to a box a tenth wider than the points all round
    #[arg(long, value_name = "FILE.vtu", conflicts_with = "weighted")]
    voronoi: Option<PathBuf>,
    #[command(flatten)]
    pub(super) common: Common,
}

#[derive(Clone, Copy, ValueEnum)]
enum Dim {
    #[value(name = "2")]
    Plane,
    #[value(name = "3")]
    Space,
}

impl From<Dim> for Dimension {
    fn from(dim: Dim) -> Self {
        match dim {
            Dim::Plane => Self::Plane,
            Dim::Space => Self::Space,
        }
    }
}

/// What came out, ready to be written.
struct Triangulated {
    mesh: Mesh,
    voronoi: Option<Polytopes>,
    report: Report,
}

const FORMATS: [Format; 10] = [
    Format::Vtu,
    Format::Vtk,
    Format::Msh,
    Format::Medit,
    Format::TriangleNode,
    Format::TriangleEle,
    // The others have no place for tetrahedra.
    Format::Off,
    Format::Ply,
    Format::Stl,
    Format::Obj,
];

/// What Voronoi cells are clipped to, in messages.
const WINDOW: &str = "the box round the points";

pub(crate) fn run(args: &DelaunayArgs) -> Result<(), Failure> {
    check_formats(&args.output, &FORMATS, "triangles or tetrahedra")?;
    check_formats(&args.voronoi, &[Format::Vtu], "Voronoi cells")?;
    let others = args.voronoi.iter().chain(&args.common.report);
    check_places(&args.points, &args.output, others)?;
    let mut watch = Watch::new(args.common.quiet);
    let points = watch.stage("read", |_| input::read(args))?;
    let Triangulated {
        mesh,
        voronoi,
        mut report,
    } = match input::dimension(args, &points) {
        Dimension::Plane => plane::triangulate(args, points, &mut watch)?,
        Dimension::Space => {
            check_formats(&args.output, &FORMATS[..6], "tetrahedra")?;
            space::tetrahedralize(args, points, &mut watch)?
        }
    };
    // To measure takes as long as to triangulate.
    if args.common.report.is_some() {
        watch.stage("measure", |_| report.measure(&measure_mesh(&mesh)));
    }
    let said = format!("{}\n{}", summary(&report), report.quality_table());
    write_together(watch, report, args.common.report.as_deref(), |outputs| {
        let mut paths = args.output.iter();
        paths.try_for_each(|path| outputs.mesh(path, &mesh))?;
        let mut cells = args.voronoi.iter().zip(&voronoi);
        cells.try_for_each(|(path, cells)| {
            outputs.file(path, |out| vtu::write_polytopes(out, cells))
        })
    })?;
    args.common.say(&said);
    Ok(())
}

fn summary(report: &Report) -> String {
    let cells = match report.dimension {
        Some(3) => "tetrahedra",
        _ => "triangles",
    };
    let count = |count: Option<usize>| count.unwrap_or_default();
    let hidden = match report.hidden {
        Some(hidden) => format!(", {hidden} hidden"),
        None => String::new(),
    };
    format!(
        "{} {cells}, {} vertices, {} on the hull, {} duplicates{hidden}",
        report.elements,
        report.vertices,
        count(report.hull_vertices),
        count(report.duplicates)
    )
}
