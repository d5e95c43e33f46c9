//! What is remembered of every triangle: its ratio r/l (§4.3) and size, where the flow leaves it (§3.3), and when it was made.

use super::flow::exit;
use super::sizes::Sizes;
use crate::quality::Quality;
use crate::stamp::Stamp;
use crate::stop::Stop;
use delaunay_core::measure::triangle::radius_edge_ratio;
use delaunay_core::{FaceId, HalfEdgeId, Subcomplex2};
use glam::DVec2;

/// Records of the triangles of a subcomplex.
#[derive(Clone, Debug)]
pub(crate) struct Records<'a> {
    bound: f64,
    sizes: Sizes<'a>,
    /// By triangle.
    entries: Vec<Entry>,
    /// That of the last change.
    last: Stamp,
    /// The first triangle found for which the sizing field gives no size, by its corners.
    unusable: Option<[DVec2; 3]>,
}

#[derive(Clone, Copy, Debug)]
struct Entry {
    quality: Quality,
    stamp: Stamp,
    squared_shortest: f64,
    exit: Option<HalfEdgeId>,
}

impl Entry {
    const GONE: Self = Self {
        quality: Quality::NONE,
        stamp: Stamp::NONE,
        squared_shortest: 0.0,
        exit: None,
    };
}

impl<'a> Records<'a> {
    /// The triangles of `region`, of low quality when r/l exceeds `bound` or they are too large.
    pub(crate) fn of(region: &Subcomplex2, bound: f64, sizes: Sizes<'a>) -> Self {
        let mut records = Self {
            bound,
            sizes,
            entries: Vec::new(),
            last: Stamp::NONE,
            unusable: None,
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
            let quality = self.measure(corners, &[f]);
            if quality.squared_size.is_nan() && self.unusable.is_none() {
                self.unusable = Some(corners);
            }
            self.entries[f.index()] = Entry {
                quality,
                stamp,
                squared_shortest: squared_edges(corners)
                    .into_iter()
                    .fold(f64::INFINITY, f64::min),
                exit: exit(region, f),
            };
        }
    }

    /// The quality of a triangle, there or not, in the region of others.
    pub(crate) fn measure(&self, corners: [DVec2; 3], home: &[FaceId]) -> Quality {
        let in_region = self.sizes.of_region(home);
        Quality {
            squared_ratio: squared_ratio(corners),
            squared_size: self.sizes.squared_size(corners, in_region),
        }
    }

    /// Whether the sizing field has given sizes for all triangles.
    ///
    /// # Errors
    /// [`Stop::UnusableSize`].
    pub(crate) fn check_sizes(&self) -> Result<(), Stop> {
        let found = self.unusable.map(|corners| self.sizes.unusable(corners));
        found.map_or(Ok(()), |unusable| Err(Stop::UnusableSize(unusable)))
    }

    /// Takes note that triangles have come in the place of others.
    pub(crate) fn inherit(&mut self, heirs: &[FaceId], from: &[FaceId]) {
        self.sizes.inherit(heirs, from);
    }

    /// Takes note of faces that have other ids, one after the other.
    pub(crate) fn rename(&mut self, moved: &[(FaceId, FaceId)]) {
        self.sizes.rename(moved);
    }

    /// The largest circumradius that a triangle may have for its size.
    pub(crate) fn largest_radius(&self, region: &Subcomplex2, f: FaceId) -> f64 {
        let in_region = self.sizes.of_region(&[f]);
        self.sizes.largest_radius(region.triangle(f), in_region)
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

    pub(crate) fn quality(&self, f: FaceId) -> Quality {
        self.entry(f).quality
    }

    /// How bad a triangle is, see [`Quality::badness`].
    pub(crate) fn badness(&self, f: FaceId) -> f64 {
        self.quality(f).badness(self.bound)
    }

    pub(crate) fn is_low(&self, f: FaceId) -> bool {
        self.quality(f).is_low(self.bound)
    }

    /// Whether the ratio of a triangle makes it one of low quality.
    pub(crate) fn is_skinny(&self, f: FaceId) -> bool {
        self.is_low_ratio(self.quality(f).squared_ratio)
    }

    /// Whether a squared ratio is one of low quality.
    pub(crate) fn is_low_ratio(&self, squared_ratio: f64) -> bool {
        squared_ratio > self.bound * self.bound
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
fn squared_ratio(corners: [DVec2; 3]) -> f64 {
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
