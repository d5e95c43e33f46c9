//! Node bubbles, element bubbles and bubble density (§2.3, eq. 1–5).
//!
//! A bubble says how large the mesh should be where it is. The bubbles of the boundary nodes are given by the
//! boundary's edges, the bubble of a triangle by those of its corners, and the triangle whose bubble covers it
//! the least is the one that needs a node most:
//!
//! ```text
//!            c
//!          / | \          r_e between r_a, r_b and r_c, nearest to that of the closest corner (eq. 3)
//!        /  (e)  \        density = area of the bubble e over area of the triangle abc      (eq. 5)
//!      a --------- b
//! ```

use std::f64::consts::PI;

use delaunay_core::measure::triangle;
use delaunay_core::{HalfEdgeId, Subcomplex2, VertexId};
use glam::DVec2;

/// A circle round a mesh node, or round the centroid of a mesh triangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bubble {
    /// The node or the centroid.
    pub center: DVec2,
    /// Not negative; unit of length.
    pub radius: f64,
}

impl Bubble {
    /// Bubble of the triangle between three nodes, round its centroid.
    ///
    /// Its radius is the mean of the nodes' radii, weighted by the reciprocals of their distances from the
    /// centroid; if all three nodes are in one place, the plain mean. Source: eq. 3.
    #[must_use]
    pub fn of_element(nodes: [Bubble; 3]) -> Self {
        let center = centroid(nodes.map(|node| node.center));
        let [a, b, c] = nodes.map(|node| node.center.distance(center));
        // 1/a : 1/b : 1/c, and no division: the centroid may be in a corner.
        let weights = match [b * c, c * a, a * b] {
            [0.0, 0.0, 0.0] => [1.0; 3],
            weights => weights,
        };
        let total: f64 = weights.into_iter().sum();
        let weighted: f64 = nodes
            .iter()
            .zip(weights)
            .map(|(node, weight)| node.radius * weight)
            .sum();
        Self {
            center,
            radius: weighted / total,
        }
    }

    /// Area of the bubble; square of the unit of length. Source: eq. 4.
    #[must_use]
    pub fn area(&self) -> f64 {
        PI * self.radius * self.radius
    }

    /// Area of the bubble over that of a triangle; infinite when the triangle has none. Source: eq. 5.
    pub(crate) fn density_in(&self, corners: [DVec2; 3]) -> f64 {
        match triangle::signed_area(corners).abs() {
            0.0 => f64::INFINITY,
            area => self.area() / area,
        }
    }
}

/// Area of the bubble at a boundary node whose edges have these lengths: the mean of the areas of equilateral
/// triangles on those edges.
///
/// Square of the unit of length; 0 without edges. Source: eq. 1, where the edges are two; where loops touch they
/// are four or more.
#[must_use]
pub fn boundary_node_area(lengths: &[f64]) -> f64 {
    let squares: f64 = lengths.iter().map(|length| length * length).sum();
    3f64.sqrt() / 4.0 * squares / lengths.len().max(1) as f64
}

/// Radius of the bubble at a boundary node whose edges have these lengths.
///
/// Same unit as the lengths; 0.3713 of the length when all are equal. Source: eq. 2.
#[must_use]
pub fn boundary_node_radius(lengths: &[f64]) -> f64 {
    (boundary_node_area(lengths) / PI).sqrt()
}

/// Bubbles of the boundary nodes of a region, by vertex; inner vertices and points without triangles have radius 0.
///
/// An edge with the region on both sides counts once, and neither the order nor the sense of the edges shows. Takes n log n
/// time. Source: eq. 2.
#[must_use]
pub fn boundary_bubbles(region: &Subcomplex2) -> Vec<Bubble> {
    let without_size = |&center| Bubble {
        center,
        radius: 0.0,
    };
    let mut bubbles: Vec<Bubble> = region.points().iter().map(without_size).collect();
    for edges in edges_by_node(region).chunk_by(|a, b| a.0 == b.0) {
        let lengths: Vec<f64> = edges.iter().map(|&(_, length)| length).collect();
        bubbles[edges[0].0.index()].radius = boundary_node_radius(&lengths);
    }
    bubbles
}

/// Density of the bubble of the triangle between three nodes: area of the bubble over area of the triangle.
///
/// Dimensionless, not negative; the smaller, the more the triangle needs a node inside. Infinite for a
/// triangle without area: no node can be put into it. Source: eq. 5.
#[must_use]
pub fn bubble_density(nodes: [Bubble; 3]) -> f64 {
    Bubble::of_element(nodes).density_in(nodes.map(|node| node.center))
}

/// The centroid of a triangle, which is always inside it (§2.2).
#[must_use]
pub fn centroid([a, b, c]: [DVec2; 3]) -> DVec2 {
    a + ((b - a) + (c - a)) / 3.0
}

/// Every node with the length of each of its edges, sorted, so that equal boundaries give equal bits.
fn edges_by_node(region: &Subcomplex2) -> Vec<(VertexId, f64)> {
    let mesh = region.mesh();
    let is_second = |h: HalfEdgeId| region.partner(h).is_some_and(|partner| partner < h);
    let mut edges: Vec<(VertexId, f64)> = Vec::new();
    for h in region.boundary().filter(|&h| !is_second(h)) {
        let [a, b] = region.segment(h);
        edges.extend([mesh.origin(h), mesh.target(h)].map(|v| (v, a.distance(b))));
    }
    edges.sort_unstable_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)));
    edges
}
