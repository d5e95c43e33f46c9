//! Figure 4: the Voronoi diagram of the samples, and of the domain.

use delaunay_core::{ConvexPolygon, Delaunay2};
use glam::DVec2;
use medial_blocking::Wall;
use medial_blocking::medial_axis::SampledAxis;
use medial_blocking::triangulation::{Across, SideId, TriangleId};
use mesh_io::svg::{Color, Panel, Picture, Sample, Stroke, Style};

use super::super::table::Table;
use super::super::{Render, Rendered};
use super::ink::{domain_panel, draw_samples};
use super::small::three_particles;

const VORONOI: Stroke = Stroke {
    color: Color::BLUE,
    width: 0.7,
    dotted: false,
};

pub(super) fn figure() -> Render {
    let blocking = three_particles()?;
    let axis = blocking.sampled_axis();
    let of_samples = Delaunay2::build(axis.samples.points())?;
    let edges = edges_of_domain(&axis);

    let mut left = domain_panel(&blocking).caption("of the samples");
    draw_cells(&mut left, &of_samples, blocking.domain().walls())?;
    draw_samples(&mut left, &axis);

    let mut right = domain_panel(&blocking).caption("of the domain");
    right
        .layer(
            "Voronoi diagram of the domain",
            Style::line(Stroke {
                width: 1.4,
                ..VORONOI
            }),
        )
        .polylines(edges.clone());
    draw_samples(&mut right, &axis);

    let picture = Picture::new("Voronoi diagram")
        .panel(left)
        .panel(right)
        .key("Voronoi edge", Sample::Line(VORONOI))
        .key("sample", Sample::Dot(Color::INK));
    Ok(Rendered {
        svg: picture.to_svg()?,
        summary: summary(&axis, &of_samples, &edges),
    })
}

/// Draws the Voronoi cells of all samples, cut at a square far outside the domain.
fn draw_cells(
    panel: &mut Panel,
    delaunay: &Delaunay2,
    walls: &[Wall],
) -> Result<(), Box<dyn std::error::Error>> {
    let reach = walls
        .iter()
        .map(|wall| wall.circle.center.abs().max_element() + wall.circle.radius)
        .fold(0.0, f64::max);
    let window = ConvexPolygon::rectangle(DVec2::splat(-2.0 * reach), DVec2::splat(2.0 * reach))?;
    let cells = delaunay
        .vertices()
        .map(|v| delaunay.voronoi().cell(v, &window).corners().to_vec());
    panel
        .layer("Voronoi diagram of the samples", Style::line(VORONOI))
        .polygons(cells);
    Ok(())
}

/// The Voronoi edges across sides shared by two triangles of the domain, each once.
fn edges_of_domain(axis: &SampledAxis<'_>) -> Vec<[DVec2; 2]> {
    let sides = axis.triangulation.ids().flat_map(sides_of);
    let shared = sides.filter_map(|side| match axis.triangulation.across(side) {
        Across::Triangle { side: mate, shift } if side < mate => Some((side, mate, shift)),
        _ => None,
    });
    let center = |side: SideId, shift| axis.circumcenter(side.triangle, shift);
    shared
        .map(|(side, mate, shift)| [center(side, glam::IVec2::ZERO), center(mate, shift)])
        .collect()
}

fn sides_of(triangle: TriangleId) -> impl Iterator<Item = SideId> {
    (0..3).map(move |side| SideId { triangle, side })
}

fn summary(axis: &SampledAxis<'_>, of_samples: &Delaunay2, edges: &[[DVec2; 2]]) -> String {
    let inside = edges.iter().flatten().filter(|&&p| {
        axis.domain
            .walls()
            .iter()
            .all(|wall| wall.distance(p) > 0.0)
    });
    let outside = 2 * edges.len() - inside.count();
    Table::new("Voronoi diagram", ["", "paper", "ours"])
        .row([
            "edges of the diagram of the samples",
            "-",
            &of_samples.voronoi().edges().count().to_string(),
        ])
        .row([
            "edges of the diagram of the domain",
            "-",
            &edges.len().to_string(),
        ])
        .row([
            "of these, ends outside the domain",
            "0",
            &outside.to_string(),
        ])
        .to_string()
}
