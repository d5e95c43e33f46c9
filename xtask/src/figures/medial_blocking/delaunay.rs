//! Figure 3: the Delaunay triangulation of the samples, and of the domain.

use delaunay_core::Delaunay2;
use medial_blocking::triangulation::{Across, Triangle};
use mesh_io::svg::{Color, Panel, Picture, Sample, Style};

use super::super::table::Table;
use super::super::{Render, Rendered};
use super::ink::{CHOSEN, EDGE, corners, domain_panel, draw_samples, draw_triangulation};
use super::small::three_particles;

pub(super) fn figure() -> Render {
    let blocking = three_particles()?;
    let axis = blocking.sampled_axis();
    let of_samples = Delaunay2::build(axis.samples.points())?;

    let mut left = domain_panel(&blocking).caption("of the samples");
    draw_all(&mut left, &of_samples);
    draw_samples(&mut left, &axis);

    let mut right = domain_panel(&blocking).caption("of the domain");
    let interior = axis.triangulation.interior().map(|id| corners(&axis, id));
    right.layer("interior triangles", CHOSEN).polygons(interior);
    draw_triangulation(&mut right, &axis);
    draw_samples(&mut right, &axis);

    let picture = Picture::new("Delaunay triangulation")
        .panel(left)
        .panel(right)
        .key("Delaunay edge", Sample::Line(EDGE))
        .key("interior triangle", Sample::Area(CHOSEN))
        .key("sample", Sample::Dot(Color::INK));
    Ok(Rendered {
        svg: picture.to_svg()?,
        summary: summary(&of_samples, axis.triangulation.triangles()),
    })
}

fn draw_all(panel: &mut Panel, delaunay: &Delaunay2) {
    let triangles = delaunay.faces().map(|face| delaunay.triangle(face));
    panel
        .layer("triangulation of the samples", Style::line(EDGE))
        .polygons(triangles);
}

fn summary(of_samples: &Delaunay2, of_domain: &[Triangle]) -> String {
    let with_wall_edges = |count: usize| {
        let edges = |triangle: &Triangle| {
            triangle
                .across
                .iter()
                .filter(|across| **across == Across::Wall)
                .count()
        };
        of_domain
            .iter()
            .filter(|triangle| edges(triangle) == count)
            .count()
            .to_string()
    };
    Table::new("Delaunay triangulation", ["", "paper", "ours"])
        .row([
            "triangles of the samples",
            "-",
            &of_samples.faces().count().to_string(),
        ])
        .row(["triangles of the domain", "-", &of_domain.len().to_string()])
        .row([
            "interior triangles, no edge on the boundary",
            "-",
            &with_wall_edges(0),
        ])
        .row(["boundary triangles, one edge", "-", &with_wall_edges(1)])
        .row([
            "triangles with two edges on the boundary",
            "0",
            &with_wall_edges(2),
        ])
        .to_string()
}
