//! Figure 1: level sets of the square distances π and φ, over the Voronoi diagram and the Delaunay triangulation (§3.1).
//!
//! Both functions are minima over circles (z, r) of |x − z|² − r²: π over the points, whose radius is zero, φ over the Delaunay
//! circles. So what lies below a level c is a union of discs of radius √(r² + c), and discs drawn from the highest level to the
//! lowest show all level sets as they are.

use std::error::Error;

use delaunay_core::measure::triangle::{circumcenter, circumradius};
use delaunay_core::{ConvexPolygon, Delaunay2};
use fixtures::points;
use glam::DVec2;
use mesh_io::svg::{Color, Panel, Picture, Sample, Stroke, Style, Window};
use sink_refine::tri::{phi, pi};
use sink_refine::{Sinks, sink};

use crate::figures::table::Table;
use crate::figures::{Render, Rendered};

/// The square that is shown. Points lie round it too, so that all of it is inside their hull.
const LOW: DVec2 = DVec2::ZERO;
const HIGH: DVec2 = DVec2::ONE;

/// Shades between the lowest and the highest value.
const SHADES: u32 = 9;

const LOWEST: Color = Color([0x5d, 0x86, 0xb8]);
const HIGHEST: Color = Color([0xf7, 0xfa, 0xfd]);
const COMPLEX: Stroke = Stroke::medium(Color::INK);

/// Figure 1.
pub(super) fn figure() -> Render {
    let delaunay = Delaunay2::build(&scattered())?;
    let sinks = Sinks::of(&delaunay);
    let sinks: Vec<DVec2> = sinks.triangles().map(|f| sink(&delaunay, f)).collect();
    let discs_of_pi: Vec<Disc> = delaunay.points().iter().copied().map(Disc::point).collect();
    let discs_of_phi: Vec<Disc> = delaunay
        .faces()
        .map(|f| Disc::round(delaunay.triangle(f)))
        .filter(Disc::is_seen)
        .collect();
    let depth = discs_of_phi
        .iter()
        .filter(|disc| is_shown(disc.center))
        .map(|disc| disc.squared_radius)
        .fold(0.0, f64::max);
    let step = depth / f64::from(SHADES);

    let mut left = panel("level sets of π, and the Voronoi diagram");
    draw_levels(&mut left, &discs_of_pi, step, 0);
    draw_voronoi(&mut left, &delaunay)?;
    draw_dots(&mut left, &delaunay, &sinks);
    let mut right = panel("level sets of φ, and the Delaunay triangulation");
    draw_levels(&mut right, &discs_of_phi, step, SHADES);
    let triangles = delaunay.faces().map(|f| delaunay.triangle(f));
    right
        .layer("Delaunay triangulation", Style::line(COMPLEX))
        .polygons(triangles);
    draw_dots(&mut right, &delaunay, &sinks);

    let area = |color| Sample::Area(Style::line(Stroke::thin(Color::GREY)).filled(color));
    let picture = Picture::new("Figure 1: square distances")
        .panel(left)
        .panel(right)
        .key("lowest values", area(LOWEST))
        .key("highest values", area(HIGHEST))
        .key("point, where both are 0", Sample::Dot(Color::INK))
        .key("sink", Sample::Dot(Color::RED));
    Ok(Rendered {
        svg: picture.to_svg()?,
        summary: summary(&delaunay, &sinks, [&discs_of_pi, &discs_of_phi])?,
    })
}

/// Points of a square twice as wide as the one shown, no two nearer than a seventh.
fn scattered() -> Vec<DVec2> {
    let mut kept: Vec<DVec2> = Vec::new();
    for point in points::uniform(4000, 5) {
        let point = 2.0 * point - DVec2::splat(0.5);
        if kept.iter().all(|other| other.distance(point) >= 1.0 / 7.0) && kept.len() < 100 {
            kept.push(point);
        }
    }
    kept
}

fn is_shown(point: DVec2) -> bool {
    point.cmpge(LOW).all() && point.cmple(HIGH).all()
}

/// A circle (z, r), from which x has the weighted square distance |x − z|² − r².
struct Disc {
    center: DVec2,
    squared_radius: f64,
}

impl Disc {
    fn point(center: DVec2) -> Self {
        Self {
            center,
            squared_radius: 0.0,
        }
    }

    fn round(triangle: [DVec2; 3]) -> Self {
        Self {
            center: circumcenter(triangle),
            squared_radius: circumradius(triangle).powi(2),
        }
    }

    /// Whether some of it is in the square shown.
    fn is_seen(&self) -> bool {
        let nearest = self.center.clamp(LOW, HIGH);
        nearest.distance_squared(self.center) < self.squared_radius
    }

    fn distance(&self, x: DVec2) -> f64 {
        self.center.distance_squared(x) - self.squared_radius
    }
}

