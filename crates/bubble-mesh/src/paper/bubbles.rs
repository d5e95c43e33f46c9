//! The node bubbles while they move.
//!
//! They are worked on in the order in which a breadth-first search meets them, so that those that are near each other in the mesh
//! are near each other in memory; vertices are numbered as they were generated, which is all over the region.

use std::collections::VecDeque;

use delaunay_core::{TriMesh, VertexId};

use crate::bubble::Bubble;

/// The bubbles of all nodes; first those of the boundary, by vertex, then the others in breadth-first order.
#[derive(Clone, Debug)]
pub(super) struct Bubbles {
    pub(super) all: Vec<Bubble>,
    /// How many are on the boundary.
    pub(super) boundary_nodes: usize,
}

impl Bubbles {
    /// The bubbles of the nodes in `order`.
    pub(super) fn in_order(bubbles: &[Bubble], order: &Order, boundary_nodes: usize) -> Self {
        let ordered = order.vertices.iter().map(|v| bubbles[v.index()]);
        Self {
            all: ordered.collect(),
            boundary_nodes,
        }
    }

    /// The bubble with this number.
    #[inline]
    pub(super) fn get(&self, number: usize) -> Bubble {
        self.all[number]
    }

    /// The bubble of an interior node, counted from the first of them.
    #[inline]
    pub(super) fn interior(&self, number: usize) -> Bubble {
        self.get(self.boundary_nodes + number)
    }

    pub(super) fn interior_count(&self) -> usize {
        self.all.len() - self.boundary_nodes
    }

    /// All of them, by vertex.
    pub(super) fn by_vertex(&self, order: &Order) -> Vec<Bubble> {
        let numbers = order.numbers.iter();
        numbers.map(|&number| self.get(number as usize)).collect()
    }
}

/// Which node has which number.
#[derive(Clone, Debug)]
pub(super) struct Order {
    /// By number.
    pub(super) vertices: Vec<VertexId>,
    /// By vertex.
    numbers: Vec<u32>,
}

impl Order {
    /// The boundary nodes as they are, the others as a search from the first of them in each part of the region meets them. Linear
    /// time.
    pub(super) fn breadth_first(mesh: &TriMesh, boundary_nodes: usize, count: usize) -> Self {
        const UNMET: u32 = u32::MAX;
        let mut vertices: Vec<VertexId> = (0..boundary_nodes).map(VertexId::new).collect();
        let mut numbers = vec![UNMET; count];
        (0..)
            .zip(&mut numbers[..boundary_nodes])
            .for_each(|(k, number)| *number = k);
        let mut front = VecDeque::new();
        for start in 0..count {
            front.push_back(VertexId::new(start));
            while let Some(v) = front.pop_front() {
                for neighbor in mesh.neighbors(v).filter(|v| !v.is_ghost()) {
                    if let Some(number @ &mut UNMET) = numbers.get_mut(neighbor.index()) {
                        *number = vertices.len() as u32;
                        vertices.push(neighbor);
                        front.push_back(neighbor);
                    }
                }
            }
        }
        Self { vertices, numbers }
    }

    /// The number of a node.
    pub(super) fn number(&self, v: VertexId) -> u32 {
        self.numbers[v.index()]
    }
}
