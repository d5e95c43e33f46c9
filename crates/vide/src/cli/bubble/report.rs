//! What became of an outline, as JSON for programs and as a line for people.

use serde::Serialize;
use vide::bubble_mesh::{Domain, NodeSpacing, Spacing, radius_ratio};
use vide::delaunay_core::VertexId;
use vide::glam::DVec2;
use vide::mesh_io::{Cell, Mesh};

use crate::cli::report::Report;

/// Triangles below this radius ratio are listed.
const POOR: f64 = 0.7;

/// Sizes that change by more than this share of the distance are warned of.
const TOO_STEEP: f64 = 0.8;

/// At most so many, the worst first.
const LISTED: usize = 20;

/// The part of a report that only bubbles have.
#[derive(Serialize)]
pub(crate) struct Bubbles {
    method: &'static str,
    boundary_nodes: usize,
    boundary_edges: usize,
    spacing: Given,
    poor: Poor,
}

/// What the nodes of the outline allow: the worst anywhere.
#[derive(Serialize)]
struct Given {
    /// The smallest angle between two edges, inside, in degrees.
    sharpest_corner: f64,
    /// The largest difference of two edges that see each other over their distance, and where.
    steepest_sizes: f64,
    steepest_at: [f64; 2],
    /// The narrowest gap over the length of an edge beside it; none where edges see their neighbours only.
    narrowest_gap: Option<f64>,
}

/// Triangles with a radius ratio below 0.7.
#[derive(Serialize)]
struct Poor {
    count: usize,
    /// Of those, how many are near a corner of the outline that is sharper than 45 degrees,
    at_sharp_corners: usize,
    /// or else near edges of the outline whose lengths differ by more than half their distance,
    at_steep_sizes: usize,
    /// or else near a gap narrower than one and a half edges beside it.
    in_narrow_gaps: usize,
    worst: Vec<PoorTriangle>,
}

#[derive(Serialize)]
struct PoorTriangle {
    /// As the files written count cells, from 0.
    element: usize,
    ratio: f64,
    center: [f64; 2],
    reason: Option<&'static str>,
}

impl Bubbles {
    pub(super) fn of(paper: bool, domain: &Domain, mesh: &Mesh) -> Self {
        let region = domain.region();
        let spacing = Spacing::of(domain);
        Self {
            method: if paper { "paper" } else { "graded" },
            boundary_nodes: region.vertex_count(),
            boundary_edges: region.boundary().count(),
            spacing: Given::of(domain, &spacing),
            poor: Poor::of(&spacing, mesh),
        }
    }
}

impl Given {
    fn of(domain: &Domain, spacing: &Spacing) -> Self {
        let worst = spacing.worst();
        let mut nodes = spacing.nodes();
        let steepest = nodes.find(|(_, node)| node.steepness == worst.steepness);
        let steepest = steepest.map_or(VertexId::new(0), |(v, _)| v);
        Self {
            sharpest_corner: worst.angle.to_degrees(),
            steepest_sizes: worst.steepness,
            steepest_at: domain.region().point(steepest).to_array(),
            narrowest_gap: worst.width.is_finite().then_some(worst.width),
        }
    }
}

/// Why a triangle can not be good, in a word.
fn reason(against: NodeSpacing) -> &'static str {
    if against.angle < NodeSpacing::SHARP {
        SHARP
    } else if against.steepness > NodeSpacing::STEEP {
        STEEP
    } else {
        NARROW
    }
}

const SHARP: &str = "sharp corner";
const STEEP: &str = "steep sizes";
const NARROW: &str = "narrow gap";

impl Poor {
    fn of(spacing: &Spacing, mesh: &Mesh) -> Self {
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
                poor.push(PoorTriangle {
                    element,
                    ratio,
                    center: (triangle.into_iter().sum::<DVec2>() / 3.0).to_array(),
                    reason: spacing.against(triangle).map(reason),
                });
            }
        }
        poor.sort_by(|a, b| a.ratio.total_cmp(&b.ratio));
        let count = poor.len();
        let because = |word: &str| poor.iter().filter(|poor| poor.reason == Some(word)).count();
        let [at_sharp_corners, at_steep_sizes, in_narrow_gaps] =
            [SHARP, STEEP, NARROW].map(because);
        poor.truncate(LISTED);
        Self {
            count,
            at_sharp_corners,
            at_steep_sizes,
            in_narrow_gaps,
            worst: poor,
        }
    }
}

/// A line or two for people.
pub(super) fn summary(report: &Report) -> String {
    let Some(bubbles) = &report.bubbles else {
        return String::new();
    };
    let poor = &bubbles.poor;
    let found = match poor.count {
        0 => "none below a radius ratio of 0.7".to_owned(),
        count => format!(
            "{count} below a radius ratio of 0.7: {} at sharp corners of the outline, {} where its edges change steeply, {} in narrow gaps",
            poor.at_sharp_corners, poor.at_steep_sizes, poor.in_narrow_gaps
        ),
    };
    let spacing = &bubbles.spacing;
    let [x, y] = spacing.steepest_at;
    let warning = match spacing.steepest_sizes > TOO_STEEP {
        true => format!(
            "edges of the outline change by {:.2} of their distance at ({x}, {y}): --boundary resample makes them change slowly\n",
            spacing.steepest_sizes
        ),
        false => String::new(),
    };
    format!(
        "{} nodes, {} of them on the outline, and {} triangles, {found}\n{warning}",
        report.vertices, bubbles.boundary_nodes, report.elements
    )
}
