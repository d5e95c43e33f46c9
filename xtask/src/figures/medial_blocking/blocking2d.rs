//! Figure 7: states of Algorithm 2, `Blocking2D`, at line 3 and at line 8.

use glam::DVec2;
use medial_blocking::Blocking;
use medial_blocking::blocking2d::{BlockPair, block_pairs};
use medial_blocking::medial_axis::SampledAxis;
use medial_blocking::triangulation::{Across, SideId, TriangleId};
use mesh_io::svg::{Anchor, Color, Panel, Picture, Sample, Stroke, Style, Window};

use super::super::table::Table;
use super::super::{Render, Rendered};
use super::ink::{AXIS, CHOSEN, corners, draw_triangulation};
use super::small::two_particles;

const C1: Stroke = Stroke {
    color: Color::RED,
    width: 2.4,
    dotted: false,
};
const C2: Stroke = Stroke {
    color: Color::OCHRE,
    width: 2.4,
    dotted: false,
};

/// Triangles, from the second of the arc, among which the fattest is shown at line 8.
const STEPS: std::ops::Range<usize> = 2..7;

pub(super) fn figure() -> Render {
    let blocking = two_particles()?;
    let axis = blocking.sampled_axis();
    let pairs = block_pairs(&axis);
    let longest = pairs
        .iter()
        .max_by_key(|pair| pair.m.len())
        .ok_or("no arcs")?;
    let picture = Picture::new("States of Blocking2D")
        .panel(at_line_3(&blocking, &axis, longest).caption("line 3"))
        .panel(at_line_8(&blocking, &axis, longest).caption("line 8"))
        .key("C1", Sample::Line(C1))
        .key("M", Sample::Line(AXIS))
        .key("C2", Sample::Line(C2))
        .key("Δ", Sample::Area(CHOSEN));
    Ok(Rendered {
        svg: picture.to_svg()?,
        summary: summary(&pairs),
    })
}

/// Before the loop: the curves are the two ends of λ and the circumcentre of Δ.
fn at_line_3(blocking: &Blocking, axis: &SampledAxis<'_>, pair: &BlockPair) -> Panel {
    let (delta, lambda) = (pair.sequence.start.triangle, pair.sequence.start);
    let mut panel = backdrop(blocking, axis, pair, delta);
    draw_curves(&mut panel, axis, pair, 0);
    let [a, b] = axis
        .triangulation
        .ends(lambda)
        .map(|corner| axis.point(corner));
    name_points(&mut panel, centroid(axis, delta), &[(a, "a"), (b, "b")]);
    name_sides(&mut panel, axis, &[(lambda, "λ")]);
    name_triangle(&mut panel, axis, delta);
    panel
}

/// Inside the loop, after some steps: Δ has been entered across λ, and p is its new vertex.
fn at_line_8(blocking: &Blocking, axis: &SampledAxis<'_>, pair: &BlockPair) -> Panel {
    let entries = &pair.sequence.entries;
    let fatness = |&step: &usize| {
        entries.get(step).map_or(0.0, |entry| {
            smallest_angle(corners(axis, entry.side.triangle))
        })
    };
    let step = STEPS
        .max_by(|a, b| fatness(a).total_cmp(&fatness(b)))
        .unwrap_or(0);
    let lambda0 = entries[step].side;
    let delta = lambda0.triangle;
    let mut panel = backdrop(blocking, axis, pair, delta);
    draw_curves(&mut panel, axis, pair, step);
    let p = axis.point(axis.triangulation.apex(lambda0));
    let [a, b] = axis
        .triangulation
        .ends(pair.sequence.start)
        .map(|corner| axis.point(corner));
    let start = centroid(axis, pair.sequence.start.triangle);
    name_points(&mut panel, start, &[(a, "a"), (b, "b")]);
    name_points(&mut panel, middle(axis, lambda0), &[(p, "p")]);
    let (lambda1, lambda2) = (lambda0.next(), lambda0.next().next());
    let sides = [(lambda0, "λ = λ0"), (lambda1, "λ1"), (lambda2, "λ2")];
    name_sides(&mut panel, axis, &sides);
    name_triangle(&mut panel, axis, delta);
    panel
}

/// The triangulation near the first triangles of the arc, with Δ filled.
fn backdrop(
    blocking: &Blocking,
    axis: &SampledAxis<'_>,
    pair: &BlockPair,
    delta: TriangleId,
) -> Panel {
    let near = pair
        .sequence
        .triangles()
        .take(STEPS.end)
        .flat_map(|(id, _)| corners(axis, id));
    let window = square(Window::around(near).widened(0.12));
    let mut panel = Panel::new(window).width(360.0);
    vide::picture::draw_walls(&mut panel, blocking);
    draw_triangulation(&mut panel, axis);
    panel.layer("delta", CHOSEN).polygon(corners(axis, delta));
    panel
}

