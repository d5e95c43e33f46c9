//! The sinks of all tetrahedra of low quality at once, each with the worst of its ancestors.

use super::flow::Successor3;
use super::records::Records;
use delaunay_core::{Subcomplex3, TetId};
use rayon::prelude::*;

/// Room for following all flows together, kept from round to round.
#[derive(Clone, Debug, Default)]
pub(crate) struct Watersheds {
    /// By tetrahedron.
    nodes: Vec<Node>,
    /// The tetrahedra reached, by the indices of their nodes.
    reached: Vec<u32>,
    /// Those whose predecessors are all done.
    ready: Vec<u32>,
}

/// A tetrahedron on the way of a flow.
#[derive(Clone, Copy, Debug)]
struct Node {
    /// How bad the worst ancestor of low quality is, itself included; 0 without one.
    worst: f64,
    /// Indices of the successors inside.
    next: [u32; 2],
    /// Predecessors reached that are not done.
    waiting: u32,
    is_reached: bool,
    /// Whether the flow ends here.
    is_sink: bool,
}

impl Node {
    const NOWHERE: u32 = u32::MAX;

    fn of(solid: &Subcomplex3, records: &Records<'_>, t: TetId) -> Self {
        let is_low = records.is_low(t);
        let mut node = Self {
            worst: if is_low { records.badness(t) } else { 0.0 },
            next: [Self::NOWHERE; 2],
            waiting: 0,
            is_reached: is_low,
            is_sink: true,
        };
        if records.is_there(t) {
            let successors = records.flow(t).successors(solid, t);
            for (next, successor) in node.next.iter_mut().zip(successors) {
                node.is_sink = false;
                if let Successor3::Tet(beyond) = successor {
                    *next = beyond.index() as u32;
                }
            }
        }
        node
    }

    fn next(self) -> impl Iterator<Item = u32> {
        let next = self.next.into_iter();
        next.filter(|&next| next != Self::NOWHERE)
    }
}

impl Watersheds {
    /// The sink tetrahedra in which flows from tetrahedra of low quality end, each with how bad the worst of those is; in no
    /// order.
    ///
    /// Every tetrahedron on the way is passed once, after its predecessors: takes time linear in the number of all tetrahedra,
    /// most of it on all threads.
    pub(crate) fn sinks(
        &mut self,
        solid: &Subcomplex3,
        records: &Records<'_>,
    ) -> Vec<(TetId, f64)> {
        let slots = (0..records.slots()).into_par_iter().with_min_len(1 << 10);
        slots
            .map(|index| Node::of(solid, records, TetId::new(index)))
            .collect_into_vec(&mut self.nodes);
        self.reach();
        self.ready.clear();
        let nodes = &self.nodes;
        let first = self.reached.iter();
        self.ready
            .extend(first.filter(|&&node| nodes[node as usize].waiting == 0));
        let mut sinks = Vec::new();
        while let Some(index) = self.ready.pop() {
            let here = self.nodes[index as usize];
            for next in here.next() {
                let node = &mut self.nodes[next as usize];
                node.worst = node.worst.max(here.worst);
                node.waiting -= 1;
                if node.waiting == 0 {
                    self.ready.push(next);
                }
            }
            if here.is_sink {
                sinks.push((TetId::new(index as usize), here.worst));
            }
        }
        sinks
    }

    /// Finds all that flows from tetrahedra of low quality pass.
    fn reach(&mut self) {
        let nodes = self.nodes.par_iter().with_min_len(1 << 12).enumerate();
        let low = nodes.filter(|(_, node)| node.is_reached);
        self.reached = low.map(|(index, _)| index as u32).collect();
        let mut next = 0;
        while let Some(&index) = self.reached.get(next) {
            next += 1;
            for beyond in self.nodes[index as usize].next() {
                let node = &mut self.nodes[beyond as usize];
                node.waiting += 1;
                if !std::mem::replace(&mut node.is_reached, true) {
                    self.reached.push(beyond);
                }
            }
        }
    }
}
