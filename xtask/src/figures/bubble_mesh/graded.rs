//! The regions of figures 3 to 6 again: the paper's optimized meshes beside what goes beyond it.

use std::error::Error;

use bubble_mesh::graded::{GradedParams, mesh};
use bubble_mesh::paper::{Params, generate, optimize};
use bubble_mesh::{Domain, Resampling, radius_ratio, resample};
use delaunay_core::measure::{AngleSummary, Statistics};
use delaunay_core::progress::silent;
use delaunay_core::{BuildOptions, Outline};
use fixtures::outlines;
use glam::DVec2;
use mesh_io::PlanarGraph;
use mesh_io::svg::{Color, Panel, Picture, Stroke, Style, Window};

use super::histogram::{self, Field};
use super::outline::domain_of_graph;
use crate::figures::table::{Table, grouped};
use crate::figures::{Render, Rendered};

const EDGE: Stroke = Stroke::thin(Color::INK);

/// Below this radius ratio the paper finds a triangle to be of low quality.
const LOW: f64 = 0.7;

/// Changes of connectivity, where they are tried.
const TRIALS: usize = 1000;

/// The region of figure 3.
pub(super) fn circle() -> Render {
    figure("The circle beyond the paper", outlines::circle())
}

/// The region of figure 4.
pub(super) fn square() -> Render {
    figure("The square beyond the paper", outlines::square_with_hole())
}

/// The region of figure 5.
pub(super) fn rectangle() -> Render {
    figure(
        "The rectangle beyond the paper",
        outlines::rectangle_with_two_holes(),
    )
}

/// The region of figure 6.
pub(super) fn arbitrary() -> Render {
    figure(
        "The arbitrary region beyond the paper",
        outlines::arbitrary_with_two_holes(),
    )
}

fn figure(title: &str, graph: PlanarGraph) -> Render {
    let domain = domain_of_graph(graph)?;
    let usual = GradedParams::default();
    let searched = GradedParams {
        trials: TRIALS,
        ..usual
    };
    let sliding = GradedParams {
        sliding: Some(Resampling::default().crease),
        ..usual
    };
    let meshes = [
        ("the paper", by_the_paper(&domain)?),
        ("graded", graded(&domain, &usual)?),
        ("1,000 trials", graded(&domain, &searched)?),
        ("nodes slide", graded(&domain, &sliding)?),
        ("nodes anew", graded(&sampled_anew(&domain)?, &usual)?),
    ];
    let window = Window::around(domain.region().points().iter().copied()).widened(0.04);
    let [(_, paper), (_, ours), ..] = &meshes;
    let picture = Picture::new(title)
        .panel(drawn(window, paper).caption("the paper's method, 200 iterations"))
        .panel(drawn(window, ours).caption("graded, nodes of the boundary fixed"))
        .panel(histograms(paper, ours)?.caption("share of the triangles by radius ratio"));
    let mut table = Table::new(
        title,
        ["", "triangles", "mean", "least", "below 0.7", "angles"],
    );
    for (name, triangles) in &meshes {
        table = table.row(row(name, triangles)?);
    }
    Ok(Rendered {
        svg: picture.to_svg()?,
        summary: format!("{table}\nMean and least are of the radius ratio (eq. 10).\n"),
    })
}

type Triangles = Vec<[DVec2; 3]>;

fn by_the_paper(domain: &Domain) -> Result<Triangles, Box<dyn Error>> {
    let params = Params::paper();
    let generated = generate(domain, &params, &mut silent);
    let region = optimize(&generated, &params, &mut silent)?.region;
    Ok(region.faces().map(|f| region.triangle(f)).collect())
}

fn graded(domain: &Domain, params: &GradedParams) -> Result<Triangles, Box<dyn Error>> {
    let complex = mesh(domain, params, &mut silent)?.complex;
    Ok(complex.faces().map(|f| complex.triangle(f)).collect())
}

/// The domain with its boundary sampled anew.
fn sampled_anew(domain: &Domain) -> Result<Domain, Box<dyn Error>> {
    let segments: Vec<_> = domain.segments().collect();
    let anew = resample(
        domain.region().points(),
        &segments,
        |_, _| true,
        &Resampling::default(),
    )?;
    let outline = Outline::new(anew.points, anew.segments)?;
    Ok(Domain::new(&outline, BuildOptions::default(), &mut silent)?)
}

fn ratios(triangles: &Triangles) -> Result<Statistics<usize>, Box<dyn Error>> {
    let ratios = triangles.iter().copied().map(radius_ratio);
    Statistics::of(ratios.enumerate()).ok_or_else(|| "no triangles".into())
}

fn row(name: &str, triangles: &Triangles) -> Result<[String; 6], Box<dyn Error>> {
    let ratios = ratios(triangles)?;
    let low = triangles.iter().filter(|&&t| radius_ratio(t) < LOW).count();
    let angles = AngleSummary::of_triangles(triangles.iter().copied()).ok_or("no angles")?;
    Ok([
        name.to_owned(),
        grouped(triangles.len()),
        format!("{:.4}", ratios.mean()),
        format!("{:.3}", ratios.min()),
        low.to_string(),
        format!("{:.1}° to {:.1}°", angles.min, angles.max),
    ])
}

fn drawn(window: Window, triangles: &Triangles) -> Panel {
    let mut panel = Panel::new(window).width(WIDTH);
    for (name, color, is_low) in [
        ("triangles", Color::WHITE, false),
        ("triangles of low quality", Color::ROSE, true),
    ] {
        let shown = triangles.iter().copied();
        let shown = shown.filter(|&t| (radius_ratio(t) < LOW) == is_low);
        panel
            .layer(name, Style::line(EDGE).filled(color))
            .polygons(shown);
    }
    panel
}

/// Pixels of a panel, and of the two histograms.
const WIDTH: f64 = 420.0;
const HISTOGRAM: [f64; 2] = [300.0, 200.0];

fn histograms(paper: &Triangles, ours: &Triangles) -> Result<Panel, Box<dyn Error>> {
    let [width, height] = HISTOGRAM;
    let mut panel = Panel::new(Window::new([0.0; 2], [width, 2.0 * height])).width(width);
    let [paper, ours] = [ratios(paper)?, ratios(ours)?];
    let tallest = histogram::tallest(&paper).max(histogram::tallest(&ours));
    for (values, title, foot) in [(&paper, "the paper", height), (&ours, "graded", 0.0)] {
        let field = Field {
            corner: [0.0, foot],
            size: HISTOGRAM,
        };
        histogram::draw(&mut panel, field, title, values, tallest);
    }
    Ok(panel)
}
