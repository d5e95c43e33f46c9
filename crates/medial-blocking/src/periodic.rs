//! The samples to triangulate, with the images that make the triangulation that of the infinite
//! tiling (§5).
//!
//! The paper tiles the circles three by three and keeps the middle. A fixed three by three is more
//! than many circles need and less than few circles need, so here the rectangle gets a *halo*: the
//! images nearer to it than the largest empty circle is wide. Departs from Guoy & Erickson §5 in
//! this only. Samples and periods are snapped to a lattice on which translations are exact and ties
//! among cocircular samples are broken by a key that moves with the points, so every image of a
//! triangle is the same triangle.

use delaunay_core::{BuildError, Delaunay2, FaceId};
use glam::DVec2;

use crate::Report;
use crate::corner::Corner;
use crate::domain::Domain;
use crate::error::BlockingError;
use crate::sample::{MAX_SAMPLES, SampleId, Samples};
use crate::wall::Shift;

/// The triangulation of the samples and, in a periodic domain, of their images in the halo.
pub(crate) struct Tiling {
    delaunay: Delaunay2,
    corners: Vec<Corner>,
}

impl Tiling {
    /// Triangulates the samples; in a periodic domain widens the halo until every circle that
    /// counts fits.
    ///
    /// The triangulation of an accepted domain's samples fails only if samples coincide: then the
    /// domain is unresolved.
    pub(crate) fn of(
        domain: &Domain,
        samples: &Samples,
        report: &mut Report<'_>,
    ) -> Result<Self, BlockingError> {
        let Some(period) = domain.period() else {
            return Self::with_halo(domain, samples, 0.0, report);
        };
        // No circle wider than the diagonal is empty of a point and all its images.
        let widest = 1.01 * period.length();
        let mut halo =
            (2.5 * (period.x * period.y / domain.hole_count() as f64).sqrt()).min(widest);
        loop {
            let tiling = Self::with_halo(domain, samples, halo, report)?;
            let needed = tiling.widest_circle_at_home(widest);
            if needed <= halo || halo >= widest {
                return Ok(tiling);
            }
            halo = (1.01 * needed).max(1.5 * halo).min(widest);
        }
    }

    fn with_halo(
        domain: &Domain,
        samples: &Samples,
        halo: f64,
        report: &mut Report<'_>,
    ) -> Result<Self, BlockingError> {
        let corners = corners_within(domain, samples, halo)?;
        let points: Vec<DVec2> = corners
            .iter()
            .map(|corner| {
                samples.points()[corner.sample.index()] + domain.translation(corner.shift)
            })
            .collect();
        let delaunay = Delaunay2::build_with(&points, report).map_err(|error| match error {
            BuildError::Cancelled(cancelled) => BlockingError::Cancelled(cancelled),
            BuildError::TooManyPoints { limit, .. } => BlockingError::TooManySamples { limit },
            BuildError::Coordinate(_) | BuildError::Flat(_) | BuildError::TooManyTets { .. } => {
                BlockingError::Unresolved
            }
        })?;
        if delaunay.duplicates().is_empty() {
            Ok(Self { delaunay, corners })
        } else {
            Err(BlockingError::Unresolved)
        }
    }

    /// The corners of every triangle that `keep` lets pass, each class of images once.
    ///
    /// The corner with the smallest sample comes first and at home.
    pub(crate) fn triangle_classes(
        &self,
        mut keep: impl FnMut([Corner; 3]) -> bool,
    ) -> Vec<[Corner; 3]> {
        self.delaunay
            .faces()
            .map(|face| rotated(self.corners_of(face)))
            .filter(|corners| corners[0].shift == Shift::ZERO && keep(*corners))
            .collect()
    }

    /// The largest diameter of a circumcircle with a corner at home; `limit` when a corner at home
    /// is on the hull.
    fn widest_circle_at_home(&self, limit: f64) -> f64 {
        let mut widest = 0.0f64;
        for face in self
            .delaunay
            .faces()
            .filter(|&face| self.touches_home(face))
        {
            let corners = self
                .delaunay
                .mesh()
                .face_vertices(face)
                .map(|vertex| self.delaunay.point(vertex));
            let diameter = 2.0 * delaunay_core::measure::triangle::circumradius(corners);
            widest = widest.max(diameter.min(limit));
        }
        let at_hull = self
            .delaunay
            .hull_vertices()
            .any(|vertex| self.corners[vertex.index()].shift == Shift::ZERO);
        if at_hull { limit } else { widest }
    }

