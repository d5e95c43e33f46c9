//! What points without a triangle are: none, one place, or a line.

use super::duplicates::Duplicates;
use crate::ids::VertexId;
use glam::DVec2;

/// Points that span no triangle, described by what they do span.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Flat {
    /// The distinct points in order along their line, the lexicographically smallest first; each
    /// by the smallest id at its place.
    pub vertices: Vec<VertexId>,
    /// The points that repeat one of `vertices`.
    pub duplicates: Duplicates,
}

/// The dimension of what [`Flat`] points span.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Extent {
    /// There are no points.
    Empty,
    /// All points are in one place.
    Point,
    /// There are two or more places, all on one line.
    Line,
}

impl Flat {
    /// What the points span.
    #[must_use]
    pub fn extent(&self) -> Extent {
        match self.vertices.len() {
            0 => Extent::Empty,
            1 => Extent::Point,
            _ => Extent::Line,
        }
    }

    /// Sorts points known to lie on one line.
    pub(super) fn sorted(points: &[DVec2]) -> Self {
        let mut order: Vec<VertexId> = (0..points.len()).map(VertexId::new).collect();
        let place = |v: VertexId| points[v.index()] + DVec2::ZERO;
        order.sort_unstable_by(|&a, &b| {
            let ([ax, ay], [bx, by]) = (place(a).to_array(), place(b).to_array());
            ax.total_cmp(&bx).then(ay.total_cmp(&by)).then(a.cmp(&b))
        });
        let mut vertices: Vec<VertexId> = Vec::new();
        let mut pairs = Vec::new();
        for v in order {
            match vertices.last() {
                Some(&last) if place(last) == place(v) => pairs.push((v, last)),
                _ => vertices.push(v),
            }
        }
        Self {
            vertices,
            duplicates: Duplicates::from_pairs(pairs),
        }
    }
}
