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
use glam::DVec2;

use crate::error::BoundaryError;

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
}

/// Area of the bubble at a boundary node whose two edges have lengths `l1` and `l2`: the mean of the areas of
/// two equilateral triangles on those edges.
///
/// Square of the unit of length. Source: eq. 1.
#[must_use]
pub fn boundary_node_area(l1: f64, l2: f64) -> f64 {
    3f64.sqrt() / 8.0 * (l1 * l1 + l2 * l2)
}

/// Radius of the bubble at a boundary node whose two edges have lengths `l1` and `l2`.
///
/// Same unit as the lengths; 0.3713 of the length when both are equal. Source: eq. 2.
#[must_use]
pub fn boundary_node_radius(l1: f64, l2: f64) -> f64 {
    (boundary_node_area(l1, l2) / PI).sqrt()
}

/// Bubbles of the nodes of a closed boundary, in the order of the nodes.
///
/// `nodes` follow each other round the boundary in either sense, the last is joined to the first. Whether the
/// boundary crosses itself is not looked at. O(nodes). Source: eq. 2.
///
/// # Errors
/// [`BoundaryError`] when there are fewer than three nodes, and for the first node that is not an accepted
/// point or is in the same place as the next.
pub fn boundary_bubbles(nodes: &[DVec2]) -> Result<Vec<Bubble>, BoundaryError> {
    let lengths = edge_lengths(nodes)?;
    let before = lengths.iter().cycle().skip(lengths.len() - 1);
    let bubbles = nodes
        .iter()
        .zip(before.zip(&lengths))
        .map(|(&center, (&before, &after))| Bubble {
            center,
            radius: boundary_node_radius(before, after),
        });
    Ok(bubbles.collect())
}

/// Density of the bubble of the triangle between three nodes: area of the bubble over area of the triangle.
///
/// Dimensionless, not negative; the smaller, the more the triangle needs a node inside. Infinite for a
/// triangle without area: no node can be put into it. Source: eq. 5.
#[must_use]
pub fn bubble_density(nodes: [Bubble; 3]) -> f64 {
    match triangle::area(nodes.map(|node| node.center)) {
        0.0 => f64::INFINITY,
        area => Bubble::of_element(nodes).area() / area,
    }
}

/// The centroid of a triangle, which is always inside it (§2.2).
#[must_use]
pub fn centroid([a, b, c]: [DVec2; 3]) -> DVec2 {
    a + ((b - a) + (c - a)) / 3.0
}

/// The length of the edge after each node; at least three, none zero.
fn edge_lengths(nodes: &[DVec2]) -> Result<Vec<f64>, BoundaryError> {
    delaunay_core::geo_predicates::check_points2(nodes)?;
    if nodes.len() < 3 {
        return Err(BoundaryError::TooFewNodes { count: nodes.len() });
    }
    let next = nodes.iter().cycle().skip(1);
    let edges = nodes.iter().zip(next).enumerate();
    edges
        .map(|(node, (start, end))| match start.distance(*end) {
            0.0 => Err(BoundaryError::RepeatedNode { node }),
            length => Ok(length),
        })
        .collect()
}
