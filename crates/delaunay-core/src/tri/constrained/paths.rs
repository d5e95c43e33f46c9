//! Ways between two vertices that lead over others: segments through vertices, and segments that have been divided.

use super::triangulation::Constrained2;
use crate::ids::VertexId;
use rustc_hash::FxHashMap;

/// What is between the ends of ways that are more than an edge.
///
/// A way is known by its ends. Parts of a path may be ways that lead over further vertices; what is noted first stays, so that no
/// path comes to lead over itself.
#[derive(Clone, Debug, Default)]
pub(super) struct Paths {
    /// From the end with the smaller id, which comes first in the key.
    between: FxHashMap<[VertexId; 2], Vec<VertexId>>,
}

impl Paths {
    /// Notes that the way between the ends of a path leads along it. Vertices may repeat one after the other.
    pub(super) fn note(&mut self, mut path: Vec<VertexId>) {
        path.dedup();
        let (Some(&first), Some(&last)) = (path.first(), path.last()) else {
            return;
        };
        if path.len() < 3 || first == last {
            return;
        }
        if last < first {
            path.reverse();
        }
        let key = [first.min(last), first.max(last)];
        let between = path[1..path.len() - 1].to_vec();
        self.between.entry(key).or_insert(between);
    }

    /// Whether the way between two vertices is known to be more than an edge.
    pub(super) fn lead_over_others(&self, [a, b]: [VertexId; 2]) -> bool {
        self.between.contains_key(&[a.min(b), a.max(b)])
    }

    /// The path between two vertices, both included, from the first one on; `None` when the way is an edge or unknown.
    pub(super) fn path(&self, [a, b]: [VertexId; 2]) -> Option<Vec<VertexId>> {
        let between = self.between.get(&[a.min(b), a.max(b)])?;
        let mut path: Vec<VertexId> = [a.min(b)]
            .into_iter()
            .chain(between.iter().copied())
            .collect();
        path.push(a.max(b));
        if b < a {
            path.reverse();
        }
        Some(path)
    }
}

impl Constrained2 {
    /// The vertices along a segment with these ends that has been added, from the first end to the second, both included.
    ///
    /// `None` when there is no such chain of edges. Takes time proportional to the degrees of the vertices on it.
    #[must_use]
    pub fn chain(&self, ends: [VertexId; 2]) -> Option<Vec<VertexId>> {
        let [start, end] = ends.map(|v| self.vertex_at(v));
        let mut chain = vec![start];
        // What is still to be followed, the next piece on top.
        let mut pending = vec![[start, end]];
        while let Some([a, b]) = pending.pop() {
            if let Some(path) = self.paths.path([a, b]) {
                pending.extend(path.windows(2).rev().map(|piece| [piece[0], piece[1]]));
                continue;
            }
            let h = self.mesh.find_half_edge(a, b)?;
            if !self.is_constrained(h) {
                return None;
            }
            chain.push(b);
        }
        Some(chain)
    }
}
