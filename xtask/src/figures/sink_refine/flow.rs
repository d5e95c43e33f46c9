//! The flow between triangles and its sinks (§3.2, §3.3), on a triangulation of our own.

use std::cmp::Reverse;

use delaunay_core::measure::triangle::{circumcenter, circumradius};
use delaunay_core::{Delaunay2, FaceId, HalfEdgeId};
use fixtures::points;
use glam::DVec2;
use mesh_io::svg::{Color, Panel, Picture, Sample, Stroke, Style, Window};
use sink_refine::{End, Sinks, Successor, flows_through, path, sink, successor};

use crate::figures::table::Table;
use crate::figures::{Render, Rendered};

const EDGE: Stroke = Stroke::thin(Color::GREY);
const ARROW: Stroke = Stroke {
    color: Color::INK,
    width: 1.2,
    dotted: false,
};
const WATERSHED: Stroke = Stroke::medium(Color::INK);
const CIRCUMCIRCLE: Stroke = Stroke::dotted(Color::BLUE);

/// What flows outside.
const OUTSIDE: Color = Color::MIST;

/// Watersheds, so that neighbours differ.
const TINTS: [Color; 5] = [
    Color::SKY,
    Color::ROSE,
    Color([0xf6, 0xe6, 0xbd]),
    Color([0xd2, 0xea, 0xd6]),
    Color([0xe2, 0xd6, 0xee]),
];

/// The flow and its sinks.
pub(super) fn figure() -> Render {
    let delaunay = Delaunay2::build(&outline())?;
    let sinks = Sinks::of(&delaunay);
    let colors = colors(&delaunay, &sinks);

    let mut left = triangles(&delaunay, &sinks, &colors).caption("the flow");
    draw_flow(&mut left, &delaunay);

    let mut right = triangles(&delaunay, &sinks, &colors)
        .caption("its sinks, and where the flow to each comes from");
    draw_watersheds(&mut right, &delaunay, &sinks);
    draw_sinks(&mut right, &delaunay, &sinks);

    let picture = Picture::new("Sinks of a Delaunay triangulation")
        .panel(left)
        .panel(right)
        .key("to the next triangle", Sample::Line(ARROW))
        .key("sink", Sample::Dot(Color::BLUE))
        .key("its circumcircle", Sample::Line(CIRCUMCIRCLE))
        .key(
            "flows outside",
            Sample::Area(Style::line(EDGE).filled(OUTSIDE)),
        );
    Ok(Rendered {
        svg: picture.to_svg()?,
        summary: summary(&delaunay, &sinks),
    })
}

/// Discs that overlap, as `[x, y, radius]`.
const DISCS: [[f64; 3]; 4] = [
    [0.27, 0.36, 0.25],
    [0.68, 0.24, 0.18],
    [0.62, 0.62, 0.21],
    [0.24, 0.80, 0.15],
];

/// Points near the outline of the discs together, none nearer to another than a twentieth: crowds of flat triangles.
fn outline() -> Vec<DVec2> {
    let mut kept: Vec<DVec2> = Vec::new();
    for point in points::uniform(20_000, 1) {
        let is_near = distance_to_outline(point).abs() < 0.012;
        if is_near && kept.iter().all(|other| other.distance(point) >= 0.05) {
            kept.push(point);
        }
    }
    kept
}

/// Negative inside.
fn distance_to_outline(point: DVec2) -> f64 {
    DISCS
        .iter()
        .map(|&[x, y, radius]| point.distance(DVec2::new(x, y)) - radius)
        .fold(f64::INFINITY, f64::min)
}

/// A colour for every triangle by its end, by face index. Large watersheds choose first.
fn colors(delaunay: &Delaunay2, sinks: &Sinks) -> Vec<Color> {
    let mut colors = vec![OUTSIDE; delaunay.mesh().face_count()];
    let mut watersheds: Vec<(End, &[FaceId])> = sinks
        .watersheds()
        .filter(|(end, _)| *end != End::Outside)
        .collect();
    watersheds.sort_by_key(|(_, ancestors)| Reverse(ancestors.len()));
    for (_, ancestors) in watersheds {
        let around = ancestors.iter().flat_map(|&f| touching(delaunay, f));
        let taken: Vec<Color> = around.map(|f| colors[f.index()]).collect();
        let color = least_used(&taken, &colors);
        ancestors.iter().for_each(|f| colors[f.index()] = color);
    }
    colors
}

/// The first tint that is taken the least nearby, then anywhere.
fn least_used(nearby: &[Color], anywhere: &[Color]) -> Color {
    let times = |tint, colors: &[Color]| colors.iter().filter(|&&color| color == tint).count();
    TINTS
        .into_iter()
        .min_by_key(|&tint| (times(tint, nearby), times(tint, anywhere)))
        .unwrap_or(OUTSIDE)
}

/// The triangles and ghosts that share a vertex with `f`.
fn touching(delaunay: &Delaunay2, f: FaceId) -> Vec<FaceId> {
    let vertices = delaunay.mesh().face_vertices(f).into_iter();
    vertices.flat_map(|v| delaunay.mesh().star(v)).collect()
}

