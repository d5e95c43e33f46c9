//! Figures 12, 13 and 14: the meshes of the paper's three data sets, and their angles beside the paper's.

use delaunay_core::measure::quad::corner_angles;
use fixtures::circles;
use medial_blocking::{BlockMesh, Blocking, CellCounts, Domain, NodeMatching, Params};
use vide::picture::{CellQuality, block_panel, keyed, quality_panel};

use super::super::table::Table;
use super::super::{Render, Rendered};
use mesh_io::svg::Picture;
use vide::convert::domain_of;

/// Cells along each side of a block. The paper gives no number.
const CELLS: u32 = 8;

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
    let mesh = |matching| {
        BlockMesh::of(
            blocking.clone(),
            &Params {
                cells: CellCounts::PerBlock(CELLS),
                matching,
            },
        )
    };
    let (equal, matched) = (
        mesh(NodeMatching::EqualSpacing)?,
        mesh(NodeMatching::EmptyCircle)?,
    );
    Ok(Rendered {
        svg: picture(&equal, printed.title).to_svg()?,
        summary: summary(printed, &equal, &matched),
    })
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

fn summary(printed: &Printed, equal: &BlockMesh, matched: &BlockMesh) -> String {
    let blocking = equal.blocking();
    let count = |what: &str, number: usize| {
        [
            what.to_owned(),
            "-".to_owned(),
            number.to_string(),
            number.to_string(),
        ]
    };
    let mut table = Table::new(
        printed.title,
        ["", "paper", "equal spacing", "empty-circle matching"],
    )
    .row([
        "blocks".to_owned(),
        printed.blocks.to_string(),
        blocking.blocks().len().to_string(),
        matched.blocking().blocks().len().to_string(),
    ])
    .row(count("medial vertices", blocking.vertices().len()))
    .row(count("medial arcs", blocking.arcs().len()))
    .row(count(
        "thin arcs (below 0.2 of the clearance)",
        blocking.thin_arcs(0.2).count(),
    ))
    .row(count("cells per block", (CELLS * CELLS) as usize))
    .row([
        "arcs whose wall nodes lean, lest cells fold".to_owned(),
        "-".to_owned(),
        equal.leaning_arcs().len().to_string(),
        matched.leaning_arcs().len().to_string(),
    ]);
    let (equal, matched) = (angles(equal), angles(matched));
    let names = [
        "smallest angle",
        "largest angle",
        "mean smallest angle",
        "mean largest angle",
    ];
    for (k, name) in names.into_iter().enumerate() {
        table = table.row([
            name.to_owned(),
            format!("{:.0}°", printed.angles[k]),
            format!("{:.1}°", equal[k]),
            format!("{:.1}°", matched[k]),
        ]);
    }
    table.to_string()
}

/// Smallest and largest corner angle, mean of the cells' smallest and of their largest angles, in degrees.
fn angles(mesh: &BlockMesh) -> [f64; 4] {
    let mut angles = [f64::INFINITY, f64::NEG_INFINITY, 0.0, 0.0];
    for cell in mesh.cells() {
        let corners = corner_angles(cell);
        let smallest = corners.into_iter().fold(f64::INFINITY, f64::min);
        let largest = corners.into_iter().fold(f64::NEG_INFINITY, f64::max);
        angles = [
            angles[0].min(smallest),
            angles[1].max(largest),
            angles[2] + smallest,
            angles[3] + largest,
        ];
    }
    let cells = mesh.cell_count() as f64;
    [angles[0], angles[1], angles[2] / cells, angles[3] / cells]
}
