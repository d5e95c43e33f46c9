//! Points and triangles one by one: what is wrong with each of them by itself, and which of them are twice.

use super::defect::{
    Coincident, NoArea, NoSuchCorner, Placed, RepeatedCorner, RepeatedTriangle, UnusedPoint,
};
use super::defects::DomainDefects;
use super::options::Domain3Options;
use crate::ids::VertexId;
use crate::progress::{Cancelled, Meter};
use crate::tet::places::Places;
use crate::tet::projection::View;
use crate::tet::surface::sorted;
use geo_predicates::check_point3;
use glam::DVec3;

/// Points and triangles as given, and what is known of each.
pub(super) struct Soup<'a> {
    pub(super) points: &'a [DVec3],
    pub(super) triangles: &'a [[VertexId; 3]],
    pub(super) places: Places,
    /// By point, whether it is a corner.
    pub(super) used: Vec<bool>,
    /// By point, whether its coordinates are accepted.
    accepted: Vec<bool>,
    /// By triangle, the first points where its corners are, and the ghost for a corner that is no point.
    pub(super) joined: Vec<[VertexId; 3]>,
    /// By triangle, whether it counts as one at its edges: it has no corner twice, and is not itself there twice.
    pub(super) counts: Vec<bool>,
    /// By triangle, whether it counts and is a triangle in space: it has area.
    pub(super) solid: Vec<bool>,
}

impl<'a> Soup<'a> {
    /// Looks at points and triangles one by one and lists what is wrong. Takes n log n time.
    pub(super) fn examine(
        points: &'a [DVec3],
        triangles: &'a [[VertexId; 3]],
        options: Domain3Options,
        defects: &mut DomainDefects,
        meter: &mut Meter<'_>,
    ) -> Result<Self, Cancelled> {
        let used = used(points.len(), triangles);
        let accepted = accepted(points, defects);
        let compared = |index: usize| accepted[index] && (used[index] || !options.drop_unused);
        let mut soup = Self {
            points,
            triangles,
            places: Places::of(points, compared),
            used,
            accepted,
            joined: Vec::with_capacity(triangles.len()),
            counts: Vec::with_capacity(triangles.len()),
            solid: Vec::with_capacity(triangles.len()),
        };
        soup.judge_points(options, defects);
        for triangle in 0..triangles.len() {
            meter.advance()?;
            soup.judge_triangle(triangle, defects);
        }
        soup.judge_repetition(defects);
        Ok(soup)
    }

    /// A vertex with its place, for a defect. It must be a point.
    pub(super) fn placed(&self, vertex: VertexId) -> Placed {
        let place = self.points[vertex.index()];
        Placed { vertex, place }
    }

    fn exists(&self, v: VertexId) -> bool {
        v.index() < self.points.len()
    }

    /// Points where others are, and points that are no corners, unless this is repaired.
    fn judge_points(&self, options: Domain3Options, defects: &mut DomainDefects) {
        let mut needed = self.used.clone();
        if options.weld {
            // What is left of points at one place is a corner when one of them is.
            for [first, second] in self.places.doubles() {
                needed[first.index()] |= needed[second.index()];
                needed[second.index()] = true;
            }
        } else {
            let doubles = self.places.doubles();
            let defect = |[first, second]: [VertexId; 2]| Coincident {
                first,
                second: self.placed(second),
            };
            defects.coincident = doubles.map(defect).collect();
        }
        if !options.drop_unused {
            let all = (0..self.points.len()).map(VertexId::new);
            let unused = all.filter(|v| !needed[v.index()]);
            let defect = |v| UnusedPoint {
                point: self.placed(v),
            };
            defects.unused = unused.map(defect).collect();
        }
    }

    /// Corners that are not there, corners that are there twice, and corners on one line.
    fn judge_triangle(&mut self, triangle: usize, defects: &mut DomainDefects) {
        let given = self.triangles[triangle];
        for (corner, vertex) in given.into_iter().enumerate() {
            if !self.exists(vertex) {
                defects.no_such_corners.push(NoSuchCorner {
                    triangle,
                    corner,
                    vertex,
                    points: self.points.len(),
                });
            }
        }
        let twice = repeated(given).filter(|&v| self.exists(v));
        if let Some(vertex) = twice {
            let corner = self.placed(vertex);
            defects
                .repeated_corners
                .push(RepeatedCorner { triangle, corner });
        }
        let joined = given.map(|v| self.places.first(v));
        let counts = twice.is_none() && repeated(joined).is_none_or(VertexId::is_ghost);
        let known = given
            .iter()
            .all(|&v| self.exists(v) && self.accepted[v.index()]);
        let area = known && View::of_area(given.map(|v| self.points[v.index()])).is_some();
        if known && !area && twice.is_none() {
            let corners = given.map(|v| self.placed(v));
            defects.no_area.push(NoArea { triangle, corners });
        }
        self.joined.push(joined);
        self.counts.push(counts);
        self.solid.push(counts && area);
    }

    /// Triangles with the corners of an earlier one, which do not count.
    fn judge_repetition(&mut self, defects: &mut DomainDefects) {
        let whole = |&triangle: &usize| {
            self.counts[triangle] && !self.joined[triangle].contains(&VertexId::GHOST)
        };
        let whole = (0..self.triangles.len()).filter(whole);
        let mut named: Vec<_> = whole.map(|i| (sorted(self.joined[i]), i)).collect();
        named.sort_unstable();
        for same in named.chunk_by(|(corners, _), (others, _)| corners == others) {
            let (_, first) = same[0];
            for &(_, second) in &same[1..] {
                self.counts[second] = false;
                self.solid[second] = false;
                let corners = self.triangles[first].map(|v| self.placed(v));
                defects.repeated_triangles.push(RepeatedTriangle {
                    first,
                    second,
                    corners,
                });
            }
        }
        defects
            .repeated_triangles
            .sort_unstable_by_key(|of| of.second);
    }
}

/// By point, whether its coordinates are accepted.
fn accepted(points: &[DVec3], defects: &mut DomainDefects) -> Vec<bool> {
    let judge = |(index, &point)| match check_point3(index, point) {
        Ok(()) => true,
        Err(error) => {
            defects.coordinates.push(error);
            false
        }
    };
    points.iter().enumerate().map(judge).collect()
}

/// By point, whether it is a corner.
fn used(points: usize, triangles: &[[VertexId; 3]]) -> Vec<bool> {
    let mut used = vec![false; points];
    for v in triangles.as_flattened() {
        if let Some(used) = used.get_mut(v.index()) {
            *used = true;
        }
    }
    used
}

/// The vertex that is at more than one corner.
fn repeated([a, b, c]: [VertexId; 3]) -> Option<VertexId> {
    if a == b || a == c {
        Some(a)
    } else if b == c {
        Some(b)
    } else {
        None
    }
}
