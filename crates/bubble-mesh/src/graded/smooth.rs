//! One vertex moves to where its triangles cost less: a step of Newton's method on the cost of its star.

use delaunay_core::{Complex2, VertexId};
use glam::DVec2;

use super::energy::{Energy, Expansion};

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
        let Some(now) = self.expansion(here, energy) else {
            return 0.0;
        };
        let Some(step) = step(&now, shortest) else {
            return 0.0;
        };
        let mut share = 1.0;
        for _ in 0..TRIES {
            let there = here + share * step;
            if self.cost(there, energy) < now.cost && complex.move_vertex(v, there) {
                return share * step.length() / shortest;
            }
            share *= SHORTER;
        }
        0.0
    }

    fn cost(&self, there: DVec2, energy: Energy) -> f64 {
        let costs = self.link.iter().map(|&[a, b]| energy.of([there, a, b]));
        costs.sum()
    }

    fn expansion(&self, there: DVec2, energy: Energy) -> Option<Expansion> {
        let mut total = Expansion::default();
        for &edge in &self.link {
            total += energy.expansion(there, edge)?;
        }
        Some(total)
    }
}

/// Newton's step, or one downhill; `None` at a place where the cost is level.
fn step(now: &Expansion, shortest: f64) -> Option<DVec2> {
    let newton = now.hessian.solve(-now.gradient);
    let downhill = || -DOWNHILL_STEP * shortest * now.gradient.normalize_or_zero();
    let step = newton
        .unwrap_or_else(downhill)
        .clamp_length_max(LONGEST_STEP * shortest);
    (step.is_finite() && step != DVec2::ZERO).then_some(step)
}
