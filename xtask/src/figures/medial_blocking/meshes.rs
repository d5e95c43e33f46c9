//! Figures 12, 13 and 14: the meshes of the paper's three data sets, and their angles beside the paper's.

use delaunay_core::measure::AngleSummary;
use fixtures::circles;
use medial_blocking::{
    BlockMesh, Blocking, BlockingError, CellCounts, Domain, NodeMatching, Params,
};
use vide::picture::{CellQuality, block_panel, keyed, quality_panel};

use super::super::table::Table;
use super::super::{Render, Rendered};
use mesh_io::svg::Picture;
use vide::convert::domain_of;

/// Cells along each side of a block in the picture. The paper gives no number.
const CELLS: u32 = 8;

/// The meshes in the table. The means depend on the number of cells, which the paper does not give, so there are two.
const MESHES: [(u32, NodeMatching); 4] = [
    (8, NodeMatching::EqualSpacing),
    (16, NodeMatching::EqualSpacing),
    (8, NodeMatching::EmptyCircle),
    (16, NodeMatching::EmptyCircle),
];

const HEADINGS: [&str; 6] = [
    "",
    "paper",
    "equal spacing, 8x8 cells a block",
    "16x16",
    "empty-circle matching, 8x8",
    "16x16",
];

/// What the paper says about a mesh (§5).
struct Printed {
    title: &'static str,
    blocks: usize,
    /// Smallest and largest angle, mean smallest and mean largest angle, in whole degrees.
    angles: [f64; 4],
}

/// Figure 12.
pub(super) fn hexagon() -> Render {
    let printed = Printed {
        title: "Hexagon",
        blocks: 36,
        angles: [46.0, 130.0, 75.0, 104.0],
    };
    figure(&domain_of(&circles::hexagon())?, &printed)
}

/// Figure 13.
pub(super) fn bubble() -> Render {
    let printed = Printed {
        title: "Bubble",
        blocks: 120,
        angles: [31.0, 148.0, 65.0, 112.0],
    };
    figure(&domain_of(&circles::bubble())?, &printed)
}

/// Figure 14.
pub(super) fn lattice() -> Render {
    let printed = Printed {
        title: "Lattice",
        blocks: 120,
        angles: [39.0, 138.0, 73.0, 106.0],
    };
    figure(&domain_of(&circles::lattice())?, &printed)
}

fn figure(domain: &Domain, printed: &Printed) -> Render {
    let blocking = Blocking::of(domain)?;
    let drawn = meshed(&blocking, CELLS, NodeMatching::EqualSpacing)?;
    let mut columns = Vec::new();
    for (cells, matching) in MESHES {
        columns.push(Column::of(&meshed(&blocking, cells, matching)?));
    }
    Ok(Rendered {
        svg: picture(&drawn, printed.title).to_svg()?,
        summary: summary(printed, &blocking, &columns),
    })
}

fn meshed(
    blocking: &Blocking,
    cells: u32,
    matching: NodeMatching,
) -> Result<BlockMesh, BlockingError> {
    let cells = CellCounts::PerBlock(cells);
    BlockMesh::of(blocking.clone(), &Params { cells, matching })
}

fn picture(mesh: &BlockMesh, title: &str) -> Picture {
    let (blocks, cells) = (mesh.blocking().blocks().len(), mesh.cell_count());
    keyed(
        Picture::new(title)
            .panel(block_panel(mesh).caption(&format!("{blocks} blocks")))
            .panel(
                quality_panel(mesh, CellQuality::SmallestAngle)
                    .caption(&format!("{cells} cells by their smallest angle")),
            ),
    )
}

/// One of the four angles of a summary.
type Angle = fn(&AngleSummary) -> f64;

/// The figures of one mesh.
struct Column {
    leaning: usize,
    angles: Option<AngleSummary>,
}

impl Column {
    fn of(mesh: &BlockMesh) -> Self {
        Self {
            leaning: mesh.leaning_arcs().len(),
            angles: AngleSummary::of_quads(mesh.cells()),
        }
    }

    fn degrees(&self, of: Angle) -> String {
        let degrees = |summary| format!("{:.1}°", of(summary));
        self.angles.as_ref().map_or_else(|| "-".to_owned(), degrees)
    }
}

fn summary(printed: &Printed, blocking: &Blocking, columns: &[Column]) -> String {
    let row = |what: &str, paper: String, ours: &dyn Fn(&Column) -> String| {
        let cells = [what.to_owned(), paper].into_iter();
        cells.chain(columns.iter().map(ours)).collect::<Vec<_>>()
    };
    let count = |what: &str, number: usize| row(what, "-".to_owned(), &|_| number.to_string());
    let thin = blocking.thin_arcs(0.2).count();
    let blocks = blocking.blocks().len();
    let table = Table::new(printed.title, HEADINGS)
        .row(row("blocks", printed.blocks.to_string(), &|_| {
            blocks.to_string()
        }))
        .row(count("medial vertices", blocking.vertices().len()))
        .row(count("medial arcs", blocking.arcs().len()))
        .row(count("thin arcs (below 0.2 of the clearance)", thin))
        .row(row(
            "arcs whose nodes lean, lest cells fold",
            "-".to_owned(),
            &|column| column.leaning.to_string(),
        ));
    let angles: [(&str, Angle); 4] = [
        ("smallest angle", |summary| summary.min),
        ("largest angle", |summary| summary.max),
        ("mean smallest angle", |summary| summary.mean_smallest),
        ("mean largest angle", |summary| summary.mean_largest),
    ];
    let rows = angles.into_iter().zip(printed.angles);
    rows.fold(table, |table, ((name, of), paper)| {
        table.row(row(name, format!("{paper:.0}°"), &|column| {
            column.degrees(of)
        }))
    })
    .to_string()
}
