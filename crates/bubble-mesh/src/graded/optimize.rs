//! Sweeps of moves and flips until nothing is gained any more.

use delaunay_core::measure::triangle::radius_ratio;
use delaunay_core::progress::{Cancelled, Meter};
use delaunay_core::{Complex2, FaceId, HalfEdgeId, VertexId};

use super::energy::Energy;
use super::smooth::Smoother;
use crate::boundary::Rails;

/// A flip has to gain this share of what its triangles cost, which is far more than rounding: the worst cost 1e24, so that no gain is
/// large for all.
const LEAST_GAIN: f64 = 1e-9;

/// No flip betters two triangles that cost less than this: it takes two with right angles, which cost 0.17, for both
/// diagonals to be as good.
const GOOD: f64 = 0.1;

/// Which vertices are moved.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sweeps {
    pub(super) energy: Energy,
    /// A vertex is moved again when it or a neighbour has moved by more than this share of an edge.
    pub(super) tolerance: f64,
    /// At most this many sweeps.
    pub(super) limit: usize,
    /// The first sweep moves the vertices of triangles below this ratio only.
    pub(super) below: f64,
}

/// Lowers the cost of all triangles; at most so many sweeps, each of which lowers it or is the last.
///
/// # Errors
/// When the meter stops it; the mesh is valid then too.
pub(super) fn optimize(
    complex: &mut Complex2,
    sweeps: Sweeps,
    meter: &mut Meter<'_>,
) -> Result<(), Cancelled> {
    optimize_on(complex, None, sweeps, meter)
}

/// As [`optimize`], with boundary vertices that move along their curves.
///
/// # Errors
/// As [`optimize`].
pub(super) fn optimize_on(
    complex: &mut Complex2,
    mut rails: Option<&mut Rails>,
    sweeps: Sweeps,
    meter: &mut Meter<'_>,
) -> Result<(), Cancelled> {
    let mut worklist = Worklist::of(complex, rails.as_deref(), sweeps.below);
    let mut smoother = Smoother::default();
    let mut changed: Vec<FaceId> = complex.faces().collect();
    for _ in 0..sweeps.limit {
        let rails = rails.as_deref_mut();
        let moved = worklist.sweep(complex, rails, &mut smoother, sweeps, &mut changed, meter)?;
        let flipped = flip_all(complex, sweeps.energy, &mut changed);
        worklist.mark(complex, &flipped);
        if !moved && flipped.is_empty() {
            break;
        }
        changed.clear();
    }
    Ok(())
}

/// The vertices that may have something to gain.
struct Worklist {
    /// Those inside, and those of the boundary that may move.
    vertices: Vec<VertexId>,
    /// By vertex index.
    pending: Vec<bool>,
}

impl Worklist {
    fn of(complex: &Complex2, rails: Option<&Rails>, below: f64) -> Self {
        let inner = complex.inner_vertices();
        let on_rails = rails.into_iter().flat_map(Rails::vertices);
        let mut worklist = Self {
            vertices: inner.chain(on_rails).collect(),
            pending: vec![false; complex.points().len()],
        };
        let poor = complex
            .faces()
            .filter(|&f| radius_ratio(complex.triangle(f)) < below);
        let poor: Vec<FaceId> = poor.collect();
        worklist.mark(complex, &poor);
        worklist
    }

    /// Marks the corners of triangles.
    fn mark(&mut self, complex: &Complex2, faces: &[FaceId]) {
        for &f in faces {
            for v in complex.mesh().face_vertices(f) {
                self.pending[v.index()] = true;
            }
        }
    }

    /// Moves every vertex that may gain something; lists the triangles that have changed and tells whether any has moved.
    fn sweep(
        &mut self,
        complex: &mut Complex2,
        mut rails: Option<&mut Rails>,
        smoother: &mut Smoother,
        sweeps: Sweeps,
        changed: &mut Vec<FaceId>,
        meter: &mut Meter<'_>,
    ) -> Result<bool, Cancelled> {
        let mut any = false;
        for k in 0..self.vertices.len() {
            let v = self.vertices[k];
            if !self.pending[v.index()] {
                continue;
            }
            meter.advance()?;
            self.pending[v.index()] = false;
            let step = match rails.as_deref_mut().filter(|_| !complex.is_inner(v)) {
                Some(rails) => smoother.slide(complex, v, rails, sweeps.energy),
                None => smoother.smooth(complex, v, sweeps.energy),
            };
            if step > sweeps.tolerance {
                any = true;
                let mesh = complex.mesh();
                for f in mesh.star(v).filter(|&f| !mesh.is_ghost_face(f)) {
                    changed.push(f);
                    for w in mesh.face_vertices(f) {
                        self.pending[w.index()] = true;
                    }
                }
            }
        }
        changed.sort_unstable();
        changed.dedup();
        Ok(any)
    }
}

