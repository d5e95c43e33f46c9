//! The curve of centres that are equally far from two walls, in closed form.
//!
//! Seen from the centre of a hole, the bisector with another wall has the polar form
//! `1 / t = A · d − B` with `d` the unit direction: a branch of a hyperbola against a hole, an
//! ellipse against the bounding circle. The medial arcs are pieces of such curves.

use glam::DVec2;

use crate::wall::{Wall, WallKind};

/// The bisector of a hole and another wall, in polar coordinates round the hole.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bisector {
    pole: DVec2,
    a: DVec2,
    b: f64,
}

impl Bisector {
    /// The bisector of `hole` and `other`.
    ///
    /// Both must be walls of one domain; `hole` must not be the bounding circle, `other` may.
    #[must_use]
    pub fn between(hole: &Wall, other: &Wall) -> Self {
        let f = other.circle.center - hole.circle.center;
        let length = f.length();
        let (a, b) = match other.kind {
            WallKind::Hole => {
                let delta = hole.circle.radius - other.circle.radius;
                let scale = 2.0 / ((length - delta) * (length + delta));
                (scale * f, scale * delta)
            }
            WallKind::Bounding => {
                let sum = other.circle.radius + hole.circle.radius;
                let scale = -2.0 / ((sum - length) * (sum + length));
                (scale * f, scale * sum)
            }
        };
        Self {
            pole: hole.circle.center,
            a,
            b,
        }
    }

    /// The point of the curve in the unit direction `d` from the hole's centre.
    ///
    /// Not finite where a hyperbola branch does not reach: medial arcs stay within reach.
    #[must_use]
    pub fn point(&self, d: DVec2) -> DVec2 {
        self.pole + d / (self.a.dot(d) - self.b)
    }

    /// Length of curve per radian of direction at `d`.
    #[must_use]
    pub fn speed(&self, d: DVec2) -> f64 {
        let t = 1.0 / (self.a.dot(d) - self.b);
        let slope = -t * t * self.a.dot(d.perp());
        t.hypot(slope)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::example_domains::wall;

    #[test]
    fn points_are_equally_far_from_both_walls() {
        let hole = wall(0.2, -0.1, 0.3, WallKind::Hole);
        for other in [
            wall(1.5, 0.7, 0.6, WallKind::Hole),
            wall(0.0, 0.0, 3.0, WallKind::Bounding),
        ] {
            let curve = Bisector::between(&hole, &other);
            for k in 0..8 {
                let p = curve.point(DVec2::from_angle(0.5 + 0.1 * f64::from(k)));
                assert!((hole.distance(p) - other.distance(p)).abs() < 1e-14);
            }
        }
    }

    #[test]
    fn speed_is_the_derivative_of_the_point() {
        let curve = Bisector::between(
            &wall(0.0, 0.0, 0.3, WallKind::Hole),
            &wall(2.0, 1.0, 0.9, WallKind::Hole),
        );
        let h = 1e-6;
        let at = |angle| curve.point(DVec2::from_angle(angle));
        let measured = at(0.3 + h).distance(at(0.3 - h)) / (2.0 * h);
        assert!((measured - curve.speed(DVec2::from_angle(0.3))).abs() < 1e-8);
    }
}
