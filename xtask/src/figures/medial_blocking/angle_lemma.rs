//! Figure 9: the Angle Lemma and its proof.

use std::f64::consts::TAU;

use glam::DVec2;
use medial_blocking::{BlockCorner, BlockId, BlockSide, Blocking, MedialVertex};
use mesh_io::svg::{Anchor, Color, Panel, Picture, Sample, Stroke, Style, Window};

use super::super::table::Table;
use super::super::{Render, Rendered};
use super::ink::{AXIS, DOTTED};
use super::small::three_particles;

const TRIANGLE: Stroke = Stroke::medium(Color::INK);
/// One colour for each angle of the triangle and the two block corners that equal it.
const ANGLES: [Color; 3] = [Color::SKY, Color::ROSE, Color([0xf3, 0xe3, 0xbf])];

/// Step along an arc that stands for its direction at the end.
const TANGENT_STEP: f64 = 1e-6;

pub(super) fn figure() -> Render {
    let blocking = three_particles()?;
    let vertex = blocking
        .vertices()
        .iter()
        .max_by(|a, b| smallest_angle(a, &blocking).total_cmp(&smallest_angle(b, &blocking)));
    let vertex = vertex.ok_or("no vertices")?;
    let picture = Picture::new("Angle Lemma")
        .panel(lemma(&blocking, vertex).caption("corners at c have the angles of the triangle"))
        .panel(
            proof(&blocking, vertex).caption("the angle at c is 2α, and the medial axis halves it"),
        )
        .key("medial axis", Sample::Line(AXIS))
        .key("η-curves", Sample::Line(DOTTED))
        .key("interior triangle", Sample::Line(TRIANGLE));
    Ok(Rendered {
        svg: picture.to_svg()?,
        summary: summary(&blocking),
    })
}

fn touching_points(blocking: &Blocking, vertex: &MedialVertex) -> Vec<DVec2> {
    let point = |touch: &medial_blocking::Touch| {
        blocking
            .domain()
            .wall_image(touch.image)
            .point_towards(touch.direction)
    };
    vertex.touches.iter().map(point).collect()
}

/// The triangle's angle at its corner `k`, in radians.
fn triangle_angle(points: &[DVec2], k: usize) -> f64 {
    let [a, b, c] = [0, 1, 2].map(|step| points[(k + step) % 3]);
    (b - a).angle_to(c - a).abs()
}

fn smallest_angle(vertex: &MedialVertex, blocking: &Blocking) -> f64 {
    let points = touching_points(blocking, vertex);
    (0..3)
        .map(|k| triangle_angle(&points, k))
        .fold(f64::INFINITY, f64::min)
}

/// The triangle of touching points, its angles and the six block corners coloured alike.
fn lemma(blocking: &Blocking, vertex: &MedialVertex) -> Panel {
    let points = touching_points(blocking, vertex);
    let (c, size) = (vertex.center, vertex.clearance);
    let mut panel = stage(blocking, vertex);
    for (k, &color) in ANGLES.iter().enumerate() {
        let [q, r, p] = [0, 1, 2].map(|step| points[(k + step) % 3]);
        let wedges = [wedge(q, r, p, 0.3 * size), wedge(c, r, p, 0.3 * size)];
        panel
            .layer("angle", Style::line(Stroke::thin(Color::INK)).filled(color))
            .polygons(wedges);
    }
    draw_lines(&mut panel, vertex, &points);
    name_points(
        &mut panel,
        vertex,
        &[(points[2], "p"), (points[0], "q"), (points[1], "r")],
    );
    panel
}

/// The empty circle, one angle at the circumference and the angle at the centre that it subtends.
fn proof(blocking: &Blocking, vertex: &MedialVertex) -> Panel {
    let points = touching_points(blocking, vertex);
    let (c, size) = (vertex.center, vertex.clearance);
    let [q, r, p] = [points[0], points[1], points[2]];
    let mut panel = stage(blocking, vertex);
    let style = Style::line(Stroke::thin(Color::INK)).filled(ANGLES[0]);
    panel
        .layer("angles", style)
        .polygons([wedge(q, r, p, 0.3 * size), wedge(c, r, p, 0.3 * size)]);
    panel
        .layer("empty circle", Style::line(Stroke::thin(Color::BLUE)))
        .circle(c, size);
    draw_lines(&mut panel, vertex, &points);
    name_points(&mut panel, vertex, &[(p, "p"), (q, "q"), (r, "r")]);
    let alpha = panel.layer("angle names", Style::area(Color::BLUE));
    for (apex, fraction) in [(q, 0.5), (c, 0.25), (c, 0.75)] {
        let at = apex + 0.39 * size * wedge_direction(apex, r, p, fraction);
        alpha.text(at, [0.0; 2], Anchor::Middle, "α");
    }
    panel
}

