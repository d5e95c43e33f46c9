//! Figure 3: the graph of φ over the USA data, with values that decrease from bottom to top (§3.2).
//!
//! It is seen from the south and from above, in parallel projection. Strips from west to east are drawn from the farthest to the
//! nearest, so that what is near covers what is behind it. A strip is cut along triangles, and where its shade changes; creases
//! between the paraboloids stay sharp.

use delaunay_core::measure::triangle::circumcenter;
use delaunay_core::{Delaunay2, FaceId, HalfEdgeId, Subcomplex2};
use glam::{DVec2, DVec3};
use mesh_io::svg::{Color, Panel, Picture, Sample, Stroke, Style, Window};
use sink_refine::tri::phi;
use sink_refine::{Sinks, sink};

use super::usa;
use crate::figures::table::{Table, grouped};
use crate::figures::{Render, Rendered};

/// Strips, and straight lines that the outline of one that crosses the whole picture consists of.
const STRIPS: u32 = 64;
const PIECES: u32 = 50;

/// Sine and cosine of the angle at which the view looks down.
const DOWN: [f64; 2] = [0.6, 0.8];

/// Height of the highest peak as a share of the width of the country.
const PEAK: f64 = 0.3;

/// Where the light comes from: west, a little south, above.
const LIGHT: DVec3 = DVec3::new(-0.6, -0.24, 0.76);

/// Shades between dark and bright.
const SHADES: usize = 30;
const DARK: Color = Color([0x3a, 0x5f, 0x92]);
const BRIGHT: Color = Color([0xf4, 0xf8, 0xfc]);
const EDGE: Stroke = Stroke {
    color: Color::INK,
    width: 0.35,
    dotted: false,
};

/// Figure 3.
pub(super) fn figure() -> Render {
    let outline = usa::triangulated()?;
    let region = usa::stable(&outline)?;
    let graph = Graph::of(&region);
    let picture = Picture::new("Figure 3: φ over the USA data, decreasing from bottom to top")
        .panel(graph.panel())
        .key("edge between paraboloids", Sample::Line(EDGE))
        .key("sink, a minimum of φ", Sample::Dot(Color::RED));
    Ok(Rendered {
        svg: picture.to_svg()?,
        summary: graph.summary(&usa::delaunay(&outline)?)?,
    })
}

/// The graph of −φ over a region.
struct Graph<'a> {
    region: &'a Subcomplex2,
    patches: Vec<Patch>,
    sinks: Vec<DVec2>,
    /// The rectangle round the region.
    low: DVec2,
    high: DVec2,
    /// From values of −φ to heights.
    scale: f64,
}

/// The part over a triangle: a paraboloid.
#[derive(Clone, Copy)]
struct Patch {
    corners: [DVec2; 3],
    center: DVec2,
}

impl Patch {
    fn of(region: &Subcomplex2, f: FaceId) -> Self {
        let corners = region.triangle(f);
        Self {
            corners,
            center: circumcenter(corners),
        }
    }

    /// −φ, zero at the corners.
    fn value(&self, y: DVec2) -> f64 {
        let [a, ..] = self.corners;
        (a - y).dot(y + a - 2.0 * self.center)
    }

    fn gradient(&self, y: DVec2) -> DVec2 {
        2.0 * (self.center - y)
    }

    /// Whether `y` is in the triangle.
    fn covers(&self, y: DVec2) -> bool {
        let [a, b, c] = self.corners;
        let sides = [[a, b], [b, c], [c, a]];
        sides
            .into_iter()
            .all(|[p, q]| (q - p).perp_dot(y - p) >= 0.0)
    }
}

/// What a strip has in the picture.
struct Strip {
    /// Its pieces by their shade, polygons.
    by_shade: Vec<Vec<Vec<[f64; 2]>>>,
    /// The parts of edges over it, lines.
    edges: Vec<Vec<[f64; 2]>>,
}

impl<'a> Graph<'a> {
    fn of(region: &'a Subcomplex2) -> Self {
        let patches: Vec<Patch> = region.faces().map(|f| Patch::of(region, f)).collect();
        let corners = || patches.iter().flat_map(|patch| patch.corners);
        let low = corners().fold(DVec2::INFINITY, DVec2::min);
        let high = corners().fold(DVec2::NEG_INFINITY, DVec2::max);
        let tops = Sinks::of(region);
        let tops: Vec<FaceId> = tops.triangles().collect();
        let top = |&f: &FaceId| Patch::of(region, f).value(sink(region, f));
        let highest = tops.iter().map(top).fold(0.0, f64::max);
        Self {
            region,
            sinks: tops.into_iter().map(|f| sink(region, f)).collect(),
            patches,
            low,
            high,
            scale: PEAK * (high.x - low.x) / highest,
        }
    }

