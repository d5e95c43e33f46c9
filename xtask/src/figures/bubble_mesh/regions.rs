//! Figures 3 to 6: four regions, generated and optimized (§4).

use bubble_mesh::paper::{Params, generate, initial_bubbles, optimize};
use bubble_mesh::{Bubble, radius_ratio};
use delaunay_core::measure::{AngleSummary, Statistics};
use delaunay_core::progress::silent;
use delaunay_core::{FaceId, Subcomplex2};
use fixtures::outlines;
use glam::DVec2;
use mesh_io::PlanarGraph;
use mesh_io::svg::{Color, Panel, Picture, Stroke, Style, Window};

use super::histogram::{self, Field};
use super::outline::domain_of_graph;
use crate::figures::table::{Table, grouped};
use crate::figures::{Render, Rendered};

const EDGE: Stroke = Stroke::thin(Color::INK);
const BUBBLE: Stroke = Stroke::thin(Color::BLUE);

/// Below this radius ratio the paper finds a triangle to be of low quality.
const LOW: f64 = 0.7;

/// Figure 3.
pub(super) fn circle() -> Render {
    figure("Figure 3: circle", outlines::circle())
}

/// Figure 4.
pub(super) fn square() -> Render {
    figure("Figure 4: square with a hole", outlines::square_with_hole())
}

/// Figure 5.
pub(super) fn rectangle() -> Render {
    figure(
        "Figure 5: rectangle with two holes",
        outlines::rectangle_with_two_holes(),
    )
}

/// Figure 6.
pub(super) fn arbitrary() -> Render {
    figure(
        "Figure 6: arbitrary region with two holes",
        outlines::arbitrary_with_two_holes(),
    )
}

fn figure(title: &str, graph: PlanarGraph) -> Render {
    let domain = domain_of_graph(graph)?;
    let params = Params::paper();
    let mesh = generate(&domain, &params, &mut silent);
    let optimized = optimize(&mesh, &params, &mut silent)?;
    let initial = initial_bubbles(&mesh, &params);
    let [before, after] = [
        (mesh.region(), &initial),
        (&optimized.region, &optimized.bubbles),
    ]
    .map(|(region, bubbles)| State { region, bubbles });
    let window = Window::around(mesh.region().points().iter().copied()).widened(0.08);

    let meshes = stacked(window, &before, &after, State::draw_mesh);
    let bubbles = stacked(window, &before, &after, State::draw_bubbles);
    let [low, high] = [before.ratios(), after.ratios()];
    let (Some(low), Some(high)) = (low, high) else {
        return Err("no triangles".into());
    };
    let picture = Picture::new(title)
        .panel(meshes.caption("Delaunay mesh above, optimized mesh below"))
        .panel(bubbles.caption("node bubbles, initial above, optimized below"))
        .panel(histograms(window, &low, &high).caption("share of the triangles by radius ratio"));
    let table = Table::new(title, ["", "Delaunay", "optimized"]);
    let rows = before.numbers(&low).into_iter().zip(after.numbers(&high));
    let table = rows.fold(table, |table, ((name, before), (_, after))| {
        table.row([name.to_owned(), before, after])
    });
    let table = table
        .row([
            "iterations".to_owned(),
            "-".to_owned(),
            optimized.iterations.to_string(),
        ])
        .row([
            "nodes held inside".to_owned(),
            "-".to_owned(),
            optimized.held.len().to_string(),
        ]);
    Ok(Rendered {
        svg: picture.to_svg()?,
        summary: format!(
            "{table}\nThe paper prints no number of iterations and no numbers of its meshes.\n"
        ),
    })
}

/// A mesh with the bubbles of its nodes.
struct State<'a> {
    region: &'a Subcomplex2,
    bubbles: &'a [Bubble],
}

impl State<'_> {
    fn ratios(&self) -> Option<Statistics<FaceId>> {
        let faces = self.region.faces();
        Statistics::of(faces.map(|f| (f, radius_ratio(self.region.triangle(f)))))
    }

    fn draw_mesh(&self, panel: &mut Panel, shift: DVec2) {
        let of_quality = |is_low: bool| {
            let triangles = self.region.faces().map(|f| self.region.triangle(f));
            let shown = triangles.filter(move |&t| (radius_ratio(t) < LOW) == is_low);
            shown.map(move |corners| corners.map(|p| p + shift))
        };
        panel
            .layer("triangles", Style::line(EDGE).filled(Color::WHITE))
            .polygons(of_quality(false));
        panel
            .layer(
                "triangles of low quality",
                Style::line(EDGE).filled(Color::ROSE),
            )
            .polygons(of_quality(true));
    }

    fn draw_bubbles(&self, panel: &mut Panel, shift: DVec2) {
        let circles = panel.layer("node bubbles", Style::line(BUBBLE));
        for bubble in self.bubbles {
            circles.circle(bubble.center + shift, bubble.radius);
        }
    }

    fn numbers(&self, ratios: &Statistics<FaceId>) -> Vec<(&'static str, String)> {
        let triangles = self.region.faces().map(|f| self.region.triangle(f));
        let low = ratios
            .smallest(usize::MAX)
            .take_while(|(_, ratio)| *ratio < LOW);
        let low = low.count();
        let share = 100.0 * low as f64 / ratios.count() as f64;
        let mut numbers = vec![
            ("nodes", grouped(self.bubbles.len())),
            ("triangles", grouped(ratios.count())),
            (
                "mean radius ratio (eq. 10)",
                format!("{:.3}", ratios.mean()),
            ),
            ("least radius ratio", format!("{:.3}", ratios.min())),
            ("radius ratios below 0.7", format!("{low} ({share:.1} %)")),
        ];
        if let Some(angles) = AngleSummary::of_triangles(triangles) {
            numbers.push(("least angle", format!("{:.1}°", angles.min)));
            numbers.push(("largest angle", format!("{:.1}°", angles.max)));
        }
        numbers
    }
}

/// A panel with two drawings of what `window` shows, the first above the other.
fn stacked<'a>(
    window: Window,
    above: &State<'a>,
    below: &State<'a>,
    draw: impl Fn(&State<'a>, &mut Panel, DVec2),
) -> Panel {
    let height = window.high[1] - window.low[1];
    let whole = Window::new(window.low, [window.high[0], window.high[1] + height]);
    let mut panel = Panel::new(whole).width(WIDTH);
    draw(above, &mut panel, DVec2::new(0.0, height));
    draw(below, &mut panel, DVec2::ZERO);
    panel
}

/// Pixels of a panel, and across a histogram.
const WIDTH: f64 = 420.0;
const HISTOGRAM_WIDTH: f64 = 300.0;

/// Histograms, each as high as what `window` shows.
fn histograms(window: Window, above: &Statistics<FaceId>, below: &Statistics<FaceId>) -> Panel {
    let sides = DVec2::from(window.high) - DVec2::from(window.low);
    let [width, height] = [HISTOGRAM_WIDTH, WIDTH * sides.y / sides.x];
    let mut panel = Panel::new(Window::new([0.0; 2], [width, 2.0 * height])).width(width);
    let tallest = histogram::tallest(above).max(histogram::tallest(below));
    for (values, title, foot) in [
        (above, "Delaunay mesh", height),
        (below, "optimized mesh", 0.0),
    ] {
        let field = Field {
            corner: [0.0, foot],
            size: [width, height],
        };
        histogram::draw(&mut panel, field, title, values, tallest);
    }
    panel
}
