//! What the paper says of flow and sinks, checked in whole numbers on points of a small lattice, where right
//! angles and common circles abound.

use delaunay_core::geo_predicates::{Sign, in_circle};
use delaunay_core::{Delaunay2, FaceId, Subcomplex2};
use glam::DVec2;
use proptest::prelude::*;
use sink_refine::tri::{phi, pi};
use sink_refine::{End, Sinks, Successor, path, sink, successor};

type Corners = [[i128; 2]; 3];

fn lattice(max: usize) -> impl Strategy<Value = Vec<DVec2>> {
    let side = prop_oneof![Just(6), Just(40), Just(1000)];
    side.prop_flat_map(move |side: i32| {
        let point = (-side..=side, -side..=side);
        prop::collection::vec(
            point.prop_map(|(x, y)| DVec2::new(x.into(), y.into())),
            3..max,
        )
    })
}

fn corners(delaunay: &Delaunay2, f: FaceId) -> Corners {
    delaunay.triangle(f).map(|p| [p.x as i128, p.y as i128])
}

fn minus(p: [i128; 2], q: [i128; 2]) -> [i128; 2] {
    [p[0] - q[0], p[1] - q[1]]
}

fn dot(u: [i128; 2], v: [i128; 2]) -> i128 {
    u[0] * v[0] + u[1] * v[1]
}

fn cross(u: [i128; 2], v: [i128; 2]) -> i128 {
    u[0] * v[1] - u[1] * v[0]
}

/// Squared circumradius as a fraction: (product of the squared edges) / (2 · twice the area)².
fn squared_radius([a, b, c]: Corners) -> (i128, i128) {
    let [ab, bc, ca] = [minus(b, a), minus(c, b), minus(a, c)];
    let area = 2 * cross(ab, minus(c, a));
    (dot(ab, ab) * dot(bc, bc) * dot(ca, ca), area * area)
}

/// How far the circumcenter is on the left of each edge, all times one positive number.
fn center_left_of_edges([a, b, c]: Corners) -> [i128; 3] {
    [[a, b, c], [b, c, a], [c, a, b]].map(|[a, b, c]| {
        let (u, v) = (minus(b, a), minus(c, a));
        // The center is a + o / (2 u × v) with o = (|u|² v − |v|² u) turned by a right angle to the right.
        let flat = [0, 1].map(|i| dot(u, u) * v[i] - dot(v, v) * u[i]);
        cross(u, [flat[1], -flat[0]])
    })
}

