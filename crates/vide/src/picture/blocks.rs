//! A block mesh as the paper draws it: thick medial axis, dotted η-curves, thin mesh lines.

use glam::DVec2;
use medial_blocking::{ArcSide, Block, BlockGrid, BlockMesh, Blocking, WallKind};
use mesh_io::svg::{Color, Panel, Picture, Sample, Stroke, Style, Window};

/// The medial axis, ξ = 0.
const AXIS: Stroke = Stroke::thick(Color::BLUE);
/// The straight lines from medial vertices to walls, η = 0 and η = 1.
const ETA: Stroke = Stroke::dotted(Color::RED);
/// Lines of the structured grids.
const GRID: Stroke = Stroke {
    width: 0.4,
    ..Stroke::thin(Color::GREY)
};
/// The walls, ξ = 1, with what they enclose.
const WALL: Style = Style::line(Stroke::medium(Color::INK)).filled(Color::MIST);

/// Pixels of the panels of a mesh.
pub(super) const WIDTH: f64 = 480.0;

/// The panel of a mesh without colours.
#[must_use]
pub fn block_panel(mesh: &BlockMesh) -> Panel {
    let mut panel = Panel::new(window_of(mesh)).width(WIDTH);
    draw_walls(&mut panel, mesh.blocking());
    draw_mesh_lines(&mut panel, mesh);
    draw_scheme(&mut panel, mesh);
    panel
}

/// The smallest window that shows every block and wall, with a narrow margin.
#[must_use]
pub fn window_of(mesh: &BlockMesh) -> Window {
    let walls = mesh.blocking().domain().walls().iter().flat_map(|wall| {
        let (center, radius) = (wall.circle.center, DVec2::splat(wall.circle.radius));
        [center - radius, center + radius]
    });
    let nodes = mesh
        .grids()
        .iter()
        .flat_map(|grid| grid.nodes().iter().copied());
    Window::around(walls.chain(nodes)).widened(0.01)
}

/// Draws the walls, particles filled.
pub fn draw_walls(panel: &mut Panel, blocking: &Blocking) {
    let walls = blocking.domain().walls();
    let bounding = panel.layer("bounding circle", Style { fill: None, ..WALL });
    for wall in walls.iter().filter(|wall| wall.kind == WallKind::Bounding) {
        bounding.circle(wall.circle.center, wall.circle.radius);
    }
    let particles = panel.layer("particles", WALL);
    for wall in walls.iter().filter(|wall| wall.kind == WallKind::Hole) {
        particles.circle(wall.circle.center, wall.circle.radius);
    }
}

/// Draws the grid lines inside the blocks.
pub fn draw_mesh_lines(panel: &mut Panel, mesh: &BlockMesh) {
    let layer = panel.layer("mesh lines", Style::line(GRID));
    for grid in mesh.grids() {
        layer.polylines((1..grid.cells_across()).map(|i| along(grid, i)));
        layer.polylines((1..grid.cells_along()).map(|j| across(grid, j)));
    }
}

/// Draws the blocking scheme: the medial axis and the η-curves.
pub fn draw_scheme(panel: &mut Panel, mesh: &BlockMesh) {
    // The η1-curve of a block is the η0-curve of the next one round the same wall.
    panel
        .layer("eta curves", Style::line(ETA))
        .polylines(mesh.grids().iter().map(|grid| across(grid, 0)));
    let own_axis = mesh
        .blocks()
        .filter(|(block, _)| draws_its_arc(mesh.blocking(), block));
    panel
        .layer("medial axis", Style::line(AXIS))
        .polylines(own_axis.map(|(_, grid)| along(grid, 0)));
}

/// Whether a block is the first to show its arc there: blocks on two sides of a period each show their own copy.
fn draws_its_arc(blocking: &Blocking, block: &Block) -> bool {
    let mate = blocking.block(block.neighbours.xi0.0);
    block.side == ArcSide::Right || block.arc_shift != mate.arc_shift
}

/// The nodes of a block at a given step from the medial axis.
fn along(grid: &BlockGrid, i: usize) -> impl Iterator<Item = DVec2> + '_ {
    (0..=grid.cells_along()).map(move |j| grid.node(i, j))
}

/// The nodes of a block at a given step along its arc.
fn across(grid: &BlockGrid, j: usize) -> impl Iterator<Item = DVec2> + '_ {
    (0..=grid.cells_across()).map(move |i| grid.node(i, j))
}

/// The picture with a key of these line styles.
#[must_use]
pub fn keyed(picture: Picture) -> Picture {
    picture
        .key("medial axis (ξ0)", Sample::Line(AXIS))
        .key("η-curves", Sample::Line(ETA))
        .key("mesh lines", Sample::Line(GRID))
        .key("particles", Sample::Area(WALL))
}
