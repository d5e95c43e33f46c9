//! The maximal stable subcomplex (§5.1).

use delaunay_core::geo_predicates::{Sign, in_diametral_ball};
use delaunay_core::{Delaunay3, FacetId, TetId};

/// Which tetrahedra of those that `within` names are in their maximal stable subcomplex, by tetrahedron.
///
/// A boundary facet is unstable when the circumcenter of the tetrahedron inside lies strictly beyond it. That tetrahedron
/// goes, its other facets become boundary, and so on; the order does not matter. No flow leaves what stays, so it ends in
/// sinks inside. Exact, linear time.
///
/// Departs from §5.1, where every circumcenter has to be inside the subcomplex: a center far off may leave through a
/// facet that is not of its own tetrahedron. The boundary test guards against that where points are inserted.
pub fn stable_tets(delaunay: &Delaunay3, mut within: impl FnMut(TetId) -> bool) -> Vec<bool> {
    let mesh = delaunay.mesh();
    let mut stays = vec![false; mesh.tet_slots()];
    for t in delaunay.tets() {
        stays[t.index()] = within(t);
    }
    let inside: Vec<TetId> = delaunay.tets().filter(|t| stays[t.index()]).collect();
    let facets = inside.into_iter().flat_map(TetId::facets);
    let mut boundary: Vec<FacetId> = facets
        .filter(|&f| !stays[mesh.twin(f).tet().index()])
        .collect();
    while let Some(f) = boundary.pop() {
        if stays[f.tet().index()] && is_unstable(delaunay, f) {
            stays[f.tet().index()] = false;
            let beyond = f.tet().facets().map(|g| mesh.twin(g));
            boundary.extend(beyond.into_iter().filter(|g| stays[g.tet().index()]));
        }
    }
    stays
}

fn is_unstable(delaunay: &Delaunay3, f: FacetId) -> bool {
    let mesh = delaunay.mesh();
    let [a, b, c] = mesh.facet_vertices(f).map(|v| delaunay.point(v));
    in_diametral_ball(a, b, c, delaunay.point(mesh.apex(f))) == Sign::Positive
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tet::FlowGraph3;
    use delaunay_core::Subcomplex3;
    use glam::DVec3;

    #[test]
    fn no_flow_leaves_the_stable_part() {
        let point = |i: u32| (f64::from(i * i) * DVec3::new(0.1234, 0.2345, 0.3456)).fract();
        let points: Vec<DVec3> = (1..=300).map(point).collect();
        let delaunay = Delaunay3::build(&points).unwrap();
        let outlets = |stays: &[bool]| {
            let part = Subcomplex3::of(&delaunay, |t| stays[t.index()]);
            FlowGraph3::of(&part).outlets().len()
        };
        let whole = vec![true; delaunay.mesh().tet_slots()];
        assert!(outlets(&whole) > 0);
        let stable = stable_tets(&delaunay, |_| true);
        assert!(stable.iter().filter(|&&stays| stays).count() > 100);
        assert_eq!(outlets(&stable), 0);
        // It is stable already.
        assert_eq!(stable_tets(&delaunay, |t| stable[t.index()]), stable);
    }
}