    fn panel(&self) -> Panel {
        let strips: Vec<Strip> = (0..STRIPS).rev().map(|k| self.strip(k)).collect();
        let pieces = strips.iter().flat_map(|strip| strip.by_shade.iter());
        let window = Window::around(pieces.flatten().flatten().copied());
        let mut panel = Panel::new(window.widened(0.02)).width(860.0);
        for strip in strips {
            draw(&mut panel, strip);
        }
        let dots = panel.layer("sinks", Style::area(Color::RED));
        for z in self.sinks.iter().filter(|z| self.is_seen(**z)) {
            dots.dot(self.seen(*z, self.value(*z).unwrap_or(0.0)), 2.2);
        }
        panel
    }

    /// Where the point of the graph with a value over `y` is in the picture.
    fn seen(&self, y: DVec2, value: f64) -> [f64; 2] {
        let [sine, cosine] = DOWN;
        [y.x, sine * y.y + cosine * self.scale * value]
    }

    /// −φ over a point of the region.
    fn value(&self, y: DVec2) -> Option<f64> {
        let patch = self.patches.iter().find(|patch| patch.covers(y))?;
        Some(patch.value(y))
    }

    /// Whether nothing in front of it hides a point of the graph.
    fn is_seen(&self, y: DVec2) -> bool {
        let height = |y: DVec2| Some(self.seen(y, self.value(y)?)[1]);
        let step = self.width_of_strip();
        let in_front = (1..=STRIPS).map(|k| y - f64::from(k) * step * DVec2::Y);
        let highest = in_front
            .filter_map(height)
            .fold(f64::NEG_INFINITY, f64::max);
        height(y).is_some_and(|here| here > highest)
    }

    fn width_of_strip(&self) -> f64 {
        (self.high.y - self.low.y) / f64::from(STRIPS)
    }

    /// The strip of a number, counted from the south.
    fn strip(&self, number: u32) -> Strip {
        let south = self.low.y + f64::from(number) * self.width_of_strip();
        let band = [south, south + self.width_of_strip()];
        let mut by_shade = vec![Vec::new(); SHADES];
        for patch in &self.patches {
            let part = between(&patch.corners, 1, band);
            for (shade, piece) in self.shaded(patch, &part) {
                let piece = self.refined(&piece, true);
                let seen = piece.into_iter().map(|y| self.seen(y, patch.value(y)));
                by_shade[shade].push(seen.collect());
            }
        }
        Strip {
            by_shade,
            edges: self.edges(band),
        }
    }

    /// The part of a strip over one triangle, cut from west to east into pieces of one shade each.
    fn shaded(&self, patch: &Patch, part: &[DVec2]) -> Vec<(usize, Vec<DVec2>)> {
        if part.len() < 3 {
            return Vec::new();
        }
        let middle = part.iter().sum::<DVec2>() / part.len() as f64;
        let west = part.iter().fold(f64::INFINITY, |west, p| west.min(p.x));
        let east = part.iter().fold(f64::NEG_INFINITY, |east, p| east.max(p.x));
        let count = ((east - west) / self.step() * 8.0).ceil().max(1.0);
        let at = |k: u32| west + (east - west) * f64::from(k) / count;
        let shade = |k: u32| self.shade(patch, DVec2::new(at(k).midpoint(at(k + 1)), middle.y));
        let mut pieces = Vec::new();
        let mut first = 0;
        for k in 1..=count as u32 {
            if f64::from(k) == count || shade(k) != shade(first) {
                let piece = between(part, 0, [at(first), at(k)]);
                pieces.push((shade(first), piece));
                first = k;
            }
        }
        pieces.retain(|(_, piece)| piece.len() >= 3);
        pieces
    }

    /// The longest line that is drawn straight.
    fn step(&self) -> f64 {
        (self.high.x - self.low.x) / f64::from(PIECES)
    }

    /// A line with points between its corners, `closed` or not.
    fn refined(&self, line: &[DVec2], closed: bool) -> Vec<DVec2> {
        let ends = line.iter().skip(1).chain(line.first().filter(|_| closed));
        let mut points: Vec<DVec2> = line.iter().take(1).copied().collect();
        for (&p, &q) in line.iter().zip(ends) {
            let count = (p.distance(q) / self.step()).ceil().max(1.0);
            points.extend((1..=count as u32).map(|k| p.lerp(q, f64::from(k) / count)));
        }
        if closed {
            points.pop();
        }
        points
    }

