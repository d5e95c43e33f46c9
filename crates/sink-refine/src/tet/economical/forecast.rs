//! What making one vertex of two would do, in rounded numbers. The mesh is not touched.
//!
//! Candidates are points between the two vertices, and one towards the middle of the hole that they leave. Nearly all fail, so
//! the cheapest tests come first: tetrahedra of low quality in the hole have to be in conflict with a candidate, which is known
//! while the hole is being filled; there must be fewer tetrahedra; only then those that come are measured.

use super::super::records::Records;
use super::hole::{Candidate, Hole};
use super::hole_cavity::HoleCavity;
use delaunay_core::geo_predicates::{Sign, check_point3, in_diametral_ball, orient3d};
use delaunay_core::{Merge, Subcomplex3, VertexId};
use glam::DVec3;

/// Where between the two vertices candidates are.
const SHARES: [f64; 7] = [0.5, 0.3, 0.7, 0.4, 0.6, 0.2, 0.8];

/// Room for forecasts.
#[derive(Debug, Default)]
pub(super) struct Forecaster {
    hole: Hole,
    candidates: Vec<Candidate>,
    cavity: HoleCavity,
    best: Merge,
    /// How many fewer tetrahedra there are with the best.
    saved: usize,
    tested: usize,
}

impl Forecaster {
    /// The way to make one vertex of two neighbours that leaves fewest tetrahedra, if one pays: with no more tetrahedra of low
    /// quality, and none that is too large.
    pub(super) fn best(
        &mut self,
        solid: &Subcomplex3,
        records: &Records<'_>,
        pair: [VertexId; 2],
    ) -> Option<&Merge> {
        if !self.hole.open(solid, records, pair) {
            return None;
        }
        self.find_candidates(pair.map(|v| solid.point(v)));
        self.hole.fill_for(&mut self.candidates, records);
        self.saved = 0;
        for i in 0..self.candidates.len() {
            let point = self.candidates[i].point;
            self.cavity.dig(solid, &self.hole, point);
            self.tested += 1;
            let saved = self.saving();
            if saved > self.saved && self.is_harmless(solid, records, point) {
                self.saved = saved;
                self.keep(pair[0], point);
            }
        }
        (self.saved > 0).then_some(&self.best)
    }

    /// How many candidates have been tested so far.
    pub(super) fn tested(&self) -> usize {
        self.tested
    }

    fn find_candidates(&mut self, [p, q]: [DVec3; 2]) {
        let between = SHARES.iter().map(|&share| p.lerp(q, share));
        let towards_middle = p.midpoint(q).midpoint(self.hole.middle());
        let all = between.chain([towards_middle]);
        self.candidates.clear();
        self.candidates.extend(
            all.filter(|&point| check_point3(0, point).is_ok())
                .map(Candidate::at),
        );
    }

    /// How many fewer tetrahedra there would be.
    fn saving(&self) -> usize {
        let gone = self.hole.stars().len() + self.cavity.outside().len();
        gone.saturating_sub(self.cavity.staying() + self.cavity.rim().len())
    }

    /// Whether the point may be a vertex, with no more tetrahedra of low quality than before and none too large.
    fn is_harmless(&self, solid: &Subcomplex3, records: &Records<'_>, point: DVec3) -> bool {
        let (hole, cavity) = (&self.hole, &self.cavity);
        let encroaches = cavity.boundary(solid).any(|f| {
            let [a, b, c] = solid.triangle(f);
            in_diametral_ball(a, b, c, point) == Sign::Positive
        });
        let low_outside = cavity.outside().iter().filter(|&&t| records.is_low(t));
        let before = hole.low_before() + low_outside.count();
        let mut after = hole.low().iter().filter(|&&t| !cavity.contains(t)).count();
        let mut rim = cavity.rim().iter();
        !encroaches
            && rim.all(|corners| {
                let [a, b, c] = corners.map(|v| solid.point(v));
                let quality = records.measure([point, a, b, c], hole.stars());
                after += usize::from(quality.is_low(records.bound()));
                let is_seen = orient3d(point, a, b, c) == Sign::Positive;
                is_seen && after <= before && !quality.is_too_large()
            })
            && after <= before
    }

