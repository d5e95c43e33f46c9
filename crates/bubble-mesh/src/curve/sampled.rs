//! Nodes and edges on curves, ready to bound a region.

use std::collections::BTreeMap;

use delaunay_core::{Outline, OutlineError, VertexId};
use glam::DVec2;

use super::place::{Mark, Span};

/// Nodes on curves and the edges between them, curve by curve in the order of the arc length.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Sampled {
    /// The nodes, by vertex. Where ends of pieces are at exactly one place, of one curve or of several, they are one node.
    pub points: Vec<DVec2>,
    /// The edges, each from a node to the next along its curve.
    pub segments: Vec<[VertexId; 2]>,
    /// By edge, the index of its curve.
    pub curve_of: Vec<usize>,
    /// By node, the arc length from the start of its curve, the first one that it is on.
    pub arc_of: Vec<f64>,
}

impl Sampled {
    /// The outline of all edges, that of a region when curves are closed, or close together, and do not cross.
    ///
    /// Takes n log n time. Whether edges cross is only known to [`Outline::region`].
    ///
    /// # Errors
    /// As [`Outline::new`]: open curves that close nothing, for instance.
    pub fn outline(&self) -> Result<Outline, OutlineError> {
        Outline::new(self.points.clone(), self.segments.clone())
    }
}

/// Numbers nodes in the order in which they are met.
#[derive(Default)]
pub(super) struct Numbering {
    sampled: Sampled,
    /// The nodes at joints, by the bits of their places.
    joints: BTreeMap<[u64; 2], VertexId>,
}

impl Numbering {
    /// Adds a curve that is divided at its joints.
    pub(super) fn add(&mut self, curve: usize, spans: &[Span]) {
        for Span { marks, .. } in spans {
            let [first, inner @ .., last] = marks.as_slice() else {
                continue;
            };
            let mut before = self.joint(first);
            for mark in inner {
                let node = self.node(mark);
                self.edge([before, node], curve);
                before = node;
            }
            let last = self.joint(last);
            self.edge([before, last], curve);
        }
    }

    pub(super) fn finish(self) -> Sampled {
        self.sampled
    }

    fn joint(&mut self, mark: &Mark) -> VertexId {
        // The sum with zero is never -0.0.
        let key = (mark.place + DVec2::ZERO).to_array().map(f64::to_bits);
        if let Some(&node) = self.joints.get(&key) {
            return node;
        }
        let node = self.node(mark);
        self.joints.insert(key, node);
        node
    }

    fn node(&mut self, mark: &Mark) -> VertexId {
        let node = VertexId::new(self.sampled.points.len());
        self.sampled.points.push(mark.place);
        self.sampled.arc_of.push(mark.arc);
        node
    }

    fn edge(&mut self, ends: [VertexId; 2], curve: usize) {
        self.sampled.segments.push(ends);
        self.sampled.curve_of.push(curve);
    }
}
