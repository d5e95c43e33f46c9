//! Figure 2: sinks of the USA data, and the ancestor sets of their triangles (§3.2, §3.3).

use delaunay_core::Subcomplex2;
use mesh_io::svg::{Color, Panel, Picture, Sample, Stroke, Style, Window};
use sink_refine::{End, Sinks, sink};

use super::usa;
use crate::figures::table::{Table, grouped};
use crate::figures::{Render, Rendered};

const EDGE: Stroke = Stroke::thin(Color::INK);
const BORDER: Stroke = Stroke {
    color: Color::INK,
    width: 2.0,
    dotted: false,
};

/// Of sink triangles.
const SINK: Color = Color([0xc6, 0xcb, 0xd2]);

/// Figure 2.
pub(super) fn figure() -> Render {
    let outline = usa::triangulated()?;
    let region = usa::stable(&outline)?;
    let sinks = Sinks::of(&region);
    let area = |color| Sample::Area(Style::line(EDGE).filled(color));
    let picture = Picture::new("Figure 2: sinks of the USA data")
        .panel(panel(&region, &sinks))
        .key("sink triangle", area(SINK))
        .key("sink", Sample::Dot(Color::RED))
        .key("border of ancestor sets", Sample::Line(BORDER));
    Ok(Rendered {
        svg: picture.to_svg()?,
        summary: summary(outline.faces().count(), &region, &sinks),
    })
}

fn panel(region: &Subcomplex2, sinks: &Sinks) -> Panel {
    let window = Window::around(region.points().iter().copied()).widened(0.02);
    let mut panel = Panel::new(window).width(860.0);
    let is_sink = |f| sinks.end(f) == Some(End::Sink(f));
    for (name, color, of_sinks) in [
        ("triangles", Color::WHITE, false),
        ("sink triangles", SINK, true),
    ] {
        let faces = region.faces().filter(|&f| is_sink(f) == of_sinks);
        panel
            .layer(name, Style::line(EDGE).filled(color))
            .polygons(faces.map(|f| region.triangle(f)));
    }
    let mesh = region.mesh();
    let parting = mesh.half_edges().filter(|&h| {
        let twin = mesh.twin(h);
        !mesh.is_ghost_face(h.face())
            && (h < twin || mesh.is_ghost_face(twin.face()))
            && sinks.end(h.face()) != sinks.end(twin.face())
    });
    panel
        .layer("borders of ancestor sets", Style::line(BORDER))
        .polylines(parting.map(|h| region.segment(h)));
    let dots = panel.layer("sinks", Style::area(Color::RED));
    for f in sinks.triangles() {
        dots.dot(sink(region, f), 2.6);
    }
    panel
}

fn summary(inside: usize, region: &Subcomplex2, sinks: &Sinks) -> String {
    let sets: Vec<usize> = sinks
        .triangles()
        .map(|f| sinks.ancestors(End::Sink(f)).len())
        .collect();
    let mean = sets.iter().sum::<usize>() as f64 / sets.len().max(1) as f64;
    let largest = sets.iter().max().copied().unwrap_or(0);
    let stable = region.faces().count();
    let outside = sinks.ancestors(End::Outside).len();
    Table::new("Figure 2: sinks of the USA data", ["", "ours", "paper"])
        .row(["triangles inside the outline", &grouped(inside), "-"])
        .row(["of the maximal stable subcomplex", &grouped(stable), "229"])
        .row(["sinks", &grouped(sets.len()), "-"])
        .row([
            "triangles of an ancestor set, mean",
            &format!("{mean:.2}"),
            "-",
        ])
        .row(["the same, most", &grouped(largest), "-"])
        .row(["triangles whose flow leaves", &grouped(outside), "0"])
        .to_string()
}
