//! Where the smooth surface is that the boundary facets stand for.
//!
//! Over each facet it is the quadratic patch of Boubekeur and Alexa 2008 (Phong tessellation): a point of the facet is projected
//! onto the tangent planes at the three corners, and moved half way toward the mean of the projections. Between facets of one
//! plane that is the plane.

use super::creases::{Creases, angle, unit_normal};
use delaunay_core::{FacetId, Subcomplex3, VertexId};
use glam::DVec3;
use rustc_hash::FxHashSet;

/// How far points move toward the mean of their projections. Half way they come onto the surface where it is a paraboloid, and
/// so up to the third order everywhere; the authors, who want round contours, take three quarters.
const SHARE: f64 = 0.5;

/// Facets passed on the way to a point, at most.
const STEPS: usize = 16;

/// What is met on the way from a facet to a point near its plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Way {
    /// The point is over this facet; its place on the patch, and on the facet.
    Facet(FacetId, [DVec3; 2]),
    /// A crease between.
    Crease([VertexId; 2]),
    /// Neither, within a number of steps.
    Lost,
}

/// The way from facet `f` to the facet of the same smooth part over which `p` is.
pub(super) fn way_to(solid: &Subcomplex3, creases: &Creases, f: FacetId, p: DVec3) -> Way {
    let mut here = f;
    for _ in 0..STEPS {
        let corners = solid.mesh().facet_vertices(here);
        let shares = barycentric(solid.triangle(here), p);
        let least = (0..3)
            .min_by(|&i, &j| shares[i].total_cmp(&shares[j]))
            .unwrap_or(0);
        if shares[least] >= 0.0 {
            return Way::Facet(here, places(solid, creases, here, shares));
        }
        let mut across = solid.across_edges(here);
        let opposite = across.find(|(edge, _)| !edge.contains(&corners[least]));
        match opposite {
            Some((edge, _)) if creases.contain(edge) => return Way::Crease(edge),
            Some((_, beyond)) => here = beyond,
            None => return Way::Lost,
        }
    }
    Way::Lost
}

/// The barycentric coordinates of the projection of `p` onto the plane of a triangle; not numbers when it has no area.
fn barycentric([a, b, c]: [DVec3; 3], p: DVec3) -> [f64; 3] {
    // Scaled, lest products leave the range of doubles.
    let largest = (b - a).abs().max((c - a).abs()).max_element();
    let [u, v, w] = [b - a, c - a, p - a].map(|arm| arm / largest);
    let n = u.cross(v);
    let [of_c, of_b] = [u.cross(w), w.cross(v)].map(|part| part.dot(n) / n.length_squared());
    [1.0 - of_b - of_c, of_b, of_c]
}

/// Where the point with these barycentric coordinates is on the patch over a facet, and on the facet.
fn places(solid: &Subcomplex3, creases: &Creases, f: FacetId, shares: [f64; 3]) -> [DVec3; 2] {
    let corners = solid.triangle(f);
    let flat: DVec3 = corners
        .iter()
        .zip(shares)
        .map(|(&corner, share)| corner * share)
        .sum();
    if creases.are_of_a_flat_surface() {
        return [flat; 2];
    }
    let vertices = solid.mesh().facet_vertices(f);
    let projections = (0..3).map(|i| {
        let n = normal_at(solid, creases, f, vertices[i]);
        (flat - n * n.dot(flat - corners[i])) * shares[i]
    });
    [flat.lerp(projections.sum(), SHARE), flat]
}

/// The unit normal at a corner of a facet: the mean over the facets round it, as far as there is no crease between, weighted by
/// their angles there.
fn normal_at(solid: &Subcomplex3, creases: &Creases, f: FacetId, v: VertexId) -> DVec3 {
    let mut sheet = vec![f];
    let mut met: FxHashSet<FacetId> = sheet.iter().copied().collect();
    let mut sum = DVec3::ZERO;
    let mut next = 0;
    while let Some(&facet) = sheet.get(next) {
        next += 1;
        sum += unit_normal(solid.triangle(facet)) * angle_at(solid, facet, v);
        for (edge, beyond) in solid.across_edges(facet) {
            if edge.contains(&v) && !creases.contain(edge) && met.insert(beyond) {
                sheet.push(beyond);
            }
        }
    }
    sum.normalize_or(unit_normal(solid.triangle(f)))
}

