//! Vertex insertion: tetrahedra of low quality give way to the star of a new vertex (Klingner and Shewchuk 2007, §3).
//!
//! Whether a set of tetrahedra, all seen from a point, should go shows at its rim: the new tetrahedra stand on it. If the
//! worst of them is to be avoided, the tetrahedron behind its facet has to go, too. So the sets that grow this way from one
//! tetrahedron contain the best one: whatever set is better than the one at hand contains the tetrahedron behind the worst
//! facet. Growing and the [climb](crate::ascent) of the new vertex take turns.

use crate::ascent::Ascent;
use crate::plan::Insertion;
use crate::quality::min_sine;
use crate::smoothing::climb;
use delaunay_core::{Complex3, FacetId, TetId};
use glam::DVec3;

/// Tetrahedra that may go at most.
const LARGEST: usize = 48;

/// How often the new vertex looks for a better place, and the tetrahedra to go are found anew.
const TURNS: usize = 4;

/// Finds places for new vertices.
#[derive(Clone, Debug, Default)]
pub(crate) struct Inserter {
    ascent: Ascent,
    cavity: Cavity,
    link: Vec<[DVec3; 3]>,
}

/// Tetrahedra that are to go.
#[derive(Clone, Debug, Default)]
struct Cavity {
    tets: Vec<TetId>,
    /// The facets round them from inside, with the quality of the new tetrahedron on each.
    rim: Vec<(FacetId, f64)>,
}

impl Inserter {
    /// The best insertion found from `start`, in the place of `t` and others; whether it is an improvement is not said.
    ///
    /// `None` when no point was found from which `t` and others make a star.
    pub(crate) fn plan(
        &mut self,
        complex: &Complex3,
        t: TetId,
        start: DVec3,
        goal: f64,
    ) -> Option<Insertion> {
        let mut best: Option<Insertion> = None;
        let mut place = start;
        for _ in 0..TURNS {
            let quality = self.cavity.grow(complex, t, place);
            if quality <= best.as_ref().map_or(0.0, |best| best.quality) {
                break;
            }
            self.link.clear();
            let rim = self.cavity.rim.iter();
            let triangles = rim.map(|&(f, _)| complex.mesh().facet_vertices(f));
            let triangles = triangles.map(|corners| corners.map(|v| complex.point(v)));
            self.link.extend(triangles.clone());
            place = climb(&mut self.ascent, &mut self.link, place, goal);
            // The records will have the same numbers, to the last bit.
            let qualities = triangles.map(|[a, b, c]| min_sine([place, a, b, c]));
            best = Some(Insertion {
                gone: self.cavity.tets.clone(),
                place,
                quality: qualities.fold(f64::INFINITY, f64::min),
            });
        }
        best
    }
}

impl Cavity {
    /// Becomes the set of tetrahedra with `t` whose replacement by the star of a vertex at `place` has the best worst
    /// tetrahedron, among those of limited size. Gives its quality.
    fn grow(&mut self, complex: &Complex3, t: TetId, place: DVec3) -> f64 {
        self.tets.clear();
        self.rim.clear();
        let mesh = complex.mesh();
        let (mut best, mut best_len) = (f64::NEG_INFINITY, 0);
        let mut next = t;
        loop {
            self.take_in(complex, next, place);
            let worst = self
                .rim
                .iter()
                .min_by(|(f, q), (g, r)| q.total_cmp(r).then(f.cmp(g)));
            let Some(&(facet, quality)) = worst else {
                break;
            };
            if quality > best {
                (best, best_len) = (quality, self.tets.len());
            }
            next = mesh.twin(facet).tet();
            if mesh.is_ghost_tet(next) || self.tets.len() == LARGEST {
                break;
            }
        }
        let taken = std::mem::take(&mut self.tets);
        self.rim.clear();
        for &t in taken.iter().take(best_len) {
            self.take_in(complex, t, place);
        }
        best
    }

    fn take_in(&mut self, complex: &Complex3, t: TetId, place: DVec3) {
        let mesh = complex.mesh();
        self.tets.push(t);
        for f in t.facets() {
            let twin = mesh.twin(f);
            if let Some(inner) = self.rim.iter().position(|&(g, _)| g == twin) {
                self.rim.swap_remove(inner);
            } else {
                let [a, b, c] = mesh.facet_vertices(f).map(|v| complex.point(v));
                self.rim.push((f, min_sine([place, a, b, c])));
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::records::Records;
    use crate::sample::{Frame, cube};

    #[test]
    fn what_is_planned_comes_about() {
        let (mut better, mut inserter) = (0, Inserter::default());
        for seed in 0..4 {
            let mut complex = cube(4, seed);
            let frame = Frame::of(&complex);
            for t in complex.tets().collect::<Vec<_>>() {
                let is_there = complex.mesh().contains_tet(t) && !complex.mesh().is_ghost_tet(t);
                if !is_there {
                    continue;
                }
                let center = complex.tetrahedron(t).into_iter().sum::<DVec3>() / 4.0;
                let plan = inserter.plan(&complex, t, center, 0.5).unwrap();
                assert!(plan.gone.contains(&t) && plan.quality > 0.0);
                let mut records = Records::of(&complex);
                if plan.quality > records.worst(&plan.gone) {
                    let (_, star) = complex.insert(&plan.gone, plan.place).unwrap();
                    records.note_change(&complex, &plan.gone, &star);
                    assert_eq!(records.worst(&star), plan.quality);
                    frame.assert_holds(&complex);
                    better += 1;
                }
            }
        }
        assert!(better > 50, "{better}");
    }

    /// Any set of tetrahedra that contains the one given, by brute force, has a worst new tetrahedron at most as good.
    #[test]
    fn the_cavity_that_is_grown_is_the_best() {
        let complex = cube(2, 3);
        let tets: Vec<TetId> = complex.tets().collect();
        let mut cavity = Cavity::default();
        for &t in &tets {
            let place = complex.tetrahedron(t).into_iter().sum::<DVec3>() / 4.0;
            let grown = cavity.grow(&complex, t, place);
            let mut best = f64::NEG_INFINITY;
            for subset in 0..1_u64 << 10.min(tets.len()) {
                let others = tets.iter().take(10).enumerate();
                let taken = others.filter(|&(i, &other)| subset >> i & 1 == 1 && other != t);
                let mut some = Cavity::default();
                some.take_in(&complex, t, place);
                for (_, &other) in taken {
                    some.take_in(&complex, other, place);
                }
                best = best.max(
                    some.rim
                        .iter()
                        .map(|&(_, q)| q)
                        .fold(f64::INFINITY, f64::min),
                );
            }
            assert!(grown >= best, "{t}: {grown} {best}");
        }
    }
}
