//! All pairs of triangles that intersect.

use super::defect::Intersection;
use super::defects::DomainDefects;
use super::hierarchy::Hierarchy;
use super::parting::{Seen, best_view};
use super::soup::Soup;
use crate::ids::VertexId;
use crate::progress::{Cancelled, Meter};
use crate::tet::bounds::Bounds;
use crate::tet::intersection::triangles_intersect;
use crate::threads;
use glam::DVec3;

/// Triangles between two reports.
const BATCH: usize = 2048;
/// Triangles that one thread takes at a time.
const PIECE: usize = 128;

/// The triangles of space among those given, each with its box.
pub(super) struct Boxed<'a> {
    pub(super) points: &'a [DVec3],
    /// By triangle, corners; different ones are at different places.
    pub(super) corners: &'a [[VertexId; 3]],
    /// The triangles with area, each once, in order.
    solid: Vec<usize>,
    pub(super) hierarchy: Hierarchy,
}

impl<'a> Boxed<'a> {
    /// The tree of the triangles of space, in time n log n.
    pub(super) fn of(soup: &'a Soup<'_>) -> Self {
        let all = 0..soup.triangles.len();
        let mut boxed = Self {
            points: soup.points,
            corners: &soup.joined,
            solid: all.filter(|&triangle| soup.solid[triangle]).collect(),
            hierarchy: Hierarchy::of(Vec::new()),
        };
        let numbered = boxed.solid.iter().map(|&i| (boxed.bounds(i), i as u32));
        boxed.hierarchy = Hierarchy::of(numbered.collect());
        boxed
    }

    /// Where a vertex is.
    pub(super) fn place(&self, v: VertexId) -> DVec3 {
        self.points[v.index()]
    }

    /// The box round a triangle.
    pub(super) fn bounds(&self, triangle: usize) -> Bounds {
        Bounds::of(self.corners[triangle].map(|v| self.place(v)))
    }

    /// Lists the pairs that intersect, by the smaller index, then by the other: all, or the first `most` of them.
    ///
    /// Takes n log n time where every triangle's box meets few others, and goes on in the current pool of `rayon`; the answer does
    /// not depend on the number of threads.
    pub(super) fn judge(
        &self,
        most: usize,
        defects: &mut DomainDefects,
        meter: &mut Meter<'_>,
    ) -> Result<(), Cancelled> {
        let mut done = 0;
        for batch in self.solid.chunks(BATCH) {
            let pieces = batch.chunks(PIECE).collect();
            let found = threads::map(pieces, |piece| self.pairs_of(piece, most));
            defects.intersections.extend(found.into_iter().flatten());
            if defects.intersections.len() > most {
                defects.intersections.truncate(most);
                defects.more_intersections = true;
                return Ok(());
            }
            done += batch.len();
            meter.reach(done)?;
        }
        Ok(())
    }

    /// The pairs whose smaller index is among these, in order; no further than one beyond `most`.
    fn pairs_of(&self, triangles: &[usize], most: usize) -> Vec<Intersection> {
        let (mut pairs, mut later) = (Vec::new(), Vec::new());
        for &first in triangles {
            let bounds = self.bounds(first);
            later.clear();
            self.hierarchy.meeting(bounds, |second| {
                if second > first {
                    later.push(second);
                }
            });
            self.keep_intersecting(first, &mut later);
            later.sort_unstable();
            for &second in &later {
                let near = bounds.common(self.bounds(second)).middle();
                pairs.push(Intersection {
                    first,
                    second,
                    near,
                });
                if pairs.len() > most {
                    return pairs;
                }
            }
        }
        pairs
    }

    /// Keeps the triangles that intersect the first one.
    fn keep_intersecting(&self, first: usize, others: &mut Vec<usize>) {
        let place = |v| self.place(v);
        let view = best_view(self.corners[first].map(place));
        let seen = |triangle: usize| {
            let corners = self.corners[triangle];
            Seen::of(view, corners, corners.map(place))
        };
        let own = seen(first);
        others.retain(|&second| {
            !own.parted(&seen(second))
                && triangles_intersect(place, self.corners[first], self.corners[second])
        });
    }
}
