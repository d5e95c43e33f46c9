//! What a refinement did, as JSON for programs and as lines for people.

use std::collections::BTreeMap;

use serde::Serialize;
use vide::delaunay_core::{FacetId, Subcomplex3, TetId, VertexId};
use vide::sink_refine::{
    Candidate, Coarsening, Low3, Method, Outcome3, Params, Reason3, Schedule, Separation3,
};

use crate::cli::report::{Report, Stop};

/// Elements of low quality that are listed.
const LISTED: usize = 20;

/// The part of a report that only a refinement has.
#[derive(Serialize)]
pub(crate) struct Refinement {
    candidate: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    schedule: Option<&'static str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    coarsen: Option<&'static str>,
    /// Elements with a larger one are of low quality.
    ratio: f64,
    given_vertices: usize,
    given_elements: usize,
    points: Points,
    separation: Separation,
    low: LowLeft,
}

/// Counts of points.
#[derive(Serialize)]
struct Points {
    tested: usize,
    encroaching: usize,
    inserted: usize,
    removed: usize,
}

/// Lengths of the shortest edge, and how many vertices have room at the one given.
#[derive(Serialize)]
struct Separation {
    given: f64,
    reached: f64,
    vertex_bound: f64,
}

/// What is left of low quality.
#[derive(Default, Serialize)]
struct LowLeft {
    count: usize,
    /// How often each reason.
    reasons: BTreeMap<Reason, usize>,
    /// The worst first.
    worst: Vec<LowElement>,
}

#[derive(Serialize)]
struct LowElement {
    /// As the files written count cells, from 0.
    element: usize,
    ratio: f64,
    reason: Reason,
    /// Vertices of the boundary triangle that is to blame.
    #[serde(skip_serializing_if = "Option::is_none")]
    boundary_triangle: Option<[usize; 3]>,
}

/// Why an element of low quality is left, the element that is to blame aside.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "snake_case")]
enum Reason {
    BoundaryTriangle,
    Encroaches,
    Outside,
    NotReached,
}

/// The report of a solid refined from so many vertices and tetrahedra, whose tetrahedra are written in the order of `tets`.
pub(super) fn refinement(
    params: &Params,
    [given_vertices, given_elements]: [usize; 2],
    outcome: &Outcome3,
    tets: &[TetId],
) -> Refinement {
    let (candidate, schedule, coarsen) = names(params.method);
    let counters = outcome.counters;
    let Separation3 {
        given,
        reached,
        vertex_bound,
    } = outcome.separation;
    Refinement {
        candidate,
        schedule,
        coarsen,
        ratio: params.ratio,
        given_vertices,
        given_elements,
        points: Points {
            tested: counters.tested,
            encroaching: counters.encroaching,
            inserted: counters.inserted,
            removed: counters.removed,
        },
        separation: Separation {
            given,
            reached,
            vertex_bound,
        },
        low: low_left(outcome, tets),
    }
}

/// The words of the command line for a method.
fn names(method: Method) -> (&'static str, Option<&'static str>, Option<&'static str>) {
    match method {
        Method::Economical(coarsening) => {
            let coarsen = match coarsening {
                Coarsening::None => "none",
                Coarsening::Removal => "removal",
                Coarsening::Merging => "merging",
            };
            ("economical", None, Some(coarsen))
        }
        Method::Paper {
            candidate,
            schedule,
        } => {
            let candidate = match candidate {
                Candidate::Sink => "sink",
                Candidate::Circumcenter => "circumcenter",
            };
            let schedule = match schedule {
                Schedule::Incremental => "incremental",
                Schedule::Block => "block",
                Schedule::Parallel => "parallel",
            };
            (candidate, Some(schedule), None)
        }
    }
}

fn low_left(outcome: &Outcome3, tets: &[TetId]) -> LowLeft {
    let mut left = LowLeft {
        count: outcome.low.len(),
        ..LowLeft::default()
    };
    for low in &outcome.low {
        *left.reasons.entry(low.reason.into()).or_default() += 1;
    }
    let worst = &outcome.low[..outcome.low.len().min(LISTED)];
    let place = |t: TetId| {
        tets.iter()
            .position(|&other| other == t)
            .unwrap_or_default()
    };
    let element = |low: &Low3| LowElement {
        element: place(low.tet),
        ratio: low.ratio,
        reason: low.reason.into(),
        boundary_triangle: facet(low.reason).map(|f| corners(&outcome.solid, f)),
    };
    left.worst = worst.iter().map(element).collect();
    left
}

impl From<Reason3> for Reason {
    fn from(reason: Reason3) -> Self {
        match reason {
            Reason3::BoundaryTriangle(_) => Self::BoundaryTriangle,
            Reason3::Encroaches(_) => Self::Encroaches,
            Reason3::Outside => Self::Outside,
            Reason3::NotReached => Self::NotReached,
        }
    }
}

impl Reason {
    /// What the terminal says of such elements.
    fn words(self) -> &'static str {
        match self {
            Self::BoundaryTriangle => "on a boundary triangle that is above it",
            Self::Encroaches => "whose points are too near to a boundary triangle",
            Self::Outside => "whose points are outside",
            Self::NotReached => "not reached",
        }
    }
}

fn facet(reason: Reason3) -> Option<FacetId> {
    match reason {
        Reason3::BoundaryTriangle(f) | Reason3::Encroaches(f) => Some(f),
        Reason3::Outside | Reason3::NotReached => None,
    }
}

/// Vertices of the boundary are given ones, which keep their numbers.
fn corners(solid: &Subcomplex3, f: FacetId) -> [usize; 3] {
    solid.mesh().facet_vertices(f).map(VertexId::index)
}

/// What a refinement says on the terminal.
pub(super) fn summary(report: &Report) -> String {
    let mut text = format!(
        "{} tetrahedra, {} vertices",
        report.elements, report.vertices
    );
    let Some(Refinement {
        given_elements,
        given_vertices,
        points,
        low,
        ratio,
        ..
    }) = &report.refinement
    else {
        return text;
    };
    text += &format!(
        " (given {given_elements} and {given_vertices})\n{} points tested, {} encroaching, {} inserted, {} removed\n",
        points.tested, points.encroaching, points.inserted, points.removed
    );
    let ended = match report.stop {
        Stop::OutOfVertices => "; no more vertices may be added",
        Stop::OutOfIds => "; there are no more numbers for vertices and tetrahedra",
        Stop::Cancelled => "; cancelled",
        Stop::Finished | Stop::AllGood | Stop::NothingToInsert => "",
    };
    let reasons: Vec<String> = low
        .reasons
        .iter()
        .map(|(r, n)| format!("{n} {}", r.words()))
        .collect();
    let left = match low.count {
        0 => format!("no tetrahedron above the ratio {ratio}"),
        count => format!("{count} above the ratio {ratio}: {}", reasons.join(", ")),
    };
    text + &left + ended + "\n\n"
}
