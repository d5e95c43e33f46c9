//! Nodes are placed in front of what is finished, until no triangle is too large.
//!
//! ```text
//!              x            A triangle is too large when its circumcircle exceeds that of the regular triangle of its
//!            /   \          size by a third. Where such a triangle has an edge with something finished on the other side, the
//!          /       \        boundary or a triangle that is not too large, a node makes a triangle of the right
//!        a --------- b      size on that edge. So layers of good triangles grow from the boundary inwards.
//!          finished
//! ```
//!
//! A node that would come too close to others or to the boundary is not placed, and its triangle counts as finished. Nodes keep
//! a distance to all others that is a share of the size, which bounds their number; so does the budget.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use delaunay_core::geo_predicates::check_point2;
use delaunay_core::measure::triangle::circumcenter;
use delaunay_core::progress::Meter;
use delaunay_core::{Cavity, FaceId, HalfEdgeId, Subcomplex2, VertexId};
use glam::DVec2;

use super::params::{GradedError, Stop};
use super::size::SizeField;

/// How much larger than the regular triangle one may be.
const TOO_LARGE: f64 = 1.35;

/// The least distance between a new node and others, over the size.
const CLOSEST_NODE: f64 = 0.65;

/// The least distance between a new node and the boundary, over the size.
const CLOSEST_EDGE: f64 = 0.4;

/// By how much sizes fall from one layer to the next at most, where the caller's are smaller than those of the boundary.
const STEEPEST_FALL: f64 = 0.3;

/// In which order triangles are taken.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Order {
    /// The largest for its size first: good where all sizes are alike.
    LargestFirst,
    /// Layer by layer from the boundary: good where sizes change.
    LayersFirst,
}

/// A mesh with nodes placed inside, and the size of each node, by vertex.
pub(super) struct Placed {
    pub(super) region: Subcomplex2,
    pub(super) sizes: Vec<f64>,
    pub(super) stop: Stop,
}

/// Places nodes in a region whose vertices have these sizes.
///
/// # Errors
/// The first size of the caller's that is none.
pub(super) fn place(
    region: &Subcomplex2,
    sizes: &[f64],
    field: &SizeField<'_>,
    order: Order,
    nodes: usize,
    meter: &mut Meter<'_>,
) -> Result<Placed, GradedError> {
    let mut front = Front {
        region: region.clone(),
        sizes: sizes.to_vec(),
        layers: vec![0; sizes.len()],
        field,
        order,
        faces: Vec::new(),
        queue: BinaryHeap::new(),
        cavity: Cavity::default(),
    };
    let all: Vec<FaceId> = region.faces().collect();
    front.examine(&all);
    let stop = front.advance(nodes, meter)?;
    Ok(Placed {
        region: front.region,
        sizes: front.sizes,
        stop,
    })
}

/// What is known of a face.
#[derive(Clone, Copy, Debug, Default)]
struct State {
    /// Its circumcircle over that of the regular triangle of its size.
    excess: f64,
    /// Whether no node can be placed for it.
    closed: bool,
    /// How often the id was given to a new face.
    stamp: u32,
}

/// A triangle that is too large.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Entry {
    urgency: f64,
    face: FaceId,
    stamp: u32,
}

impl Eq for Entry {}

impl Ord for Entry {
    fn cmp(&self, other: &Self) -> Ordering {
        let by_urgency = self.urgency.total_cmp(&other.urgency);
        by_urgency.then_with(|| (other.face, other.stamp).cmp(&(self.face, self.stamp)))
    }
}

impl PartialOrd for Entry {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

/// The mesh while nodes are placed.
struct Front<'a> {
    region: Subcomplex2,
    /// By vertex.
    sizes: Vec<f64>,
    /// By vertex, how many layers it is from the boundary.
    layers: Vec<u32>,
    field: &'a SizeField<'a>,
    order: Order,
    /// By face.
    faces: Vec<State>,
    queue: BinaryHeap<Entry>,
    cavity: Cavity,
}