proptest! {
    #[test]
    fn the_successor_is_across_the_edge_beyond_which_the_center_lies(points in lattice(30)) {
        let Ok(delaunay) = Delaunay2::build(&points) else { return Ok(()) };
        for f in delaunay.faces() {
            let left = center_left_of_edges(corners(&delaunay, f));
            let beyond: Vec<_> = f.half_edges().into_iter().zip(left).filter(|(_, left)| *left < 0).collect();
            prop_assert!(beyond.len() <= 1);
            let expected = beyond.first().map_or(Successor::None, |&(h, _)| {
                let next = delaunay.mesh().twin(h).face();
                if delaunay.is_ghost_face(next) { Successor::Outside } else { Successor::Triangle(next) }
            });
            prop_assert_eq!(successor(&delaunay, f), expected);
        }
    }

    #[test]
    fn the_circumradius_grows_along_the_flow_except_on_one_circle(points in lattice(30)) {
        let Ok(delaunay) = Delaunay2::build(&points) else { return Ok(()) };
        for f in delaunay.faces() {
            let Successor::Triangle(next) = successor(&delaunay, f) else { continue };
            let (small, large) = (squared_radius(corners(&delaunay, f)), squared_radius(corners(&delaunay, next)));
            let [a, b, c] = delaunay.triangle(f);
            let one_circle = delaunay.triangle(next).iter().all(|&p| in_circle(a, b, c, p) == Sign::Zero);
            if one_circle {
                prop_assert_eq!(small.0 * large.1, large.0 * small.1);
            } else {
                prop_assert!(small.0 * large.1 < large.0 * small.1);
            }
        }
    }

    #[test]
    fn a_flow_passes_no_triangle_twice(points in lattice(60)) {
        let Ok(delaunay) = Delaunay2::build(&points) else { return Ok(()) };
        for f in delaunay.faces() {
            let limit = delaunay.faces().count() + 1;
            let mut passed: Vec<FaceId> = path(&delaunay, f).take(limit).collect();
            passed.sort();
            prop_assert!(passed.len() < limit && passed.windows(2).all(|pair| pair[0] != pair[1]));
        }
    }

    #[test]
    fn sinks_are_the_triangles_that_contain_their_circumcenters(points in lattice(60)) {
        let Ok(delaunay) = Delaunay2::build(&points) else { return Ok(()) };
        let contains_center =
            |f: &FaceId| center_left_of_edges(corners(&delaunay, *f)).iter().all(|&left| left >= 0);
        let expected: Vec<FaceId> = delaunay.faces().filter(contains_center).collect();
        prop_assert_eq!(Sinks::of(&delaunay).triangles().collect::<Vec<_>>(), expected);
    }

    #[test]
    fn a_sink_is_accurate_to_a_few_last_digits(points in lattice(60)) {
        let Ok(delaunay) = Delaunay2::build(&points) else { return Ok(()) };
        for f in Sinks::of(&delaunay).triangles() {
            let [a, b, c] = corners(&delaunay, f);
            let (u, v) = (minus(b, a), minus(c, a));
            let flat = [0, 1].map(|i| dot(u, u) * v[i] - dot(v, v) * u[i]);
            let area = cross(u, v);
            let exact = [0, 1].map(|i| (2 * area * a[i] + [flat[1], -flat[0]][i]) as f64 / (2 * area) as f64);
            prop_assert!(sink(&delaunay, f).distance(DVec2::from(exact)) <= 4.0 * 1000.0 * f64::EPSILON);
        }
    }

    /// At a sink π is the squared radius and φ its negative, and no point near by has more of the one, less of the other (§3.2).
    #[test]
    fn sinks_are_maxima_of_one_distance_and_minima_of_the_other(points in lattice(60), turn in 0.0..6.3) {
        let Ok(delaunay) = Delaunay2::build(&points) else { return Ok(()) };
        // With a right angle the center is on an edge, and beyond it may be worse.
        let is_acute = |f: &FaceId| center_left_of_edges(corners(&delaunay, *f)).iter().all(|&left| left > 0);
        for f in Sinks::of(&delaunay).triangles().filter(is_acute) {
            let [a, ..] = delaunay.triangle(f);
            let center = sink(&delaunay, f);
            let square = center.distance_squared(a);
            let near = |x: f64, y: f64| (x - y).abs() <= 1e-9 * square;
            prop_assert!(near(pi(&delaunay, center).unwrap(), square));
            prop_assert!(phi(&delaunay, center).unwrap().is_some_and(|phi| near(phi, -square)));
            let beside = center + DVec2::from_angle(turn) * 1e-3;
            prop_assert!(pi(&delaunay, beside).unwrap() <= square * (1.0 + 1e-9));
            prop_assert!(phi(&delaunay, beside).unwrap().is_none_or(|phi| phi >= -square * (1.0 + 1e-9)));
        }
    }

    /// The flow through the whole of a triangulation, taken as a part of itself, is the same.
    #[test]
    fn the_whole_as_a_part_has_the_same_flow(points in lattice(60)) {
        let Ok(delaunay) = Delaunay2::build(&points) else { return Ok(()) };
        let whole = Subcomplex2::of(&delaunay, |_| true);
        let flows = |f: FaceId, part: FaceId| {
            let crossed = [successor(&delaunay, f), successor(&whole, part)];
            crossed.map(|successor| std::mem::discriminant(&successor))
        };
        for (f, part) in delaunay.faces().zip(whole.faces()) {
            prop_assert_eq!(delaunay.triangle(f), whole.triangle(part));
            let [one, other] = flows(f, part);
            prop_assert_eq!(one, other);
        }
        prop_assert_eq!(Sinks::of(&delaunay).triangles().count(), Sinks::of(&whole).triangles().count());
    }

    #[test]
    fn every_triangle_belongs_to_the_watershed_in_which_its_flow_ends(points in lattice(60)) {
        let Ok(delaunay) = Delaunay2::build(&points) else { return Ok(()) };
        let sinks = Sinks::of(&delaunay);
        for f in delaunay.faces() {
            let last = path(&delaunay, f).last().unwrap();
            let end = match successor(&delaunay, last) {
                Successor::None => End::Sink(last),
                _ => End::Outside,
            };
            prop_assert_eq!(sinks.end(f), Some(end));
            prop_assert!(sinks.ancestors(end).contains(&f));
        }
    }

    #[test]
    fn watersheds_are_disjoint_and_cover_all_triangles(points in lattice(60)) {
        let Ok(delaunay) = Delaunay2::build(&points) else { return Ok(()) };
        let sinks = Sinks::of(&delaunay);
        let mut all = Vec::new();
        for (end, ancestors) in sinks.watersheds() {
            prop_assert_eq!(sinks.ancestors(end), ancestors);
            prop_assert!(ancestors.is_sorted());
            all.extend_from_slice(ancestors);
        }
        all.sort();
        prop_assert_eq!(all, delaunay.faces().collect::<Vec<_>>());
    }
}

#[test]
fn points_on_one_circle_share_one_sink() {
    // The 12 whole points of the circle of radius 5, and their triangulation without inner vertex.
    let points: Vec<DVec2> = (-5..=5)
        .flat_map(|x| (-5..=5).map(move |y| (x, y)))
        .filter(|(x, y)| x * x + y * y == 25)
        .map(|(x, y): (i32, i32)| DVec2::new(x.into(), y.into()))
        .collect();
    let delaunay = Delaunay2::build(&points).unwrap();
    let sinks = Sinks::of(&delaunay);
    // The center is on a diagonal between opposite points, or inside one triangle.
    assert!((1..=2).contains(&sinks.triangles().count()));
    for f in sinks.triangles() {
        assert_eq!(sink(&delaunay, f), DVec2::ZERO);
    }
    assert!(delaunay.faces().all(|f| sinks.end(f) != Some(End::Outside)));
}

#[test]
fn ghosts_and_strange_faces_have_no_end() {
    let delaunay = Delaunay2::build(&[DVec2::ZERO, DVec2::X, DVec2::Y]).unwrap();
    let sinks = Sinks::of(&delaunay);
    let ghost = delaunay
        .mesh()
        .faces()
        .find(|&f| delaunay.is_ghost_face(f))
        .unwrap();
    assert_eq!(sinks.end(ghost), None);
    assert_eq!(sinks.end(FaceId::new(1_000_000)), None);
    assert!(sinks.ancestors(End::Sink(ghost)).is_empty());
}