/// A panel with the triangles, coloured, and sink triangles darker.
fn triangles(delaunay: &Delaunay2, sinks: &Sinks, colors: &[Color]) -> Panel {
    let mut panel = Panel::new(Window::around(delaunay.points().iter().copied()).widened(0.06));
    for f in delaunay.faces() {
        let color = colors[f.index()];
        let fill = if sinks.end(f) == Some(End::Sink(f)) {
            color.mixed(Color::INK, 0.22)
        } else {
            color
        };
        panel
            .layer(&format!("triangle {f}"), Style::line(EDGE).filled(fill))
            .polygon(delaunay.triangle(f));
    }
    panel
}

/// An arrow from every triangle into its successor, across their common edge.
fn draw_flow(panel: &mut Panel, delaunay: &Delaunay2) {
    let layer = panel.layer("flow", Style::line(ARROW));
    for f in delaunay.faces() {
        let center = centroid(delaunay.triangle(f));
        let through = f
            .half_edges()
            .into_iter()
            .find(|&h| flows_through(delaunay, h));
        match (successor(delaunay, f), through) {
            (Successor::Triangle(next), _) => {
                layer.arrow(center, centroid(delaunay.triangle(next)));
            }
            (Successor::Outside, Some(h)) => {
                layer.arrow(center, beyond(delaunay, h));
            }
            _ => {}
        }
    }
}

/// A point a little outside a hull edge, opposite its middle.
fn beyond(delaunay: &Delaunay2, h: HalfEdgeId) -> DVec2 {
    let mesh = delaunay.mesh();
    let [a, b] = [mesh.origin(h), mesh.target(h)].map(|v| delaunay.point(v));
    let outward = DVec2::new(b.y - a.y, a.x - b.x).normalize_or_zero();
    a.midpoint(b) + 0.03 * outward
}

/// Draws the edges between triangles of different ends.
fn draw_watersheds(panel: &mut Panel, delaunay: &Delaunay2, sinks: &Sinks) {
    let mesh = delaunay.mesh();
    let parting = mesh.half_edges().filter(|&h| {
        let twin = mesh.twin(h);
        h < twin && sinks.end(h.face()) != sinks.end(twin.face())
    });
    let edges = parting.map(|h| [mesh.origin(h), mesh.target(h)].map(|v| delaunay.point(v)));
    panel
        .layer("borders of watersheds", Style::line(WATERSHED))
        .polylines(edges);
}

/// Draws the sinks with the circumcircles of their triangles.
fn draw_sinks(panel: &mut Panel, delaunay: &Delaunay2, sinks: &Sinks) {
    let circles = panel.layer("circumcircles", Style::line(CIRCUMCIRCLE));
    for f in sinks.triangles() {
        let corners = delaunay.triangle(f);
        circles.circle(circumcenter(corners), circumradius(corners));
    }
    let dots = panel.layer("sinks", Style::area(Color::BLUE));
    for f in sinks.triangles() {
        dots.dot(sink(delaunay, f), 3.5);
    }
}

fn centroid([a, b, c]: [DVec2; 3]) -> DVec2 {
    (a + b + c) / 3.0
}

fn summary(delaunay: &Delaunay2, sinks: &Sinks) -> String {
    let triangles = delaunay.faces().count();
    let of_sinks: Vec<usize> = sinks
        .triangles()
        .map(|f| sinks.ancestors(End::Sink(f)).len())
        .collect();
    let outside = sinks.ancestors(End::Outside).len();
    let longest = delaunay.faces().map(|f| path(delaunay, f).count()).max();
    let growing = delaunay.faces().filter(|&f| grows(delaunay, f)).count();
    let mean = of_sinks.iter().sum::<usize>() as f64 / of_sinks.len().max(1) as f64;
    Table::new("Sinks of a Delaunay triangulation", ["", "ours"])
        .row(["points", &delaunay.vertex_count().to_string()])
        .row(["triangles", &triangles.to_string()])
        .row(["sinks", &of_sinks.len().to_string()])
        .row(["triangles that flow outside", &outside.to_string()])
        .row(["triangles that flow to a sink, mean", &format!("{mean:.2}")])
        .row([
            "the same, most",
            &of_sinks.iter().max().copied().unwrap_or(0).to_string(),
        ])
        .row(["longest path, triangles", &longest.unwrap_or(0).to_string()])
        .row([
            "successors with a smaller circumcircle (paper: 0)",
            &(triangles - growing).to_string(),
        ])
        .to_string()
}

/// Whether the circumcircle of the successor of `f`, if there is one, is not smaller.
fn grows(delaunay: &Delaunay2, f: FaceId) -> bool {
    let radius = |f| circumradius(delaunay.triangle(f));
    match successor(delaunay, f) {
        Successor::Triangle(next) => radius(next) >= radius(f),
        Successor::None | Successor::Outside => true,
    }
}
