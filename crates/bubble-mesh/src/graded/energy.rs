//! What poor shapes cost: a function of the radius ratio that hardly minds good triangles and cannot bear bad ones.
//!
//! With d = 1 - ρ a triangle costs d + d₀ (d / d₀)^p: the mean counts as long as d is below d₀, beyond it the worst. A triangle that is flat or
//! turned over has ρ = 0 and costs the most; so what is flat by rounding alone costs no more than what nearly is.

use glam::DVec2;

/// What triangles cost.
#[derive(Clone, Copy, Debug)]
pub(super) struct Energy {
    /// d₀.
    knee: f64,
    /// p.
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
    knee: 0.084,
    power: Power::TwentyFour,
};

impl Energy {
    /// Cost of a triangle with corners counterclockwise; rounded, and not alike from whichever corner it is listed.
    #[inline]
    pub(super) fn of(&self, [a, b, c]: [DVec2; 3]) -> f64 {
        let (u, w, base) = (a - b, a - c, c - b);
        let area = base.perp_dot(u);
        let [u, w, base] = [u, w, base].map(DVec2::length);
        let ratio = match area > 0.0 {
            true => 4.0 * area * area / (u * w * base * (u + w + base)),
            false => 0.0,
        };
        let short = 1.0 - ratio;
        let [power, ..] = self.power(short / self.knee);
        short + self.knee * power
    }

    /// Cost of the triangle `apex`, `a`, `b`, counterclockwise, with its first and second derivatives when the apex moves. `None`
    /// for a triangle that is flat or turned over.
    #[inline]
    pub(super) fn expansion(&self, apex: DVec2, [a, b]: [DVec2; 2]) -> Option<Expansion> {
        let (u, w, base) = (apex - a, apex - b, b - a);
        let area = base.perp_dot(u);
        if area <= 0.0 {
            return None;
        }
        let [lu, lw, lb] = [u, w, base].map(DVec2::length);
        let around = lu + lw + lb;
        let ratio = 4.0 * area * area / (lu * lw * lb * around);
        let (u, w, base) = (u / lu, w / lw, base.perp() / area);
        // Derivatives of the logarithm of the ratio, 2 ln area - ln lu - ln lw - ln around.
        let along = (u + w) / around;
        let slope = 2.0 * base - u / lu - w / lw - along;
        let in_u = Symmetric::of(u);
        let in_w = Symmetric::of(w);
        let curvature = Symmetric::of(base) * -2.0
            + (in_u * 2.0 - Symmetric::ONE) * (1.0 / (lu * lu))
            + (in_w * 2.0 - Symmetric::ONE) * (1.0 / (lw * lw))
            + (in_u - Symmetric::ONE) * (1.0 / (lu * around))
            + (in_w - Symmetric::ONE) * (1.0 / (lw * around))
            + Symmetric::of(along);
        // Those of the cost.
        let short = 1.0 - ratio;
        let [power, first, second] = self.power(short / self.knee);
        let by_ratio = -(1.0 + first);
        let squared_slope = Symmetric::of(slope);
        let by_slopes = second / self.knee * ratio * ratio;
        Some(Expansion {
            cost: short + self.knee * power,
            gradient: by_ratio * ratio * slope,
            hessian: (curvature + squared_slope) * (by_ratio * ratio) + squared_slope * by_slopes,
        })
    }

    /// A power and its derivatives.
    #[inline]
    fn power(&self, x: f64) -> [f64; 3] {
        let x2 = x * x;
        let x6 = x2 * x2 * x2;
        match self.power {
            Power::Eight => [x6 * x2, 8.0 * x6 * x, 56.0 * x6],
            Power::TwentyFour => {
                let x22 = x6 * x6 * x6 * x2 * x2;
                [x22 * x2, 24.0 * x22 * x, 552.0 * x22]
            }
        }
    }
}

/// A cost with its derivatives.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Expansion {
    pub(super) cost: f64,
    pub(super) gradient: DVec2,
    pub(super) hessian: Symmetric,
}

