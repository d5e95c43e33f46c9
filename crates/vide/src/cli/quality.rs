//! `vide quality`: the measures of a mesh file.

use std::path::PathBuf;

use clap::Args;
use vide::mesh_io::read_mesh;
use vide::quality::{Measured, measure_mesh};

use super::Common;
use super::failure::Failure;
use super::output::{check_places, write_together};
use super::progress::Watch;
use super::report::Report;

#[derive(Args)]
pub(crate) struct QualityArgs {
    /// A mesh of triangles, quads or tetrahedra, by extension: .vtu .vtk .msh .mesh .p3d .p3b .ele .off .ply .stl .obj
    #[arg(value_name = "MESH")]
    mesh: PathBuf,
    /// List this many of the worst cells of each measure
    #[arg(long, value_name = "K", default_value_t = 0)]
    worst: usize,
    #[command(flatten)]
    pub(super) common: Common,
}

pub(crate) fn run(args: &QualityArgs) -> Result<(), Failure> {
    check_places(&args.mesh, &[], &args.common.report)?;
    let mut watch = Watch::new(args.common.quiet);
    let mesh = watch.stage("read", |_| read_mesh(&args.mesh))?;
    let measured = watch.stage("measure", |_| measure_mesh(&mesh));
    if measured.is_empty() {
        return Err(Failure::input(
            &args.mesh,
            "no triangle, quad or tetrahedron to measure",
        ));
    }
    let mut report = Report {
        vertices: mesh.points.len(),
        elements: mesh.cells.kinds().len(),
        ..Report::default()
    };
    report.measure(&measured);
    let said = format!(
        "{} cells, {} vertices\n{}{}",
        report.elements,
        report.vertices,
        report.quality_table(),
        worst_cells(&measured, args.worst)
    );
    write_together(watch, report, args.common.report.as_deref(), |_| Ok(()))?;
    args.common.say(&said);
    Ok(())
}

/// A line per measure that lists its worst cells; nothing for none.
fn worst_cells(measured: &[Measured], count: usize) -> String {
    let line = |measure: &Measured| {
        let cells = measure.worst_cells(count);
        let listed: Vec<String> = cells
            .iter()
            .map(|(id, value)| format!("{id} ({value:.4})"))
            .collect();
        format!("worst {}: {}\n", measure.name, listed.join(", "))
    };
    measured.iter().filter(|_| count > 0).map(line).collect()
}
