//! How far the touching points of the empty circles along an arc turn round the walls on its sides.
//!
//! Nodes at equal turns fold no cell: each strip turns by at most the whole over the number of
//! strips round either wall, and two walls are turned round by less than two full turns together.

use glam::DVec2;

use crate::arc_length::{PIECES, at};
use crate::medial_graph::ArcCurve;

/// Halvings of a piece that leave nothing but rounding.
const HALVINGS: usize = 48;

/// Turn along an arc, round both walls together, as a function of its parameter.
pub(crate) struct Turn {
    curve: ArcCurve,
    centers: [DVec2; 2],
    /// Radians from the start to the parameter `k / PIECES`.
    upto: [f64; PIECES + 1],
}

impl Turn {
    /// The turn along `curve` round walls with these centres; the touching points turn by less than
    /// half a turn in each piece.
    pub(crate) fn of(curve: ArcCurve, centers: [DVec2; 2]) -> Self {
        let mut turn = Self {
            curve,
            centers,
            upto: [0.0; PIECES + 1],
        };
        for k in 0..PIECES {
            turn.upto[k + 1] = turn.upto[k] + turn.between(at(k), at(k + 1));
        }
        turn
    }

    /// The parameter by which the arc has turned the given fraction of its whole turn.
    pub(crate) fn parameter(&self, fraction: f64) -> f64 {
        let target = fraction * self.upto[PIECES];
        let piece = self.upto.partition_point(|&upto| upto <= target);
        let piece = piece.clamp(1, PIECES) - 1;
        let (mut low, mut high) = (at(piece), at(piece + 1));
        for _ in 0..HALVINGS {
            let middle = low.midpoint(high);
            if self.upto[piece] + self.between(at(piece), middle) < target {
                low = middle;
            } else {
                high = middle;
            }
        }
        low.midpoint(high)
    }

    /// Radians between two parameters of one piece, both walls together.
    fn between(&self, from: f64, to: f64) -> f64 {
        let [p, q] = [from, to].map(|u| self.curve.point(u));
        let round = |center: &DVec2| (p - center).angle_to(q - center).abs();
        self.centers.iter().map(round).sum()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Blocking;
    use crate::example_domains::three_holes;

    #[test]
    fn equal_fractions_turn_by_equal_angles() {
        let domain = three_holes();
        let blocking = Blocking::of(&domain).unwrap();
        for arc in blocking.arcs() {
            let centers = [arc.right, arc.left].map(|image| domain.wall_image(image).circle.center);
            let turn = Turn::of(arc.curve, centers);
            let steps: Vec<f64> = (0..=8)
                .map(|k| turn.parameter(f64::from(k) / 8.0))
                .collect();
            for two in steps.windows(2) {
                let eighth = turn.upto[PIECES] / 8.0;
                assert!((turn.between(two[0], two[1]) - eighth).abs() < 1e-9);
            }
        }
    }
}
