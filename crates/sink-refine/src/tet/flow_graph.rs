//! The relation of all tetrahedra at once (§3.3): successors, predecessors, ancestors and sinks.

use super::flow::{Successor3, successors};
use delaunay_core::{Subcomplex3, TetId};

/// The flow relation τ ≺ σ of a subcomplex, a graph without cycles where they are Delaunay. Valid as long as the subcomplex does not change.
#[derive(Clone, Debug)]
pub struct FlowGraph3 {
    /// Pairs (σ, τ) with τ ≺ σ, ascending.
    arcs: Vec<(TetId, TetId)>,
    /// The tetrahedra without successor, ascending.
    sinks: Vec<TetId>,
    /// The tetrahedra that precede ω, ascending.
    outlets: Vec<TetId>,
    slots: usize,
}

impl FlowGraph3 {
    /// The relation of all tetrahedra. Exact, linear time but for sorting.
    #[must_use]
    pub fn of(solid: &Subcomplex3) -> Self {
        let mut graph = Self {
            arcs: Vec::new(),
            sinks: Vec::new(),
            outlets: Vec::new(),
            slots: solid.mesh().tet_slots(),
        };
        for t in solid.tets() {
            let mut ends = true;
            for successor in successors(solid, t) {
                ends = false;
                match successor {
                    Successor3::Tet(beyond) => graph.arcs.push((beyond, t)),
                    Successor3::Outside(_) => graph.outlets.push(t),
                }
            }
            if ends {
                graph.sinks.push(t);
            }
        }
        graph.outlets.dedup();
        graph.arcs.sort_unstable();
        graph
    }

    /// The sink tetrahedra, by id. Two that share a facet through their common circumcenter are both listed.
    #[must_use]
    pub fn sinks(&self) -> &[TetId] {
        &self.sinks
    }

    /// The tetrahedra whose flow crosses the boundary next, by id: the predecessors of ω.
    #[must_use]
    pub fn outlets(&self) -> &[TetId] {
        &self.outlets
    }

    /// The tetrahedra τ with τ ≺ `t`, by id; at most four. O(log n).
    pub fn predecessors(&self, t: TetId) -> impl Iterator<Item = TetId> + Clone + '_ {
        let first = self.arcs.partition_point(|&(to, _)| to < t);
        let arcs = self.arcs[first..].iter();
        arcs.take_while(move |&&(to, _)| to == t)
            .map(|&(_, from)| from)
    }

    /// The tetrahedra from which the flow reaches `t`, itself among them, by id: the ancestors of §3.3. Linear in their number, times
    /// a logarithm.
    #[must_use]
    pub fn ancestors(&self, t: TetId) -> Vec<TetId> {
        let mut seen = vec![false; self.slots];
        let mut ancestors = vec![t];
        if let Some(first) = seen.get_mut(t.index()) {
            *first = true;
        }
        let mut next = 0;
        while let Some(&here) = ancestors.get(next) {
            next += 1;
            for before in self.predecessors(here) {
                if !std::mem::replace(&mut seen[before.index()], true) {
                    ancestors.push(before);
                }
            }
        }
        ancestors.sort_unstable();
        ancestors
    }
}