impl std::ops::AddAssign for Expansion {
    fn add_assign(&mut self, other: Self) {
        self.cost += other.cost;
        self.gradient += other.gradient;
        self.hessian = self.hessian + other.hessian;
    }
}

/// A symmetric matrix.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Symmetric {
    xx: f64,
    xy: f64,
    yy: f64,
}

impl Symmetric {
    const ONE: Self = Self {
        xx: 1.0,
        xy: 0.0,
        yy: 1.0,
    };

    /// The product of a vector with itself.
    fn of(v: DVec2) -> Self {
        Self {
            xx: v.x * v.x,
            xy: v.x * v.y,
            yy: v.y * v.y,
        }
    }

    /// The second derivative in a direction of length one.
    pub(super) fn along(self, d: DVec2) -> f64 {
        d.x * d.x * self.xx + 2.0 * d.x * d.y * self.xy + d.y * d.y * self.yy
    }

    /// The solution of `self` x = `right`, when the matrix is positive definite, clearly.
    pub(super) fn solve(self, right: DVec2) -> Option<DVec2> {
        let determinant = self.xx * self.yy - self.xy * self.xy;
        let enough = 1e-12 * (self.xx * self.xx + self.yy * self.yy);
        let x = self.yy * right.x - self.xy * right.y;
        let y = self.xx * right.y - self.xy * right.x;
        (self.xx > 0.0 && determinant > enough).then(|| DVec2::new(x, y) / determinant)
    }
}

impl std::ops::Add for Symmetric {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            xx: self.xx + other.xx,
            xy: self.xy + other.xy,
            yy: self.yy + other.yy,
        }
    }
}

impl std::ops::Sub for Symmetric {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + other * -1.0
    }
}

impl std::ops::Mul<f64> for Symmetric {
    type Output = Self;

    fn mul(self, by: f64) -> Self {
        Self {
            xx: self.xx * by,
            xy: self.xy * by,
            yy: self.yy * by,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const A: DVec2 = DVec2::new(-0.3, 0.1);
    const B: DVec2 = DVec2::new(1.1, -0.2);

    #[test]
    fn the_best_triangle_costs_nothing_and_a_flat_one_the_most() {
        for energy in [FIRST, LAST] {
            let top = DVec2::new(0.5, 0.75_f64.sqrt());
            assert!(energy.of([DVec2::ZERO, DVec2::X, top]).abs() < 1e-15);
            let flat = energy.of([DVec2::ZERO, DVec2::X, 2.0 * DVec2::X]);
            assert_eq!(energy.of([DVec2::ZERO, top, DVec2::X]), flat);
            let needle = energy.of([DVec2::ZERO, DVec2::X, DVec2::new(0.5, 1e-3)]);
            assert!(flat > needle && needle > 1e4);
        }
    }

    #[test]
    fn derivatives_are_those_of_the_cost() {
        for energy in [FIRST, LAST] {
            for apex in [
                DVec2::new(0.4, 0.9),
                DVec2::new(0.1, 0.7),
                DVec2::new(0.9, 0.8),
            ] {
                let at = |apex: DVec2| energy.expansion(apex, [A, B]).unwrap();
                let here = at(apex);
                let cost = energy.of([apex, A, B]);
                assert!((here.cost - cost).abs() < 1e-12 * (1.0 + cost));
                let step = 1e-6;
                let [x, y] = [DVec2::X, DVec2::Y].map(|along| {
                    let [ahead, behind] = [step, -step].map(|by| at(apex + by * along));
                    let slope = (ahead.cost - behind.cost) / (2.0 * step);
                    (slope, (ahead.gradient - behind.gradient) / (2.0 * step))
                });
                let gradient = DVec2::new(x.0, y.0);
                assert!((here.gradient - gradient).length() < 1e-6 * (1.0 + gradient.length()));
                let Symmetric { xx, xy, yy } = here.hessian;
                let off = [xx - x.1.x, xy - x.1.y, xy - y.1.x, yy - y.1.y];
                assert!(
                    off.iter()
                        .all(|off| off.abs() < 1e-5 * (1.0 + xx.abs() + yy.abs())),
                    "{off:?}"
                );
            }
        }
    }
}
