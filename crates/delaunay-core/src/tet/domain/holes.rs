//! Open edges as they follow one another round holes.
//!
//! ```text
//!       a-------b           Where four open edges meet, as at c, a loop is cut off as soon as a walk comes
//!       |       |           to a vertex again: no loop has a vertex twice.
//!       d-------c-------f
//!               |       |   Loops: a b c d and c f g h.
//!               h-------g
//! ```

use crate::ids::VertexId;
use rustc_hash::FxHashMap;

/// Open edges that follow one another.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Hole {
    /// The vertices, as given, each once: from each to the next goes an open edge.
    pub vertices: Vec<VertexId>,
    /// Whether there is also an edge from the last to the first. All holes are closed unless other defects, as edges with three
    /// triangles, are where the chain ends.
    pub closed: bool,
}

impl Hole {
    /// The number of open edges.
    #[must_use]
    pub fn edge_count(&self) -> usize {
        self.vertices.len() - usize::from(!self.closed)
    }
}

/// The open edges at each vertex, and which have been walked.
struct Walks<'a> {
    edges: &'a [[VertexId; 2]],
    walked: Vec<bool>,
    /// Vertices with the edges at them, in order.
    at: Vec<(VertexId, usize)>,
    /// By vertex, where in `at` its edges that may not have been walked begin.
    rest: FxHashMap<VertexId, usize>,
}

/// Loops and chains of edges, each edge in one of them. Takes n log n time.
pub(super) fn holes(edges: &[[VertexId; 2]]) -> Vec<Hole> {
    let ends = |(index, &[a, b]): (usize, &[VertexId; 2])| [(a, index), (b, index)];
    let mut at: Vec<_> = edges.iter().enumerate().flat_map(ends).collect();
    at.sort_unstable();
    let vertices: Vec<_> = at.chunk_by(|(v, _), (w, _)| v == w).collect();
    // A chain has to be walked from an end.
    let odd = vertices.iter().filter(|edges| edges.len() % 2 == 1);
    let starts: Vec<VertexId> = odd.chain(&vertices).map(|edges| edges[0].0).collect();
    let mut first = 0;
    let mut rest = FxHashMap::default();
    for edges in &vertices {
        rest.insert(edges[0].0, first);
        first += edges.len();
    }
    let mut walks = Walks {
        edges,
        walked: vec![false; edges.len()],
        at,
        rest,
    };
    let mut holes = Vec::new();
    for start in starts {
        walks.walk(start, &mut holes);
    }
    holes
}

impl Walks<'_> {
    /// Walks from a vertex as long as there are edges, which become fewer with every step.
    fn walk(&mut self, start: VertexId, holes: &mut Vec<Hole>) {
        let mut path = vec![start];
        let mut position = FxHashMap::from_iter([(start, 0)]);
        let mut here = start;
        while let Some(next) = self.step(here) {
            here = next;
            let Some(&again) = position.get(&next) else {
                position.insert(next, path.len());
                path.push(next);
                continue;
            };
            let vertices: Vec<_> = path[again..].to_vec();
            path.truncate(again + 1);
            for v in &vertices[1..] {
                position.remove(v);
            }
            let closed = true;
            holes.push(Hole { vertices, closed });
        }
        if path.len() > 1 {
            let (vertices, closed) = (path, false);
            holes.push(Hole { vertices, closed });
        }
    }

    /// The other end of the first edge at a vertex that has not been walked.
    fn step(&mut self, from: VertexId) -> Option<VertexId> {
        let rest = self.rest.get_mut(&from)?;
        while let Some(&(_, edge)) = self.at.get(*rest).filter(|(v, _)| *v == from) {
            *rest += 1;
            if !self.walked[edge] {
                self.walked[edge] = true;
                let [a, b] = self.edges[edge];
                return Some(if a == from { b } else { a });
            }
        }
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(edges: &[[usize; 2]]) -> Vec<(Vec<usize>, bool)> {
        let edges: Vec<_> = edges.iter().map(|ends| ends.map(VertexId::new)).collect();
        let holes = holes(&edges);
        let count: usize = holes.iter().map(Hole::edge_count).sum();
        assert_eq!(count, edges.len());
        let plain = |hole: Hole| {
            let vertices = hole.vertices.iter().map(|v| v.index()).collect();
            (vertices, hole.closed)
        };
        holes.into_iter().map(plain).collect()
    }

    #[test]
    fn loops_that_meet_at_a_vertex_are_told_apart() {
        let square = [[0, 1], [1, 2], [2, 3], [0, 3]];
        let other = [[2, 4], [4, 5], [5, 6], [2, 6]];
        assert_eq!(found(&square), [(vec![0, 1, 2, 3], true)]);
        let both = found(&[square, other].concat());
        assert_eq!(both.len(), 2);
        assert!(
            both.iter()
                .all(|(vertices, closed)| *closed && vertices.len() == 4)
        );
    }

    #[test]
    fn a_chain_is_walked_from_end_to_end() {
        assert_eq!(
            found(&[[1, 2], [0, 1], [2, 3]]),
            [(vec![0, 1, 2, 3], false)]
        );
        let with_loop = found(&[[0, 1], [1, 2], [2, 3], [1, 3]]);
        assert_eq!(with_loop, [(vec![1, 2, 3], true), (vec![0, 1], false)]);
        assert!(found(&[]).is_empty());
    }
}
