//! Figure 2: the medial axis and some of the maximal empty circles whose centres it collects.

use glam::DVec2;
use medial_blocking::Blocking;
use mesh_io::svg::{Color, Panel, Picture, Sample, Style};

use super::super::table::Table;
use super::super::{Render, Rendered};
use super::ink::{AXIS, DOTTED, domain_panel};
use super::small::three_particles;

/// Places on an arc where a circle may be shown.
const PLACES: u32 = 12;

/// A circle touches a wall when it comes nearer than this, in units of its radius.
const TOUCHING: f64 = 1e-9;

/// An empty circle: centre and radius.
#[derive(Clone, Copy)]
struct EmptyCircle {
    center: DVec2,
    radius: f64,
}

impl EmptyCircle {
    /// The circle round a point that the nearest wall stops.
    fn round(blocking: &Blocking, center: DVec2) -> Self {
        let walls = blocking.domain().walls().iter();
        Self {
            center,
            radius: walls
                .map(|wall| wall.distance(center))
                .fold(f64::INFINITY, f64::min),
        }
    }

    /// Where it touches walls.
    fn touching_points(&self, blocking: &Blocking) -> Vec<DVec2> {
        let touched = |wall: &&medial_blocking::Wall| {
            wall.distance(self.center) <= self.radius * (1.0 + TOUCHING)
        };
        let walls = blocking.domain().walls().iter().filter(touched);
        walls
            .map(|wall| {
                wall.point_towards((self.center - wall.circle.center).normalize_or(DVec2::X))
            })
            .collect()
    }
}

pub(super) fn figure() -> Render {
    let blocking = three_particles()?;
    let circles = chosen(&blocking);
    let picture = Picture::new("Medial axis")
        .panel(panel(&blocking, &circles))
        .key("medial axis", Sample::Line(AXIS))
        .key("maximal empty circle", Sample::Line(DOTTED))
        .key("touching point", Sample::Dot(Color::INK));
    Ok(Rendered {
        svg: picture.to_svg()?,
        summary: summary(&blocking, &circles),
    })
}

/// One circle that touches three walls, round the vertex in the widest place, and as many round points of arcs as fit in beside
/// it and each other.
fn chosen(blocking: &Blocking) -> Vec<EmptyCircle> {
    let widest = blocking
        .vertices()
        .iter()
        .max_by(|a, b| a.clearance.total_cmp(&b.clearance));
    let round_vertex = widest.map(|vertex| EmptyCircle {
        center: vertex.center,
        radius: vertex.clearance,
    });
    let mut circles: Vec<EmptyCircle> = round_vertex.into_iter().collect();
    let places = (1..PLACES).map(|k| f64::from(k) / f64::from(PLACES));
    let candidates = blocking
        .arcs()
        .iter()
        .flat_map(|arc| places.clone().map(|u| arc.curve.point(u)));
    for candidate in candidates.map(|center| EmptyCircle::round(blocking, center)) {
        let apart = |other: &EmptyCircle| {
            other.center.distance(candidate.center) > other.radius + candidate.radius
        };
        if circles.iter().all(apart) {
            circles.push(candidate);
        }
    }
    circles
}

fn panel(blocking: &Blocking, circles: &[EmptyCircle]) -> Panel {
    let mut panel = domain_panel(blocking).width(440.0);
    let axis = blocking
        .arcs()
        .iter()
        .map(|arc| (0..=32).map(|k| arc.curve.point(f64::from(k) / 32.0)));
    panel
        .layer("medial axis", Style::line(AXIS))
        .polylines(axis);
    let dotted = panel.layer("empty circles", Style::line(DOTTED));
    for circle in circles {
        dotted.circle(circle.center, circle.radius);
    }
    for (name, color, pixels) in [
        ("centres", Color::RED, 2.4),
        ("touching points", Color::INK, 2.6),
    ] {
        let layer = panel.layer(name, Style::area(color));
        for circle in circles {
            let points = if name == "centres" {
                vec![circle.center]
            } else {
                circle.touching_points(blocking)
            };
            for point in points {
                layer.dot(point, pixels);
            }
        }
    }
    panel
}

fn summary(blocking: &Blocking, circles: &[EmptyCircle]) -> String {
    let touching = |count: usize| {
        circles
            .iter()
            .filter(|circle| circle.touching_points(blocking).len() == count)
            .count()
            .to_string()
    };
    Table::new(
        "Maximal empty circles shown",
        ["that touch", "paper", "ours"],
    )
    .row([
        "fewer than two walls",
        "none",
        &(circles.len() - numbers(&[touching(2), touching(3)])).to_string(),
    ])
    .row(["two walls", "most", &touching(2)])
    .row(["three walls", "1", &touching(3)])
    .to_string()
}

fn numbers(texts: &[String]) -> usize {
    texts
        .iter()
        .filter_map(|text| text.parse::<usize>().ok())
        .sum()
}
