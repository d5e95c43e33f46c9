//! Spheres to be found by where they are.

use glam::DVec3;
use rstar::RTree;
use rstar::primitives::GeomWithData;

/// Spheres, to be asked for those near a place.
#[derive(Debug, Default)]
pub(crate) struct Spheres {
    /// With their radii.
    centers: RTree<GeomWithData<[f64; 3], f64>>,
    largest: f64,
}

impl Spheres {
    /// Adds a sphere. Expected time log n.
    pub(crate) fn insert(&mut self, center: DVec3, radius: f64) {
        self.centers
            .insert(GeomWithData::new(center.to_array(), radius));
        self.largest = self.largest.max(radius);
    }

    /// Whether all spheres with centers nearer to `center` than `squared_reach` of the largest radius pass `test`.
    pub(crate) fn near_all(
        &self,
        center: DVec3,
        squared_reach: impl Fn(f64) -> f64,
        test: impl Fn((DVec3, f64)) -> bool,
    ) -> bool {
        let reach = squared_reach(self.largest);
        let near = self
            .centers
            .locate_within_distance(center.to_array(), reach);
        near.into_iter()
            .all(|sphere| test((DVec3::from(*sphere.geom()), sphere.data)))
    }
}
