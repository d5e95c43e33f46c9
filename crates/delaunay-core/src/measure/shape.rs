//! What the measures of a triangle have in common in the plane and in space: three lengths and an area.

use super::angle::degrees;

/// A triangle up to rigid motion: enough for every measure but the sign of the area.
///
/// Lengths are in units of `unit`, so that their products are of the order of one at most.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Shape {
    /// A power of two near the longest edge; 0 for a point.
    pub(super) unit: f64,
    /// Lengths of the edges opposite each corner.
    pub(super) edges: [f64; 3],
    /// For each corner, the dot product of the two edges that leave it.
    pub(super) dots: [f64; 3],
    /// Twice the area, not negative.
    pub(super) cross: f64,
}

impl Shape {
    /// The three angles in degrees.
    pub(super) fn angles(&self) -> [f64; 3] {
        self.dots.map(|dot| degrees(self.cross, dot))
    }

    pub(super) fn area(&self) -> f64 {
        0.5 * self.cross * self.unit * self.unit
    }

    pub(super) fn circumradius(&self) -> f64 {
        if self.cross == 0.0 {
            f64::INFINITY
        } else {
            self.unit * self.relative_circumradius()
        }
    }

    pub(super) fn inradius(&self) -> f64 {
        if self.cross == 0.0 {
            0.0
        } else {
            self.unit * self.relative_inradius()
        }
    }

    pub(super) fn shortest_edge(&self) -> f64 {
        self.unit * self.edges.into_iter().fold(f64::INFINITY, f64::min)
    }

    pub(super) fn longest_edge(&self) -> f64 {
        self.unit * self.edges.into_iter().fold(0.0, f64::max)
    }

    /// r/l = l1 l2 / 4A with the two longer edges; infinite for an area of zero.
    pub(super) fn radius_edge_ratio(&self) -> f64 {
        let [l0, l1, l2] = self.edges;
        let longer = (l0 * l1).max(l1 * l2).max(l2 * l0);
        if self.cross == 0.0 {
            f64::INFINITY
        } else {
            longer / (2.0 * self.cross)
        }
    }

    /// Twice inradius over circumradius, and not above 1 by rounding; 0 for an area of zero.
    pub(super) fn radius_ratio(&self) -> f64 {
        if self.cross == 0.0 {
            return 0.0;
        }
        (2.0 * self.relative_inradius() / self.relative_circumradius()).min(1.0)
    }

    /// l0 l1 l2 / 4A.
    fn relative_circumradius(&self) -> f64 {
        // Whatever rounds: no circle through both ends of an edge of length one is smaller.
        (self.edges.into_iter().product::<f64>() / (2.0 * self.cross)).max(0.5)
    }

    /// 2A / (l0 + l1 + l2).
    fn relative_inradius(&self) -> f64 {
        self.cross / self.edges.into_iter().sum::<f64>()
    }
}