    fn touches_home(&self, face: FaceId) -> bool {
        self.corners_of(face)
            .iter()
            .any(|corner| corner.shift == Shift::ZERO)
    }

    fn corners_of(&self, face: FaceId) -> [Corner; 3] {
        self.delaunay
            .mesh()
            .face_vertices(face)
            .map(|vertex| self.corners[vertex.index()])
    }
}

/// Every sample, then the images within `halo` of the box of the samples.
fn corners_within(
    domain: &Domain,
    samples: &Samples,
    halo: f64,
) -> Result<Vec<Corner>, BlockingError> {
    let mut corners: Vec<Corner> = (0..samples.len() as u32)
        .map(|sample| Corner {
            sample: SampleId(sample),
            shift: Shift::ZERO,
        })
        .collect();
    let Some(period) = domain.period() else {
        return Ok(corners);
    };
    let points = samples.points().iter().copied();
    let low = points.clone().fold(DVec2::INFINITY, DVec2::min) - halo;
    let high = points.fold(DVec2::NEG_INFINITY, DVec2::max) + halo;
    let images = ((high - low) / period).element_product();
    if images * samples.len() as f64 > MAX_SAMPLES as f64 {
        return Err(BlockingError::TooManySamples { limit: MAX_SAMPLES });
    }
    let home = corners.clone();
    for shift in shifts_within(((high - low) / period).ceil().as_ivec2()) {
        let by = domain.translation(shift);
        let is_near = |corner: &Corner| {
            let p = samples.points()[corner.sample.index()] + by;
            p.cmpge(low).all() && p.cmple(high).all()
        };
        corners.extend(
            home.iter()
                .filter(|corner| is_near(corner))
                .map(|corner| corner.moved(shift)),
        );
    }
    Ok(corners)
}

/// All shifts of at most `reach` periods but the one that moves nothing.
fn shifts_within(reach: Shift) -> impl Iterator<Item = Shift> {
    (-reach.x..=reach.x)
        .flat_map(move |x| (-reach.y..=reach.y).map(move |y| Shift::new(x, y)))
        .filter(|&shift| shift != Shift::ZERO)
}

/// The corners rotated so that the one with the smallest sample, then shift, is first.
fn rotated(corners: [Corner; 3]) -> [Corner; 3] {
    let first = (0..3).min_by_key(|&k| corners[k].key()).unwrap_or(0);
    [
        corners[first],
        corners[(first + 1) % 3],
        corners[(first + 2) % 3],
    ]
}

#[cfg(test)]
mod tests {
    use delaunay_core::progress::silent;

    use super::*;
    use crate::clearance::Clearance;
    use crate::example_domains::two_periodic_holes;
    use crate::wall::Circle;

    fn tiling(domain: &Domain) -> Result<(Samples, Tiling), BlockingError> {
        let samples = Samples::by_local_gap(domain, &Clearance::new(domain), &mut silent)?;
        let tiling = Tiling::of(domain, &samples, &mut silent)?;
        Ok((samples, tiling))
    }

    /// A triangulation of the torus with s vertices has 2 s triangles.
    #[test]
    fn every_class_of_triangles_is_found_once() {
        let (samples, tiling) = tiling(&two_periodic_holes()).unwrap();
        let mut classes = tiling.triangle_classes(|_| true);
        assert_eq!(classes.len(), 2 * samples.len());
        classes.sort_unstable_by_key(|corners| corners.map(Corner::key));
        classes.dedup();
        assert_eq!(classes.len(), 2 * samples.len());
    }

    #[test]
    fn a_bounded_domain_has_no_images() {
        let domain = crate::example_domains::three_holes();
        let (samples, tiling) = tiling(&domain).unwrap();
        assert_eq!(tiling.corners.len(), samples.len());
    }

    #[test]
    fn a_period_too_long_for_its_holes_is_refused_instead_of_filling_the_memory() {
        for aspect in [1e9, 1e30, 1e60] {
            let hole = Circle::new(DVec2::new(0.5, 0.5), 0.25);
            for period in [DVec2::new(1.0, aspect), DVec2::new(aspect, 1.0)] {
                let Ok(domain) = Domain::periodic(period, &[hole]) else {
                    continue;
                };
                assert!(matches!(
                    tiling(&domain).err(),
                    Some(BlockingError::TooManySamples { .. })
                ));
            }
        }
    }
}
