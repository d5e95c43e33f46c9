//! Edge removal: the n tetrahedra round an edge give way to 2 (n - 2) others (de Cougny and Shephard 1995).
//!
//! The link of the edge is a polygon in space. Each triangulation of it makes tetrahedra, one with either end of the edge
//! on every triangle; the one whose worst tetrahedron is best is found by dynamic programming (Klincsek 1980), as a
//! triangulation of the part of the polygon from corner i to corner j is a triangle on the side ij and triangulations of
//! the two parts beyond it.

use crate::plan::Exchange;
use crate::quality::min_sine;
use crate::records::Records;
use crate::ring::Ring;
use delaunay_core::{Complex3, TetId};
use glam::DVec3;

/// Tetrahedra round an edge at most.
const LONGEST: usize = 12;

/// The removal of edge `number` of `t` whose worst tetrahedron is best, if that is better than the worst round the edge.
///
/// `None` for an edge on the boundary, too. Takes n³ time.
pub(crate) fn plan(
    complex: &Complex3,
    records: &Records,
    t: TetId,
    number: usize,
) -> Option<Exchange> {
    let ring = Ring::of(complex, t, number, LONGEST)?;
    let ends = ring.edge.map(|v| complex.point(v));
    let mut link = [DVec3::ZERO; LONGEST];
    for (place, &v) in link.iter_mut().zip(&ring.link) {
        *place = complex.point(v);
    }
    let bound = records.worst(&ring.tets);
    let (quality, triangles) = best_triangulation(ends, &link[..ring.link.len()], bound)?;
    let [a, b] = ring.edge;
    let made = triangles.into_iter().flat_map(|corners| {
        let [x, y, z] = corners.map(|i| ring.link[i]);
        [[a, x, y, z], [x, y, z, b]]
    });
    Some(Exchange {
        made: made.collect(),
        gone: ring.tets,
        quality,
    })
}

/// The quality of the worse of the tetrahedra between a triangle and two ends, the second one on the side from which the
/// triangle turns counterclockwise; any number up to `bound` if it is not above.
#[inline]
fn quality_between([a, b]: [DVec3; 2], [x, y, z]: [DVec3; 3], bound: f64) -> f64 {
    let first = min_sine([a, x, y, z]);
    if first <= bound {
        return first;
    }
    first.min(min_sine([x, y, z, b]))
}

/// The triangles of the best triangulation of a polygon of at most [`LONGEST`] corners, and the quality of its worst
/// tetrahedron; `None` when that is not above `bound`.
fn best_triangulation(
    ends: [DVec3; 2],
    link: &[DVec3],
    bound: f64,
) -> Option<(f64, Vec<[usize; 3]>)> {
    let last = link.len() - 1;
    // By side: the quality of the part beyond it, and the third corner of the triangle on it.
    let mut best = [[(f64::INFINITY, 0); LONGEST]; LONGEST];
    for span in 2..=last {
        for i in 0..=last - span {
            let j = i + span;
            let mut choice = (bound, i);
            for k in i + 1..j {
                let beyond = best[i][k].0.min(best[k][j].0);
                if beyond > choice.0 {
                    let triangle = [link[i], link[k], link[j]];
                    let quality = beyond.min(quality_between(ends, triangle, choice.0));
                    if quality > choice.0 {
                        choice = (quality, k);
                    }
                }
            }
            best[i][j] = choice;
        }
    }
    let quality = best[0][last].0;
    if quality <= bound {
        return None;
    }
    let mut triangles = Vec::with_capacity(link.len() - 2);
    let mut sides = vec![(0, last)];
    while let Some((i, j)) = sides.pop() {
        if j > i + 1 {
            let k = best[i][j].1;
            triangles.push([i, k, j]);
            sides.extend([(i, k), (k, j)]);
        }
    }
    Some((quality, triangles))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample::{Random, cube, exercise};
    use std::collections::BTreeSet;

    /// The best worst quality of all triangulations of the corners from `i` to `j`.
    fn brute_force(ends: [DVec3; 2], link: &[DVec3], i: usize, j: usize) -> f64 {
        let between = |k: usize| {
            let here = quality_between(ends, [link[i], link[k], link[j]], f64::NEG_INFINITY);
            let parts = brute_force(ends, link, i, k).min(brute_force(ends, link, k, j));
            here.min(parts)
        };
        match j == i + 1 {
            true => f64::INFINITY,
            false => (i + 1..j).map(between).fold(f64::NEG_INFINITY, f64::max),
        }
    }

    #[test]
    fn the_best_of_all_triangulations_is_found() {
        let mut random = Random::new(7);
        for round in 0..400 {
            let n = 3 + round % 7;
            let link: Vec<DVec3> = (0..n)
                .map(|i| {
                    let angle = std::f64::consts::TAU * i as f64 / n as f64;
                    DVec3::new(angle.cos(), angle.sin(), 0.0) + random.vector() * 0.5
                })
                .collect();
            let ends = [-DVec3::Z, DVec3::Z].map(|end| end + random.vector() * 0.5);
            let expected = brute_force(ends, &link, 0, n - 1);
            let found = best_triangulation(ends, &link, -2.0);
            let (quality, triangles) = found.unwrap();
            assert_eq!((quality, triangles.len()), (expected, n - 2));
            let worst = triangles
                .iter()
                .map(|t| quality_between(ends, t.map(|i| link[i]), f64::NEG_INFINITY))
                .fold(f64::INFINITY, f64::min);
            assert_eq!(worst, expected);
            assert_eq!(best_triangulation(ends, &link, expected), None);
        }
    }

    #[test]
    fn a_link_on_a_plane_with_the_ends_has_no_triangulation() {
        let link =
            [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [3.0, 0.0]].map(|[x, y]| DVec3::new(x, y, 0.0));
        let ends = [DVec3::new(1.0, -1.0, 0.0), DVec3::new(1.0, 1.0, 0.0)];
        assert_eq!(best_triangulation(ends, &link, 0.0), None);
    }

    #[test]
    fn edges_inside_give_way_to_better_tetrahedra() {
        let mut sizes = BTreeSet::new();
        for seed in 0..4 {
            let removed = exercise(cube(4, seed), |complex, records, t| {
                let plans = (0..6).filter_map(|edge| plan(complex, records, t, edge));
                let plan = plans.max_by_key(|plan| plan.gone.len())?;
                assert_eq!(plan.made.len(), 2 * (plan.gone.len() - 2));
                assert!(plan.quality > records.worst(&plan.gone));
                sizes.insert(plan.gone.len());
                Some(plan)
            });
            assert!(removed > 20, "{removed}");
        }
        assert!(sizes.contains(&3) && sizes.contains(&5), "{sizes:?}");
    }
}
