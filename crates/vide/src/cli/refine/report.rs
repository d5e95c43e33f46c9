//! What a refinement did, as JSON for programs and as lines for people.

use std::collections::{BTreeMap, HashMap};
use std::hash::Hash;

use serde::Serialize;
use vide::delaunay_core::{FaceId, TetId, VertexId};
use vide::sink_refine::{
    Boundary, Candidate, Coarsening, Counters, Method, Outcome2, Outcome3, Params, Reason2,
    Reason3, Schedule, Separation2, Separation3,
};

use super::improve::Improvement;
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
    /// Whether the boundary might be divided.
    boundary: &'static str,
    /// Elements with a larger one are of low quality.
    ratio: f64,
    /// The length of edges asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    size: Option<f64>,
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
    /// Of those inserted.
    on_boundary: usize,
    removed: usize,
}

/// Lengths of the shortest edge, and how many vertices have room at the one given.
#[derive(Serialize)]
struct Separation {
    given: f64,
    reached: f64,
    vertex_bound: f64,
}

impl From<Separation3> for Separation {
    fn from(of: Separation3) -> Self {
        Self {
            given: of.given,
            reached: of.reached,
            vertex_bound: of.vertex_bound,
        }
    }
}

impl From<Separation2> for Separation {
    fn from(of: Separation2) -> Self {
        Self {
            given: of.given,
            reached: of.reached,
            vertex_bound: of.vertex_bound,
        }
    }
}

/// What is left of low quality.
#[derive(Default, Serialize)]
struct LowLeft {
    count: usize,
    /// Those that are too large.
    too_large: usize,
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
    /// Circumradius over the largest allowed, where a size is asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    size: Option<f64>,
    reason: Reason,
    /// Vertices of the boundary triangle, edge or corner that is to blame.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    boundary: Vec<usize>,
}

/// Why an element of low quality is left, the element that is to blame aside.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "snake_case")]
enum Reason {
    BoundaryTriangle,
    BoundaryAngle,
    BoundaryEdge,
    Encroaches,
    Outside,
    NotReached,
}

/// The report of a solid refined from so many vertices and tetrahedra, whose tetrahedra are written in the order of `tets`.
pub(super) fn of_solid(
    params: &Params,
    size: Option<f64>,
    given: [usize; 2],
    outcome: &Outcome3,
    tets: &[TetId],
) -> Refinement {
    let mesh = outcome.solid.mesh();
    let places = Places::of(tets);
    let numbers = Numbers::of(outcome.solid.points().len(), |v| mesh.home(v).is_some());
    let low = outcome.low.iter().map(|low| LowElement {
        element: places.of_element(low.tet),
        ratio: low.ratio,
        size: (low.size > 0.0).then_some(low.size),
        reason: low.reason.into(),
        boundary: match low.reason {
            Reason3::BoundaryTriangle(f) | Reason3::Encroaches(f) => {
                numbers.list(mesh.facet_vertices(f))
            }
            Reason3::Outside | Reason3::NotReached => Vec::new(),
        },
    });
    let low = LowLeft::of(low);
    Refinement::new(
        params,
        size,
        given,
        outcome.counters,
        outcome.separation.into(),
        low,
    )
}

/// The report of a region refined from so many vertices and triangles, whose triangles are written in the order of
/// `faces`.
pub(super) fn of_region(
    params: &Params,
    size: Option<f64>,
    given: [usize; 2],
    outcome: &Outcome2,
    faces: &[FaceId],
) -> Refinement {
    let mesh = outcome.region.mesh();
    let places = Places::of(faces);
    let numbers = Numbers::of(outcome.region.points().len(), |v| {
        mesh.outgoing(v).is_some()
    });
    let low = outcome.low.iter().map(|low| LowElement {
        element: places.of_element(low.face),
        ratio: low.ratio,
        size: (low.size > 0.0).then_some(low.size),
        reason: low.reason.into(),
        boundary: match low.reason {
            Reason2::BoundaryAngle(v) => numbers.list([v]),
            Reason2::BoundaryEdge(h) | Reason2::Encroaches(h) => {
                numbers.list([mesh.origin(h), mesh.target(h)])
            }
            Reason2::Outside | Reason2::NotReached => Vec::new(),
        },
    });
    let low = LowLeft::of(low);
    Refinement::new(
        params,
        size,
        given,
        outcome.counters,
        outcome.separation.into(),
        low,
    )
}

/// By vertex its number in the files written, in which vertices that have been removed are left out.
struct Numbers(Vec<usize>);

impl Numbers {
    fn of(vertices: usize, is_there: impl Fn(VertexId) -> bool) -> Self {
        let all = (0..vertices).map(VertexId::new);
        let before = all.scan(0, |before, v| {
            let number = *before;
            *before += usize::from(is_there(v));
            Some(number)
        });
        Self(before.collect())
    }

