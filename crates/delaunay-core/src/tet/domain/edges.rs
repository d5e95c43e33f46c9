//! The edges of triangles, each with the triangles on it.

use super::defect::{OddEdge, OpenEdge};
use super::defects::DomainDefects;
use super::holes::holes;
use super::options::Domain3Options;
use super::soup::Soup;
use crate::ids::VertexId;
use crate::tet::surface::sorted;

/// One side of a triangle.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Side {
    /// The ends of the edge, by id.
    pub(super) ends: [VertexId; 2],
    triangle: u32,
    /// Whether the corners of the triangle go from the smaller end to the greater.
    pub(super) forward: bool,
}

impl Side {
    pub(super) fn triangle(self) -> usize {
        self.triangle as usize
    }
}

/// The sides of triangles, edge by edge.
pub(super) struct Edges {
    sides: Vec<Side>,
}

impl Edges {
    /// The edges of triangles with the numbers that come with them, which are below 2^32; sides at the ghost are left out. Takes
    /// n log n time.
    pub(super) fn of(triangles: impl Iterator<Item = (usize, [VertexId; 3])>) -> Self {
        let sides = triangles.flat_map(|(triangle, [a, b, c])| {
            [[a, b], [b, c], [c, a]].map(|[from, to]| Side {
                ends: sorted([from, to]),
                triangle: triangle as u32,
                forward: from < to,
            })
        });
        let there = |side: &Side| !side.ends.contains(&VertexId::GHOST);
        let mut sides: Vec<Side> = sides.filter(there).collect();
        sides.sort_unstable();
        Self { sides }
    }

    /// The sides on each edge, by its ends, then by triangle.
    pub(super) fn iter(&self) -> impl Iterator<Item = &[Side]> + '_ {
        self.sides.chunk_by(|side, next| side.ends == next.ends)
    }

    /// Edges that have one triangle or an odd number of them, unless this is allowed.
    pub(super) fn judge(
        &self,
        soup: &Soup<'_>,
        options: Domain3Options,
        defects: &mut DomainDefects,
    ) {
        for on_edge in self.iter() {
            let ends = on_edge[0].ends.map(|v| soup.placed(v));
            if let &[side] = on_edge {
                if !(options.interfaces && options.dangling) {
                    let triangle = side.triangle();
                    defects.open_edges.push(OpenEdge { ends, triangle });
                }
            } else if on_edge.len() % 2 == 1 && !options.interfaces {
                let triangles = on_edge.iter().map(|side| side.triangle()).collect();
                defects.odd_edges.push(OddEdge { ends, triangles });
            }
        }
        let open = defects.open_edges.iter();
        let open: Vec<_> = open.map(|edge| edge.ends.map(|end| end.vertex)).collect();
        defects.holes = holes(&open);
    }
}
