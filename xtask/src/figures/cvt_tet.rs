//! Du & Wang, *Tetrahedral mesh generation and optimization based on centroidal Voronoi tessellations*: figure 1.

use std::error::Error;

use cvt_tet::{GeneratorError, Generators, Moments, Outcome, Params, lloyd, lloyd_with};
use delaunay_core::ConvexPolygon;
use delaunay_core::measure::{Statistics, triangle};
use delaunay_core::progress::silent;
use fixtures::points;
use glam::DVec2;
use mesh_io::svg::{Color, Panel, Picture, Sample, Stroke, Style, Window};

use super::shades::Shades;
use super::table::Table;
use super::{Figure, Render, Rendered};

/// Figure 1.
pub const FIGURES: &[Figure] = &[Figure {
    name: "cvt_fig1_square",
    caption: "The same random points of a square before Lloyd's iteration, and after it for a uniform density and for one that is \
              large near a curve. Cells are coloured by their share of the cost: in the end all cost about the same.",
    render: square,
}];

/// Points of the square.
const POINTS: usize = 400;

const PARAMS: Params = Params {
    iterations: 1000,
    tolerance: 1e-6,
};

const EDGE: Stroke = Stroke::thin(Color::INK);

const SHARE: Shades = Shades::EXCESS_IS_RED;

/// Large near a quarter of a circle, where cells should be small: their size goes with the square root of `size`. The paper gives none.
fn density(p: DVec2) -> f64 {
    let distance = p.length() - 0.7;
    let size = 0.01 + distance * distance;
    1.0 / (size * size)
}

fn square() -> Render {
    let square = ConvexPolygon::rectangle(DVec2::ZERO, DVec2::ONE)?;
    let start = Generators::new(square, &points::uniform(POINTS, 4))?;
    let uniform = Tessellation::uniform(&start)?;
    let graded = Tessellation::graded(&start)?;

    let area = |color| Sample::Area(Style::line(EDGE).filled(color));
    let picture = Picture::new("Centroidal Voronoi tessellations of a square")
        .panel(panel(&start, uniform_cost).caption("random points"))
        .panel(panel(&uniform.free.generators, uniform_cost).caption("uniform density"))
        .panel(panel(&graded.free.generators, graded_cost).caption("density large near a curve"))
        .key("cell that costs nothing", area(SHARE.none))
        .key("the mean", area(Color::WHITE))
        .key("twice the mean and more", area(SHARE.twice))
        .key("generator", Sample::Dot(Color::INK));
    Ok(Rendered {
        svg: picture.to_svg()?,
        summary: summary(&uniform, &graded),
    })
}

/// What a cell costs for density 1.
fn uniform_cost(cell: &ConvexPolygon, generator: DVec2) -> f64 {
    Moments::uniform(cell, generator).second
}

/// What a cell costs for the given density, zero where that is no number.
fn graded_cost(cell: &ConvexPolygon, generator: DVec2) -> f64 {
    Moments::weighted(cell, generator, density).map_or(0.0, |moments| moments.second)
}

/// What Lloyd's iteration makes of points.
struct Tessellation {
    /// Not bound to the boundary.
    free: Outcome,
    /// The same with the points of cells at the boundary moved onto it, and iterated again: the mesh of the paper's figure.
    bound: Outcome,
    cost: Cost,
}

impl Tessellation {
    fn uniform(start: &Generators) -> Result<Self, GeneratorError> {
        let free = lloyd(start.clone(), &PARAMS, &mut silent);
        let bound = lloyd(free.generators.attached()?, &PARAMS, &mut silent);
        Ok(Self {
            free,
            bound,
            cost: uniform_cost,
        })
    }

    fn graded(start: &Generators) -> Result<Self, Box<dyn Error>> {
        let free = lloyd_with(start.clone(), density, &PARAMS, &mut silent)?;
        let attached = free.generators.attached()?;
        let bound = lloyd_with(attached, density, &PARAMS, &mut silent)?;
        Ok(Self {
            free,
            bound,
            cost: graded_cost,
        })
    }
}

/// What a cell of a generator costs.
type Cost = fn(&ConvexPolygon, DVec2) -> f64;

/// A panel with the cells coloured by their cost relative to the mean, and the generators.
fn panel(generators: &Generators, cost: Cost) -> Panel {
    let mut panel = Panel::new(Window::new([0.0, 0.0], [1.0, 1.0]).widened(0.005)).width(340.0);
    let corners = |i| generators.cell(i).corners().to_vec();
    let cells: Vec<_> = shares(generators, cost)
        .into_iter()
        .enumerate()
        .map(|(i, share)| (corners(i), share))
        .collect();
    SHARE.draw(&mut panel, "cells of cost", EDGE, &cells);
    let dots = panel.layer("generators", Style::area(Color::INK));
    for &point in generators.points() {
        dots.dot(point, 1.0);
    }
    panel
}

/// The cost of every cell relative to their mean, by point.
fn shares(generators: &Generators, cost: Cost) -> Vec<f64> {
    let points = generators.points().iter().enumerate();
    let costs: Vec<f64> = points.map(|(i, &z)| cost(&generators.cell(i), z)).collect();
    let mean = costs.iter().sum::<f64>() / costs.len() as f64;
    costs.iter().map(|cost| cost / mean).collect()
}

fn summary(uniform: &Tessellation, graded: &Tessellation) -> String {
    let table = Table::new(
        "Centroidal Voronoi tessellations of a square",
        ["", "uniform density", "density large near a curve"],
    );
    let hexagons = 5.0 * 3f64.sqrt() / 54.0 / POINTS as f64;
    numbers(uniform)
        .into_iter()
        .zip(numbers(graded))
        .fold(table, |table, ((name, uniform), (_, graded))| {
            table.row([name.to_owned(), uniform, graded])
        })
        .row([
            "cost of as many regular hexagons",
            &format!("{hexagons:.3e}"),
            "-",
        ])
        .to_string()
}

fn numbers(tessellation: &Tessellation) -> Vec<(&'static str, String)> {
    let Tessellation { free, bound, cost } = tessellation;
    let mut numbers = vec![("generators", free.generators.points().len().to_string())];
    if let [before, .., after] = free.costs[..] {
        numbers.push(("cost before", format!("{before:.3e}")));
        numbers.push(("cost after", format!("{after:.3e}")));
    }
    numbers.push(("iterations", free.costs.len().saturating_sub(1).to_string()));
    numbers.push(("stopped because", format!("{:?}", free.stop)));
    let shares = shares(&free.generators, *cost).into_iter().enumerate();
    if let Some(shares) = Statistics::of(shares) {
        numbers.push(("cheapest cell, of the mean", format!("{:.2}", shares.min())));
        numbers.push(("dearest cell, of the mean", format!("{:.2}", shares.max())));
    }
    let mesh = &bound.generators;
    let ratio = |f| (f, triangle::radius_ratio(mesh.delaunay().triangle(f)));
    if let Some(ratios) = Statistics::of(mesh.triangles().map(ratio)) {
        numbers.push((
            "with points on the boundary: triangles",
            ratios.count().to_string(),
        ));
        numbers.push(("their mean radius ratio", format!("{:.3}", ratios.mean())));
        numbers.push(("their least radius ratio", format!("{:.3}", ratios.min())));
    }
    numbers
}