impl Front<'_> {
    fn advance(&mut self, nodes: usize, meter: &mut Meter<'_>) -> Result<Stop, GradedError> {
        while let Some(face) = self.next() {
            let Some(edge) = self.finished_edge(face) else {
                continue;
            };
            if self.sizes.len() >= nodes {
                return Ok(Stop::OutOfNodes);
            }
            if !self.place_before(face, edge)? {
                self.close(face);
            }
            if meter.advance().is_err() {
                return Ok(Stop::Cancelled);
            }
        }
        Ok(Stop::Done)
    }

    /// The next triangle that is too large and there still.
    fn next(&mut self) -> Option<FaceId> {
        loop {
            let Entry { face, stamp, .. } = self.queue.pop()?;
            let state = self.faces[face.index()];
            if state.stamp == stamp && !state.closed {
                return Some(face);
            }
        }
    }

    /// The shortest edge of a triangle with something finished on the other side.
    fn finished_edge(&self, face: FaceId) -> Option<HalfEdgeId> {
        let is_finished = |h: &HalfEdgeId| {
            let beyond = self.region.mesh().twin(*h).face();
            self.region.is_boundary(*h) || !self.is_open(beyond)
        };
        let length = |h: &HalfEdgeId| {
            let [a, b] = self.region.segment(*h);
            a.distance_squared(b)
        };
        let edges = face.half_edges().into_iter().filter(is_finished);
        edges.min_by(|g, h| length(g).total_cmp(&length(h)))
    }

    /// Whether a triangle waits for a node.
    fn is_open(&self, face: FaceId) -> bool {
        let state = self.faces[face.index()];
        !state.closed && state.excess > TOO_LARGE
    }

    /// Places a node before an edge of a triangle if there is room; tells whether it did.
    fn place_before(&mut self, face: FaceId, edge: HalfEdgeId) -> Result<bool, GradedError> {
        let place = self.place(face, edge)?;
        let mut cavity = std::mem::take(&mut self.cavity);
        let size = self.size_before(edge, place)?;
        let mesh = self.region.mesh();
        let ends = [mesh.origin(edge), mesh.target(edge)].map(|v| self.layers[v.index()]);
        let placed = check_point2(0, place).is_ok()
            && self.region.dig(place, face, &mut cavity)
            && self.has_room(&cavity, place, size)
            && self.region.fill(place, &mut cavity).is_some();
        if placed {
            self.sizes.push(size);
            self.layers.push(ends[0].max(ends[1]) + 1);
            self.examine(cavity.faces());
            for &f in cavity.faces() {
                // Across the edge that is not at the new node.
                self.list(self.region.mesh().twin(f.half_edge(1)).face());
            }
        }
        self.cavity = cavity;
        Ok(placed)
    }

    /// Where a node makes a triangle of the right size on an edge of a triangle, not beyond its circumcenter.
    fn place(&self, face: FaceId, edge: HalfEdgeId) -> Result<DVec2, GradedError> {
        let mesh = self.region.mesh();
        let [a, b] = self.region.segment(edge);
        let ends = [mesh.origin(edge), mesh.target(edge)].map(|v| self.sizes[v.index()]);
        let (middle, length) = (a.midpoint(b), a.distance(b));
        let inward = (b - a).perp() / length;
        let at_edge = 0.5 * (ends[0] + ends[1]);
        let before = self.size_before(edge, middle + 0.75_f64.sqrt() * at_edge * inward)?;
        let size = 0.5 * (at_edge + before);
        let height = (size * size - 0.25 * length * length)
            .max(0.25 * size * size)
            .sqrt();
        let center = (circumcenter(self.region.triangle(face)) - middle).dot(inward);
        let height = if center > 0.0 {
            height.min(center)
        } else {
            height
        };
        Ok(middle + height * inward)
    }

    /// The size at a place before an edge.
    fn size_before(&self, edge: HalfEdgeId, place: DVec2) -> Result<f64, GradedError> {
        let size = self.field.at(place)?;
        if !self.field.is_sized() {
            return Ok(size);
        }
        let mesh = self.region.mesh();
        let [a, b] = [mesh.origin(edge), mesh.target(edge)].map(|v| self.sizes[v.index()]);
        Ok(size.max((1.0 - STEEPEST_FALL) * a.min(b)))
    }

    /// Whether a place keeps its distance to the vertices and boundary edges round its cavity.
    fn has_room(&self, cavity: &Cavity, place: DVec2, size: f64) -> bool {
        let [node, edge] = [CLOSEST_NODE, CLOSEST_EDGE].map(|share| share * size);
        let mut vertices = cavity.vertices();
        let mut rim = cavity.rim().iter();
        vertices.all(|v| self.region.point(v).distance_squared(place) >= node * node)
            && rim.all(|rim| {
                let beyond = rim.outer.face();
                if !self.region.mesh().is_ghost_face(beyond) {
                    return true;
                }
                let [b, a] = self.region.segment(rim.outer);
                (b - a).perp_dot(place - a) >= edge * a.distance(b)
            })
    }

    /// Notes that no node can be placed for a triangle; its neighbours have something finished beside them now.
    fn close(&mut self, face: FaceId) {
        self.faces[face.index()].closed = true;
        let beside = face.half_edges().map(|h| self.region.mesh().twin(h).face());
        beside.into_iter().for_each(|f| self.list(f));
    }

    /// Takes up new triangles.
    fn examine(&mut self, new: &[FaceId]) {
        let count = self.region.mesh().face_count();
        self.faces.resize(count, State::default());
        for &f in new {
            let state = State {
                excess: self.excess(f),
                closed: false,
                stamp: self.faces[f.index()].stamp + 1,
            };
            self.faces[f.index()] = state;
        }
        new.iter().for_each(|&f| self.list(f));
    }

    fn list(&mut self, face: FaceId) {
        if self.region.mesh().is_ghost_face(face) || !self.is_open(face) {
            return;
        }
        self.queue.push(Entry {
            urgency: self.urgency(face),
            face,
            stamp: self.faces[face.index()].stamp,
        });
    }

    fn urgency(&self, face: FaceId) -> f64 {
        match self.order {
            Order::LargestFirst => self.faces[face.index()].excess,
            Order::LayersFirst => {
                let corners = self.region.mesh().face_vertices(face);
                let layers = corners.map(|v| self.layers[v.index()]);
                let [first, ..] = corners;
                -f64::from(layers[0].min(layers[1]).min(layers[2]))
                    - 1e-3 * self.sizes[first.index()]
            }
        }
    }

    fn excess(&self, face: FaceId) -> f64 {
        let corners: [VertexId; 3] = self.region.mesh().face_vertices(face);
        let sizes = corners.map(|v| self.sizes[v.index()]);
        let mut size = sizes.iter().sum::<f64>() / 3.0;
        let triangle = self.region.triangle(face);
        let center = circumcenter(triangle);
        if self.field.is_sized() {
            // What is fine may lie between coarse nodes. A size that is none is found out when a node is placed.
            let inside = triangle.into_iter().sum::<DVec2>() / 3.0;
            let least = sizes.into_iter().fold(f64::INFINITY, f64::min);
            let inside = self.field.at(inside).unwrap_or(0.0);
            size = size.min(inside.max((1.0 - STEEPEST_FALL) * least));
        }
        center.distance(triangle[0]) * 3.0_f64.sqrt() / size
    }
}
