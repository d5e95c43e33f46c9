//! Triangles coloured by quality.

use delaunay_core::measure::triangle::radius_ratio;
use glam::DVec2;
use mesh_io::svg::{Color, ColorBar, ColorMap, Panel, Picture, Stroke, Style, Window};
use mesh_io::{Cell, Mesh};

use super::blocks::WIDTH;

/// The picture of the triangles of a plane mesh by their radius ratio, 1 for the best.
///
/// Cells that are no triangles are left out. O(cells), and so is the length of the document.
#[must_use]
pub fn triangle_picture(mesh: &Mesh, title: &str) -> Picture {
    let place = |v: u32| {
        let [x, y, _] = mesh.points[v as usize];
        DVec2::new(x, y)
    };
    let triangles = mesh.cells.iter().filter_map(|cell| match cell {
        Cell::Triangle(corners) => Some(corners.map(place)),
        _ => None,
    });
    let triangles: Vec<[DVec2; 3]> = triangles.collect();
    let bar = ColorBar {
        map: ColorMap::new(0.4, 1.0),
        title: "radius ratio".to_owned(),
        ticks: vec![0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0],
        unit: String::new(),
    };
    let window = Window::around(triangles.as_flattened().iter().copied()).widened(0.02);
    let mut panel = Panel::new(window).width(WIDTH);
    let colored = triangles
        .iter()
        .map(|&corners| (corners, radius_ratio(corners)));
    panel
        .layer("triangles", Style::default())
        .colored_polygons(&bar.map, colored);
    panel
        .layer("edges", Style::line(Stroke::thin(Color::WHITE)))
        .polygons(triangles.iter().copied());
    Picture::new(title).panel(panel.color_bar(bar))
}
