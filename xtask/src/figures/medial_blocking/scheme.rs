//! Figures 6 and 8: one block, the whole blocking scheme, and the mesh in its blocks.

use glam::DVec2;
use medial_blocking::{BlockId, BlockMesh, BlockSide, Blocking, CellCounts, Params};
use mesh_io::svg::{Anchor, Color, Panel, Picture, Sample, Stroke, Style};
use vide::picture::{block_panel, draw_scheme, keyed};

use super::super::table::Table;
use super::super::{Render, Rendered};
use super::ink::{AXIS, DOTTED, WALL, domain_panel};
use super::small::three_particles;

/// The wall of the block.
const XI1: Stroke = Stroke {
    color: Color::OCHRE,
    width: 2.4,
    dotted: false,
};

/// Steps into which curves are cut.
const STEPS: u32 = 24;

/// Figure 6.
pub(super) fn blocks() -> Render {
    let blocking = three_particles()?;
    let mesh = mesh_of(&blocking, STEPS)?;

    let mut left = domain_panel(&blocking).caption("a block");
    if let Some(block) = widest_block_of_a_particle(&blocking) {
        draw_block(&mut left, &blocking, block);
    }
    let mut right = domain_panel(&blocking).caption("the whole blocking scheme");
    draw_scheme(&mut right, &mesh);

    let picture = Picture::new("Blocks")
        .panel(left)
        .panel(right)
        .key("ξ0: medial arc", Sample::Line(AXIS))
        .key("ξ1: wall", Sample::Line(XI1))
        .key("η0, η1: straight", Sample::Line(DOTTED));
    Ok(Rendered {
        svg: picture.to_svg()?,
        summary: summary(&blocking),
    })
}

/// Figure 8.
pub(super) fn mesh() -> Render {
    let mesh = mesh_of(&three_particles()?, 16)?;
    let cells = mesh.cell_count();
    let picture =
        keyed(Picture::new("Multiblock structured mesh").panel(block_panel(&mesh).width(520.0)));
    let folded = mesh
        .cells()
        .filter(|&cell| vide::picture::CellQuality::ScaledJacobian.of(cell) <= 0.0)
        .count();
    let summary = Table::new("Mesh of three particles", ["", "paper", "ours"])
        .row(["cells", "-", &cells.to_string()])
        .row(["folded cells", "0", &folded.to_string()])
        .to_string();
    Ok(Rendered {
        svg: picture.to_svg()?,
        summary,
    })
}

fn mesh_of(blocking: &Blocking, cells: u32) -> Result<BlockMesh, Box<dyn std::error::Error>> {
    let params = Params {
        cells: CellCounts::PerBlock(cells),
        ..Params::default()
    };
    Ok(BlockMesh::of(blocking.clone(), &params)?)
}

/// The block that turns furthest round its particle.
fn widest_block_of_a_particle(blocking: &Blocking) -> Option<BlockId> {
    // Blocks on particles sweep clockwise, blocks on the bounding circle counterclockwise.
    blocking
        .block_ids()
        .min_by(|&a, &b| blocking.wall_sweep(a).total_cmp(&blocking.wall_sweep(b)))
}

fn draw_block(panel: &mut Panel, blocking: &Blocking, id: BlockId) {
    let curve =
        |side| (0..=STEPS).map(move |k| blocking.curve(id, side, f64::from(k) / f64::from(STEPS)));
    let outline = curve(BlockSide::Xi0).chain(curve(BlockSide::Eta1));
    let outline = outline
        .chain(curve(BlockSide::Xi1).rev())
        .chain(curve(BlockSide::Eta0).rev());
    panel
        .layer("block", Style::area(Color::SKY))
        .polygon(outline);
    for (name, stroke, sides) in [
        (
            "eta curves",
            DOTTED,
            &[BlockSide::Eta0, BlockSide::Eta1][..],
        ),
        ("wall", XI1, &[BlockSide::Xi1]),
        ("medial arc", AXIS, &[BlockSide::Xi0]),
    ] {
        panel
            .layer(name, Style::line(stroke))
            .polylines(sides.iter().map(|&side| curve(side)));
    }
    let inside = blocking
        .curve(id, BlockSide::Xi0, 0.5)
        .midpoint(blocking.curve(id, BlockSide::Xi1, 0.5));
    let names = [
        (BlockSide::Xi0, "ξ0"),
        (BlockSide::Xi1, "ξ1"),
        (BlockSide::Eta0, "η0"),
        (BlockSide::Eta1, "η1"),
    ];
    let layer = panel.layer(
        "names",
        Style::area(WALL.stroke.map_or(Color::INK, |stroke| stroke.color)),
    );
    for (side, name) in names {
        let middle = blocking.curve(id, side, 0.5);
        // ξ0 is named inside the block: outside there may be little room.
        let side_of_name = if side == BlockSide::Xi0 { -12.0 } else { 17.0 };
        let away = (middle - inside).normalize_or(DVec2::Y) * side_of_name;
        layer.text(middle, away.to_array(), Anchor::Middle, name);
    }
}

fn summary(blocking: &Blocking) -> String {
    let holes = blocking.domain().hole_count();
    Table::new("Blocks of three particles", ["", "paper", "ours"])
        .row([
            "blocks",
            &format!("6 (h - 1) = {}", 6 * (holes - 1)),
            &blocking.blocks().len().to_string(),
        ])
        .row([
            "blocks that share each medial arc",
            "2",
            &per(blocking.blocks().len(), blocking.arcs().len()),
        ])
        .row([
            "blocks round each medial vertex",
            "6",
            &per(2 * blocking.blocks().len(), blocking.vertices().len()),
        ])
        .to_string()
}

/// A ratio of counts, as a whole number where it is one.
fn per(count: usize, of: usize) -> String {
    (count as f64 / of as f64).to_string()
}
