//! Simple polygons triangulated by cutting off ears, anywhere and preferably needles.
//!
//! An ear is a corner strictly convex whose triangle has no other corner in it or on its sides. A simple polygon whose corners are not
//! all on a line has a triangulation with all its corners, and a triangle of it with two sides of the polygon is an ear; so one is
//! found until a triangle is left. Signs are exact.

use delaunay_core::geo_predicates::{Sign, orient2d};
use glam::DVec2;
use rand::RngExt;

use super::Random;
use super::flat::Cap;

/// The triangles of a simple polygon whose corners run counterclockwise. Time n^2 usually, n^3 at most.
///
/// What remains is left out when there is no ear, which means that the polygon is not simple.
#[must_use]
pub fn clipped(polygon: &[DVec2], random: &mut Random) -> Cap {
    let mut left: Vec<u32> = (0..polygon.len() as u32).collect();
    let mut triangles = Vec::with_capacity(polygon.len());
    while left.len() >= 3 {
        let start = random.random_range(0..left.len());
        let Some(ear) = ear(polygon, &left, start, random.random_bool(0.5)) else {
            break;
        };
        triangles.push(around(&left, ear));
        left.remove(ear);
    }
    Cap {
        points: polygon.to_vec(),
        triangles,
    }
}

/// The first ear from `start` on, or the thinnest of the first four.
fn ear(polygon: &[DVec2], left: &[u32], start: usize, is_thin: bool) -> Option<usize> {
    const LOOKED_AT: usize = 4;
    let corners = (0..left.len()).map(|step| (start + step) % left.len());
    let mut ears = corners.filter(|&corner| is_ear(polygon, left, corner));
    if !is_thin {
        return ears.next();
    }
    let shape = |&corner: &usize| {
        let [a, b, c] = around(left, corner).map(|v| polygon[v as usize]);
        (b - a).perp_dot(c - a) / a.distance_squared(c).max(a.distance_squared(b))
    };
    ears.take(LOOKED_AT)
        .min_by(|a, b| shape(a).total_cmp(&shape(b)))
}

fn is_ear(polygon: &[DVec2], left: &[u32], corner: usize) -> bool {
    let ear = around(left, corner);
    let [a, b, c] = ear.map(|v| polygon[v as usize]);
    let is_beside = |p: DVec2| {
        [[a, b], [b, c], [c, a]]
            .into_iter()
            .any(|[from, to]| orient2d(from, to, p) == Sign::Negative)
    };
    orient2d(a, b, c) == Sign::Positive
        && left
            .iter()
            .all(|v| ear.contains(v) || is_beside(polygon[*v as usize]))
}

fn around(left: &[u32], corner: usize) -> [u32; 3] {
    let count = left.len();
    [corner + count - 1, corner, corner + 1].map(|index| left[index % count])
}

#[cfg(test)]
mod tests {
    use super::super::random;
    use super::*;
    use glam::dvec2;

    #[test]
    fn flat_corners_and_notches_are_no_obstacle() {
        let corners = [
            [0, 0],
            [1, 0],
            [2, 0],
            [4, 0],
            [4, 4],
            [3, 4],
            [3, 1],
            [2, 1],
            [2, 4],
            [0, 4],
            [0, 2],
        ];
        let polygon = corners.map(|[x, y]| dvec2(f64::from(x), f64::from(y)));
        for seed in 0..50 {
            let cap = clipped(&polygon, &mut random(seed));
            assert_eq!(cap.triangles.len(), polygon.len() - 2);
            let area: f64 = cap.places().map(|[a, b, c]| (b - a).perp_dot(c - a)).sum();
            assert!((area / 2.0 - 13.0).abs() < 1e-12);
        }
    }
}