    /// Keeps the candidate whose cavity is found.
    fn keep(&mut self, vertex: VertexId, point: DVec3) {
        let (hole, cavity, best) = (&self.hole, &self.cavity, &mut self.best);
        best.point = point;
        best.gone.clear();
        best.gone.extend_from_slice(hole.stars());
        best.gone.extend_from_slice(cavity.outside());
        let star = cavity.rim().iter().map(|&[a, b, c]| [vertex, a, b, c]);
        let filling = hole.filling().iter().enumerate();
        let staying = filling.filter(|&(index, _)| !cavity.contains(index));
        best.made.clear();
        best.made.extend(star);
        best.made.extend(staying.map(|(_, tet)| hole.corners(tet)));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sizing::Sizing;
    use crate::tet::sizes::Sizes;
    use delaunay_core::Delaunay3;
    use rand::{RngExt, SeedableRng};
    use rand_chacha::ChaCha8Rng;

    /// How many tetrahedra there are, and how many of low quality.
    fn counts(solid: &Subcomplex3, records: &Records<'_>) -> [usize; 2] {
        let measured = solid
            .tets()
            .map(|t| records.measure(solid.tetrahedron(t), &[t]));
        let low = measured.filter(|quality| quality.is_low(records.bound()));
        [solid.tets().count(), low.count()]
    }

    /// Makes every merge that is forecast, each in a mesh of its own. Gives how many were made and how many refused.
    fn merge_all_ways(points: &[DVec3]) -> [usize; 2] {
        let solid = Subcomplex3::of(&Delaunay3::build(points).unwrap(), |_| true);
        let sizes = Sizes::of(&solid, &Sizing::default()).unwrap();
        let records = Records::of(&solid, 1.5, sizes);
        let [tets, low] = counts(&solid, &records);
        let mut forecaster = Forecaster::default();
        let [mut made, mut refused] = [0; 2];
        for u in (0..points.len()).map(VertexId::new) {
            for v in solid.mesh().neighbors(u).filter(|v| !v.is_ghost()) {
                let Some(merge) = forecaster.best(&solid, &records, [u, v]).cloned() else {
                    continue;
                };
                let mut merged = solid.clone();
                if merged.merge([u, v], &merge).is_none() {
                    assert!(merged.mesh() == solid.mesh() && merged.points() == solid.points());
                    refused += 1;
                    continue;
                }
                assert_eq!(merged.mesh().check(), Ok(()));
                let [tets_after, low_after] = counts(&merged, &records);
                assert_eq!(tets_after, tets - forecaster.saved);
                assert!(tets_after < tets && low_after <= low);
                made += 1;
            }
        }
        [made, refused]
    }

    #[test]
    fn what_is_forecast_happens() {
        let mut rng = ChaCha8Rng::seed_from_u64(5);
        let mut place = || DVec3::from(std::array::from_fn(|_| rng.random_range(0.0..1.0)));
        let points: Vec<DVec3> = (0..150).map(|_| place()).collect();
        let [made, refused] = merge_all_ways(&points);
        assert!(made > 100 && refused == 0, "{made} {refused}");
    }

    /// Of points of a lattice many are on a common sphere: rounded numbers break ties as they like.
    #[test]
    fn a_wrong_forecast_changes_nothing() {
        let point = |i: u32| (f64::from(i * i) * DVec3::new(0.1234, 0.2345, 0.3456)).fract();
        let points: Vec<DVec3> = (1..=300).map(point).collect();
        let [made, refused] = merge_all_ways(&points);
        assert!(made > 100 && refused > 0, "{made} {refused}");
    }

    #[test]
    fn vertices_of_the_boundary_stay() {
        let cube = |i: u32| DVec3::from([i & 1, i >> 1 & 1, i >> 2].map(f64::from));
        let points: Vec<DVec3> = (0..8).map(cube).chain([DVec3::splat(0.4)]).collect();
        let solid = Subcomplex3::of(&Delaunay3::build(&points).unwrap(), |_| true);
        let sizes = Sizes::of(&solid, &Sizing::default()).unwrap();
        let records = Records::of(&solid, 2.0, sizes);
        let pair = [0, 8].map(VertexId::new);
        let mut forecaster = Forecaster::default();
        for [u, v] in [pair, [pair[1], pair[0]]] {
            assert!(forecaster.best(&solid, &records, [u, v]).is_none());
        }
        assert_eq!(forecaster.tested(), 0);
    }
}
