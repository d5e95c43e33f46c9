//! Generation of a mesh (§2.4): nodes go where bubbles are scarce, until the bubbles fill the region.
//!
//! The triangle with the least bubble density gets a node at its centroid, as large as the triangle's bubble
//! was. It contains its centroid, so the cavity is dug from there and nothing has to be looked for; the
//! boundary stops the cavity, so no boundary edge is lost. Only the triangles round the new node change, and
//! the area of their bubbles in the sum.

use std::ops::ControlFlow;

use delaunay_core::geo_predicates::{Sign, check_point2, orient2d};
use delaunay_core::measure::Sum;
use delaunay_core::progress::{Meter, Progress};
use delaunay_core::{Cavity, FaceId, Subcomplex2};
use glam::DVec2;

use super::params::Params;
use super::queue::Queue;
use crate::bubble::Bubble;
use crate::domain::Domain;

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
    pub(super) region: Subcomplex2,
    pub(super) bubbles: Vec<Bubble>,
    pub(super) boundary_nodes: usize,
    pub(super) stop: Stop,
}

impl Mesh {
    /// The triangles.
    #[must_use]
    pub fn region(&self) -> &Subcomplex2 {
        &self.region
    }

    /// The bubble of each node, by vertex; the boundary nodes come first.
    #[must_use]
    pub fn bubbles(&self) -> &[Bubble] {
        &self.bubbles
    }

    /// How many nodes are on the boundary: those of the domain.
    #[must_use]
    pub fn boundary_nodes(&self) -> usize {
        self.boundary_nodes
    }

    /// Why the generation stopped.
    #[must_use]
    pub fn stop(&self) -> Stop {
        self.stop
    }
}

/// The mesh of a region whose boundary edges say how large its triangles should be.
///
/// Bubbles are never smaller than the smallest of the boundary, of radius r, so a region of area A gets at most
/// A / (π r²) + 2 triangles beyond those so flat that their centroids round to the edge; these count for nothing. Takes
/// n log n time for n nodes; `report` is told of every 4096th node and cancels the work by
/// [`ControlFlow::Break`]. Source: §2.4, steps b–f.
#[must_use]
pub fn generate(
    domain: &Domain,
    params: &Params,
    report: &mut dyn FnMut(Progress) -> ControlFlow<()>,
) -> Mesh {
    let mut growth = Growth::start(domain);
    let stop = growth.fill(domain.area(), params.nodes, report);
    Mesh {
        region: growth.region,
        bubbles: growth.nodes,
        boundary_nodes: domain.bubbles().len(),
        stop,
    }
}

/// The mesh while it grows.
struct Growth {
    region: Subcomplex2,
    /// By vertex.
    nodes: Vec<Bubble>,
    /// The bubble of each triangle, by face; of radius 0 for ghosts and where there is no room for a node.
    elements: Vec<Bubble>,
    /// Σ `A_e`, the area of all element bubbles.
    covered: Sum,
    queue: Queue,
    cavity: Cavity,
}

impl Growth {
    /// Step b.
    fn start(domain: &Domain) -> Self {
        let mut growth = Self {
            region: domain.region().clone(),
            nodes: domain.bubbles().to_vec(),
            elements: Vec::new(),
            covered: Sum::default(),
            queue: Queue::new(),
            cavity: Cavity::default(),
        };
        for f in domain.region().faces() {
            growth.examine(f);
        }
        growth
    }

    /// Steps c to f. Every turn adds a node or takes a triangle off the queue for good, and nodes are bounded.
    fn fill(
        &mut self,
        region: f64,
        limit: usize,
        report: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Stop {
        let Ok(mut meter) = Meter::start(report, "nodes", limit) else {
            return Stop::Cancelled;
        };
        while self.covered.total() < region {
            if self.nodes.len() >= limit {
                return Stop::OutOfNodes;
            }
            let Some(scarcest) = self.queue.pop() else {
                return Stop::OutOfRoom;
            };
            if self.insert_centroid(scarcest) && meter.advance().is_err() {
                return Stop::Cancelled;
            }
        }
        Stop::Filled
    }

    /// Steps d and e; `false` when ids run out.
    fn insert_centroid(&mut self, f: FaceId) -> bool {
        let bubble = self.elements[f.index()];
        let mut cavity = std::mem::take(&mut self.cavity);
        let inserted = self.region.dig(bubble.center, f, &mut cavity)
            && self.region.fill(bubble.center, &mut cavity).is_some();
        if inserted {
            self.nodes.push(bubble);
            cavity.faces().iter().for_each(|&f| self.examine(f));
        }
        self.cavity = cavity;
        inserted
    }

    /// Takes up the triangle `f`, new or changed.
    fn examine(&mut self, f: FaceId) {
        let vertices = self.region.mesh().face_vertices(f);
        let nodes = vertices.map(|v| self.nodes[v.index()]);
        let corners = nodes.map(|node| node.center);
        let mut element = Bubble::of_element(nodes);
        let density = element.density_in(corners);
        if density.is_finite() && has_room(corners, element.center) {
            self.queue.push(f, density, element.center);
        } else {
            // Departs from Luo §2.3.4: no node will ever be there, so its bubble fills nothing.
            element.radius = 0.0;
            self.queue.forget(f);
        }
        self.replace_element(f, element);
    }

    fn replace_element(&mut self, f: FaceId, element: Bubble) {
        if self.elements.len() <= f.index() {
            let nothing = Bubble {
                center: DVec2::ZERO,
                radius: 0.0,
            };
            self.elements.resize(f.index() + 1, nothing);
        }
        let place = &mut self.elements[f.index()];
        self.covered.add(-place.area());
        self.covered.add(element.area());
        *place = element;
    }
}

/// Whether the centroid of a counterclockwise triangle is an accepted point and not on or, by rounding, beyond an edge.
fn has_room([a, b, c]: [DVec2; 3], centroid: DVec2) -> bool {
    check_point2(0, centroid).is_ok()
        && [[a, b], [b, c], [c, a]]
            .iter()
            .all(|&[from, to]| orient2d(from, to, centroid) == Sign::Positive)
}
