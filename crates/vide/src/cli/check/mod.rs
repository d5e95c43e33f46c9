//! `vide check`: whether a surface bounds bodies or separates regions, and all that is wrong with it.

mod report;

use std::path::PathBuf;

use clap::Args;
use vide::delaunay_core::{Domain3, Domain3Options, DomainError};
use vide::mesh_io::read_mesh;
use vide::triangles::Triangles;

use super::Common;
use super::failure::Failure;
use super::output::{check_places, write_together};
use super::progress::Watch;
use super::report::Report;

pub(crate) use report::Check;

#[derive(Args)]
pub(crate) struct CheckArgs {
    /// A surface of triangles, by extension: .off .ply .stl .obj .vtu .msh; corners in an .stl are joined by place when read
    #[arg(value_name = "SURFACE")]
    surface: PathBuf,
    /// Take points at exactly the same place for one
    #[arg(long)]
    weld: bool,
    /// Leave out points that are no corners
    #[arg(long)]
    drop_unused: bool,
    /// The triangles separate regions, so that any number of them from two on may meet at an edge; otherwise they bound bodies
    #[arg(long)]
    interfaces: bool,
    /// With --interfaces: the surface may end within a region
    #[arg(long, requires = "interfaces")]
    dangling: bool,
    /// Most pairs of triangles that intersect to list
    #[arg(long, value_name = "N", default_value_t = Domain3Options::default().most_intersections)]
    most_intersections: usize,
    #[command(flatten)]
    pub(super) common: Common,
}

impl CheckArgs {
    fn options(&self) -> Domain3Options {
        Domain3Options {
            weld: self.weld,
            drop_unused: self.drop_unused,
            interfaces: self.interfaces,
            dangling: self.dangling,
            most_intersections: self.most_intersections,
        }
    }
}

pub(crate) fn run(args: &CheckArgs) -> Result<(), Failure> {
    check_places(&args.surface, &[], &args.common.report)?;
    let mut watch = Watch::new(args.common.quiet);
    let mesh = watch.stage("read", |_| read_mesh(&args.surface))?;
    let failed = |problem: &dyn std::fmt::Display| Failure::input(&args.surface, problem);
    let given = Triangles::of(&mesh).map_err(|error| failed(&error))?;
    let mut report = Report {
        vertices: given.points.len(),
        elements: given.triangles.len(),
        ..Report::default()
    };
    let judged = watch.stage("check", |watch| {
        let mut hear = |progress| watch.report(progress);
        Domain3::build(&given.points, &given.triangles, args.options(), &mut hear)
    });
    let (check, said, problem) = match judged {
        Ok((domain, repairs)) => {
            let check = Check::of(&domain, &repairs);
            let said = check.words();
            (check, said, None)
        }
        Err(DomainError::Defects(defects)) => {
            let problem = format!("not valid: {}", report::summaries(&defects));
            (
                Check::failed(&defects),
                report::listed(&defects),
                Some(problem),
            )
        }
        Err(error) => return Err(failed(&error)),
    };
    report.check = Some(check);
    let counts = format!(
        "{} triangles, {} vertices\n",
        report.elements, report.vertices
    );
    write_together(watch, report, args.common.report.as_deref(), |_| Ok(()))?;
    args.common.say(&(counts + &said));
    match problem {
        Some(problem) => Err(failed(&problem)),
        None => Ok(()),
    }
}
