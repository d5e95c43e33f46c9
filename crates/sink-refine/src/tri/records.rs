//! What is remembered of every triangle: its ratio r/l (§4.3), where the flow leaves it (§3.3), and when it was made.

use super::flow::exit;
use crate::stamp::Stamp;
use delaunay_core::measure::triangle::radius_edge_ratio;
use delaunay_core::{FaceId, HalfEdgeId, Subcomplex2};
use glam::DVec2;

/// Records of the triangles of a subcomplex.
#[derive(Clone, Debug)]
pub(crate) struct Records {
    bound: f64,
    /// By triangle.
    entries: Vec<Entry>,
    /// That of the last change.
    last: Stamp,
}

#[derive(Clone, Copy, Debug)]
struct Entry {
    squared_ratio: f64,
    stamp: Stamp,
    squared_shortest: f64,
    exit: Option<HalfEdgeId>,
}

impl Entry {
    const GONE: Self = Self {
        squared_ratio: 0.0,
        stamp: Stamp::NONE,
        squared_shortest: 0.0,
        exit: None,
    };
}

impl Records {
    /// The triangles of `region`, of low quality when r/l exceeds `bound`.
    pub(crate) fn of(region: &Subcomplex2, bound: f64) -> Self {
        let mut records = Self {
            bound,
            entries: Vec::new(),
            last: Stamp::NONE,
        };
        records.examine(region, region.faces());
        records
    }

    /// Measures triangles that are new.
    pub(crate) fn examine(
        &mut self,
        region: &Subcomplex2,
        faces: impl IntoIterator<Item = FaceId>,
    ) {
        let stamp = self.last.advance();
        self.entries.resize(region.mesh().face_count(), Entry::GONE);
        for f in faces {
            let corners = region.triangle(f);
            self.entries[f.index()] = Entry {
                squared_ratio: squared_ratio(corners),
                stamp,
                squared_shortest: squared_edges(corners)
                    .into_iter()
                    .fold(f64::INFINITY, f64::min),
                exit: exit(region, f),
            };
        }
    }

    /// Forgets triangles that are gone.
    pub(crate) fn forget(&mut self, faces: impl IntoIterator<Item = FaceId>) {
        for f in faces {
            self.entries[f.index()] = Entry::GONE;
        }
    }

    /// One more than the greatest id of a triangle.
    pub(crate) fn slots(&self) -> usize {
        self.entries.len()
    }

    /// Whether there is a triangle of this id.
    pub(crate) fn is_there(&self, f: FaceId) -> bool {
        self.entry(f).stamp != Stamp::NONE
    }

    pub(crate) fn stamp(&self, f: FaceId) -> Stamp {
        self.entry(f).stamp
    }

    /// The half-edge through which the flow leaves a triangle.
    #[inline]
    pub(crate) fn exit(&self, f: FaceId) -> Option<HalfEdgeId> {
        self.entry(f).exit
    }

    /// The square of the length of the shortest edge.
    pub(crate) fn squared_shortest(&self, f: FaceId) -> f64 {
        self.entry(f).squared_shortest
    }

    fn entry(&self, f: FaceId) -> &Entry {
        self.entries.get(f.index()).unwrap_or(&Entry::GONE)
    }

    pub(crate) fn squared_ratio(&self, f: FaceId) -> f64 {
        self.entry(f).squared_ratio
    }

    pub(crate) fn ratio(&self, f: FaceId) -> f64 {
        self.squared_ratio(f).sqrt()
    }

    pub(crate) fn is_low(&self, f: FaceId) -> bool {
        self.is_low_ratio(self.squared_ratio(f))
    }

    /// Whether a squared ratio is one of low quality.
    pub(crate) fn is_low_ratio(&self, squared_ratio: f64) -> bool {
        squared_ratio > self.bound * self.bound
    }

    /// By how much a squared ratio exceeds that of the bound, as a logarithm.
    pub(crate) fn excess(&self, squared_ratio: f64) -> f64 {
        (squared_ratio / (self.bound * self.bound)).ln()
    }

    /// The bound on r/l.
    pub(crate) fn bound(&self) -> f64 {
        self.bound
    }
}

/// The square of r/l of a triangle.
///
/// r = abc / 2d with the lengths a, b, c of the edges and the determinant d of two of them.
#[inline]
pub(crate) fn squared_ratio(corners: [DVec2; 3]) -> f64 {
    let [a, b, c] = corners;
    let determinant = (b - a).perp_dot(c - a);
    let mut edges = squared_edges(corners);
    edges.sort_unstable_by(f64::total_cmp);
    // The shortest edge is in the product and below the line.
    let [_, middle, longest] = edges;
    let divisor = 4.0 * determinant * determinant;
    let squared = middle * longest / divisor;
    // Beyond these sizes doubles run out.
    if divisor > 1e-250 && squared < 1e250 {
        squared
    } else {
        radius_edge_ratio(corners).powi(2)
    }
}

fn squared_edges([a, b, c]: [DVec2; 3]) -> [f64; 3] {
    [
        a.distance_squared(b),
        b.distance_squared(c),
        c.distance_squared(a),
    ]
}
