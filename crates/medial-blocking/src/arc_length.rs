//! Length along a medial arc, and the point at a given length.

use crate::medial_graph::ArcCurve;

/// Pieces into which an arc is cut to measure its length.
pub(crate) const PIECES: usize = 24;

/// Abscissae and weights of Gauss–Legendre quadrature with three points on [0, 1].
const GAUSS: [(f64, f64); 3] = [
    (0.112_701_665_379_258_3, 5.0 / 18.0),
    (0.5, 8.0 / 18.0),
    (0.887_298_334_620_741_7, 5.0 / 18.0),
];

/// Length along an arc as a function of its parameter, tabulated.
pub(crate) struct ArcLength {
    curve: ArcCurve,
    /// Length from the start to the parameter `k / PIECES`.
    upto: [f64; PIECES + 1],
}

impl ArcLength {
    pub(crate) fn of(curve: ArcCurve) -> Self {
        let mut upto = [0.0; PIECES + 1];
        for k in 0..PIECES {
            upto[k + 1] = upto[k] + Self::between(&curve, at(k), at(k + 1));
        }
        Self { curve, upto }
    }

    pub(crate) fn total(&self) -> f64 {
        self.upto[PIECES]
    }

    /// The parameter at which the length from the start is `length`, by safeguarded Newton steps
    /// inside one piece.
    pub(crate) fn parameter(&self, length: f64) -> f64 {
        let piece = self
            .upto
            .partition_point(|&upto| upto <= length)
            .clamp(1, PIECES)
            - 1;
        let (mut low, mut high) = (at(piece), at(piece + 1));
        let within = (length - self.upto[piece]) / (self.upto[piece + 1] - self.upto[piece]);
        let mut u = if within.is_finite() {
            low + (high - low) * within.clamp(0.0, 1.0)
        } else {
            low
        };
        for _ in 0..8 {
            let excess = self.upto[piece] + Self::between(&self.curve, at(piece), u) - length;
            if excess.abs() <= 1e-14 * self.total() {
                break;
            }
            if excess > 0.0 {
                high = u;
            } else {
                low = u;
            }
            let newton = u - excess / self.curve.speed(u);
            u = if (low..=high).contains(&newton) {
                newton
            } else {
                low.midpoint(high)
            };
        }
        u
    }

    /// Length of curve between two parameters of one piece.
    fn between(curve: &ArcCurve, from: f64, to: f64) -> f64 {
        GAUSS
            .iter()
            .map(|&(x, weight)| weight * curve.speed(from + (to - from) * x))
            .sum::<f64>()
            * (to - from)
    }
}

/// The parameter at which a piece starts.
pub(crate) fn at(piece: usize) -> f64 {
    piece as f64 / PIECES as f64
}