/// Flips edges of the triangles listed, and of those that change, as long as that lowers the cost; gives the triangles that
/// have changed.
///
/// Every flip lowers the sum of the costs, by more than rounding, so no triangulation comes back.
pub(super) fn flip_all(
    complex: &mut Complex2,
    energy: Energy,
    pending: &mut Vec<FaceId>,
) -> Vec<FaceId> {
    let mut flipped = Vec::new();
    while let Some(f) = pending.pop() {
        let cost = energy.of(complex.triangle(f));
        let mut edges = f.half_edges().into_iter();
        let faces = edges.find_map(|h| {
            let beyond = complex.mesh().twin(h).face();
            let flips = gains(complex, h, cost, energy) && complex.flip(h).is_some();
            flips.then_some([f, beyond])
        });
        flipped.extend(faces.into_iter().flatten());
        pending.extend(faces.into_iter().flatten());
    }
    flipped
}

/// Whether the flip of an edge lowers the cost; `cost` is that of its face.
fn gains(complex: &Complex2, h: HalfEdgeId, cost: f64, energy: Energy) -> bool {
    let mesh = complex.mesh();
    let t = mesh.twin(h);
    let corners = [mesh.origin(h), mesh.target(h), mesh.apex(h), mesh.apex(t)];
    if corners.iter().any(|v| v.is_ghost()) {
        return false;
    }
    let [a, b, c, d] = corners.map(|v| complex.point(v));
    let beyond = energy.of([b, a, d]);
    if cost.max(beyond) < GOOD {
        return false;
    }
    is_gain(cost + beyond, energy.of([a, d, c]) + energy.of([d, b, c]))
}

/// Whether two triangles cost less than others, and not by rounding.
fn is_gain(before: f64, after: f64) -> bool {
    after < (1.0 - LEAST_GAIN) * before
}

#[cfg(test)]
mod tests {
    use super::super::energy::{FIRST, LAST};
    use super::*;
    use glam::DVec2;

    /// Rectangles, whose diagonals are equally good: only rounding tells them apart, whatever the triangles cost.
    #[test]
    fn rounding_flips_no_edge() {
        let mut differ = 0;
        for energy in [FIRST, LAST] {
            for k in 1..2000 {
                let across = DVec2::from_angle(f64::from(k));
                let high = 0.5_f64.powf(f64::from(k % 97) / 4.0) * across.perp();
                let corners = [DVec2::ZERO, across, across + high, high];
                let [a, b, c, d] = corners.map(|p| p + f64::from(k % 3) * DVec2::ONE);
                // The triangles on one diagonal and on the other, from each corner on, as a mesh may list them.
                let rotations = |[a, b, c]: [DVec2; 3]| [[a, b, c], [b, c, a], [c, a, b]];
                for one in rotations([a, b, c]) {
                    for two in rotations([a, c, d]) {
                        for three in rotations([a, b, d]) {
                            for four in rotations([b, c, d]) {
                                let before = energy.of(one) + energy.of(two);
                                let after = energy.of(three) + energy.of(four);
                                assert!(
                                    !is_gain(before, after) && !is_gain(after, before),
                                    "{energy:?} {k}: {before} {after}"
                                );
                                differ += usize::from(before != after);
                            }
                        }
                    }
                }
            }
        }
        assert!(differ > 0);
    }

    /// On a grid of places for the two corners beyond an edge of length one.
    #[test]
    fn no_flip_betters_good_triangles() {
        let steps = 60;
        let at = |i: usize, j: usize| {
            let [x, y] = [i, j].map(|k| k as f64 / f64::from(steps));
            DVec2::new(1.6 * x - 0.3, 0.3 + 1.1 * y)
        };
        let grid =
            || (0..=steps as usize).flat_map(|i| (0..=steps as usize).map(move |j| at(i, j)));
        let (a, b) = (DVec2::ZERO, DVec2::X);
        let mut pairs = 0;
        for energy in [FIRST, LAST] {
            let good: Vec<(DVec2, f64)> = grid()
                .map(|c| (c, energy.of([a, b, c])))
                .filter(|&(_, cost)| cost < GOOD)
                .collect();
            for &(c, above) in &good {
                for &(mirrored, below) in &good {
                    let d = DVec2::new(mirrored.x, -mirrored.y);
                    let flipped = energy.of([a, d, c]) + energy.of([d, b, c]);
                    assert!(flipped > above + below, "{energy:?}: {c} {d}");
                    pairs += 1;
                }
            }
        }
        assert!(pairs > 100_000, "{pairs}");
    }
}
