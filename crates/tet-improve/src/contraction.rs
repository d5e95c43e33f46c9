//! Edge contraction: a vertex inside goes onto a neighbour, and the tetrahedra between them vanish.

use crate::plan::Exchange;
use crate::quality::min_sine;
use crate::records::Records;
use crate::stars::Stars;
use delaunay_core::{Complex3, VertexId};

/// The contraction of the edge from `v` onto `onto`, if the worst tetrahedron round `v` becomes better.
///
/// `None` when `v` is on the boundary. That the result is a mesh is for [`Complex3::replace`] to find out.
pub(crate) fn plan(
    complex: &Complex3,
    records: &Records,
    stars: &mut Stars,
    [v, onto]: [VertexId; 2],
) -> Option<Exchange> {
    if records.is_on_boundary(v) {
        return None;
    }
    let mesh = complex.mesh();
    let star = stars.of(mesh, v);
    let bound = records.worst(star);
    let (mut made, mut quality) = (Vec::new(), f64::INFINITY);
    for corners in star.iter().map(|&t| mesh.tet_vertices(t)) {
        if !corners.contains(&onto) {
            let corners = corners.map(|w| if w == v { onto } else { w });
            quality = quality.min(min_sine(corners.map(|w| complex.point(w))));
            if quality <= bound {
                return None;
            }
            made.push(corners);
        }
    }
    Some(Exchange {
        gone: star.to_vec(),
        made,
        quality,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample::{cube, exercise};

    #[test]
    fn vertices_inside_go_onto_a_neighbour() {
        let mut contracted = 0;
        for seed in 0..20 {
            let mut stars = Stars::default();
            contracted += exercise(cube(4, seed), |complex, records, t| {
                let corners = complex.mesh().tet_vertices(t);
                let pairs = corners.into_iter().flat_map(|v| corners.map(|w| [v, w]));
                let mut pairs = pairs.filter(|[v, w]| v != w);
                let plan = pairs.find_map(|pair| plan(complex, records, &mut stars, pair))?;
                assert!(plan.quality > records.worst(&plan.gone));
                assert!(plan.made.len() < plan.gone.len());
                Some(plan)
            });
        }
        assert!(contracted > 20, "{contracted}");
    }
}