fn panel(caption: &str) -> Panel {
    Panel::new(Window::new(LOW, HIGH)).caption(caption)
}

/// Draws the level sets of the minimum of weighted square distances, which has `negative` shades below zero: the shade that ends
/// at the level k·step covers what lies below.
fn draw_levels(panel: &mut Panel, discs: &[Disc], step: f64, negative: u32) {
    let corners = [
        LOW,
        DVec2::new(HIGH.x, LOW.y),
        HIGH,
        DVec2::new(LOW.x, HIGH.y),
    ];
    panel
        .layer("above all levels", Style::area(HIGHEST))
        .polygon(corners);
    for shade in (0..SHADES - 1).rev() {
        let level = (f64::from(shade + 1) - f64::from(negative)) * step;
        let share = f64::from(shade) / f64::from(SHADES - 1);
        let style = Style::area(LOWEST.mixed(HIGHEST, share));
        let layer = panel.layer(&format!("below level {}", shade + 1), style);
        for disc in discs {
            let squared_radius = disc.squared_radius + level;
            if squared_radius > 0.0 {
                layer.circle(disc.center, squared_radius.sqrt());
            }
        }
    }
}

fn draw_voronoi(panel: &mut Panel, delaunay: &Delaunay2) -> Result<(), Box<dyn Error>> {
    // Cells are cut off a little outside, where the cut is not seen.
    let window = ConvexPolygon::rectangle(LOW - DVec2::ONE, HIGH + DVec2::ONE)?;
    let cells = delaunay.vertices();
    let cells = cells.map(|v| delaunay.voronoi().cell(v, &window).corners().to_vec());
    panel
        .layer("Voronoi diagram", Style::line(COMPLEX))
        .polygons(cells);
    Ok(())
}

fn draw_dots(panel: &mut Panel, delaunay: &Delaunay2, sinks: &[DVec2]) {
    for (name, color, dots) in [
        ("points", Color::INK, delaunay.points()),
        ("sinks", Color::RED, sinks),
    ] {
        let layer = panel.layer(name, Style::area(color));
        for &dot in dots.iter().filter(|&&dot| is_shown(dot)) {
            layer.dot(dot, 3.5);
        }
    }
}

fn summary(
    delaunay: &Delaunay2,
    sinks: &[DVec2],
    [of_pi, of_phi]: [&[Disc]; 2],
) -> Result<String, Box<dyn Error>> {
    let shown: Vec<DVec2> = sinks.iter().copied().filter(|&z| is_shown(z)).collect();
    let given = delaunay.points().iter().filter(|&&a| is_shown(a)).count();
    let mut table = Table::new("Figure 1: square distances", ["", "π", "φ"])
        .row(["points shown", &given.to_string(), "the same"])
        .row(["sinks shown", &shown.len().to_string(), "the same"]);
    let mut values = Vec::new();
    let mut apart = [0.0_f64; 2];
    for x in samples() {
        let exact = [pi(delaunay, x)?, phi(delaunay, x)?.unwrap_or(f64::NAN)];
        let drawn = [of_pi, of_phi].map(|discs| lowest(discs, x));
        for k in 0..2 {
            apart[k] = apart[k].max((exact[k] - drawn[k]).abs());
        }
        values.push(exact);
    }
    let extreme = |k: usize, pick: fn(f64, f64) -> f64| {
        let values = values.iter().map(|of| of[k]);
        format!("{:.4}", values.fold(f64::NAN, pick))
    };
    let [high, low] = [of_pi, of_phi].map(|discs| {
        let values = shown.iter().map(|&z| lowest(discs, z).abs());
        format!("{:.4}", values.fold(0.0, f64::max))
    });
    table = table
        .row([
            "least of a grid of samples",
            &extreme(0, f64::min),
            &extreme(1, f64::min),
        ])
        .row(["greatest", &extreme(0, f64::max), &extreme(1, f64::max)])
        .row(["farthest from 0 at a sink", &high, &format!("-{low}")])
        .row([
            "drawn and computed values differ by less than 1e-9",
            &(apart[0] < 1e-9).to_string(),
            &(apart[1] < 1e-9).to_string(),
        ]);
    Ok(table.to_string())
}

/// The least weighted square distance.
fn lowest(discs: &[Disc], x: DVec2) -> f64 {
    let distances = discs.iter().map(|disc| disc.distance(x));
    distances.fold(f64::INFINITY, f64::min)
}

/// A grid of points of the square shown.
fn samples() -> impl Iterator<Item = DVec2> {
    const COUNT: u32 = 120;
    let at = |k: u32| (f64::from(k) + 0.5) / f64::from(COUNT);
    (0..COUNT * COUNT).map(move |k| LOW + (HIGH - LOW) * DVec2::new(at(k % COUNT), at(k / COUNT)))
}
