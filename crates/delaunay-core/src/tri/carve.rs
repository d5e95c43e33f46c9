//! A convex polygon carved by half-planes whose normals turn counterclockwise, at most once round.
//!
//! The corners form a ring that turns with the normals: the corner farthest along the last normal is at the
//! back, the next one counterclockwise at the front. A half-plane takes corners off both ends and closes
//! the gap with two new ones. Each corner comes once and goes at most once, so the whole takes linear time.
//!
//! Which corner is farthest follows from the lines on which the edges lie, not from coordinates: the ends
//! of a short edge round, and a direction computed from them may be anything.

use super::convex::ConvexPolygon;
use glam::DVec2;
use std::collections::VecDeque;

/// A convex polygon in the making.
pub(super) struct Carving {
    ring: VecDeque<Corner>,
}

#[derive(Clone, Copy)]
struct Corner {
    place: DVec2,
    /// Outward normal of the edge that leaves the corner counterclockwise.
    normal: DVec2,
}

impl Carving {
    /// The polygon moved by `offset`, ready for a half-plane with the normal `first`.
    pub(super) fn new(polygon: &ConvexPolygon, offset: DVec2, first: DVec2) -> Self {
        let corners = polygon.corners();
        let ends = corners.iter().cycle().skip(1);
        let mut ring: VecDeque<Corner> = corners
            .iter()
            .zip(ends)
            .map(|(&start, &end)| Corner {
                place: start + offset,
                normal: -(end - start).perp(),
            })
            .collect();
        let height = |i: &usize| corners[*i].dot(first);
        let farthest = (0..corners.len()).max_by(|i, j| height(i).total_cmp(&height(j)));
        ring.rotate_left(farthest.map_or(0, |farthest| farthest + 1));
        Self { ring }
    }

    /// Keeps what lies in the half-plane `x · normal <= limit`.
    pub(super) fn cut(&mut self, normal: DVec2, limit: f64) {
        self.turn_to(normal);
        let beyond = |corner: &Corner| corner.place.dot(normal) - limit;
        let is_beyond = |corner: &Corner| beyond(corner) > 0.0;
        let Some(&farthest) = self.ring.back().filter(|corner| is_beyond(corner)) else {
            return;
        };
        let (mut first, mut last) = (farthest, farthest);
        while let Some(&corner) = self.ring.back().filter(|corner| is_beyond(corner)) {
            first = corner;
            self.ring.pop_back();
        }
        while let Some(&corner) = self.ring.front().filter(|corner| is_beyond(corner)) {
            last = corner;
            self.ring.pop_front();
        }
        let (Some(before), Some(after)) = (self.ring.back(), self.ring.front()) else {
            return;
        };
        let crossing = |near: &Corner, far: &Corner| {
            let (from, to) = (beyond(near), beyond(far));
            near.place.lerp(far.place, from / (from - to))
        };
        let closing = [
            (crossing(before, &first), normal),
            (crossing(after, &last), last.normal),
        ];
        let closing = closing.map(|(place, normal)| Corner { place, normal });
        self.ring.extend(closing);
    }

    /// Brings the corner farthest along `normal` to the back.
    fn turn_to(&mut self, normal: DVec2) {
        for _ in 0..self.ring.len() {
            match self.ring.back() {
                Some(corner) if corner.normal.perp_dot(normal) > 0.0 => self.ring.rotate_left(1),
                _ => return,
            }
        }
    }

    /// What is left, moved by `offset`.
    pub(super) fn finish(self, offset: DVec2) -> ConvexPolygon {
        let places = self.ring.into_iter().map(|corner| corner.place + offset);
        ConvexPolygon::from_rounded(places.collect())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn carved(cuts: &[([f64; 2], f64)]) -> ConvexPolygon {
        let square = ConvexPolygon::rectangle(DVec2::splat(-1.0), DVec2::ONE).unwrap();
        let first = cuts.first().map_or(DVec2::X, |&(normal, _)| normal.into());
        let mut carving = Carving::new(&square, DVec2::ZERO, first);
        for &(normal, limit) in cuts {
            carving.cut(normal.into(), limit);
        }
        carving.finish(DVec2::ZERO)
    }

    #[test]
    fn a_cut_keeps_the_near_side() {
        assert_eq!(carved(&[]).area(), 4.0);
        assert_eq!(carved(&[([1.0, 1.0], 0.0)]).area(), 2.0);
        assert_eq!(carved(&[([1.0, 1.0], 2.0)]).area(), 4.0);
        assert_eq!(carved(&[([1.0, 1.0], 1.0), ([-1.0, 1.0], 1.0)]).area(), 3.0);
    }

    #[test]
    fn cuts_that_leave_nothing_leave_no_corners() {
        assert!(carved(&[([1.0, 1.0], -3.0)]).is_empty());
        assert!(carved(&[([1.0, 1.0], -3.0), ([-1.0, 0.0], 0.0)]).is_empty());
        assert!(carved(&[([1.0, 0.0], -0.5), ([-1.0, 0.0], 0.0)]).is_empty());
        assert!(carved(&[([1.0, 1.0], -2.0)]).is_empty());
    }

    #[test]
    fn many_cuts_all_round_leave_a_disk() {
        let count = 1000;
        for start in 0..count {
            let normal = |i: usize| {
                let turn = (start + i) as f64 / count as f64;
                DVec2::from_angle(turn * std::f64::consts::TAU).to_array()
            };
            let cuts: Vec<_> = (0..count).map(|i| (normal(i), 0.5)).collect();
            let disk = carved(&cuts);
            assert_eq!(disk.corners().len(), count);
            assert!((disk.area() - 0.25 * std::f64::consts::PI).abs() < 1e-5);
        }
    }
}
