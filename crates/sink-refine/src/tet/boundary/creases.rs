//! Creases: edges of the boundary at which it turns by more than an angle. Between them it is smooth.

use crate::boundary::{TURN_TOLERANCE, is_acute, shell};
use delaunay_core::{FacetId, Subcomplex3, VertexId};
use glam::DVec3;
use rustc_hash::{FxHashMap, FxHashSet};

/// The creases of a boundary, as a graph on its vertices.
#[derive(Clone, Debug)]
pub(super) struct Creases {
    edges: FxHashSet<[VertexId; 2]>,
    /// By vertex: the other ends of its creases.
    ends: FxHashMap<VertexId, Vec<VertexId>>,
    /// The largest angle of a smooth turn, in radians.
    smooth: f64,
    is_flat: bool,
}

impl Creases {
    /// The edges at which the boundary of `solid` turns by more than `degrees`, and those with more than two boundary facets.
    pub(super) fn of(solid: &Subcomplex3, degrees: f64) -> Self {
        let smooth = degrees.to_radians() + TURN_TOLERANCE;
        let mut creases = Self {
            edges: FxHashSet::default(),
            ends: FxHashMap::default(),
            smooth,
            is_flat: degrees == 0.0,
        };
        let mut facets_on: FxHashMap<[VertexId; 2], u32> = FxHashMap::default();
        for f in solid.boundary() {
            for (edge, beyond) in solid.across_edges(f) {
                let facets = facets_on.entry(in_order(edge)).or_default();
                *facets += 1;
                if *facets > 2 || turn(solid, f, beyond) > smooth {
                    creases.add(edge);
                }
            }
        }
        creases
    }

    pub(super) fn contain(&self, edge: [VertexId; 2]) -> bool {
        self.edges.contains(&in_order(edge))
    }

    /// Whether what is between creases is flat.
    pub(super) fn are_of_a_flat_surface(&self) -> bool {
        self.is_flat
    }

    /// The edge is a crease from now on, if it was none.
    fn add(&mut self, [a, b]: [VertexId; 2]) {
        if self.edges.insert(in_order([a, b])) {
            self.ends.entry(a).or_default().push(b);
            self.ends.entry(b).or_default().push(a);
        }
    }

    /// The crease `ab` has been divided at `middle`.
    pub(super) fn divide(&mut self, [a, b]: [VertexId; 2], middle: VertexId) {
        self.edges.remove(&in_order([a, b]));
        for [from, to] in [[a, b], [b, a]] {
            if let Some(ends) = self.ends.get_mut(&from) {
                ends.retain(|end| *end != to);
            }
        }
        self.add([a, middle]);
        self.add([middle, b]);
    }

    /// The place that divides a crease.
    ///
    /// In the middle; but from a vertex where another crease is near, at a power of two, so that both are divided at the same
    /// distances and do not make each other be divided again (Ruppert 1995, concentric shells). Where creases go on smoothly
    /// not on the chord but on the cubic Hermite curve between its ends, with speed |ab| along the tangents there.
    pub(super) fn middle(&self, solid: &Subcomplex3, [a, b]: [VertexId; 2]) -> DVec3 {
        let [p, q] = [a, b].map(|v| solid.point(v));
        let chord = q - p;
        match [self.is_sharp(solid, [a, b]), self.is_sharp(solid, [b, a])] {
            [true, false] => return p + chord * shell(chord.length()),
            [false, true] => return q - chord * shell(chord.length()),
            _ => {}
        }
        if self.is_flat {
            return p.midpoint(q);
        }
        let leaving = self
            .tangent(solid, [b, a])
            .map_or(chord, |back| -back * chord.length());
        let arriving = self
            .tangent(solid, [a, b])
            .map_or(chord, |on| on * chord.length());
        p.midpoint(q) + (leaving - arriving) / 8.0
    }

    /// Whether another crease at `a` makes an acute angle with that to `b`.
    fn is_sharp(&self, solid: &Subcomplex3, [a, b]: [VertexId; 2]) -> bool {
        let ends = self.ends.get(&a).into_iter().flatten();
        let along = |end: VertexId| solid.point(end) - solid.point(a);
        let mut others = ends.filter(|&&end| end != b);
        others.any(|&end| is_acute(angle(along(end), along(b))))
    }

    /// The unit tangent at `b` of the curve that the crease from `a` to `b` is part of: that of the circle through three vertices;
    /// `None` when it does not go on smoothly.
    fn tangent(&self, solid: &Subcomplex3, [a, b]: [VertexId; 2]) -> Option<DVec3> {
        let next = match self.ends.get(&b)?[..] {
            [u, v] if u == a => v,
            [u, v] if v == a => u,
            _ => return None,
        };
        let [p, q, r] = [a, b, next].map(|v| solid.point(v));
        let [before, after] = [q - p, r - q];
        let is_smooth = angle(before, after) <= self.smooth;
        // Chords turn from the tangent in proportion to their lengths.
        let mean = before.normalize_or_zero() * after.length()
            + after.normalize_or_zero() * before.length();
        is_smooth.then(|| mean.normalize_or_zero())
    }
}

/// The angle by which the boundary turns from one facet to the next, in radians.
fn turn(solid: &Subcomplex3, f: FacetId, g: FacetId) -> f64 {
    let [n, m] = [f, g].map(|facet| unit_normal(solid.triangle(facet)));
    n.cross(m).length().atan2(n.dot(m))
}

/// The angle between two vectors in radians.
pub(super) fn angle(u: DVec3, v: DVec3) -> f64 {
    let [u, v] = [u, v].map(DVec3::normalize_or_zero);
    u.cross(v).length().atan2(u.dot(v))
}

/// Outward; zero when the triangle has no area.
pub(super) fn unit_normal([a, b, c]: [DVec3; 3]) -> DVec3 {
    // Scaled, lest products leave the range of doubles.
    let largest = (b - a).abs().max((c - a).abs()).max_element();
    ((b - a) / largest)
        .cross((c - a) / largest)
        .normalize_or_zero()
}

fn in_order([a, b]: [VertexId; 2]) -> [VertexId; 2] {
    [a.min(b), a.max(b)]
}
