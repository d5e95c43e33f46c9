//! Off-centers: points on the way from the shortest edge of a triangle to its circumcenter.
//!
//! They stay near the edge that they cure, so sizes grow away from short edges as fast as the bound allows, and no faster
//! (after Üngör 2004). The open disk round the circumcenter is empty, so no vertex is nearer to an off-center
//! than its height over the edge: that keeps the minimum separation. Where the size asked for allows less than the bound, they
//! are as near as the size demands, and have to be as far from vertices as the circumradius that it allows.

use super::super::refiner::Refiner;
use delaunay_core::FaceId;
use delaunay_core::measure::triangle::circumcenter;
use glam::DVec2;

/// The ratio r/l of the regular triangle: 1/√3.
const REGULAR: f64 = 0.577_350_269_189_625_8;

/// Where the off-centers of a triangle are.
#[derive(Clone, Copy, Debug)]
pub(super) struct OffCenters {
    /// The midpoint of the shortest edge.
    middle: DVec2,
    /// Length of the shortest edge.
    shortest: f64,
    /// The largest circumradius that is allowed.
    largest_radius: f64,
    circumcenter: DVec2,
}

impl OffCenters {
    /// Those of a triangle of the mesh.
    pub(super) fn of_triangle(refiner: &Refiner<'_>, face: FaceId) -> Self {
        let largest_radius = refiner.records.largest_radius(&refiner.region, face);
        Self::of(refiner.region.triangle(face), largest_radius)
    }

    /// Those of a triangle whose size allows no larger circumradius than `largest_radius`.
    fn of(corners: [DVec2; 3], largest_radius: f64) -> Self {
        let [a, b, c] = corners;
        let edges = [[a, b], [b, c], [c, a]];
        let squared = |[a, b]: [DVec2; 2]| a.distance_squared(b);
        let shorter = |e: [DVec2; 2], f| if squared(f) < squared(e) { f } else { e };
        let [a, b] = edges.into_iter().reduce(shorter).unwrap_or(edges[0]);
        Self {
            middle: a.midpoint(b),
            shortest: a.distance(b),
            largest_radius,
            circumcenter: circumcenter(corners),
        }
    }

    /// The least distance from vertices that points keep: the shortest edge's length, or the largest circumradius allowed, if that
    /// is less.
    pub(super) fn separation(&self) -> f64 {
        self.shortest.min(self.largest_radius)
    }

    /// The off-center at `share` of the height at which it makes with the shortest edge a triangle whose ratio r/l is
    /// `bound`, or less if that is too large; the circumcenter where that is nearer.
    ///
    /// Of that height it stays below by the rounding of coordinates. Else short edges far from the origin would call for points
    /// all over the region, since rounding makes the triangle of one point in two of low quality again.
    pub(super) fn at(&self, share: f64, bound: f64) -> DVec2 {
        let bound = bound.min((self.largest_radius / self.shortest).max(REGULAR));
        let height = |share| share * self.shortest * (bound + (bound * bound - 0.25).sqrt());
        let below_whole = (height(1.0) - self.rounding()).max(0.0);
        let height = height(share).min(below_whole);
        let way = self.circumcenter - self.middle;
        match way.length() {
            length if length <= height => self.circumcenter,
            length => self.middle + way * (height / length),
        }
    }

    /// How far rounding may move an off-center, with some room.
    fn rounding(&self) -> f64 {
        4.0 * f64::EPSILON * self.middle.abs().max_element()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use delaunay_core::measure::triangle::{circumradius, radius_edge_ratio};

    /// A needle whose circumcenter is far above its short edge.
    const NEEDLE: [DVec2; 3] = [
        DVec2::new(-0.5, 0.0),
        DVec2::new(0.5, 0.0),
        DVec2::new(0.1, 20.0),
    ];

    #[test]
    fn the_whole_height_makes_a_triangle_of_the_bound() {
        let off = OffCenters::of(NEEDLE, f64::INFINITY);
        assert_eq!(off.shortest, 1.0);
        let ratio = radius_edge_ratio([NEEDLE[0], NEEDLE[1], off.at(1.0, 2.0)]);
        assert!((ratio - 2.0).abs() < 1e-12);
    }

    #[test]
    fn where_the_size_allows_less_than_the_bound_the_triangle_is_as_large_as_allowed() {
        for (largest, expected) in [(0.8, 0.8), (0.1, REGULAR), (9.0, 2.0)] {
            let off = OffCenters::of(NEEDLE, largest);
            let radius = circumradius([NEEDLE[0], NEEDLE[1], off.at(1.0, 2.0)]);
            assert!((radius - expected).abs() < 1e-12, "{radius}");
            assert_eq!(off.separation(), f64::min(largest, 1.0));
        }
    }

    #[test]
    fn far_from_the_origin_rounding_makes_no_triangle_one_of_low_quality() {
        for turn in (0..100).map(f64::from) {
            let place = |p: DVec2| DVec2::new(4e8, 5e8) + DVec2::from_angle(turn).rotate(p) * 1e-3;
            let [a, b, c] = NEEDLE.map(place);
            let off = OffCenters::of([a, b, c], f64::INFINITY).at(1.0 - 1e-9, 1.0);
            let ratio = radius_edge_ratio([a, b, off]);
            assert!(ratio <= 1.0 && ratio > 0.99, "{ratio}");
        }
    }

    #[test]
    fn no_off_center_is_beyond_the_circumcenter() {
        let off = OffCenters::of(NEEDLE, f64::INFINITY);
        assert_eq!(off.at(1.0, 100.0), circumcenter(NEEDLE));
    }
}
