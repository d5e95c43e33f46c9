//! Spheres, in the plane circles, to be found by where they are.

use rstar::primitives::GeomWithData;
use rstar::{Point, RTree};

/// Spheres with centers of type `P`, to be asked for those near a place.
#[derive(Debug)]
pub(crate) struct Spheres<P: Point> {
    /// With their radii.
    centers: RTree<GeomWithData<P, f64>>,
    largest: f64,
}

impl<P: Point<Scalar = f64>> Spheres<P> {
    pub(crate) fn new() -> Self {
        Self {
            centers: RTree::new(),
            largest: 0.0,
        }
    }

    /// Adds a sphere. Expected time log n.
    pub(crate) fn insert(&mut self, center: P, radius: f64) {
        self.centers.insert(GeomWithData::new(center, radius));
        self.largest = self.largest.max(radius);
    }

    /// Whether all spheres with centers nearer to `center` than `squared_reach` of the largest radius pass `test`.
    pub(crate) fn near_all(
        &self,
        center: P,
        squared_reach: impl Fn(f64) -> f64,
        test: impl Fn(P, f64) -> bool,
    ) -> bool {
        let reach = squared_reach(self.largest);
        let near = self.centers.locate_within_distance(center, reach);
        near.into_iter()
            .all(|sphere| test(sphere.geom().clone(), sphere.data))
    }
}
