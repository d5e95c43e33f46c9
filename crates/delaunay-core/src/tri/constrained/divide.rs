//! Segments that cross, under the rule that divides them where they meet.
//!
//! ```text
//!          d                The place where two segments meet is rounded, so x may be a little off both: then the
//!          |                halves of c-d are laid anew, from c to x and from x to d, and so are those of the way.
//!    s ----x----- e         Where x would be a vertex that is there already, that vertex is taken.
//!          |
//!          c
//! ```
//!
//! A way is only divided at a vertex strictly inside the circle that has it as diameter, an exact test. So the parts are
//! shorter than the whole, and no way comes to lead over itself. In numbers without rounding each pair of segments meets once and
//! the work ends; as rounded halves might meet again, it ends at a stated number of divisions at the latest.

use super::recover::Crossed;
use super::triangulation::Constrained2;
use crate::ids::{HalfEdgeId, VertexId};
use crate::progress::{Cancelled, Meter};
use crate::tri::insert::Inserted;
use geo_predicates::{Sign, check_point2, in_diametral_circle};
use glam::DVec2;

/// What to do with segments that cross.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Crossings {
    /// They are an error, which lists them.
    #[default]
    Refuse,
    /// They are divided where they meet, in rounded coordinates.
    Divide {
        /// More divisions are an error.
        at_most: usize,
    },
}

/// A piece of a segment that is still to be laid.
#[derive(Clone, Copy, Debug)]
struct Piece {
    ends: [VertexId; 2],
    label: u32,
}

/// Why a segment is not laid.
#[derive(Clone, Copy, Debug)]
pub(super) enum Undivided {
    /// The divisions that were allowed are used up.
    OutOfDivisions,
    /// It meets an edge of this segment where no vertex has room.
    TooClose(usize),
    /// The report closure stopped the work.
    Cancelled(Cancelled),
}

/// A place that is nearer to an end than this share of the greatest coordinate is where the end is.
///
/// A few roundings. Three segments through one vertex that have been bent elsewhere miss it by a rounding; a vertex where two of
/// them meet would bend one, so that it meets the third a rounding further, and so on.
const INDISTINCT: f64 = 16.0 * f64::EPSILON;

impl Constrained2 {
    /// Lays a segment and divides what it crosses; takes the divisions from `left`, and each is a step more.
    pub(super) fn lay_dividing(
        &mut self,
        ends: [VertexId; 2],
        label: u32,
        left: &mut usize,
        meter: &mut Meter<'_>,
    ) -> Result<(), Undivided> {
        let mut pending = vec![Piece { ends, label }];
        while let Some(Piece { ends, label }) = pending.pop() {
            if let Some(path) = self.paths.path(ends) {
                let pieces = path.windows(2).map(|piece| [piece[0], piece[1]]);
                pending.extend(pieces.map(|ends| Piece { ends, label }));
                continue;
            }
            let Err(crossed) = self.lay(ends, label, 0) else {
                continue;
            };
            *left = left.checked_sub(1).ok_or(Undivided::OutOfDivisions)?;
            meter.expect(1);
            meter.advance().map_err(Undivided::Cancelled)?;
            let [start, end] = crossed.way();
            let (vertex, halves) = self.divide(&crossed)?;
            let Crossed { before, after, .. } = crossed;
            self.paths.note([before, vec![vertex], after].concat());
            pending.extend([[start, vertex], [vertex, end]].map(|ends| Piece { ends, label }));
            pending.extend(halves);
        }
        Ok(())
    }

    /// Finds or makes the vertex where a way and an edge meet; gives it and what has to be laid anew of the edge.
    fn divide(&mut self, crossed: &Crossed) -> Result<(VertexId, Vec<Piece>), Undivided> {
        let ends = crossed.edge;
        let too_close = Undivided::TooClose(crossed.segment);
        let vertex = self.vertex_between(crossed.way(), ends).ok_or(too_close)?;
        if ends.contains(&vertex) {
            return Ok((vertex, Vec::new()));
        }
        let Some(h) = self.mesh.find_half_edge(ends[0], ends[1]) else {
            // The new vertex is on the edge exactly, which has been divided with it.
            return Ok((vertex, Vec::new()));
        };
        let label = self.labels[h.index()];
        self.release(h);
        self.paths.note(vec![ends[0], vertex, ends[1]]);
        let halves = ends.map(|end| Piece {
            ends: [end, vertex],
            label,
        });
        Ok((vertex, halves.to_vec()))
    }

    /// A vertex where two ways meet, up to rounding, that may divide those of which it is no end: a new one, or the end of
    /// one that is nearest where there is no room for a new one or hardly a difference.
    fn vertex_between(&mut self, way: [VertexId; 2], edge: [VertexId; 2]) -> Option<VertexId> {
        let place = self.meeting(way, edge);
        let divides = |p: DVec2, ends: [VertexId; 2]| {
            let [a, b] = ends.map(|v| self.point(v));
            p == a || p == b || in_diametral_circle(a, b, p) == Sign::Positive
        };
        let is_between = |p: DVec2| divides(p, way) && divides(p, edge);
        let ends = edge.into_iter().chain(way);
        let known = ends.filter(|&v| is_between(self.point(v)));
        let distance = |v: &VertexId| self.point(*v).distance_squared(place);
        let nearest = known.min_by(|v, w| distance(v).total_cmp(&distance(w)));
        let reach = edge.into_iter().chain(way);
        let reach = reach.fold(0.0, |most: f64, v| {
            most.max(self.point(v).abs().max_element())
        });
        let is_at = |v: VertexId| self.point(v).distance(place) <= INDISTINCT * reach;
        if nearest.is_some_and(is_at) || !is_between(place) {
            return nearest;
        }
        match self.insert_near(place, edge[0]) {
            Ok(Some(Inserted::New(v) | Inserted::Duplicate(v))) => Some(v),
            Ok(None) | Err(_) => nearest,
        }
    }

    /// Takes the segment off the edge of `h`.
    fn release(&mut self, h: HalfEdgeId) {
        for side in [h, self.mesh.twin(h)] {
            self.labels[side.index()] = 0;
        }
        self.restore(vec![h]);
    }

    /// Where two segments that cross meet, rounded, within the box round the second one.
    pub(super) fn meeting(&self, way: [VertexId; 2], edge: [VertexId; 2]) -> DVec2 {
        let [[s, e], [c, d]] = [way, edge].map(|ends| ends.map(|v| self.point(v)));
        let offset = |p: DVec2| (e - s).perp_dot(p - s);
        let [at_c, at_d] = [offset(c), offset(d)];
        let share = at_c / (at_c - at_d);
        let place = match share.is_finite() {
            true => c.lerp(d, share.clamp(0.0, 1.0)),
            false => c.midpoint(d),
        };
        let place = place.clamp(c.min(d), c.max(d));
        // A coordinate that would not be accepted is one very near to zero.
        let accepted = |value: f64| match check_point2(0, DVec2::new(value, 0.0)).is_ok() {
            true => value,
            false => 0.0,
        };
        DVec2::new(accepted(place.x), accepted(place.y))
    }
}
