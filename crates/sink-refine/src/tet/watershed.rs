//! The sinks of all tetrahedra of low quality at once, each with the worst of its ancestors.

use super::flow::Successor3;
use super::records::Records;
use delaunay_core::{Subcomplex3, TetId};

/// Room for following all flows together, kept from round to round.
#[derive(Clone, Debug, Default)]
pub(crate) struct Watersheds {
    /// By tetrahedron.
    nodes: Vec<Node>,
    /// The tetrahedra reached.
    reached: Vec<TetId>,
    /// Those whose predecessors are all done.
    ready: Vec<TetId>,
}

#[derive(Clone, Copy, Debug, Default)]
struct Node {
    is_reached: bool,
    /// Predecessors reached that are not done.
    waiting: u32,
    /// How bad the worst ancestor of low quality is.
    worst: f64,
}

impl Watersheds {
    /// The sink tetrahedra in which flows from tetrahedra of low quality end, each with how bad the worst of those is;
    /// in no order.
    ///
    /// Every tetrahedron on the way is passed once, after its predecessors: takes time linear in their number.
    pub(crate) fn sinks(
        &mut self,
        solid: &Subcomplex3,
        records: &Records<'_>,
    ) -> Vec<(TetId, f64)> {
        self.nodes.clear();
        self.nodes.resize(records.slots(), Node::default());
        self.reach(solid, records);
        self.ready.clear();
        let nodes = &self.nodes;
        let first = self.reached.iter();
        self.ready
            .extend(first.filter(|t| nodes[t.index()].waiting == 0));
        let mut sinks = Vec::new();
        while let Some(t) = self.ready.pop() {
            let worst = self.nodes[t.index()].worst;
            let mut ends = true;
            for successor in records.flow(t).successors(solid, t) {
                ends = false;
                if let Successor3::Tet(beyond) = successor {
                    let node = &mut self.nodes[beyond.index()];
                    node.worst = node.worst.max(worst);
                    node.waiting -= 1;
                    if node.waiting == 0 {
                        self.ready.push(beyond);
                    }
                }
            }
            if ends {
                sinks.push((t, worst));
            }
        }
        sinks
    }

    /// Finds the tetrahedra of low quality and all that their flows pass.
    fn reach(&mut self, solid: &Subcomplex3, records: &Records<'_>) {
        self.reached.clear();
        for (t, worst) in records.all_low() {
            self.nodes[t.index()] = Node {
                is_reached: true,
                waiting: 0,
                worst,
            };
            self.reached.push(t);
        }
        let mut next = 0;
        while let Some(&t) = self.reached.get(next) {
            next += 1;
            for successor in records.flow(t).successors(solid, t) {
                if let Successor3::Tet(beyond) = successor {
                    let node = &mut self.nodes[beyond.index()];
                    node.waiting += 1;
                    if !std::mem::replace(&mut node.is_reached, true) {
                        self.reached.push(beyond);
                    }
                }
            }
        }
    }
}
