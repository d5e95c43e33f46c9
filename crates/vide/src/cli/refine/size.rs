//! How large elements may be: the area limits in a `.poly`.

use vide::glam::DVec2;
use vide::mesh_io::PlanarGraph;
use vide::sink_refine::RegionLimit;

/// The limits of the regions of a graph: edges of the regular triangle whose area is the largest allowed.
///
/// No triangle is larger then, as the regular one is the largest in its circle.
pub(super) fn of_regions(graph: &PlanarGraph) -> Vec<RegionLimit<DVec2>> {
    let regions = graph.regions.iter();
    let limits = regions.map(|region| RegionLimit {
        seed: DVec2::from(region.seed),
        size: region
            .max_area
            .map_or(f64::INFINITY, |area| (4.0 * area / 3.0_f64.sqrt()).sqrt()),
    });
    limits.collect()
}
