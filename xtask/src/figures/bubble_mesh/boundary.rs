//! Bubbles of a boundary and the mesh that they lead to, in a convex region.

use bubble_mesh::paper::{Mesh, Params, generate};
use bubble_mesh::{Bubble, Domain, bubble_density, radius_ratio};
use delaunay_core::measure::{Statistics, triangle};
use delaunay_core::progress::silent;
use delaunay_core::{FaceId, Subcomplex2};
use glam::DVec2;
use mesh_io::svg::{Color, Panel, Picture, Sample, Stroke, Style, Window};

use super::outline::domain_of_loop;
use crate::figures::shades::Shades;
use crate::figures::table::Table;
use crate::figures::{Render, Rendered};

const EDGE: Stroke = Stroke::thin(Color::INK);
const NODE_BUBBLE: Stroke = Stroke::medium(Color::BLUE);
const ELEMENT_BUBBLE: Stroke = Stroke::medium(Color::RED);

const DENSITY: Shades = Shades::LACK_IS_RED;

/// The bubbles of a boundary and the mesh.
pub(super) fn figure() -> Render {
    let domain = domain_of_loop(boundary())?;
    let mesh = generate(&domain, &Params::paper(), &mut silent);
    let (start, end) = (State::of_domain(&domain), State::of_mesh(&mesh));

    let mut left = start.panel().caption("the nodes of the boundary");
    start.draw_element_bubbles(&mut left);
    start.draw_node_bubbles(&mut left);
    let mut right = end.panel().caption("the mesh and its nodes");
    end.draw_node_bubbles(&mut right);

    let area = |color| Sample::Area(Style::line(EDGE).filled(color));
    let picture = Picture::new("Bubbles")
        .panel(left)
        .panel(right)
        .key("node bubble", Sample::Line(NODE_BUBBLE))
        .key("element bubble", Sample::Line(ELEMENT_BUBBLE))
        .key("bubble density 0", area(DENSITY.none))
        .key("1", area(Color::WHITE))
        .key("2 and more", area(DENSITY.twice));
    Ok(Rendered {
        svg: picture.to_svg()?,
        summary: summary(&start, &end, &mesh),
    })
}

/// Nodes on the outline of an egg, at its tip seven times as close as where they are sparsest.
fn boundary() -> Vec<DVec2> {
    const NODES: u32 = 38;
    (0..NODES)
        .map(|i| on_egg((2.0 * f64::from(i) + 1.3) / f64::from(NODES) - 1.0))
        .collect()
}

/// The point of the egg at the angle 2 arctan t with t from `s` in (-1, 1), by arithmetic that has the same bits on every machine.
fn on_egg(s: f64) -> DVec2 {
    let t = 0.5 * s / (1.0 - s.abs());
    let (cos, sin) = ((1.0 - t * t) / (1.0 + t * t), 2.0 * t / (1.0 + t * t));
    DVec2::new(1.4 * cos, (1.0 - 0.2 * cos) * sin)
}

/// A triangulation with the bubbles of its nodes.
struct State<'a> {
    region: &'a Subcomplex2,
    bubbles: &'a [Bubble],
}

impl<'a> State<'a> {
    fn of_domain(domain: &'a Domain) -> Self {
        Self {
            region: domain.region(),
            bubbles: domain.bubbles(),
        }
    }

    fn of_mesh(mesh: &'a Mesh) -> Self {
        Self {
            region: mesh.region(),
            bubbles: mesh.bubbles(),
        }
    }

    /// The bubbles of the corners of a triangle.
    fn corners(&self, f: FaceId) -> [Bubble; 3] {
        let vertices = self.region.mesh().face_vertices(f);
        vertices.map(|v| self.bubbles[v.index()])
    }

    /// The bubble of a triangle.
    fn element(&self, f: FaceId) -> Bubble {
        Bubble::of_element(self.corners(f))
    }

    fn density(&self, f: FaceId) -> f64 {
        bubble_density(self.corners(f))
    }

    /// A panel with the triangles coloured by bubble density.
    fn panel(&self) -> Panel {
        let window = Window::around(self.region.points().iter().copied());
        let mut panel = Panel::new(window.widened(0.06)).width(480.0);
        let triangle = |f| (self.region.triangle(f), self.density(f));
        let triangles: Vec<_> = self.region.faces().map(triangle).collect();
        DENSITY.draw(&mut panel, "triangles of density", EDGE, &triangles);
        panel
    }

    fn draw_element_bubbles(&self, panel: &mut Panel) {
        let elements = panel.layer("element bubbles", Style::line(ELEMENT_BUBBLE));
        for bubble in self.region.faces().map(|f| self.element(f)) {
            elements.circle(bubble.center, bubble.radius);
        }
    }

    fn draw_node_bubbles(&self, panel: &mut Panel) {
        let nodes = panel.layer("node bubbles", Style::line(NODE_BUBBLE));
        for bubble in self.bubbles {
            nodes.circle(bubble.center, bubble.radius);
        }
    }
}

fn summary(start: &State<'_>, end: &State<'_>, mesh: &Mesh) -> String {
    let [before, after] = [start, end].map(numbers);
    let table = Table::new("Bubbles", ["", "boundary", "mesh"]);
    before
        .into_iter()
        .zip(after)
        .fold(table, |table, ((name, before), (_, after))| {
            table.row([name.to_owned(), before, after])
        })
        .row(["stopped because", "-", &format!("{:?}", mesh.stop())])
        .to_string()
}

fn numbers(state: &State<'_>) -> Vec<(&'static str, String)> {
    let faces = || state.region.faces();
    let shape = |f| state.region.triangle(f);
    let area: f64 = faces().map(|f| triangle::area(shape(f))).sum();
    let covered: f64 = faces().map(|f| state.element(f).area()).sum();
    let mut numbers = vec![
        ("nodes", state.bubbles.len().to_string()),
        ("triangles", faces().count().to_string()),
        ("area of the region", format!("{area:.3}")),
        (
            "area of the element bubbles (eq. 6)",
            format!("{covered:.3}"),
        ),
    ];
    let radii = state.bubbles.iter().map(|bubble| bubble.radius);
    if let Some(radii) = Statistics::of(radii.enumerate()) {
        numbers.push((
            "smallest node bubble, radius",
            format!("{:.3}", radii.min()),
        ));
        numbers.push(("largest node bubble, radius", format!("{:.3}", radii.max())));
    }
    if let Some(densities) = Statistics::of(faces().map(|f| (f, state.density(f)))) {
        numbers.push((
            "least bubble density (eq. 5)",
            format!("{:.3}", densities.min()),
        ));
    }
    if let Some(ratios) = Statistics::of(faces().map(|f| (f, radius_ratio(shape(f))))) {
        numbers.push((
            "mean radius ratio (eq. 10)",
            format!("{:.3}", ratios.mean()),
        ));
        numbers.push(("least radius ratio", format!("{:.3}", ratios.min())));
    }
    numbers
}
