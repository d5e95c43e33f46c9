//! Polygons with holes, triangulated without new vertices and then made worse.
//!
//! ```text
//!   d ───── c        d ───── c     an edge that is no segment is flipped when its two triangles
//!   │ \     │        │     / │     are strictly convex together, preferably when that makes the
//!   │    \  │   ->   │  /    │     worse of them still worse: what remains are needles
//!   a ───── b        a ───── b
//! ```
//!
//! Orientation is exact, so the triangulation stays one.

use delaunay_core::geo_predicates::{Sign, orient2d};
use delaunay_core::{BuildOptions, Constrained2, Crossings, VertexId, progress::silent};
use glam::DVec2;
use rand::RngExt;
use rustc_hash::{FxHashMap, FxHashSet};

use super::Random;
use super::places::Places;

/// Points and segments in the plane. Segments must not cross.
#[derive(Clone, Debug, Default)]
pub struct Drawing {
    points: Vec<DVec2>,
    at: Places<2>,
    segments: Vec<[usize; 2]>,
}

/// A part of the plane in triangles.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Cap {
    /// The vertices.
    pub points: Vec<DVec2>,
    /// Corners of each triangle, counterclockwise.
    pub triangles: Vec<[u32; 3]>,
}

impl Drawing {
    /// Adds a point; the index of the one at that place.
    pub fn point(&mut self, place: DVec2) -> usize {
        let place = place + 0.0;
        let (index, is_new) = self.at.number(place.to_array());
        if is_new {
            self.points.push(place);
        }
        index
    }

    /// Adds a segment.
    pub fn segment(&mut self, from: DVec2, to: DVec2) {
        let ends = [from, to].map(|end| self.point(end));
        self.segments.push(ends);
    }

    /// Adds a closed polygon.
    pub fn ring(&mut self, corners: &[DVec2]) {
        for (index, &corner) in corners.iter().enumerate() {
            self.segment(corner, corners[(index + 1) % corners.len()]);
        }
    }

    /// The triangles that an odd number of rings surrounds, made worse at random.
    ///
    /// Empty when segments cross or all points are on a line.
    #[must_use]
    pub fn inside(&self, random: &mut Random) -> Cap {
        let Some(triangulation) = self.triangulation() else {
            return Cap::default();
        };
        let Ok(parts) = triangulation.components(&mut silent) else {
            return Cap::default();
        };
        let inside = triangulation.faces().filter(|&f| parts.is_odd(f));
        let corners = inside.map(|f| triangulation.mesh().face_vertices(f));
        self.cap(&triangulation, corners.map(indices).collect(), random)
    }

    /// The triangles whose centre of gravity is wanted, made worse at random.
    ///
    /// Empty when segments cross or all points are on a line.
    #[must_use]
    pub fn wherever(&self, is_wanted: impl Fn(DVec2) -> bool, random: &mut Random) -> Cap {
        let Some(triangulation) = self.triangulation() else {
            return Cap::default();
        };
        let corners = triangulation
            .faces()
            .map(|f| indices(triangulation.mesh().face_vertices(f)));
        let centre = |&[a, b, c]: &[u32; 3]| {
            let [a, b, c] = [a, b, c].map(|v| self.points[v as usize]);
            (a + b + c) / 3.0
        };
        let wanted = corners.filter(|corners| is_wanted(centre(corners)));
        self.cap(&triangulation, wanted.collect(), random)
    }

    fn triangulation(&self) -> Option<Constrained2> {
        let segments: Vec<[VertexId; 2]> = self
            .segments
            .iter()
            .map(|ends| ends.map(VertexId::new))
            .collect();
        let options = BuildOptions::default();
        Constrained2::build(
            &self.points,
            &segments,
            Crossings::Refuse,
            options,
            &mut silent,
        )
        .ok()
    }

    fn cap(
        &self,
        triangulation: &Constrained2,
        triangles: Vec<[u32; 3]>,
        random: &mut Random,
    ) -> Cap {
        let mesh = triangulation.mesh();
        let is_fixed = triangulation
            .constrained_edges()
            .map(|h| edge([mesh.origin(h), mesh.target(h)].map(|v| v.index() as u32)))
            .collect();
        let mut flipping = Flipping::new(&self.points, triangles, is_fixed);
        flipping.spoil(random);
        Cap {
            points: self.points.clone(),
            triangles: flipping.triangles,
        }
    }
}

impl Cap {
    /// The edges with one triangle, with that on the left, in the order of the triangles.
    #[must_use]
    pub fn rim(&self) -> Vec<[DVec2; 2]> {
        let sides = |&[a, b, c]: &[u32; 3]| [[a, b], [b, c], [c, a]];
        let all: FxHashSet<[u32; 2]> = self.triangles.iter().flat_map(sides).collect();
        let alone = self.triangles.iter().flat_map(sides);
        let alone = alone.filter(|&[from, to]| !all.contains(&[to, from]));
        alone
            .map(|ends| ends.map(|v| self.points[v as usize]))
            .collect()
    }

    /// The corners of each triangle as places.
    pub fn places(&self) -> impl Iterator<Item = [DVec2; 3]> + '_ {
        self.triangles
            .iter()
            .map(|corners| corners.map(|v| self.points[v as usize]))
    }
}