    fn list<const N: usize>(&self, vertices: [VertexId; N]) -> Vec<usize> {
        vertices.map(|v| self.0[v.index()]).to_vec()
    }
}

/// Where each element is in the files written.
struct Places<I>(HashMap<I, usize>);

impl<I: Copy + Eq + Hash> Places<I> {
    fn of(order: &[I]) -> Self {
        Self(order.iter().copied().zip(0..).collect())
    }

    fn of_element(&self, id: I) -> usize {
        self.0.get(&id).copied().unwrap_or(0)
    }
}

impl Refinement {
    /// The same for elements that have been exchanged since: they are counted, not named.
    pub(super) fn without_elements(mut self) -> Self {
        self.low.worst.clear();
        self
    }

    fn new(
        params: &Params,
        size: Option<f64>,
        [given_vertices, given_elements]: [usize; 2],
        counters: Counters,
        separation: Separation,
        low: LowLeft,
    ) -> Self {
        let (candidate, schedule, coarsen) = names(params.method);
        Self {
            candidate,
            schedule,
            coarsen,
            boundary: match params.boundary {
                Boundary::Keep => "keep",
                Boundary::Split { .. } => "split",
            },
            ratio: params.ratio,
            size,
            given_vertices,
            given_elements,
            points: Points {
                tested: counters.tested,
                encroaching: counters.encroaching,
                inserted: counters.inserted,
                on_boundary: counters.split,
                removed: counters.removed,
            },
            separation,
            low,
        }
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

impl LowLeft {
    /// Of all elements of low quality, the worst first.
    fn of(elements: impl Iterator<Item = LowElement>) -> Self {
        let mut left = Self::default();
        for element in elements {
            left.count += 1;
            left.too_large += usize::from(element.size.is_some_and(|size| size > 1.0));
            *left.reasons.entry(element.reason).or_default() += 1;
            if left.worst.len() < LISTED {
                left.worst.push(element);
            }
        }
        left
    }
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

impl From<Reason2> for Reason {
    fn from(reason: Reason2) -> Self {
        match reason {
            Reason2::BoundaryAngle(_) => Self::BoundaryAngle,
            Reason2::BoundaryEdge(_) => Self::BoundaryEdge,
            Reason2::Encroaches(_) => Self::Encroaches,
            Reason2::Outside => Self::Outside,
            Reason2::NotReached => Self::NotReached,
        }
    }
}

impl Reason {
    /// What the terminal says of such elements.
    fn words(self) -> &'static str {
        match self {
            Self::BoundaryTriangle => "on a boundary triangle that is above it",
            Self::BoundaryAngle => "in an angle of the boundary that is too small",
            Self::BoundaryEdge => "on an edge of the boundary that is too long",
            Self::Encroaches => "whose points are too near to the boundary",
            Self::Outside => "whose points are outside",
            Self::NotReached => "not reached",
        }
    }
}

/// What a refinement says on the terminal.
pub(super) fn summary(report: &Report) -> String {
    let element = match report.dimension {
        Some(2) => "triangle",
        _ => "tetrahedron",
    };
    let elements = match report.dimension {
        Some(2) => "triangles",
        _ => "tetrahedra",
    };
    let mut text = format!(
        "{} {elements}, {} vertices",
        report.elements, report.vertices
    );
    let Some(Refinement {
        given_elements,
        given_vertices,
        points,
        low,
        ratio,
        size,
        ..
    }) = &report.refinement
    else {
        return text;
    };
    let on_boundary = match points.on_boundary {
        0 => String::new(),
        count => format!(" ({count} on the boundary)"),
    };
    text += &format!(
        " (given {given_elements} and {given_vertices})\n\
         {} points tested, {} encroaching, {} inserted{on_boundary}, {} removed\n",
        points.tested, points.encroaching, points.inserted, points.removed
    );
    let ended = match report.stop {
        Stop::OutOfVertices => "; no more vertices may be added",
        Stop::OutOfIds => "; there are no more numbers for vertices and elements",
        Stop::UnusableSize => "; there is no size somewhere",
        Stop::Cancelled => "; cancelled",
        Stop::Finished | Stop::AllGood | Stop::NothingToInsert => "",
    };
    let reasons: Vec<String> = low
        .reasons
        .iter()
        .map(|(r, n)| format!("{n} {}", r.words()))
        .collect();
    let or_size = match (size, low.too_large) {
        (Some(size), _) => format!(" or the size {size}"),
        (None, 0) => String::new(),
        (None, _) => " or the size of a region".to_owned(),
    };
    let left = match low.count {
        0 => format!("no {element} above the ratio {ratio}{or_size}"),
        count => format!(
            "{count} above the ratio {ratio}{or_size}: {}",
            reasons.join(", ")
        ),
    };
    let improved = report.improvement.as_ref();
    let (when, improved) = match improved.map(Improvement::summary) {
        Some(line) => ("refined: ", line),
        None => ("", String::new()),
    };
    text + when + &left + ended + "\n" + &improved + "\n"
}
