//! One vertex moves to where its triangles cost less: a step of Newton's method on the cost of its star.

use delaunay_core::{Complex2, VertexId};
use glam::{DMat2, DVec2};

use super::energy::{Energy, FORBIDDEN};

/// The step is at most this share of the shortest edge.
const LONGEST_STEP: f64 = 0.3;

/// Where the cost is not convex, the step is this share of the shortest edge, downhill.
const DOWNHILL_STEP: f64 = 0.1;

/// How often the step is made shorter, and by how much.
const TRIES: usize = 5;
const SHORTER: f64 = 0.35;

/// The links of one star after the other.
#[derive(Clone, Debug, Default)]
pub(super) struct Smoother {
    /// The edges opposite the vertex.
    link: Vec<[DVec2; 2]>,
}

impl Smoother {
    /// Moves an inner vertex if its star costs less then; gives the length of the step over that of the shortest edge, 0 when it
    /// stays.
    pub(super) fn smooth(&mut self, complex: &mut Complex2, v: VertexId, energy: Energy) -> f64 {
        let (here, mesh) = (complex.point(v), complex.mesh());
        self.link.clear();
        self.link.extend(
            mesh.link(v)
                .map(|h| [mesh.origin(h), mesh.target(h)].map(|v| complex.point(v))),
        );
        let edges = self.link.iter().map(|[a, _]| a.distance_squared(here));
        let shortest = edges.fold(f64::INFINITY, f64::min).sqrt();
        let (cost, gradient) = self.with_gradient(here, energy);
        let Some(step) = self.step(here, gradient, shortest, energy) else {
            return 0.0;
        };
        let mut share = 1.0;
        for _ in 0..TRIES {
            let there = here + share * step;
            if self.cost(there, energy) < cost && complex.move_vertex(v, there) {
                return share * step.length() / shortest;
            }
            share *= SHORTER;
        }
        0.0
    }

    /// Newton's step, or one downhill; `None` at a place where the cost is level.
    fn step(&self, here: DVec2, gradient: DVec2, shortest: f64, energy: Energy) -> Option<DVec2> {
        let reach = 1e-4 * shortest;
        let slope_at = |there: DVec2| self.with_gradient(there, energy).1;
        let by_x = (slope_at(here + reach * DVec2::X) - gradient) / reach;
        let by_y = (slope_at(here + reach * DVec2::Y) - gradient) / reach;
        let mixed = 0.5 * (by_x.y + by_y.x);
        let hessian = DMat2::from_cols(DVec2::new(by_x.x, mixed), DVec2::new(mixed, by_y.y));
        let determinant = hessian.determinant();
        let enough = 1e-12 * (by_x.x * by_x.x + by_y.y * by_y.y);
        let step = if by_x.x > 0.0 && determinant > enough {
            -(hessian.inverse() * gradient)
        } else {
            -DOWNHILL_STEP * shortest * gradient.normalize_or_zero()
        };
        let step = step.clamp_length_max(LONGEST_STEP * shortest);
        (step.is_finite() && step != DVec2::ZERO).then_some(step)
    }

    fn cost(&self, there: DVec2, energy: Energy) -> f64 {
        let costs = self.link.iter().map(|&[a, b]| energy.of([there, a, b]));
        costs.sum()
    }

    fn with_gradient(&self, there: DVec2, energy: Energy) -> (f64, DVec2) {
        let mut total = (0.0, DVec2::ZERO);
        for &edge in &self.link {
            let (cost, gradient) = energy.with_gradient(there, edge);
            if cost == FORBIDDEN {
                return (FORBIDDEN, DVec2::ZERO);
            }
            total.0 += cost;
            total.1 += gradient;
        }
        total
    }
}
