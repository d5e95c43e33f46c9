//! Figure 4: the relation τ ≺ σ between triangles, and τ ≺ ω with the dummy element outside (§3.3).

use std::error::Error;

use delaunay_core::measure::triangle::{circumcenter, circumradius};
use delaunay_core::{Delaunay2, FaceId, HalfEdgeId};
use glam::DVec2;
use mesh_io::svg::{Anchor, Color, Panel, Picture, Sample, Stroke, Style, Window};
use sink_refine::{Successor, flows_through, successor};

use crate::figures::table::Table;
use crate::figures::{Render, Rendered};

const EDGE: Stroke = Stroke::medium(Color::INK);
const LINE: Stroke = Stroke::thin(Color::INK);
const CIRCLE: Stroke = Stroke::dotted(Color::BLUE);
const ARROW: Stroke = Stroke::medium(Color::RED);

/// The obtuse triangle τ.
const TAU: [[f64; 2]; 3] = [[0.0, 0.0], [4.0, 0.0], [1.7, 1.15]];

/// A point below makes its long edge one inside, a point above one of the hull.
const BELOW: [f64; 2] = [2.6, -3.8];
const ABOVE: [f64; 2] = [2.3, 2.6];

/// Pixels from the place named to the name of what τ precedes.
const NUDGE: [[f64; 2]; 2] = [[34.0, -26.0], [90.0, -10.0]];

/// Figure 4.
pub(super) fn figure() -> Render {
    let inside = Example::of(BELOW)?;
    let outward = Example::of(ABOVE)?;
    let picture = Picture::new("Figure 4: the relation between triangles")
        .panel(
            inside
                .panel(NUDGE[0])
                .caption("the centre is on σ's side of the common edge: τ ≺ σ"),
        )
        .panel(
            outward
                .panel(NUDGE[1])
                .caption("the centre is beyond an edge of the hull: τ ≺ ω"),
        )
        .key("circumcircle of τ", Sample::Line(CIRCLE))
        .key("its centre", Sample::Dot(Color::BLUE))
        .key("flow", Sample::Line(ARROW));
    let both = [&inside, &outward];
    let table = Table::new("Figure 4: the relation", ["", "left", "right"])
        .row(row(
            "τ precedes",
            both.map(|example| example.beyond.0.to_owned()),
        ))
        .row(row(
            "circumradius of τ",
            both.map(|example| format!("{:.3}", example.radius())),
        ))
        .row(row(
            "of what it precedes, larger",
            both.map(Example::larger),
        ));
    Ok(Rendered {
        svg: picture.to_svg()?,
        summary: table.to_string(),
    })
}

fn row(name: &str, [left, right]: [String; 2]) -> [String; 3] {
    [name.to_owned(), left, right]
}

/// A triangulation of τ and one more point.
struct Example {
    delaunay: Delaunay2,
    /// The half-edge through which the flow leaves τ.
    exit: HalfEdgeId,
    /// The name of what is beyond, and the triangle if it is one.
    beyond: (&'static str, Option<FaceId>),
}

impl Example {
    fn of(other: [f64; 2]) -> Result<Self, Box<dyn Error>> {
        let [a, b, c] = TAU;
        let delaunay = Delaunay2::build(&[a, b, c, other].map(DVec2::from))?;
        let half_edges: Vec<HalfEdgeId> = delaunay.faces().flat_map(FaceId::half_edges).collect();
        let is_base = |h: &HalfEdgeId| {
            let [origin, target] = ends(&delaunay, *h);
            [origin, target] == [a, b].map(DVec2::from) && flows_through(&delaunay, *h)
        };
        let exit = half_edges.into_iter().find(is_base);
        let exit = exit.ok_or("no flow through the long edge")?;
        let beyond = match successor(&delaunay, exit.face()) {
            Successor::None => return Err("no successor".into()),
            Successor::Triangle(sigma) => ("σ", Some(sigma)),
            Successor::Outside => ("ω", None),
        };
        Ok(Self {
            delaunay,
            exit,
            beyond,
        })
    }

    fn tau(&self) -> [DVec2; 3] {
        self.delaunay.triangle(self.exit.face())
    }

    fn radius(&self) -> f64 {
        circumradius(self.tau())
    }

    /// The circumradius of what τ precedes.
    fn larger(&self) -> String {
        let triangle = self.beyond.1.map(|sigma| self.delaunay.triangle(sigma));
        triangle.map_or_else(
            || "infinite, as agreed".to_owned(),
            |corners| format!("{:.3}", circumradius(corners)),
        )
    }

    fn panel(&self, nudge: [f64; 2]) -> Panel {
        let tau = self.tau();
        let center = circumcenter(tau);
        let window = Window::new(center - DVec2::splat(3.0), center + DVec2::new(3.0, 4.0));
        let mut panel = Panel::new(window);
        let faces = self.delaunay.faces().filter(|&f| f != self.exit.face());
        panel
            .layer("triangles", Style::line(EDGE).filled(Color::MIST))
            .polygons(faces.map(|f| self.delaunay.triangle(f)));
        panel
            .layer("τ", Style::line(EDGE).filled(Color::SKY))
            .polygon(tau);
        let [a, b] = ends(&self.delaunay, self.exit);
        panel
            .layer("line through the edge", Style::line(LINE))
            .polyline([a - (b - a), b + (b - a)]);
        panel
            .layer("circumcircle of τ", Style::line(CIRCLE))
            .circle(center, circumradius(tau));
        panel
            .layer("flow", Style::line(ARROW))
            .arrow(centroid(tau), center);
        panel
            .layer("circumcentre of τ", Style::area(Color::BLUE))
            .dot(center, 3.5);
        let names = panel.layer("names", Style::area(Color::INK));
        names.text(centroid(tau), [-30.0, 2.0], Anchor::Middle, "τ");
        names.text(center, nudge, Anchor::Middle, self.beyond.0);
        panel
    }
}

fn ends(delaunay: &Delaunay2, h: HalfEdgeId) -> [DVec2; 2] {
    let mesh = delaunay.mesh();
    [mesh.origin(h), mesh.target(h)].map(|v| delaunay.point(v))
}

fn centroid([a, b, c]: [DVec2; 3]) -> DVec2 {
    (a + b + c) / 3.0
}
