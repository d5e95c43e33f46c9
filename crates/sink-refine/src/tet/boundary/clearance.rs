//! Whether new triangles of the boundary keep clear of all others.
//!
//! A vertex that is put outside a boundary facet pulls the boundary with it, by a rounding error where it is flat, by the height
//! of the surface over the facet where it is smooth. Another part of the boundary may be in the way.

use delaunay_core::geo_predicates::{Sign, orient3d};
use delaunay_core::{FacetId, Subcomplex3, VertexId, triangles_intersect};
use glam::DVec3;
use rstar::primitives::{GeomWithData, Rectangle};
use rstar::{AABB, RTree};

/// A boundary facet by its corners, to be found by where it is.
type Triangle = GeomWithData<Rectangle<[f64; 3]>, [VertexId; 3]>;

/// Stands for the vertex to come.
const NEW: VertexId = VertexId::GHOST;

/// The boundary facets, once they have been asked for.
#[derive(Debug, Default)]
pub(super) struct Clearance {
    triangles: Option<RTree<Triangle>>,
}

/// A vertex that is to be put on the boundary.
#[derive(Clone, Copy)]
pub(super) struct Pull<'a> {
    pub(super) point: DVec3,
    /// The boundary facets that give way.
    pub(super) disk: &'a [FacetId],
    /// The directed edges round them.
    pub(super) rim: &'a [[VertexId; 2]],
}

impl Clearance {
    /// Whether the triangles between the point and the rim meet no other triangle of the boundary and have nothing in the space
    /// that the solid gains. Exact; takes time log n and what is near, the first time n log n.
    pub(super) fn is_given(&mut self, solid: &Subcomplex3, pull: Pull<'_>) -> bool {
        let outside = |f: &FacetId| {
            let [a, b, c] = solid.triangle(*f);
            orient3d(a, b, c, pull.point) == Sign::Positive
        };
        let gains: Vec<FacetId> = pull.disk.iter().copied().filter(outside).collect();
        if gains.is_empty() {
            return true;
        }
        let place = |v: VertexId| match v {
            NEW => pull.point,
            v => solid.point(v),
        };
        let new: Vec<[VertexId; 3]> = pull.rim.iter().map(|&[u, v]| [NEW, u, v]).collect();
        let mut later = new.iter().enumerate();
        if later.any(|(i, &t)| new[..i].iter().any(|&s| triangles_intersect(place, s, t))) {
            return false;
        }
        let gone: Vec<[VertexId; 3]> = pull.disk.iter().map(|&f| sorted(solid, f)).collect();
        let ends = pull.disk.iter().flat_map(|&f| solid.triangle(f));
        let reach = bounds(ends.chain([pull.point]));
        let tree = self.triangles.get_or_insert_with(|| {
            let all = solid.boundary();
            RTree::bulk_load(all.map(|f| triangle(solid, f)).collect())
        });
        let near = tree.locate_in_envelope_intersecting(reach);
        near.into_iter()
            .map(|near| near.data)
            .filter(|corners| !gone.contains(corners))
            .all(|corners| {
                let meets = |&t: &[VertexId; 3]| triangles_intersect(place, t, corners);
                let swallowed = |&f: &FacetId| {
                    let mut free = corners
                        .iter()
                        .filter(|v| !pull.rim.iter().flatten().any(|u| u == *v));
                    free.any(|&v| is_between(solid.triangle(f), pull.point, solid.point(v)))
                };
                !new.iter().any(meets) && !gains.iter().any(swallowed)
            })
    }

    /// Takes note that the facets of a disk are about to give way.
    pub(super) fn forget(&mut self, solid: &Subcomplex3, disk: &[FacetId]) {
        if let Some(triangles) = &mut self.triangles {
            for &f in disk {
                triangles.remove(&triangle(solid, f));
            }
        }
    }

    /// Takes note of new boundary facets.
    pub(super) fn note(&mut self, solid: &Subcomplex3, facets: impl IntoIterator<Item = FacetId>) {
        if let Some(triangles) = &mut self.triangles {
            for f in facets {
                triangles.insert(triangle(solid, f));
            }
        }
    }
}

fn triangle(solid: &Subcomplex3, f: FacetId) -> Triangle {
    let bounds = bounds(solid.triangle(f));
    GeomWithData::new(Rectangle::from_aabb(bounds), sorted(solid, f))
}

fn bounds(points: impl IntoIterator<Item = DVec3>) -> AABB<[f64; 3]> {
    let points: Vec<[f64; 3]> = points.into_iter().map(|p| p.to_array()).collect();
    AABB::from_points(&points)
}

fn sorted(solid: &Subcomplex3, f: FacetId) -> [VertexId; 3] {
    let mut corners = solid.mesh().facet_vertices(f);
    corners.sort_unstable();
    corners
}

/// Whether `q` is in the tetrahedron between a facet and the point `p` outside it, its surface included.
fn is_between([a, b, c]: [DVec3; 3], p: DVec3, q: DVec3) -> bool {
    let sides = [[a, b, c], [b, a, p], [c, b, p], [a, c, p]];
    sides
        .into_iter()
        .all(|[u, v, w]| orient3d(u, v, w, q) != Sign::Negative)
}

#[cfg(test)]
mod tests {
    use super::*;
    use delaunay_core::Delaunay3;

    /// Two tetrahedra, one above the other, and the top facet of the lower one.
    fn two(gap: f64) -> (Subcomplex3, FacetId) {
        let base = [[0.0, 0.0], [4.0, 0.0], [0.0, 4.0]];
        let mut points: Vec<DVec3> = base.map(|[x, y]| DVec3::new(x, y, 0.0)).to_vec();
        points.push(DVec3::new(1.0, 1.0, -3.0));
        points.push(DVec3::new(1.0, 1.0, gap));
        points.extend(base.map(|[x, y]| DVec3::new(x, y, gap + 3.0)));
        let delaunay = Delaunay3::build(&points).unwrap();
        let is_one = |t| {
            let corners = delaunay.mesh().tet_vertices(t);
            let lower = corners.iter().filter(|v| v.index() < 4).count();
            lower == 0 || lower == 4
        };
        let both = Subcomplex3::of(&delaunay, is_one);
        assert_eq!(both.tets().count(), 2);
        let is_top = |f: &FacetId| both.triangle(*f).iter().all(|p| p.z == 0.0);
        let top = both.boundary().find(is_top).unwrap();
        (both, top)
    }

    #[test]
    fn what_is_in_the_way_is_seen() {
        let (both, top) = two(3.0);
        let [a, b, c] = both.mesh().facet_vertices(top);
        let rim = [[a, b], [b, c], [c, a]];
        let mut clearance = Clearance::default();
        let mut is_clear = |z: f64| {
            let pull = Pull {
                point: DVec3::new(1.0, 1.0, z),
                disk: &[top],
                rim: &rim,
            };
            clearance.is_given(&both, pull)
        };
        assert!(is_clear(-0.5));
        assert!(is_clear(2.5));
        assert!(!is_clear(3.0));
        assert!(!is_clear(3.5));
    }

    #[test]
    fn what_would_be_swallowed_is_seen() {
        let (both, top) = two(3.0);
        let [a, b, c] = both.triangle(top);
        let p = DVec3::new(1.0, 1.0, 9.0);
        assert!(is_between([a, b, c], p, DVec3::new(1.0, 1.0, 1.0)));
        assert!(!is_between([a, b, c], p, DVec3::new(1.0, 1.0, -1.0)));
        assert!(!is_between([a, b, c], p, DVec3::new(1.0, 1.0, 10.0)));
    }
}