/// The window made as high as wide, so that panels match.
fn square(window: Window) -> Window {
    let (low, high) = (DVec2::from(window.low), DVec2::from(window.high));
    let reach = DVec2::splat((high - low).max_element() / 2.0);
    Window::new(low.midpoint(high) - reach, low.midpoint(high) + reach)
}

/// Draws the curves as they are once the first `steps` triangles after the start have been entered.
fn draw_curves(panel: &mut Panel, axis: &SampledAxis<'_>, pair: &BlockPair, steps: usize) {
    let is_wall = |side| axis.triangulation.across(side) == Across::Wall;
    let entered = || {
        pair.sequence
            .entries
            .iter()
            .take(steps)
            .map(|entry| entry.side)
    };
    let c1 = 1 + entered().filter(|side| is_wall(side.next())).count();
    let c2 = 1 + entered().filter(|side| is_wall(side.next().next())).count();
    for (name, stroke, curve, known) in [("C1", C1, &pair.c1, c1), ("C2", C2, &pair.c2, c2)] {
        let points: Vec<DVec2> = curve
            .iter()
            .take(known)
            .map(|&corner| axis.point(corner))
            .collect();
        draw_curve(panel, name, stroke, &points);
    }
    draw_curve(panel, "M", AXIS, &pair.m[..=steps.min(pair.m.len() - 1)]);
}

fn draw_curve(panel: &mut Panel, name: &str, stroke: Stroke, points: &[DVec2]) {
    let layer = panel.layer(name, Style::line(stroke));
    layer.polyline(points.iter().copied());
    for &point in points {
        layer.dot(point, 3.2);
    }
}

fn name_points(panel: &mut Panel, from: DVec2, points: &[(DVec2, &str)]) {
    let layer = panel.layer("points", Style::area(Color::INK));
    for &(point, name) in points {
        layer.dot(point, 3.0);
        layer.text(point, nudge(point - from, 14.0), Anchor::Middle, name);
    }
}

/// Names sides on their right, outside the triangle.
fn name_sides(panel: &mut Panel, axis: &SampledAxis<'_>, sides: &[(SideId, &str)]) {
    let layer = panel.layer("sides", Style::line(Stroke::medium(Color::INK)));
    for &(side, name) in sides {
        let [a, b] = axis
            .triangulation
            .ends(side)
            .map(|corner| axis.point(corner));
        layer.polyline([a, b]);
        layer.text(
            a.lerp(b, 0.4),
            nudge(-(b - a).perp(), 16.0),
            Anchor::Middle,
            name,
        );
    }
}

fn name_triangle(panel: &mut Panel, axis: &SampledAxis<'_>, triangle: TriangleId) {
    panel.layer("name", Style::area(Color::BLUE)).text(
        centroid(axis, triangle),
        [0.0; 2],
        Anchor::Middle,
        "Δ",
    );
}

fn nudge(towards: DVec2, pixels: f64) -> [f64; 2] {
    (towards.normalize_or(DVec2::Y) * pixels).to_array()
}

fn middle(axis: &SampledAxis<'_>, side: SideId) -> DVec2 {
    let [a, b] = axis
        .triangulation
        .ends(side)
        .map(|corner| axis.point(corner));
    a.midpoint(b)
}

/// Smallest angle of a triangle in radians.
fn smallest_angle(corners: [DVec2; 3]) -> f64 {
    let at = |k: usize| {
        (corners[(k + 1) % 3] - corners[k])
            .angle_to(corners[(k + 2) % 3] - corners[k])
            .abs()
    };
    at(0).min(at(1)).min(at(2))
}

fn centroid(axis: &SampledAxis<'_>, triangle: TriangleId) -> DVec2 {
    corners(axis, triangle).into_iter().sum::<DVec2>() / 3.0
}

fn summary(pairs: &[BlockPair]) -> String {
    // Every boundary triangle extends M and exactly one of C1 and C2.
    let balanced = pairs
        .iter()
        .all(|pair| pair.c1.len() + pair.c2.len() == pair.m.len());
    Table::new("Algorithm 2", ["", "paper", "ours"])
        .row(["pairs of blocks", "-", &pairs.len().to_string()])
        .row([
            "each boundary triangle extends M and one of C1 and C2",
            "yes",
            if balanced { "yes" } else { "no" },
        ])
        .to_string()
}
