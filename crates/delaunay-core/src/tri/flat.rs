//! What points without a triangle are: none, one place, or a line; without a tetrahedron, also a plane.

use super::duplicates::Duplicates;
use super::mesh::TriMesh;
use crate::ids::VertexId;
use glam::DVec2;

/// Points that span no triangle, or in space no tetrahedron, described by what they do span.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Flat {
    /// The distinct points in lexicographic order, which is the order along their line; each by the
    /// smallest id at its place.
    pub vertices: Vec<VertexId>,
    /// The points that repeat one of `vertices`.
    pub duplicates: Duplicates,
    /// The Delaunay triangulation in their plane, for points of space that span one: exact, with the
    /// ties of a triangulation of the plane, ghost faces on the hull edges included.
    pub plane: Option<TriMesh>,
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
    /// There are three or more places, all on one plane and not on one line.
    Plane,
}

impl Flat {
    /// What the points span.
    #[must_use]
    pub fn extent(&self) -> Extent {
        match self.vertices.len() {
            _ if self.plane.is_some() => Extent::Plane,
            0 => Extent::Empty,
            1 => Extent::Point,
            _ => Extent::Line,
        }
    }

    /// Sorts points known to lie on one line.
    pub(super) fn sorted(points: &[DVec2]) -> Self {
        Self::sorted_by(points.len(), |i| (points[i] + DVec2::ZERO).to_array())
    }

    /// Sorts `count` points with coordinates `place(index)`, in which no zero is negative.
    pub(crate) fn sorted_by<const N: usize>(
        count: usize,
        place: impl Fn(usize) -> [f64; N],
    ) -> Self {
        let mut order: Vec<VertexId> = (0..count).map(VertexId::new).collect();
        order.sort_unstable_by(|&a, &b| {
            let pairs = place(a.index()).into_iter().zip(place(b.index()));
            let mut differences = pairs.map(|(a, b)| a.total_cmp(&b));
            let first = differences.find(|order| order.is_ne());
            first.unwrap_or(a.cmp(&b))
        });
        let mut vertices: Vec<VertexId> = Vec::new();
        let mut pairs = Vec::new();
        for v in order {
            match vertices.last() {
                Some(&last) if place(last.index()) == place(v.index()) => pairs.push((v, last)),
                _ => vertices.push(v),
            }
        }
        Self {
            vertices,
            duplicates: Duplicates::from_pairs(pairs),
            plane: None,
        }
    }
}
