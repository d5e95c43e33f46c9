//! What is remembered of every tetrahedron and vertex: quality, and when something changed there last.

use crate::quality::min_sine;
use delaunay_core::{Complex3, TetId, VertexId};

/// A moment in the course of the changes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Moment(u32);

impl Moment {
    /// Before all changes.
    pub(crate) const NEVER: Self = Self(0);

    /// Changes that have moments of their own.
    pub(crate) const LIMIT: usize = u32::MAX as usize - 1;
}

/// What is remembered of a tetrahedron.
#[derive(Clone, Copy, Debug)]
struct Entry {
    quality: f64,
    /// When it was made or changed.
    made: Moment,
    /// When other vertices were last found not to help it.
    given_up: Moment,
}

impl Entry {
    const GONE: Self = Self {
        quality: 0.0,
        made: Moment::NEVER,
        given_up: Moment::NEVER,
    };
}

/// Records beside a mesh.
#[derive(Clone, Debug)]
pub(crate) struct Records {
    /// By tetrahedron.
    tets: Vec<Entry>,
    /// By vertex: when a tetrahedron at it changed last.
    touched: Vec<Moment>,
    /// By vertex: when it was last found to be in the best place.
    settled: Vec<Moment>,
    /// By vertex: whether it is on the boundary, for ever.
    on_boundary: Vec<bool>,
    now: Moment,
}

impl Records {
    /// The records of a mesh that has not changed yet.
    pub(crate) fn of(complex: &Complex3) -> Self {
        let mut records = Self {
            tets: Vec::new(),
            touched: Vec::new(),
            settled: Vec::new(),
            on_boundary: vec![false; complex.points().len()],
            now: Moment::NEVER,
        };
        for f in complex.boundary() {
            for v in complex.mesh().facet_vertices(f) {
                records.on_boundary[v.index()] = true;
            }
        }
        let all: Vec<TetId> = complex.tets().collect();
        records.note_change(complex, &[], &all);
        records
    }

    /// Forgets the tetrahedra `gone` and measures those that are new or have changed.
    pub(crate) fn note_change(&mut self, complex: &Complex3, gone: &[TetId], new: &[TetId]) {
        self.now.0 += 1;
        let never = Moment::NEVER;
        self.tets.resize(complex.mesh().tet_slots(), Entry::GONE);
        let vertices = complex.points().len();
        self.touched.resize(vertices, never);
        self.settled.resize(vertices, never);
        self.on_boundary.resize(vertices, false);
        for t in gone {
            self.tets[t.index()] = Entry::GONE;
        }
        for &t in new {
            self.tets[t.index()] = Entry {
                quality: min_sine(complex.tetrahedron(t)),
                made: self.now,
                given_up: never,
            };
            for v in complex.mesh().tet_vertices(t) {
                self.touched[v.index()] = self.now;
            }
        }
    }

    /// The quality of a tetrahedron.
    #[inline]
    pub(crate) fn quality(&self, t: TetId) -> f64 {
        self.tets[t.index()].quality
    }

    /// The quality of the worst of some tetrahedra.
    pub(crate) fn worst(&self, tets: &[TetId]) -> f64 {
        let qualities = tets.iter().map(|&t| self.quality(t));
        qualities.fold(f64::INFINITY, f64::min)
    }

    /// When a tetrahedron was made or changed: never the same for two with the same id.
    pub(crate) fn made(&self, t: TetId) -> Moment {
        self.tets[t.index()].made
    }

    /// When other vertices were last found not to help a tetrahedron.
    pub(crate) fn given_up(&self, t: TetId) -> Moment {
        self.tets[t.index()].given_up
    }

    pub(crate) fn give_up(&mut self, t: TetId) {
        self.tets[t.index()].given_up = self.now;
    }

    /// The moment of the last change.
    pub(crate) fn now(&self) -> Moment {
        self.now
    }

    /// Whether a tetrahedron at `v` has changed since `then`.
    pub(crate) fn is_news(&self, v: VertexId, then: Moment) -> bool {
        self.touched[v.index()] > then
    }

    pub(crate) fn is_on_boundary(&self, v: VertexId) -> bool {
        self.on_boundary[v.index()]
    }

    /// Whether the star of `v` is as it was when `v` was found to be in the best place.
    pub(crate) fn is_settled(&self, v: VertexId) -> bool {
        self.settled[v.index()] >= self.touched[v.index()]
    }

    /// Forgets which vertices are in their best places: another goal is about to be set.
    pub(crate) fn unsettle(&mut self) {
        self.settled.fill(Moment::NEVER);
    }

    /// Takes down that `v` is in the best place.
    pub(crate) fn settle(&mut self, v: VertexId) {
        self.settled[v.index()] = self.now;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample::cube;

    #[test]
    fn a_change_is_news_to_the_corners_of_what_it_makes() {
        let mut complex = cube(2, 1);
        let mut records = Records::of(&complex);
        let center = VertexId::new(13);
        assert!(records.on_boundary.iter().filter(|&&on| !on).count() == 1);
        assert!(!records.is_on_boundary(center));
        let (t, then) = (complex.mesh().home(center).unwrap(), records.now());
        records.settle(center);
        assert!(records.is_settled(center) && !records.is_news(center, then));
        let corners = complex.tetrahedron(t);
        let (v, star) = complex
            .insert(&[t], corners.into_iter().sum::<glam::DVec3>() / 4.0)
            .unwrap();
        records.note_change(&complex, &[t], &star);
        assert!(!records.is_settled(center) && !records.is_on_boundary(v));
        for w in (0..complex.points().len()).map(VertexId::new) {
            let at_star = star
                .iter()
                .any(|&t| complex.mesh().tet_vertices(t).contains(&w));
            assert_eq!(records.is_news(w, then), at_star, "{w}");
        }
        assert!(star.iter().all(|&t| records.made(t) == records.now()));
        records.unsettle();
        assert!(!records.is_settled(center));
    }
}
