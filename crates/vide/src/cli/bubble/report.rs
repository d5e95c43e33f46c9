//! What became of an outline, as JSON for programs and as a line for people.

use std::collections::BTreeSet;

use serde::Serialize;
use vide::bubble_mesh::{Domain, radius_ratio};
use vide::glam::DVec2;
use vide::mesh_io::{Cell, Mesh};

use crate::cli::report::Report;

/// Triangles below this radius ratio are listed.
const POOR: f64 = 0.7;

/// At most so many, the worst first.
const LISTED: usize = 20;

/// The part of a report that only bubbles have.
#[derive(Serialize)]
pub(crate) struct Bubbles {
    method: &'static str,
    boundary_nodes: usize,
    boundary_edges: usize,
    poor: Poor,
}

/// Triangles with a radius ratio below 0.7.
#[derive(Serialize)]
struct Poor {
    count: usize,
    /// Of those, how many have a corner of the outline that is sharper than 45 degrees, which no triangle there can make up for.
    at_sharp_corners: usize,
    worst: Vec<PoorTriangle>,
}

#[derive(Serialize)]
struct PoorTriangle {
    /// As the files written count cells, from 0.
    element: usize,
    ratio: f64,
    center: [f64; 2],
    at_sharp_corner: bool,
}

impl Bubbles {
    pub(super) fn of(paper: bool, domain: &Domain, mesh: &Mesh) -> Self {
        let region = domain.region();
        Self {
            method: if paper { "paper" } else { "graded" },
            boundary_nodes: region.vertex_count(),
            boundary_edges: region.boundary().count(),
            poor: Poor::of(domain, mesh),
        }
    }
}

impl Poor {
    fn of(domain: &Domain, mesh: &Mesh) -> Self {
        let sharp = sharp_corners(domain);
        let place = |v: u32| {
            let [x, y, _] = mesh.points[v as usize];
            DVec2::new(x, y)
        };
        let mut poor = Vec::new();
        for (element, cell) in mesh.cells.iter().enumerate() {
            let Cell::Triangle(corners) = cell else {
                continue;
            };
            let triangle = corners.map(place);
            let ratio = radius_ratio(triangle);
            if ratio < POOR {
                let bits = |p: DVec2| p.to_array().map(f64::to_bits);
                poor.push(PoorTriangle {
                    element,
                    ratio,
                    center: (triangle.into_iter().sum::<DVec2>() / 3.0).to_array(),
                    at_sharp_corner: triangle.iter().any(|&p| sharp.contains(&bits(p))),
                });
            }
        }
        poor.sort_by(|a, b| a.ratio.total_cmp(&b.ratio));
        let count = poor.len();
        let at_sharp_corners = poor.iter().filter(|poor| poor.at_sharp_corner).count();
        poor.truncate(LISTED);
        Self {
            count,
            at_sharp_corners,
            worst: poor,
        }
    }
}

/// The places of corners where the region has an angle below 45 degrees.
fn sharp_corners(domain: &Domain) -> BTreeSet<[u64; 2]> {
    let region = domain.region();
    let mut angles = vec![0.0; region.points().len()];
    let mut sharp = BTreeSet::new();
    for h in region.boundary() {
        // The angle from a boundary edge on, through the triangles, to the next one.
        let mesh = region.mesh();
        let v = mesh.origin(h);
        let [here, to] = region.segment(h);
        let mut last = h.prev();
        while !region.is_boundary(last) {
            last = mesh.twin(last).prev();
        }
        let from = region.point(mesh.origin(last)) - here;
        let turn = (to - here).angle_to(from).rem_euclid(std::f64::consts::TAU);
        angles[v.index()] = turn;
        if turn < std::f64::consts::FRAC_PI_4 {
            sharp.insert(here.to_array().map(f64::to_bits));
        }
    }
    sharp
}

/// One line for people.
pub(super) fn summary(report: &Report) -> String {
    let Some(bubbles) = &report.bubbles else {
        return String::new();
    };
    let poor = match bubbles.poor.count {
        0 => "none below a radius ratio of 0.7".to_owned(),
        count => format!(
            "{count} below a radius ratio of 0.7, {} of them at sharp corners of the outline",
            bubbles.poor.at_sharp_corners
        ),
    };
    format!(
        "{} nodes, {} of them on the outline, and {} triangles, {poor}\n",
        report.vertices, bubbles.boundary_nodes, report.elements
    )
}
