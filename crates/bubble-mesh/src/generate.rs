//! Generation of a mesh (§2.4): nodes go where bubbles are scarce, until the bubbles fill the region.
//!
//! The triangle with the least bubble density gets a node at its centroid, as large as the triangle's bubble
//! was. Only the triangles round the new node change, so the triangles wait in a queue by density, and those
//! that have gone are recognised when they come up.

use std::cmp::Reverse;
use std::collections::BinaryHeap;
use std::ops::ControlFlow;

use delaunay_core::geo_predicates::{Sign, orient2d};
use delaunay_core::measure::triangle;
use delaunay_core::progress::{Meter, Progress};
use delaunay_core::{Delaunay2, FaceId, Inserted, VertexId};

use glam::DVec2;

use crate::bubble::{Bubble, bubble_density};
use crate::domain::Domain;

/// When to stop before the bubbles fill the region.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Params {
    /// At most this many nodes, those of the boundary included.
    pub nodes: usize,
}

impl Default for Params {
    /// A million nodes.
    fn default() -> Self {
        Self { nodes: 1_000_000 }
    }
}

/// Why the generation stopped. The mesh is valid in every case.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stop {
    /// The bubbles of the triangles have at least the area of the region (eq. 6).
    Filled,
    /// The budget of nodes is used up.
    OutOfNodes,
    /// No triangle is left whose centroid can be told from its corners and edges.
    OutOfRoom,
    /// The report closure stopped it.
    Cancelled,
}

/// A mesh and the bubbles of its nodes.
#[derive(Clone, Debug)]
pub struct Mesh {
    /// The triangles: all faces of this triangulation.
    pub delaunay: Delaunay2,
    /// One bubble for each vertex, by vertex; the boundary nodes come first.
    pub bubbles: Vec<Bubble>,
    /// Why the generation stopped.
    pub stop: Stop,
}

/// The mesh of a region whose boundary edges say how large its triangles should be.
///
/// Bubbles are never smaller than the smallest of the boundary, of radius r, so a region of area A gets at most
/// A / (π r²) + 2 triangles. Takes n log n time for n nodes; `report` is told of every 4096th node and cancels
/// the work by [`ControlFlow::Break`]. Source: §2.4, steps b–f.
#[must_use]
pub fn generate(
    domain: Domain,
    params: &Params,
    report: &mut dyn FnMut(Progress) -> ControlFlow<()>,
) -> Mesh {
    let region: f64 = domain
        .delaunay
        .faces()
        .map(|f| triangle::area(domain.delaunay.triangle(f)))
        .sum();
    let mut growth = Growth::start(domain);
    let stop = growth.fill(region, params, report);
    Mesh {
        delaunay: growth.delaunay,
        bubbles: growth.nodes,
        stop,
    }
}

/// The mesh while it grows.
struct Growth {
    delaunay: Delaunay2,
    /// By vertex.
    nodes: Vec<Bubble>,
    /// The bubble of each triangle, by face; no area for ghosts.
    elements: Vec<Element>,
    /// Σ `A_e`, the area of all element bubbles.
    covered: f64,
    /// Bits of the density, which are in the order of the numbers as none is negative; the least comes first.
    /// What is not as in `elements` is of the past.
    queue: BinaryHeap<Reverse<(u64, FaceId)>>,
}

#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Element {
    area: f64,
    density: f64,
}

impl Growth {
    /// Step b.
    fn start(domain: Domain) -> Self {
        let Domain { delaunay, bubbles } = domain;
        let mut growth = Self {
            delaunay,
            nodes: bubbles,
            elements: Vec::new(),
            covered: 0.0,
            queue: BinaryHeap::new(),
        };
        for f in growth.delaunay.mesh().faces() {
            growth.examine(f);
        }
        growth
    }

    fn fill(
        &mut self,
        region: f64,
        params: &Params,
        report: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Stop {
        let Ok(mut meter) = Meter::start(report, "nodes", params.nodes) else {
            return Stop::Cancelled;
        };
        while self.covered < region {
            if self.nodes.len() >= params.nodes {
                return Stop::OutOfNodes;
            }
            let Some(scarce) = self.pop_scarcest() else {
                return Stop::OutOfRoom;
            };
            if self.insert_centroid(scarce) && meter.advance().is_err() {
                return Stop::Cancelled;
            }
        }
        Stop::Filled
    }

    /// Step c.
    fn pop_scarcest(&mut self) -> Option<FaceId> {
        loop {
            let Reverse((density, f)) = self.queue.pop()?;
            if self
                .elements
                .get(f.index())
                .is_some_and(|element| element.density.to_bits() == density)
            {
                return Some(f);
            }
        }
    }

    /// Steps d and e; `false` when the centroid is not a place of its own.
    fn insert_centroid(&mut self, f: FaceId) -> bool {
        let bubble = Bubble::of_element(self.corners(f));
        if !strictly_inside(self.delaunay.triangle(f), bubble.center) {
            return false;
        }
        let [near, ..] = self.delaunay.mesh().face_vertices(f);
        match self.delaunay.insert_near(bubble.center, near) {
            Ok(Inserted::New(node)) => self.add(node, bubble),
            Ok(Inserted::Duplicate(_)) | Err(_) => return false,
        }
        true
    }

    fn add(&mut self, node: VertexId, bubble: Bubble) {
        self.nodes.push(bubble);
        let star: Vec<FaceId> = self.delaunay.mesh().star(node).collect();
        star.into_iter().for_each(|f| self.examine(f));
    }

    /// Takes up the triangle `f`, new or changed.
    fn examine(&mut self, f: FaceId) {
        let element = if self.delaunay.is_ghost_face(f) {
            Element::default()
        } else {
            let corners = self.corners(f);
            let density = bubble_density(corners);
            self.queue.push(Reverse((density.to_bits(), f)));
            Element {
                area: Bubble::of_element(corners).area(),
                density,
            }
        };
        if self.elements.len() <= f.index() {
            self.elements.resize(f.index() + 1, Element::default());
        }
        self.covered += element.area - self.elements[f.index()].area;
        self.elements[f.index()] = element;
    }

    fn corners(&self, f: FaceId) -> [Bubble; 3] {
        self.delaunay
            .mesh()
            .face_vertices(f)
            .map(|v| self.nodes[v.index()])
    }
}

/// Whether `p` is not on or, by rounding, beyond an edge of the counterclockwise triangle.
fn strictly_inside([a, b, c]: [DVec2; 3], p: DVec2) -> bool {
    [[a, b], [b, c], [c, a]]
        .iter()
        .all(|&[from, to]| orient2d(from, to, p) == Sign::Positive)
}
