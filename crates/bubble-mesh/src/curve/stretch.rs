//! A part of a curve that one formula gives: straight, an arc of an ellipse, or a cubic.

use glam::DVec2;

/// Nodes and weights of Gauss and Legendre on the interval from -1 to 1, exact for polynomials of degree 9.
const GAUSS: [(f64, f64); 5] = [
    (-0.906_179_845_938_664, 0.236_926_885_056_189_1),
    (-0.538_469_310_105_683_1, 0.478_628_670_499_366_5),
    (0.0, 0.568_888_888_888_888_9),
    (0.538_469_310_105_683_1, 0.478_628_670_499_366_5),
    (0.906_179_845_938_664, 0.236_926_885_056_189_1),
];

/// One formula for a parameter from 0 to 1.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Stretch {
    /// From one point straight to the other.
    Line([DVec2; 2]),
    /// Of a circle or an ellipse.
    Arc(Arc),
    /// The control points of Bézier.
    Cubic([DVec2; 4]),
}

/// The places `center + cos a · u + sin a · v` for angles `a` from `start` to `start + sweep`.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Arc {
    pub(super) center: DVec2,
    pub(super) u: DVec2,
    pub(super) v: DVec2,
    pub(super) start: f64,
    pub(super) sweep: f64,
    /// Where it begins and ends, not rounded.
    pub(super) ends: [DVec2; 2],
}

impl Arc {
    fn at(&self, t: f64) -> DVec2 {
        let (sin, cos) = (self.start + t * self.sweep).sin_cos();
        cos * self.u + sin * self.v
    }

    /// The derivative of `at` by the angle.
    fn across(&self, t: f64) -> DVec2 {
        let (sin, cos) = (self.start + t * self.sweep).sin_cos();
        cos * self.v - sin * self.u
    }
}

impl Stretch {
    /// Where it begins and ends, exactly.
    pub(super) fn ends(&self) -> [DVec2; 2] {
        match self {
            Self::Line(ends) => *ends,
            Self::Arc(arc) => arc.ends,
            Self::Cubic([a, _, _, b]) => [*a, *b],
        }
    }

    pub(super) fn point(&self, t: f64) -> DVec2 {
        let ends = self.ends();
        if t <= 0.0 {
            return ends[0];
        }
        if t >= 1.0 {
            return ends[1];
        }
        match self {
            Self::Line([a, b]) => a.lerp(*b, t),
            Self::Arc(arc) => arc.center + arc.at(t),
            Self::Cubic([a, b, c, d]) => {
                let (ab, bc, cd) = (a.lerp(*b, t), b.lerp(*c, t), c.lerp(*d, t));
                ab.lerp(bc, t).lerp(bc.lerp(cd, t), t)
            }
        }
    }

    /// The derivative by the parameter.
    pub(super) fn velocity(&self, t: f64) -> DVec2 {
        match self {
            Self::Line([a, b]) => *b - *a,
            Self::Arc(arc) => arc.sweep * arc.across(t),
            Self::Cubic([a, b, c, d]) => {
                let (ab, bc, cd) = (*b - *a, *c - *b, *d - *c);
                3.0 * ab.lerp(bc, t).lerp(bc.lerp(cd, t), t)
            }
        }
    }

    fn acceleration(&self, t: f64) -> DVec2 {
        match self {
            Self::Line(_) => DVec2::ZERO,
            Self::Arc(arc) => -arc.sweep * arc.sweep * arc.at(t),
            Self::Cubic([a, b, c, d]) => {
                let (abc, bcd) = (*c - 2.0 * *b + *a, *d - 2.0 * *c + *b);
                6.0 * abc.lerp(bcd, t)
            }
        }
    }

    /// One over the radius of curvature, never negative; infinite in a cusp, 0 where the parameter stands still without one.
    pub(super) fn curvature(&self, t: f64) -> f64 {
        let velocity = self.velocity(t);
        let speed = velocity.length();
        let bent = velocity.perp_dot(self.acceleration(t)).abs();
        match bent > 0.0 {
            true => bent / (speed * speed * speed),
            false => 0.0,
        }
    }

    /// The arc length between two parameters near each other, by the quadrature of Gauss.
    pub(super) fn length(&self, from: f64, to: f64) -> f64 {
        let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
        let speed = |at: f64| self.velocity(middle + half * at).length();
        half * GAUSS
            .iter()
            .map(|&(at, weight)| weight * speed(at))
            .sum::<f64>()
    }

    /// The parameter at an arc length after `from`, at most `to`.
    ///
    /// Newton's method, where it leaves the interval that is known to contain the answer the middle of that: 40 steps at most.
    pub(super) fn advance(&self, [from, to]: [f64; 2], whole: f64, length: f64) -> f64 {
        let (mut low, mut high) = (from, to);
        let mut t = from + (to - from) * (length / whole).clamp(0.0, 1.0);
        for _ in 0..40 {
            let missing = length - self.length(from, t);
            if missing.abs() <= 1e-13 * whole {
                break;
            }
            match missing > 0.0 {
                true => low = t,
                false => high = t,
            }
            let next = t + missing / self.velocity(t).length();
            t = match next > low && next < high {
                true => next,
                false => 0.5 * (low + high),
            };
        }
        t
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn samples() -> [Stretch; 3] {
        let arc = Arc {
            center: DVec2::new(1.0, 2.0),
            u: DVec2::new(2.0, 1.0),
            v: DVec2::new(-0.5, 1.0),
            start: 0.3,
            sweep: -2.0,
            ends: [DVec2::ZERO; 2],
        };
        [
            Stretch::Line([DVec2::ZERO, DVec2::new(3.0, 4.0)]),
            Stretch::Arc(arc),
            Stretch::Cubic([[0.0, 0.0], [1.0, 2.0], [2.0, -1.0], [3.0, 1.0]].map(DVec2::from)),
        ]
    }

    #[test]
    fn derivatives_are_those_of_the_places() {
        for stretch in samples() {
            for t in [0.1, 0.4, 0.77] {
                let d = 1e-5;
                let [before, at, after] = [t - d, t, t + d].map(|t| stretch.point(t));
                let velocity = (after - before) / (2.0 * d);
                let acceleration = (after - 2.0 * at + before) / (d * d);
                assert!((velocity - stretch.velocity(t)).length() < 1e-8);
                assert!((acceleration - stretch.acceleration(t)).length() < 1e-3);
            }
        }
    }

    #[test]
    fn lengths_are_found_again() {
        for stretch in samples() {
            let (from, to) = (0.2, 0.3);
            let whole = stretch.length(from, to);
            for part in [0.0, 0.1, 0.5, 0.9, 1.0] {
                let t = stretch.advance([from, to], whole, part * whole);
                assert!((stretch.length(from, t) - part * whole).abs() <= 1e-12 * whole);
            }
        }
        let [line, ..] = samples();
        assert!((line.length(0.0, 1.0) - 5.0).abs() < 1e-15);
    }

    #[test]
    fn a_circle_has_one_over_its_radius() {
        let arc = Arc {
            center: DVec2::ONE,
            u: 4.0 * DVec2::X,
            v: 4.0 * DVec2::Y,
            start: 0.0,
            sweep: 1.0,
            ends: [DVec2::ZERO; 2],
        };
        assert!((Stretch::Arc(arc).curvature(0.6) - 0.25).abs() < 1e-15);
    }
}