fn name_points(panel: &mut Panel, vertex: &MedialVertex, points: &[(DVec2, &str)]) {
    let names = panel.layer("names", Style::area(Color::INK));
    for &(point, name) in points {
        names.dot(point, 3.0).text(
            point,
            nudge(point - vertex.center, 16.0),
            Anchor::Middle,
            name,
        );
    }
    // Half way between an η-curve and the medial arc beside it.
    let towards = points
        .iter()
        .map(|&(point, _)| point - vertex.center)
        .nth(1)
        .unwrap_or(DVec2::Y);
    let towards = DVec2::from_angle(0.5).rotate(towards);
    names
        .dot(vertex.center, 3.0)
        .text(vertex.center, nudge(towards, 15.0), Anchor::Middle, "c");
}

/// The walls and the medial arcs near the vertex.
fn stage(blocking: &Blocking, vertex: &MedialVertex) -> Panel {
    let reach = DVec2::splat(1.45 * vertex.clearance);
    let mut panel =
        Panel::new(Window::new(vertex.center - reach, vertex.center + reach)).width(360.0);
    vide::picture::draw_walls(&mut panel, blocking);
    panel
}

fn draw_lines(panel: &mut Panel, vertex: &MedialVertex, points: &[DVec2]) {
    let c = vertex.center;
    panel
        .layer("triangle", Style::line(TRIANGLE))
        .polygon(points.iter().copied());
    panel
        .layer("eta curves", Style::line(DOTTED))
        .polylines(points.iter().map(|&point| [c, point]));
    let arcs = (0..3).map(|k| {
        let towards = wedge_direction(c, points[(k + 1) % 3], points[(k + 2) % 3], 0.5);
        [c, c + 0.62 * vertex.clearance * towards]
    });
    panel
        .layer("medial axis", Style::line(AXIS))
        .polylines(arcs);
}

/// The sector of a circle round `apex` from the direction of `from` counterclockwise to that of `to`.
fn wedge(apex: DVec2, from: DVec2, to: DVec2, radius: f64) -> Vec<DVec2> {
    let rim =
        (0..=16).map(|k| apex + radius * wedge_direction(apex, from, to, f64::from(k) / 16.0));
    std::iter::once(apex).chain(rim).collect()
}

fn wedge_direction(apex: DVec2, from: DVec2, to: DVec2, fraction: f64) -> DVec2 {
    let start = (from - apex).normalize_or(DVec2::X);
    let turn = start.angle_to(to - apex).rem_euclid(TAU);
    DVec2::from_angle(fraction * turn).rotate(start)
}

fn nudge(towards: DVec2, pixels: f64) -> [f64; 2] {
    (towards.normalize_or(DVec2::Y) * pixels).to_array()
}

fn summary(blocking: &Blocking) -> String {
    let differences: Vec<f64> = blocking
        .block_ids()
        .flat_map(|id| differences(blocking, id))
        .collect();
    let largest = differences.iter().copied().fold(0.0, f64::max).to_degrees();
    let ours = if largest < 1e-3 {
        "below 0.001°".to_owned()
    } else {
        format!("{largest:.3}°")
    };
    Table::new("Angle Lemma", ["", "paper", "ours"])
        .row([
            "interior corners of blocks",
            "-",
            &differences.len().to_string(),
        ])
        .row([
            "largest difference to an angle of the interior triangle",
            "0°",
            &ours,
        ])
        .to_string()
}

/// How much the two interior corners of a block differ from the triangle's angles opposite to its arc.
fn differences(blocking: &Blocking, id: BlockId) -> [f64; 2] {
    let block = blocking.block(id);
    let mate = blocking.block(block.neighbours.xi0.0);
    let corner = |own: &BlockCorner, other: &BlockCorner, [at, near]: [f64; 2]| {
        let xi0 = |t| blocking.curve(id, BlockSide::Xi0, t);
        let to_wall = blocking.wall_corner(block, own) - blocking.inner_corner(own);
        let angle = (xi0(near) - xi0(at)).angle_to(to_wall).abs();
        let third = 3 - usize::from(own.touch) - usize::from(other.touch);
        let points = touching_points(blocking, blocking.vertex(own.vertex));
        (angle - triangle_angle(&points, third)).abs()
    };
    [
        corner(&block.start, &mate.end, [0.0, TANGENT_STEP]),
        corner(&block.end, &mate.start, [1.0, 1.0 - TANGENT_STEP]),
    ]
}