    /// What a strip has of the graph over the edges.
    fn edges(&self, band: [f64; 2]) -> Vec<Vec<[f64; 2]>> {
        let mesh = self.region.mesh();
        let once = |h: &HalfEdgeId| {
            let twin = mesh.twin(*h);
            *h < twin || mesh.is_ghost_face(twin.face())
        };
        let half_edges = self.region.faces().flat_map(FaceId::half_edges);
        let lines = half_edges.filter(once).filter_map(|h| {
            let part = cut(self.region.segment(h), band)?;
            let patch = Patch::of(self.region, h.face());
            let line = self.refined(&part, false);
            Some(
                line.into_iter()
                    .map(|y| self.seen(y, patch.value(y)))
                    .collect(),
            )
        });
        lines.collect()
    }

    /// The shade of a patch over `y`, the more it faces the light the brighter.
    fn shade(&self, patch: &Patch, y: DVec2) -> usize {
        let slope = self.scale * patch.gradient(y);
        let normal = DVec3::new(-slope.x, -slope.y, 1.0).normalize_or_zero();
        let light = (0.5 + 0.5 * normal.dot(LIGHT)).clamp(0.0, 1.0);
        (light * (SHADES - 1) as f64).round() as usize
    }

    fn summary(&self, delaunay: &Delaunay2) -> Result<String, Box<dyn std::error::Error>> {
        let mut apart = 0.0_f64;
        for patch in &self.patches {
            let y = patch.corners.iter().sum::<DVec2>() / 3.0;
            let exact = phi(delaunay, y)?.unwrap_or(f64::NAN);
            apart = apart.max((exact + patch.value(y)).abs() / exact.abs());
        }
        let lowest = self
            .patches
            .iter()
            .filter(|patch| self.sinks.contains(&patch.center));
        let lowest = lowest
            .map(|patch| -patch.value(patch.center))
            .fold(0.0, f64::min);
        Ok(Table::new("Figure 3: φ over the USA data", ["", "ours"])
            .row(["paraboloids", &grouped(self.patches.len())])
            .row(["minima", &grouped(self.sinks.len())])
            .row(["lowest, in square kilometres", &format!("{lowest:.0}")])
            .row(["at the points", "0"])
            .row([
                "drawn and computed values agree to 9 digits",
                &(apart < 1e-9).to_string(),
            ])
            .to_string())
    }
}

fn draw(panel: &mut Panel, strip: Strip) {
    for (shade, pieces) in strip.by_shade.into_iter().enumerate() {
        if !pieces.is_empty() {
            let color = DARK.mixed(BRIGHT, shade as f64 / (SHADES - 1) as f64);
            // A line of the same colour closes the gaps between pieces.
            let seam = Stroke { color, ..EDGE };
            panel
                .layer("strip", Style::line(seam).filled(color))
                .polygons(pieces);
        }
    }
    if !strip.edges.is_empty() {
        panel
            .layer("edges", Style::line(EDGE))
            .polylines(strip.edges);
    }
}

/// The part of a convex polygon in which a coordinate is between two bounds; empty when there is none.
fn between(polygon: &[DVec2], axis: usize, [low, high]: [f64; 2]) -> Vec<DVec2> {
    let above = clipped(polygon, |p| p[axis] - low);
    clipped(&above, |p| high - p[axis])
}

/// The part of a convex polygon in which a linear function is not negative.
fn clipped(polygon: &[DVec2], inside: impl Fn(DVec2) -> f64) -> Vec<DVec2> {
    let mut part = Vec::new();
    for (k, &p) in polygon.iter().enumerate() {
        let q = polygon[(k + 1) % polygon.len()];
        let [at_p, at_q] = [p, q].map(&inside);
        if at_p >= 0.0 {
            part.push(p);
        }
        if (at_p > 0.0 && at_q < 0.0) || (at_p < 0.0 && at_q > 0.0) {
            part.push(p.lerp(q, at_p / (at_p - at_q)));
        }
    }
    part
}

/// The part of a segment in which the second coordinate is between two bounds.
fn cut([p, q]: [DVec2; 2], [low, high]: [f64; 2]) -> Option<[DVec2; 2]> {
    let (p, q) = if p.y <= q.y { (p, q) } else { (q, p) };
    let at = |y: f64| p.lerp(q, (y - p.y) / (q.y - p.y));
    let start = if p.y < low { at(low) } else { p };
    let end = if q.y > high { at(high) } else { q };
    (p.y < high && q.y >= low).then_some([start, end])
}