fn indices(corners: [VertexId; 3]) -> [u32; 3] {
    corners.map(|v| v.index() as u32)
}

fn edge([a, b]: [u32; 2]) -> [u32; 2] {
    [a.min(b), a.max(b)]
}

/// A triangulation whose edges are flipped.
struct Flipping<'p> {
    points: &'p [DVec2],
    triangles: Vec<[u32; 3]>,
    /// Which triangle has an edge, from end to end counterclockwise round it.
    of: FxHashMap<[u32; 2], usize>,
    is_fixed: FxHashSet<[u32; 2]>,
}

impl<'p> Flipping<'p> {
    fn new(points: &'p [DVec2], triangles: Vec<[u32; 3]>, is_fixed: FxHashSet<[u32; 2]>) -> Self {
        let mut flipping = Self {
            points,
            triangles: Vec::with_capacity(triangles.len()),
            of: FxHashMap::default(),
            is_fixed,
        };
        for (index, corners) in triangles.into_iter().enumerate() {
            flipping.triangles.push(corners);
            flipping.enter(index);
        }
        flipping
    }

    fn enter(&mut self, triangle: usize) {
        let [a, b, c] = self.triangles[triangle];
        for side in [[a, b], [b, c], [c, a]] {
            self.of.insert(side, triangle);
        }
    }

    /// Tries sixteen flips for each triangle, at random places.
    fn spoil(&mut self, random: &mut Random) {
        /// How often a flip is made that does not make the worse triangle worse.
        const ANYWAY: f64 = 0.2;
        if self.triangles.is_empty() {
            return;
        }
        for _ in 0..16 * self.triangles.len() {
            let triangle = random.random_range(0..self.triangles.len());
            let side = random.random_range(0..3);
            self.flip(triangle, side, random.random_bool(ANYWAY));
        }
    }

    fn flip(&mut self, first: usize, side: usize, is_forced: bool) {
        let corners = self.triangles[first];
        let [a, b, c] = [0, 1, 2].map(|next| corners[(side + next) % 3]);
        if self.is_fixed.contains(&edge([a, b])) {
            return;
        }
        let Some(&second) = self.of.get(&[b, a]) else {
            return;
        };
        let Some(d) = self.triangles[second]
            .into_iter()
            .find(|&v| v != a && v != b)
        else {
            return;
        };
        let now = [[a, b, c], [b, a, d]];
        let then = [[c, a, d], [d, b, c]];
        if then.iter().all(|&corners| self.is_positive(corners))
            && (is_forced || self.worse_of(then) < self.worse_of(now))
        {
            self.of.remove(&[a, b]);
            self.of.remove(&[b, a]);
            for (triangle, corners) in [first, second].into_iter().zip(then) {
                self.triangles[triangle] = corners;
                self.enter(triangle);
            }
        }
    }

    fn is_positive(&self, corners: [u32; 3]) -> bool {
        let [a, b, c] = corners.map(|v| self.points[v as usize]);
        orient2d(a, b, c) == Sign::Positive
    }

    /// Height over base, of the worse one.
    fn worse_of(&self, triangles: [[u32; 3]; 2]) -> f64 {
        let shape = |corners: [u32; 3]| {
            let [a, b, c] = corners.map(|v| self.points[v as usize]);
            let base = a
                .distance_squared(b)
                .max(b.distance_squared(c))
                .max(c.distance_squared(a));
            (b - a).perp_dot(c - a) / base
        };
        let [first, second] = triangles.map(shape);
        first.min(second)
    }
}

#[cfg(test)]
mod tests {
    use super::super::random;
    use super::*;
    use glam::dvec2;

    fn square(low: f64, high: f64) -> [DVec2; 4] {
        [
            dvec2(low, low),
            dvec2(high, low),
            dvec2(high, high),
            dvec2(low, high),
        ]
    }

    fn area(cap: &Cap) -> f64 {
        cap.places()
            .map(|[a, b, c]| (b - a).perp_dot(c - a) / 2.0)
            .sum()
    }

    #[test]
    fn a_square_with_a_hole_keeps_its_area_its_rim_and_its_vertices() {
        for seed in 0..20 {
            let mut drawing = Drawing::default();
            drawing.ring(&square(0.0, 10.0));
            drawing.ring(&square(4.0, 7.0));
            let cap = drawing.inside(&mut random(seed));
            assert_eq!(cap.triangles.len(), 8);
            assert_eq!(cap.rim().len(), 8);
            assert!((area(&cap) - 91.0).abs() < 1e-9);
        }
    }

    #[test]
    fn flipping_makes_needles() {
        let mut drawing = Drawing::default();
        let side = (0..=20).map(f64::from);
        let corners: Vec<DVec2> = side
            .clone()
            .map(|x| dvec2(x, 0.0))
            .chain(side.rev().map(|x| dvec2(x, 1.0)))
            .collect();
        drawing.ring(&corners);
        let cap = drawing.inside(&mut random(1));
        assert!((area(&cap) - 20.0).abs() < 1e-9);
        let longest = cap
            .places()
            .map(|[a, b, c]| a.distance(b).max(b.distance(c)));
        // A Delaunay triangulation has none beyond 1.5.
        assert!(longest.fold(0.0, f64::max) > 4.0);
    }
}
