//! What the explaining figures have in common: line styles, window, walls, triangles.

use glam::DVec2;
use medial_blocking::Blocking;
use medial_blocking::medial_axis::SampledAxis;
use medial_blocking::triangulation::TriangleId;
use mesh_io::svg::{Color, Panel, Stroke, Style, Window};

/// The medial axis.
pub(super) const AXIS: Stroke = Stroke::thick(Color::BLUE);
/// Triangulations and diagrams.
pub(super) const EDGE: Stroke = Stroke::thin(Color::GREY);
/// Dotted curves.
pub(super) const DOTTED: Stroke = Stroke::dotted(Color::RED);
/// Triangles that a figure is about.
pub(super) const CHOSEN: Style = Style::line(Stroke::medium(Color::BLUE)).filled(Color::SKY);
/// Walls and what they enclose.
pub(super) const WALL: Style = Style::line(Stroke::medium(Color::INK)).filled(Color::MIST);

/// A panel that shows the whole bounded domain with its walls.
pub(super) fn domain_panel(blocking: &Blocking) -> Panel {
    let mut panel = Panel::new(bounding_window(blocking)).width(360.0);
    vide::picture::draw_walls(&mut panel, blocking);
    panel
}

fn bounding_window(blocking: &Blocking) -> Window {
    let corners = blocking.domain().walls().iter().flat_map(|wall| {
        let reach = DVec2::splat(wall.circle.radius);
        [wall.circle.center - reach, wall.circle.center + reach]
    });
    Window::around(corners).widened(0.02)
}

/// The corners of a triangle of the domain.
pub(super) fn corners(axis: &SampledAxis<'_>, triangle: TriangleId) -> [DVec2; 3] {
    axis.triangulation
        .triangle(triangle)
        .corners
        .map(|corner| axis.point(corner))
}

/// Draws the triangulation of the domain in thin lines.
pub(super) fn draw_triangulation(panel: &mut Panel, axis: &SampledAxis<'_>) {
    let triangles = axis.triangulation.ids().map(|id| corners(axis, id));
    panel
        .layer("triangulation of the domain", Style::line(EDGE))
        .polygons(triangles);
}

/// Draws the samples of the walls.
pub(super) fn draw_samples(panel: &mut Panel, axis: &SampledAxis<'_>) {
    let layer = panel.layer("samples", Style::area(Color::INK));
    for &sample in axis.samples.points() {
        layer.dot(sample, 1.4);
    }
}

/// Draws the sampled medial axis, thick.
pub(super) fn draw_axis(panel: &mut Panel, axis: &SampledAxis<'_>) {
    let arcs = axis.arcs();
    panel
        .layer("medial axis", Style::line(AXIS))
        .polylines(arcs.iter().map(|arc| arc.polyline(axis)));
}
