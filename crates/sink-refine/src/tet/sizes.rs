//! Which tetrahedra are too large, see [`Sizing`].

use crate::error::RefineError;
use crate::region_sizes::RegionSizes;
use crate::sizing::{Sizing, UnusableSize};
use delaunay_core::geo_predicates::{Sign, check_point3, orient3d};
use delaunay_core::measure::tetrahedron::circumradius;
use delaunay_core::{Subcomplex3, TetId};
use glam::DVec3;

/// The circumradius of the regular tetrahedron with edges of length 1: √6/4.
const RADIUS: f64 = 0.612_372_435_695_794_5;

/// The sizes asked for.
#[derive(Clone, Debug)]
pub(crate) struct Sizes<'a> {
    sizing: Sizing<'a, DVec3>,
    regions: RegionSizes,
}

impl<'a> Sizes<'a> {
    /// Finds the regions. Takes time linear in the number of tetrahedra, for each of the regions.
    ///
    /// # Errors
    /// [`RefineError::RegionSize`], [`RefineError::RegionOutside`].
    pub(crate) fn of(solid: &Subcomplex3, sizing: &Sizing<'a, DVec3>) -> Result<Self, RefineError> {
        let at = |seed| tet_at(solid, seed).map(TetId::index);
        let neighbors = |index| neighbors(solid, TetId::new(index));
        let regions = RegionSizes::find(sizing.regions, at, neighbors)?;
        let sizing = *sizing;
        Ok(Self { sizing, regions })
    }

    /// The size of the region that tetrahedra are in, all of them in one; or were in when they are gone.
    pub(crate) fn of_region(&self, tets: &[TetId]) -> f64 {
        let first = tets.first();
        first.map_or(f64::INFINITY, |t| self.regions.of(t.index()))
    }

    /// Takes note that tetrahedra have come in the place of others.
    pub(crate) fn inherit(&mut self, heirs: &[TetId], from: &[TetId]) {
        let size = self.of_region(from);
        for t in heirs {
            self.regions.set(t.index(), size);
        }
    }

    /// The square of the circumradius over the largest allowed, of a tetrahedron in a region of size `in_region`.
    ///
    /// 0 where no size is asked for; not a number where the field gives no size.
    pub(crate) fn squared_size(&self, corners: [DVec3; 4], in_region: f64) -> f64 {
        match self.largest_radius(corners, in_region) {
            f64::INFINITY => 0.0,
            largest if largest.is_nan() => largest,
            largest => (circumradius(corners) / largest).powi(2).min(f64::MAX),
        }
    }

    /// The largest circumradius that is allowed for a tetrahedron in a region of size `in_region`: infinite where no size is
    /// asked for; not a number where the field gives no size.
    pub(crate) fn largest_radius(&self, corners: [DVec3; 4], in_region: f64) -> f64 {
        let here = self.sizing.field;
        match here.map_or(f64::INFINITY, |field| field(centroid(corners))) {
            size if size > 0.0 => RADIUS * size.min(in_region),
            _ => f64::NAN,
        }
    }

    /// What the field has answered for a tetrahedron for which it gives no size.
    pub(crate) fn unusable(&self, corners: [DVec3; 4]) -> UnusableSize {
        let place = centroid(corners);
        UnusableSize {
            place,
            size: self.sizing.field.map_or(f64::NAN, |field| field(place)),
        }
    }
}

fn centroid([a, b, c, d]: [DVec3; 4]) -> DVec3 {
    (a + b + c + d) / 4.0
}

/// The first tetrahedron that contains a point, on its surface included.
fn tet_at(solid: &Subcomplex3, place: DVec3) -> Option<TetId> {
    check_point3(0, place).ok()?;
    solid.tets().find(|&t| {
        let facets = t.facets().into_iter().map(|f| solid.triangle(f));
        let mut sides = facets.map(|[a, b, c]| orient3d(a, b, c, place));
        // Facets turn counterclockwise as seen from outside.
        sides.all(|side| side != Sign::Positive)
    })
}

/// The tetrahedra across the facets of a tetrahedron that are no boundary, by index.
fn neighbors(solid: &Subcomplex3, t: TetId) -> impl Iterator<Item = usize> {
    let inner = t.facets().into_iter();
    let inner = inner.filter(|&f| !solid.is_boundary(f));
    inner.map(|f| solid.mesh().twin(f).tet().index())
}
