//! Figure 5: vertices of the medial axis are interior triangles, its arcs sequences of triangles.

use medial_blocking::medial_axis::{SampledAxis, TriangleSequence};
use mesh_io::svg::{Color, Panel, Picture, Sample, Stroke, Style};

use super::super::table::Table;
use super::super::{Render, Rendered};
use super::ink::{AXIS, CHOSEN, corners, domain_panel, draw_axis, draw_triangulation};
use super::small::three_particles;

/// The boundary triangles along an arc.
const BETWEEN: Style = Style::line(Stroke::thin(Color::RED)).filled(Color::ROSE);

pub(super) fn figure() -> Render {
    let blocking = three_particles()?;
    let axis = blocking.sampled_axis();
    let arcs = axis.arcs();

    let mut left = domain_panel(&blocking).caption("vertices and interior triangles");
    draw_triangulation(&mut left, &axis);
    left.layer("interior triangles", CHOSEN)
        .polygons(axis.triangulation.interior().map(|id| corners(&axis, id)));
    draw_axis(&mut left, &axis);
    draw_vertices(&mut left, &axis);

    let mut right = domain_panel(&blocking).caption("an arc and its sequence of triangles");
    draw_triangulation(&mut right, &axis);
    if let Some(longest) = arcs.iter().max_by_key(|arc| arc.entries.len()) {
        draw_sequence(&mut right, &axis, longest);
    }

    let picture = Picture::new("Medial axis from the Delaunay triangulation")
        .panel(left)
        .panel(right)
        .key("medial axis", Sample::Line(AXIS))
        .key("interior triangle", Sample::Area(CHOSEN))
        .key("boundary triangle of the arc", Sample::Area(BETWEEN))
        .key("circumcentre", Sample::Dot(Color::INK));
    Ok(Rendered {
        svg: picture.to_svg()?,
        summary: summary(&axis, &arcs),
    })
}

fn draw_vertices(panel: &mut Panel, axis: &SampledAxis<'_>) {
    let layer = panel.layer("vertices", Style::area(Color::INK));
    for id in axis.triangulation.interior() {
        layer.dot(axis.circumcenter(id, glam::IVec2::ZERO), 3.2);
    }
}

fn draw_sequence(panel: &mut Panel, axis: &SampledAxis<'_>, arc: &TriangleSequence) {
    let (ends, between): (Vec<_>, Vec<_>) = arc
        .triangles()
        .map(|(id, _)| id)
        .partition(|&id| axis.triangulation.triangle(id).is_interior());
    panel
        .layer("boundary triangles", BETWEEN)
        .polygons(between.into_iter().map(|id| corners(axis, id)));
    panel
        .layer("interior triangles", CHOSEN)
        .polygons(ends.into_iter().map(|id| corners(axis, id)));
    panel
        .layer("arc", Style::line(AXIS))
        .polyline(arc.polyline(axis));
    let centers = panel.layer("circumcentres", Style::area(Color::INK));
    for center in arc.polyline(axis) {
        centers.dot(center, 2.2);
    }
}

fn summary(axis: &SampledAxis<'_>, arcs: &[TriangleSequence]) -> String {
    let interior = axis.triangulation.interior().count();
    let boundary = axis.triangulation.triangles().len() - interior;
    let visited: usize = arcs
        .iter()
        .map(|arc| arc.entries.len().saturating_sub(1))
        .sum();
    let ends_interior = arcs.iter().all(|arc| {
        let mut triangles = arc
            .triangles()
            .map(|(id, _)| axis.triangulation.triangle(id).is_interior());
        triangles.next() == Some(true) && triangles.last() == Some(true)
    });
    Table::new("Algorithm 1", ["", "paper", "ours"])
        .row([
            "medial vertices = interior triangles",
            "-",
            &interior.to_string(),
        ])
        .row([
            "medial arcs = sequences",
            "3/2 of the vertices",
            &arcs.len().to_string(),
        ])
        .row([
            "sequences start and end at interior triangles",
            "yes",
            if ends_interior { "yes" } else { "no" },
        ])
        .row(["boundary triangles", "-", &boundary.to_string()])
        .row([
            "boundary triangles in sequences",
            "all",
            &visited.to_string(),
        ])
        .to_string()
}
