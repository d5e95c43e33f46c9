//! What poor shapes cost: a function of the radius ratio that hardly minds good triangles and cannot bear bad ones.
//!
//! With d = 1 - ρ a triangle costs d + d₀ (d / d₀)^p: the mean counts as long as d is below d₀, beyond it the worst.

use delaunay_core::measure::triangle::radius_ratio;
use glam::DVec2;

/// Cost of a triangle that is flat or turned over: more than any other.
pub(super) const FORBIDDEN: f64 = 1e9;

/// What triangles cost.
#[derive(Clone, Copy, Debug)]
pub(super) struct Energy {
    /// d₀.
    knee: f64,
    /// p, a power of two times 1 or 3, at least 8.
    power: Power,
}

#[derive(Clone, Copy, Debug)]
enum Power {
    Eight,
    TwentyFour,
}

/// The first energy: the mean, with triangles below 0.8 pulled up.
pub(super) const FIRST: Energy = Energy {
    knee: 0.2,
    power: Power::Eight,
};

/// The last energy: the worst triangles, wherever they are below 0.92.
pub(super) const LAST: Energy = Energy {
    knee: 0.08,
    power: Power::TwentyFour,
};

impl Energy {
    /// Cost of a triangle with corners counterclockwise.
    #[inline]
    pub(super) fn of(&self, corners: [DVec2; 3]) -> f64 {
        let [a, b, c] = corners;
        if (b - a).perp_dot(c - a) <= 0.0 {
            return FORBIDDEN;
        }
        let short = 1.0 - radius_ratio(corners);
        let (power, _) = self.power(short / self.knee);
        short + self.knee * power
    }

    /// Cost of the triangle `apex`, `a`, `b`, counterclockwise, and its gradient when the apex moves; the cost is forbidden for a
    /// triangle that is flat or turned over.
    #[inline]
    pub(super) fn with_gradient(&self, apex: DVec2, [a, b]: [DVec2; 2]) -> (f64, DVec2) {
        let (u, w, base) = (apex - a, apex - b, b - a);
        let area = base.perp_dot(u);
        if area <= 0.0 {
            return (FORBIDDEN, DVec2::ZERO);
        }
        let [lu, lw, lb] = [u, w, base].map(DVec2::length);
        let around = lu + lw + lb;
        let ratio = 4.0 * area * area / (lu * lw * lb * around);
        let short = 1.0 - ratio;
        let (power, slope) = self.power(short / self.knee);
        // The gradient of the logarithm of the ratio.
        let logarithmic =
            2.0 * base.perp() / area - u / (lu * lu) - w / (lw * lw) - (u / lu + w / lw) / around;
        let gradient = -(1.0 + slope) * ratio * logarithmic;
        (short + self.knee * power, gradient)
    }

    /// A power and its derivative.
    #[inline]
    fn power(&self, x: f64) -> (f64, f64) {
        let x2 = x * x;
        let x4 = x2 * x2;
        let x7 = x4 * x2 * x;
        match self.power {
            Power::Eight => (x7 * x, 8.0 * x7),
            Power::TwentyFour => {
                let x8 = x7 * x;
                let x16 = x8 * x8;
                (x16 * x8, 24.0 * x16 * x7)
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const A: DVec2 = DVec2::new(-0.3, 0.1);
    const B: DVec2 = DVec2::new(1.1, -0.2);

    #[test]
    fn the_best_triangle_costs_nothing_and_a_flat_one_is_forbidden() {
        for energy in [FIRST, LAST] {
            let top = DVec2::new(0.5, 0.75_f64.sqrt());
            assert!(energy.of([DVec2::ZERO, DVec2::X, top]).abs() < 1e-15);
            assert_eq!(
                energy.of([DVec2::ZERO, DVec2::X, 2.0 * DVec2::X]),
                FORBIDDEN
            );
            assert_eq!(energy.of([DVec2::ZERO, top, DVec2::X]), FORBIDDEN);
        }
    }

    #[test]
    fn the_gradient_is_that_of_the_cost() {
        for energy in [FIRST, LAST] {
            for apex in [
                DVec2::new(0.4, 0.9),
                DVec2::new(0.1, 0.7),
                DVec2::new(0.9, 0.8),
            ] {
                let cost = |apex: DVec2| energy.of([apex, A, B]);
                let (value, gradient) = energy.with_gradient(apex, [A, B]);
                assert!((value - cost(apex)).abs() < 1e-12 * (1.0 + value));
                let step = 1e-6;
                let difference = |along: DVec2| {
                    (cost(apex + step * along) - cost(apex - step * along)) / (2.0 * step)
                };
                let expected = DVec2::new(difference(DVec2::X), difference(DVec2::Y));
                assert!(
                    (gradient - expected).length() < 1e-6 * (1.0 + gradient.length()),
                    "{gradient} {expected}"
                );
            }
        }
    }
}
