//! Figure 5: prestar and star of a point, and their flowers (§4.1, §4.2).

use delaunay_core::measure::triangle::{circumcenter, circumradius};
use delaunay_core::{Cavity, Delaunay2, FaceId, Subcomplex2};
use fixtures::points;
use glam::DVec2;
use mesh_io::svg::{Color, Panel, Picture, Sample, Stroke, Style, Window};
use sink_refine::{Sinks, sink};

use crate::figures::table::Table;
use crate::figures::{Render, Rendered};

const EDGE: Stroke = Stroke::thin(Color::GREY);
const BOLD: Stroke = Stroke {
    color: Color::INK,
    width: 1.8,
    dotted: false,
};
const PRESTAR_FLOWER: Color = Color::SKY;
const GROWTH: Color = Color([0x8f, 0xb2, 0xd9]);

/// Where the sink is looked for, and half a side of what is shown round it.
const MIDDLE: DVec2 = DVec2::splat(0.5);
const NEAR: f64 = 0.25;
const REACH: f64 = 0.27;

/// Figure 5.
pub(super) fn figure() -> Render {
    let delaunay = Delaunay2::build(&scattered())?;
    let before = Subcomplex2::of(&delaunay, |_| true);
    let insertion = Insertion::of(before)?;
    let area = |color| Sample::Area(Style::line(EDGE).filled(color));
    let picture = Picture::new("Figure 5: flowers")
        .panel(insertion.before_panel())
        .panel(insertion.after_panel())
        .key("flower of the prestar", area(PRESTAR_FLOWER))
        .key("what the flower of the star has more", area(GROWTH))
        .key("edge of the prestar, of the star", Sample::Line(BOLD))
        .key("sink inserted", Sample::Dot(Color::RED));
    Ok(Rendered {
        svg: picture.to_svg()?,
        summary: insertion.summary(),
    })
}

/// Points of the unit square, no two nearer than an eleventh.
fn scattered() -> Vec<DVec2> {
    let mut kept: Vec<DVec2> = Vec::new();
    for point in points::uniform(70, 5) {
        if kept.iter().all(|other| other.distance(point) >= 1.0 / 11.0) {
            kept.push(point);
        }
    }
    kept
}

/// A sink that becomes a vertex.
struct Insertion {
    sink: DVec2,
    before: Subcomplex2,
    prestar: Vec<FaceId>,
    after: Subcomplex2,
    star: Vec<FaceId>,
}

impl Insertion {
    /// That of the sink not far from the middle that has the most triangles in its prestar.
    fn of(before: Subcomplex2) -> Result<Self, Box<dyn std::error::Error>> {
        let sinks = Sinks::of(&before);
        let near = sinks
            .triangles()
            .filter(|&f| sink(&before, f).distance(MIDDLE) < NEAR);
        let prestar = |f: FaceId| {
            let mut cavity = Cavity::default();
            let inside = before.dig(sink(&before, f), f, &mut cavity);
            inside.then_some((f, cavity))
        };
        let largest = near
            .filter_map(prestar)
            .max_by_key(|(_, cavity)| cavity.faces().len());
        let (seed, mut cavity) = largest.ok_or("no sink that can be inserted")?;
        let sink = sink(&before, seed);
        let prestar = cavity.faces().to_vec();
        let mut after = before.clone();
        after.fill(sink, &mut cavity).ok_or("no ids")?;
        let star = cavity.faces().to_vec();
        Ok(Self {
            sink,
            before,
            prestar,
            after,
            star,
        })
    }

    fn before_panel(&self) -> Panel {
        let mut panel = self.panel("before: the prestar of the sink and its flower");
        draw_flower(
            &mut panel,
            "flower of the prestar",
            PRESTAR_FLOWER,
            &self.before,
            &self.prestar,
        );
        draw_triangles(&mut panel, &self.before, &self.prestar);
        self.draw_sink(&mut panel);
        panel
    }

    fn after_panel(&self) -> Panel {
        let mut panel = self.panel("after: the star, whose flower is larger");
        draw_flower(
            &mut panel,
            "flower of the star",
            GROWTH,
            &self.after,
            &self.star,
        );
        draw_flower(
            &mut panel,
            "flower of the prestar",
            PRESTAR_FLOWER,
            &self.before,
            &self.prestar,
        );
        draw_triangles(&mut panel, &self.after, &self.star);
        self.draw_sink(&mut panel);
        panel
    }

    fn panel(&self, caption: &str) -> Panel {
        let reach = DVec2::splat(REACH);
        Panel::new(Window::new(self.sink - reach, self.sink + reach)).caption(caption)
    }

    fn draw_sink(&self, panel: &mut Panel) {
        panel
            .layer("sink", Style::area(Color::RED))
            .dot(self.sink, 4.0);
    }

    fn summary(&self) -> String {
        let [small, large] =
            [(&self.before, &self.prestar), (&self.after, &self.star)].map(|(region, faces)| {
                faces
                    .iter()
                    .map(|&f| region.triangle(f))
                    .collect::<Vec<_>>()
            });
        let is_in = |flower: &[[DVec2; 3]], x: DVec2| {
            flower
                .iter()
                .any(|&corners| circumcenter(corners).distance(x) < circumradius(corners))
        };
        let samples: Vec<[bool; 2]> = samples(self.sink)
            .map(|x| [is_in(&small, x), is_in(&large, x)])
            .collect();
        let count = |test: fn(&[bool; 2]) -> bool| samples.iter().filter(|x| test(x)).count();
        let share = |count: usize| format!("{:.3}", count as f64 / samples.len() as f64);
        Table::new("Figure 5: flowers", ["", "prestar", "star"])
            .row([
                "triangles".to_owned(),
                small.len().to_string(),
                large.len().to_string(),
            ])
            .row([
                "flower, share of the picture".to_owned(),
                share(count(|x| x[0])),
                share(count(|x| x[1])),
            ])
            .row([
                "samples in the flower of the prestar alone (paper: 0)",
                &count(|x| x[0] && !x[1]).to_string(),
                "-",
            ])
            .to_string()
    }
}

/// Draws the union of the circumdiscs of triangles.
fn draw_flower(
    panel: &mut Panel,
    name: &str,
    color: Color,
    region: &Subcomplex2,
    faces: &[FaceId],
) {
    let layer = panel.layer(name, Style::area(color));
    for &f in faces {
        let corners = region.triangle(f);
        layer.circle(circumcenter(corners), circumradius(corners));
    }
}

/// Draws all triangles with thin lines and some with bold ones.
fn draw_triangles(panel: &mut Panel, region: &Subcomplex2, bold: &[FaceId]) {
    let all = region.faces().map(|f| region.triangle(f));
    panel
        .layer("triangulation", Style::line(EDGE))
        .polygons(all);
    let bold = bold.iter().map(|&f| region.triangle(f));
    panel
        .layer("its triangles", Style::line(BOLD))
        .polygons(bold);
}

/// A grid of points of what is shown.
fn samples(middle: DVec2) -> impl Iterator<Item = DVec2> {
    const COUNT: u32 = 300;
    let at = |k: u32| 2.0 * (f64::from(k) + 0.5) / f64::from(COUNT) - 1.0;
    (0..COUNT * COUNT).map(move |k| middle + REACH * DVec2::new(at(k % COUNT), at(k / COUNT)))
}
