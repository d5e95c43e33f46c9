//! Figure 1: a node at a centroid, its cavity and its star (§2.2).
//!
//! ```text
//!       g ------- l         The triangle def is on the other side of a slot in the region. The circle through its
//!      / \ \    /   \       corners contains the new node, but no triangles between are there to be crossed.
//!     /   b -- d --- k
//!    a  p |    |\   /|
//!      \  |    | f - j
//!         c    e /
//! ```

use std::error::Error;

use bubble_mesh::{Domain, centroid};
use delaunay_core::measure::triangle::{circumcenter, circumradius};
use delaunay_core::{Cavity, FaceId, Subcomplex2, VertexId};
use glam::DVec2;
use mesh_io::svg::{Anchor, Color, Panel, Picture, Sample, Stroke, Style, Window};

use super::outline::domain_of_loop;
use crate::figures::table::Table;
use crate::figures::{Render, Rendered};

const EDGE: Stroke = Stroke::medium(Color::INK);
const CIRCLE: Stroke = Stroke::thin(Color::GREY);
const FAR_CIRCLE: Stroke = Stroke::medium(Color::RED);

/// Corners round the region, and f in its inside.
const ROUND: [(&str, [f64; 2]); 10] = [
    ("a", [-2.0, 0.0]),
    ("c", [0.0, -1.0]),
    ("b", [0.0, 1.0]),
    ("d", [0.6, 0.62]),
    ("e", [0.6, -0.62]),
    ("f", [0.87, 0.1]),
    ("j", [1.8, -0.8]),
    ("k", [1.85, 0.95]),
    ("l", [0.7, 1.8]),
    ("g", [-1.35, 1.3]),
];

/// Figure 1.
pub(super) fn figure() -> Render {
    let insertion = Insertion::new()?;
    let area = |color| Sample::Area(Style::line(EDGE).filled(color));
    let picture = Picture::new("Figure 1: insertion of a node")
        .panel(insertion.before_panel())
        .panel(insertion.after_panel())
        .key("cavity of the node, its star", area(Color::SKY))
        .key("in conflict, but far", area(Color::ROSE))
        .key("new node", Sample::Dot(Color::RED));
    Ok(Rendered {
        svg: picture.to_svg()?,
        summary: insertion.summary(),
    })
}

/// The node p at the centroid of abc.
struct Insertion {
    node: DVec2,
    before: Subcomplex2,
    cavity: Vec<FaceId>,
    after: Subcomplex2,
    star: Vec<FaceId>,
}

impl Insertion {
    fn new() -> Result<Self, Box<dyn Error>> {
        let domain: Domain = domain_of_loop(ROUND.map(|(_, place)| place.into()).to_vec())?;
        let before = domain.region().clone();
        let seed = before.faces().find(|&f| name(&before, f) == "abc");
        let seed = seed.ok_or("no triangle abc")?;
        let node = centroid(before.triangle(seed));
        let mut cavity = Cavity::default();
        if !before.dig(node, seed, &mut cavity) {
            return Err("the centroid is inside".into());
        }
        let dug = cavity.faces().to_vec();
        let mut after = before.clone();
        after.fill(node, &mut cavity).ok_or("no ids")?;
        Ok(Self {
            node,
            before,
            cavity: dug,
            after,
            star: cavity.faces().to_vec(),
        })
    }

    /// All triangles whose circumcircles contain the node.
    fn in_conflict(&self) -> impl Iterator<Item = FaceId> + '_ {
        let faces = self.before.faces();
        faces.filter(|&f| self.before.in_conflict(self.node, f))
    }

    fn before_panel(&self) -> Panel {
        let mut panel = panel("before: circles that contain p, and the cavity");
        let far = |f: &FaceId| !self.cavity.contains(f);
        draw(&mut panel, &self.before, &self.cavity, Color::SKY);
        let distant: Vec<FaceId> = self.in_conflict().filter(far).collect();
        draw(&mut panel, &self.before, &distant, Color::ROSE);
        self.draw_circles(&mut panel, "circumcircles", CIRCLE, &self.cavity);
        self.draw_circles(&mut panel, "far circumcircle", FAR_CIRCLE, &distant);
        self.draw_names(&mut panel);
        panel
    }

    fn after_panel(&self) -> Panel {
        let mut panel = panel("after: the star of p");
        draw(&mut panel, &self.after, &self.star, Color::SKY);
        self.draw_names(&mut panel);
        panel
    }

    fn draw_circles(&self, panel: &mut Panel, name: &str, stroke: Stroke, faces: &[FaceId]) {
        let circles = panel.layer(name, Style::line(stroke));
        for corners in faces.iter().map(|&f| self.before.triangle(f)) {
            circles.circle(circumcenter(corners), circumradius(corners));
        }
    }

    fn draw_names(&self, panel: &mut Panel) {
        let dot = panel.layer("new node", Style::area(Color::RED));
        dot.dot(self.node, 4.0);
        let names = panel.layer("names", Style::area(Color::INK));
        for (name, place) in ROUND {
            let outward = DVec2::from(place) - DVec2::new(0.3, 0.2);
            let nudge = 11.0 * outward.normalize_or_zero();
            names.text(place, [nudge.x, nudge.y - 4.0], Anchor::Middle, name);
        }
        names.text(self.node, [8.0, -10.0], Anchor::Middle, "p");
    }

    fn summary(&self) -> String {
        let names = |region: &Subcomplex2, faces: &[FaceId]| {
            let mut names: Vec<String> = faces.iter().map(|&f| name(region, f)).collect();
            names.sort_unstable();
            names.join(", ")
        };
        let conflicting: Vec<FaceId> = self.in_conflict().collect();
        Table::new(
            "Figure 1: insertion of a node",
            ["triangles", "paper", "ours"],
        )
        .row([
            "in conflict with p",
            "abc, abg, def",
            &names(&self.before, &conflicting),
        ])
        .row([
            "of the cavity",
            "abc, abg",
            &names(&self.before, &self.cavity),
        ])
        .row([
            "of the star",
            "pac, pag, pbc, pbg",
            &names(&self.after, &self.star),
        ])
        .to_string()
    }
}

fn panel(caption: &str) -> Panel {
    let window = Window::around(ROUND.map(|(_, place)| place)).widened(0.09);
    Panel::new(window).width(460.0).caption(caption)
}

/// The triangles, some of them coloured.
fn draw(panel: &mut Panel, region: &Subcomplex2, colored: &[FaceId], color: Color) {
    let corners = |&f: &FaceId| region.triangle(f);
    let colored = colored.iter().map(corners);
    panel
        .layer("coloured triangles", Style::line(EDGE).filled(color))
        .polygons(colored);
    let all: Vec<FaceId> = region.faces().collect();
    panel
        .layer("triangles", Style::line(EDGE))
        .polygons(all.iter().map(corners));
}

/// The names of the corners of a triangle: p first, then in the order of the alphabet.
fn name(region: &Subcomplex2, f: FaceId) -> String {
    let letter = |v: VertexId| ROUND.get(v.index()).map_or("p", |(name, _)| name);
    let mut letters = region.mesh().face_vertices(f).map(letter);
    letters.sort_unstable_by_key(|letter| (*letter != "p", *letter));
    letters.concat()
}
