//! Multi-face removal: facets between two vertices give way to an edge (Shewchuk 2002, *Two discrete optimization
//! algorithms for the topological improvement of tetrahedral meshes*).
//!
//! ```text
//!              a             A facet is sandwiched between a and b when it makes a tetrahedron with either. Some connected
//!            / | \           sandwiched facets, in the drawing uvw and others behind it, are m facets with m + 2 edges
//!          u --|-- w         round them: 2 m tetrahedra give way to m + 2 round the new edge ab, one on each of these
//!            \ v /           edges. With one facet it is the 2-3 flip; the inverse of an edge removal in any case.
//!              b
//! ```
//!
//! Facets are taken in across an edge where that is better than to make a tetrahedron on this edge, from the far end back.

use crate::plan::Exchange;
use crate::quality::min_sine;
use crate::records::Records;
use delaunay_core::{Complex3, FacetId, TetId, VertexId};

/// How many facets away from the first one a facet may be.
const DEPTH: usize = 4;

/// The removal of the facet `f`, with others between the same two vertices, whose worst tetrahedron is best, if that is
/// better than what it replaces.
///
/// `None` for a facet on the boundary. Takes constant time.
pub(crate) fn plan(complex: &Complex3, records: &Records, f: FacetId) -> Option<Exchange> {
    let mesh = complex.mesh();
    let twin = mesh.twin(f);
    if mesh.is_ghost_tet(twin.tet()) {
        return None;
    }
    let sandwich = Sandwich {
        complex,
        records,
        // Counterclockwise seen from `f`'s outside, where `b` is: `[a, u, v, w]` is right-handed.
        ends: [mesh.apex(f), mesh.apex(twin)],
    };
    let [u, v, w] = mesh.facet_vertices(f);
    let mut part = Part {
        old: records.worst(&[f.tet(), twin.tet()]),
        new: f64::INFINITY,
        gone: vec![f.tet(), twin.tet()],
        made: Vec::new(),
    };
    for edge in [[u, v], [v, w], [w, u]] {
        part.join(sandwich.beyond(f.tet(), twin.tet(), edge, DEPTH));
    }
    // Facets all round a vertex meet again; they leave no edge on which to stand.
    let mut gone = part.gone.clone();
    gone.sort_unstable();
    let distinct = gone.windows(2).all(|pair| pair[0] != pair[1]);
    (part.new > part.old && distinct).then_some(Exchange {
        gone: part.gone,
        made: part.made,
        quality: part.new,
    })
}

/// The facets between two vertices.
struct Sandwich<'a> {
    complex: &'a Complex3,
    records: &'a Records,
    ends: [VertexId; 2],
}

/// What goes and comes beyond an edge.
struct Part {
    /// Quality of the worst tetrahedron that goes.
    old: f64,
    /// Quality of the worst that comes.
    new: f64,
    gone: Vec<TetId>,
    made: Vec<[VertexId; 4]>,
}

impl Part {
    fn join(&mut self, other: Self) {
        self.old = self.old.min(other.old);
        self.new = self.new.min(other.new);
        self.gone.extend(other.gone);
        self.made.extend(other.made);
    }
}

impl Sandwich<'_> {
    /// The better of two: a tetrahedron on `edge`, or to remove the facet beyond it, too.
    ///
    /// `above` and `below` are the tetrahedra with the ends on the side of `edge` that goes; the edge runs
    /// counterclockwise seen from the second end.
    fn beyond(&self, above: TetId, below: TetId, edge: [VertexId; 2], depth: usize) -> Part {
        let ([a, b], [u, w]) = (self.ends, edge);
        let corners = [a, u, w, b];
        let closed = Part {
            old: f64::INFINITY,
            new: min_sine(corners.map(|v| self.complex.point(v))),
            gone: Vec::new(),
            made: vec![corners],
        };
        match self.open(above, below, edge, depth) {
            Some(open) if open.new > closed.new.min(open.old) => open,
            _ => closed,
        }
    }

    /// What removing the facet beyond `edge` makes, if there is a sandwiched one.
    fn open(
        &self,
        above: TetId,
        below: TetId,
        [u, w]: [VertexId; 2],
        depth: usize,
    ) -> Option<Part> {
        let mesh = self.complex.mesh();
        let across = |t: TetId, end: VertexId| {
            let corners = mesh.tet_vertices(t);
            let third = |v: &VertexId| ![u, w, end].contains(v);
            let exit = t.facet(corners.iter().position(third)?);
            let entry = mesh.twin(exit);
            (!mesh.is_ghost_tet(entry.tet())).then(|| (entry.tet(), mesh.apex(entry)))
        };
        let depth = depth.checked_sub(1)?;
        let ((above, x), (below, y)) = (across(above, self.ends[0])?, across(below, self.ends[1])?);
        if x != y || self.ends.contains(&x) {
            return None;
        }
        let gone = vec![above, below];
        let mut part = Part {
            old: self.records.worst(&gone),
            new: f64::INFINITY,
            gone,
            made: Vec::new(),
        };
        for edge in [[u, x], [x, w]] {
            part.join(self.beyond(above, below, edge, depth));
        }
        Some(part)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample::{cube, exercise};
    use std::collections::BTreeSet;

    #[test]
    fn facets_inside_give_way_to_better_tetrahedra() {
        let mut sizes = BTreeSet::new();
        for seed in 0..20 {
            let removed = exercise(cube(4, seed), |complex, records, t| {
                let facets = t.facets().into_iter();
                let plans = facets.filter_map(|f| plan(complex, records, f));
                let plan = plans.max_by_key(|plan| plan.gone.len())?;
                assert_eq!(plan.made.len(), plan.gone.len() / 2 + 2);
                assert!(plan.quality > records.worst(&plan.gone));
                sizes.insert(plan.gone.len());
                Some(plan)
            });
            assert!(removed > 5, "{removed}");
        }
        assert!(sizes.contains(&2) && sizes.contains(&4), "{sizes:?}");
    }
}
