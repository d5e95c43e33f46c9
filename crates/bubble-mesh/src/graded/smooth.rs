//! One vertex moves to where its triangles cost less: a step of Newton's method on the cost of its star.

use delaunay_core::{Complex2, HalfEdgeId, VertexId};
use glam::DVec2;

use super::energy::{Energy, Expansion};
use crate::boundary::Rails;

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
        let shortest = self.shortest(here);
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

    /// As [`Smoother::smooth`], for a boundary vertex that moves along its curve.
    pub(super) fn slide(
        &mut self,
        complex: &mut Complex2,
        v: VertexId,
        rails: &mut Rails,
        energy: Energy,
    ) -> f64 {
        let Some(along) = rails.direction(v) else {
            return 0.0;
        };
        let (here, mesh) = (complex.point(v), complex.mesh());
        let real = mesh.link(v).filter(|h| !mesh.is_ghost_face(h.face()));
        let ends = |h: HalfEdgeId| [mesh.origin(h), mesh.target(h)].map(|v| complex.point(v));
        self.link.clear();
        self.link.extend(real.map(ends));
        let shortest = self.shortest(here);
        let Some(now) = self.expansion(here, energy) else {
            return 0.0;
        };
        let slope = now.gradient.dot(along);
        let bend = now.hessian.along(along);
        let step = match bend > 0.0 {
            true => (-slope / bend).clamp(-LONGEST_STEP * shortest, LONGEST_STEP * shortest),
            false => -slope.signum() * DOWNHILL_STEP * shortest,
        };
        let mut share = 1.0;
        for _ in 0..TRIES {
            let Some((at, there)) = rails.ahead(v, share * step) else {
                return 0.0;
            };
            if self.cost(there, energy) < now.cost && complex.move_boundary_vertex(v, there) {
                rails.seat(v, at);
                return there.distance(here) / shortest;
            }
            share *= SHORTER;
        }
        0.0
    }

    /// The shortest edge from a place to the link.
    fn shortest(&self, here: DVec2) -> f64 {
        let ends = self.link.iter().flatten();
        let lengths = ends.map(|end| end.distance_squared(here));
        lengths.fold(f64::INFINITY, f64::min).sqrt()
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
