//! Regions for tests and benches.
#![allow(dead_code, reason = "every test and bench uses some of them")]

use std::f64::consts::TAU;

use bubble_mesh::{Bubble, Domain};
use delaunay_core::progress::silent;
use delaunay_core::{BuildOptions, Outline, Subcomplex2, VertexId};
use glam::DVec2;

/// The outline with these loops.
pub(crate) fn outline(loops: &[Vec<DVec2>]) -> Outline {
    let mut segments = Vec::new();
    let mut start = 0;
    for nodes in loops {
        let count = nodes.len();
        segments
            .extend((0..count).map(|i| [start + i, start + (i + 1) % count].map(VertexId::new)));
        start += count;
    }
    Outline::new(loops.concat(), segments).expect("closed loops")
}

/// The domain with these loops.
pub(crate) fn domain(loops: &[Vec<DVec2>]) -> Domain {
    of_outline(&outline(loops))
}

/// The domain with these loops, if they do not cross.
pub(crate) fn try_domain(loops: &[Vec<DVec2>]) -> Option<Domain> {
    Domain::new(&outline(loops), BuildOptions::default(), &mut silent).ok()
}

/// The domain of an outline.
pub(crate) fn of_outline(outline: &Outline) -> Domain {
    Domain::new(outline, BuildOptions::default(), &mut silent).expect("a region")
}

/// The four regions of the paper, with their names.
pub(crate) fn of_the_paper() -> [(&'static str, Domain); 4] {
    fixtures::outlines::bubble_regions().map(|(name, graph)| {
        let points = graph.points.into_iter().map(DVec2::from).collect();
        let segments = graph.segments.iter();
        let segments = segments.map(|ends| ends.map(|v| VertexId::new(v as usize)));
        let outline = Outline::new(points, segments.collect()).expect("a closed outline");
        (name, of_outline(&outline))
    })
}

/// A unit square with `count` edges on each side, turned by an angle.
pub(crate) fn square(count: usize, angle: f64) -> Vec<DVec2> {
    let turn = DVec2::from_angle(angle);
    let corners = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].map(DVec2::from);
    let sides = (0..4).flat_map(|side| {
        let (start, end) = (corners[side], corners[(side + 1) % 4]);
        (0..count).map(move |i| start.lerp(end, i as f64 / count as f64))
    });
    sides.map(|p| turn.rotate(p)).collect()
}

/// Nodes of a circle, at these parts of a turn.
pub(crate) fn circle(
    center: DVec2,
    radius: f64,
    turns: impl IntoIterator<Item = f64>,
) -> Vec<DVec2> {
    let on_circle = |turn: f64| center + radius * DVec2::from_angle(turn * TAU);
    turns.into_iter().map(on_circle).collect()
}

/// Parts of a turn, equally spaced.
pub(crate) fn even(count: u32) -> impl Iterator<Item = f64> {
    (0..count).map(move |i| f64::from(i) / f64::from(count))
}

/// Area of the bubbles of all triangles.
pub(crate) fn element_area(region: &Subcomplex2, bubbles: &[Bubble]) -> f64 {
    let element = |f| {
        let vertices = region.mesh().face_vertices(f);
        Bubble::of_element(vertices.map(|v| bubbles[v.index()]))
    };
    region.faces().map(|f| element(f).area()).sum()
}

/// Two squares that share a corner and nothing else.
pub(crate) fn touching_squares() -> Outline {
    let left = square(10, 0.0);
    let right: Vec<DVec2> = left.iter().map(|&p| -p).collect();
    // The corner at the origin is shared.
    let points: Vec<DVec2> = left.iter().chain(&right[1..]).copied().collect();
    let first = (0..40).map(|i| [i, (i + 1) % 40]);
    let second = (0..40).map(|i| [i, (i + 1) % 40].map(|k| if k == 0 { 0 } else { 39 + k }));
    let segments = first.chain(second).map(|ends| ends.map(VertexId::new));
    Outline::new(points, segments.collect()).expect("closed loops")
}