fn angle_at(solid: &Subcomplex3, f: FacetId, v: VertexId) -> f64 {
    let vertices = solid.mesh().facet_vertices(f);
    let mut corners = solid.triangle(f);
    corners.rotate_left(vertices.iter().position(|&u| u == v).unwrap_or(0));
    let [a, b, c] = corners;
    angle(b - a, c - a)
}

#[cfg(test)]
mod tests {
    use super::*;
    use delaunay_core::Delaunay3;

    /// A pyramid with a square base.
    fn pyramid(height: f64) -> Subcomplex3 {
        let base = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
        let mut points: Vec<DVec3> = base.map(|[x, y]| DVec3::new(x, y, 0.0)).to_vec();
        points.push(DVec3::new(0.0, 0.0, height));
        Subcomplex3::of(&Delaunay3::build(&points).unwrap(), |_| true)
    }

    fn facet_under(solid: &Subcomplex3, p: DVec3) -> FacetId {
        let distance = |f: &FacetId| {
            let [a, b, c] = solid.triangle(*f);
            ((a + b + c) / 3.0).distance(p)
        };
        let nearest = |f: &FacetId, g: &FacetId| distance(f).total_cmp(&distance(g));
        solid.boundary().min_by(nearest).unwrap()
    }

    #[test]
    fn the_way_ends_at_creases_and_crosses_what_is_smooth() {
        let pyramid = pyramid(1.0);
        let from = facet_under(&pyramid, DVec3::new(0.6, 0.0, 0.3));
        let to = DVec3::new(-0.6, 0.1, 0.4);
        let creased = Creases::of(&pyramid, 10.0);
        assert!(matches!(
            way_to(&pyramid, &creased, from, to),
            Way::Crease(_)
        ));
        let smooth = Creases::of(&pyramid, 180.0);
        let way = way_to(&pyramid, &smooth, from, to);
        let under = facet_under(&pyramid, DVec3::new(-0.6, 0.0, 0.3));
        assert!(matches!(way, Way::Facet(f, _) if f == under), "{way:?}");
    }

    #[test]
    fn between_creases_the_patch_is_flat() {
        let pyramid = pyramid(1.0);
        let creases = Creases::of(&pyramid, 10.0);
        let middle = DVec3::new(0.7, 0.1, 0.3);
        let f = facet_under(&pyramid, middle);
        let Way::Facet(_, [curved, flat]) = way_to(&pyramid, &creases, f, middle) else {
            panic!("the middle is over its facet");
        };
        assert!(curved.distance(middle) < 1e-15 && flat.distance(middle) < 1e-15);
    }

    #[test]
    fn on_a_ball_the_patch_is_near_the_ball() {
        let mut points: Vec<DVec3> = Vec::new();
        for i in 0..300 {
            // Evenly along a spiral (Vogel).
            let z = 1.0 - (f64::from(i) + 0.5) / 150.0;
            let angle = 2.399_963 * f64::from(i);
            let radius = (1.0 - z * z).sqrt();
            points.push(DVec3::new(radius * angle.cos(), radius * angle.sin(), z));
        }
        let ball = Subcomplex3::of(&Delaunay3::build(&points).unwrap(), |_| true);
        let creases = Creases::of(&ball, 45.0);
        for f in ball.boundary() {
            let [a, b, c] = ball.triangle(f);
            let Way::Facet(_, [curved, flat]) = way_to(&ball, &creases, f, (a + b + c) / 3.0)
            else {
                panic!("the middle is over its facet");
            };
            assert!((curved.length() - 1.0).abs() < 0.1 * (1.0 - flat.length()));
        }
    }
}
