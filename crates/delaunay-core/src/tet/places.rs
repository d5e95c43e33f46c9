//! Which points are at the same place, bit for bit but for the sign of zero.

use crate::ids::VertexId;
use glam::DVec3;
use std::cmp::Ordering;

/// By point, the first point at its place.
pub(super) struct Places {
    first: Vec<VertexId>,
}

impl Places {
    /// Compares the points that are to be compared; each of the others has a place of its own. Takes n log n time.
    pub(super) fn of(points: &[DVec3], compared: impl Fn(usize) -> bool) -> Self {
        // Coordinates that are accepted are numbers, so any two can be compared, and -0.0 equals 0.0.
        let by_place = |&i: &usize, &j: &usize| {
            let [p, q] = [i, j].map(|index| points[index].to_array());
            p.partial_cmp(&q).unwrap_or(Ordering::Equal)
        };
        let mut order: Vec<usize> = (0..points.len()).filter(|&i| compared(i)).collect();
        order.sort_unstable_by(|i, j| by_place(i, j).then(i.cmp(j)));
        let mut first: Vec<VertexId> = (0..points.len()).map(VertexId::new).collect();
        for together in order.chunk_by(|i, j| by_place(i, j).is_eq()) {
            for &index in together {
                first[index] = VertexId::new(together[0]);
            }
        }
        Self { first }
    }

    /// The first point where a point is: itself, unless there is an earlier one. The ghost is where no point is.
    pub(super) fn first(&self, v: VertexId) -> VertexId {
        self.first.get(v.index()).map_or(VertexId::GHOST, |&v| v)
    }

    /// The points that are where an earlier one is, by id, each with the first one there.
    pub(super) fn doubles(&self) -> impl Iterator<Item = [VertexId; 2]> + '_ {
        let all = self.first.iter().enumerate();
        let named = all.map(|(index, &first)| [first, VertexId::new(index)]);
        named.filter(|[first, second]| first != second)
    }
}
