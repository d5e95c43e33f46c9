//! Figure 2: a node and its nearby nodes (§3.3).

use bubble_mesh::paper::{Params, generate, rings};
use delaunay_core::VertexId;
use delaunay_core::progress::silent;
use fixtures::outlines;
use glam::DVec2;
use mesh_io::svg::{Color, Panel, Picture, Sample, Stroke, Style, Window};

use super::outline::domain_of_graph;
use crate::figures::table::Table;
use crate::figures::{Render, Rendered};

const EDGE: Stroke = Stroke::thin(Color::GREY);
const RINGS: [(&str, Color); 3] = [
    ("1st level", Color::RED),
    ("2nd level", Color::OCHRE),
    ("3rd level", Color::BLUE),
];

/// Figure 2.
pub(super) fn figure() -> Render {
    let domain = domain_of_graph(outlines::circle())?;
    let mesh = generate(&domain, &Params::paper(), &mut silent);
    let region = mesh.region();
    let nodes = (0..mesh.bubbles().len()).map(VertexId::new);
    let distance = |v: &VertexId| region.point(*v).length();
    let current = nodes.min_by(|v, w| distance(v).total_cmp(&distance(w)));
    let current = current.ok_or("no node")?;
    let rings = rings(region, current);

    let shown = rings[2].iter().map(|&v| region.point(v));
    let mut panel = Panel::new(Window::around(shown).widened(0.1)).width(480.0);
    let near = |corners: &[DVec2; 3]| corners.iter().any(|p| p.length() < 0.75);
    let triangles = region.faces().map(|f| region.triangle(f)).filter(near);
    panel
        .layer("triangles", Style::line(EDGE))
        .polygons(triangles);
    let mut picture =
        Picture::new("Figure 2: nearby nodes").key("current node", Sample::Dot(Color::INK));
    let mut table = Table::new("Figure 2: nearby nodes", ["level", "nodes", "in a lattice"]);
    for (((name, color), ring), lattice) in RINGS.into_iter().zip(&rings).zip([6, 12, 18]) {
        let dots = panel.layer(name, Style::area(color));
        for &v in ring {
            dots.dot(region.point(v), 5.0);
        }
        picture = picture.key(name, Sample::Dot(color));
        table = table.row([name.to_owned(), ring.len().to_string(), lattice.to_string()]);
    }
    panel
        .layer("current node", Style::area(Color::INK))
        .dot(region.point(current), 6.0);
    Ok(Rendered {
        svg: picture.panel(panel).to_svg()?,
        summary: table.to_string(),
    })
}
