//! Which triangles are too large, see [`Sizing`].

use crate::error::RefineError;
use crate::region_sizes::RegionSizes;
use crate::sizing::{Sizing, UnusableSize};
use delaunay_core::geo_predicates::{Sign, check_point2, orient2d};
use delaunay_core::measure::triangle::circumradius;
use delaunay_core::{FaceId, Subcomplex2};
use glam::DVec2;

/// The circumradius of the regular triangle with edges of length 1: 1/√3.
const RADIUS: f64 = 0.577_350_269_189_625_8;

/// The sizes asked for.
#[derive(Clone, Debug)]
pub(crate) struct Sizes<'a> {
    sizing: Sizing<'a, DVec2>,
    regions: RegionSizes,
}

impl<'a> Sizes<'a> {
    /// Finds the regions. Takes time linear in the number of triangles, for each of the regions.
    ///
    /// # Errors
    /// [`RefineError::RegionSize`], [`RefineError::RegionOutside`].
    pub(crate) fn of(
        region: &Subcomplex2,
        sizing: &Sizing<'a, DVec2>,
    ) -> Result<Self, RefineError> {
        let at = |seed| face_at(region, seed).map(FaceId::index);
        let neighbors = |index| neighbors(region, FaceId::new(index));
        let regions = RegionSizes::find(sizing.regions, at, neighbors)?;
        let sizing = *sizing;
        Ok(Self { sizing, regions })
    }

    /// The size of the region that triangles are in, all of them in one; or were in when they are gone.
    pub(crate) fn of_region(&self, faces: &[FaceId]) -> f64 {
        let first = faces.first();
        first.map_or(f64::INFINITY, |f| self.regions.of(f.index()))
    }

    /// Takes note that triangles have come in the place of others.
    pub(crate) fn inherit(&mut self, heirs: &[FaceId], from: &[FaceId]) {
        let size = self.of_region(from);
        for f in heirs {
            self.regions.set(f.index(), size);
        }
    }

    /// Takes note of faces that have other ids, one after the other.
    pub(crate) fn rename(&mut self, moved: &[(FaceId, FaceId)]) {
        for &(old, new) in moved {
            self.regions.set(new.index(), self.regions.of(old.index()));
        }
    }

    /// The square of the circumradius over the largest allowed, of a triangle in a region of size `in_region`.
    ///
    /// 0 where no size is asked for; not a number where the field gives no size.
    pub(crate) fn squared_size(&self, corners: [DVec2; 3], in_region: f64) -> f64 {
        match self.largest_radius(corners, in_region) {
            f64::INFINITY => 0.0,
            largest if largest.is_nan() => largest,
            largest => (circumradius(corners) / largest).powi(2).min(f64::MAX),
        }
    }

    /// The largest circumradius that is allowed for a triangle in a region of size `in_region`: infinite where no size is asked
    /// for; not a number where the field gives no size.
    pub(crate) fn largest_radius(&self, corners: [DVec2; 3], in_region: f64) -> f64 {
        let here = self.sizing.field;
        match here.map_or(f64::INFINITY, |field| field(centroid(corners))) {
            size if size > 0.0 => RADIUS * size.min(in_region),
            _ => f64::NAN,
        }
    }

    /// What the field has answered for a triangle for which it gives no size.
    pub(crate) fn unusable(&self, corners: [DVec2; 3]) -> UnusableSize {
        let place = centroid(corners);
        UnusableSize {
            place: place.extend(0.0),
            size: self.sizing.field.map_or(f64::NAN, |field| field(place)),
        }
    }
}

fn centroid([a, b, c]: [DVec2; 3]) -> DVec2 {
    (a + b + c) / 3.0
}

/// The first triangle that contains a point, on its border included.
fn face_at(region: &Subcomplex2, place: DVec2) -> Option<FaceId> {
    check_point2(0, place).ok()?;
    region.faces().find(|&f| {
        let [a, b, c] = region.triangle(f);
        let edges = [[a, b], [b, c], [c, a]].into_iter();
        edges
            .map(|[a, b]| orient2d(a, b, place))
            .all(|side| side != Sign::Negative)
    })
}

/// The triangles across the edges of a triangle that are no boundary, by index.
fn neighbors(region: &Subcomplex2, f: FaceId) -> impl Iterator<Item = usize> {
    let inner = f.half_edges().into_iter();
    let inner = inner.filter(|&h| !region.is_boundary(h));
    inner.map(|h| region.mesh().twin(h).face().index())
}
