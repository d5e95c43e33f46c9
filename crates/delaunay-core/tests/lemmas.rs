//! What makes a Delaunay triangulation, against brute force.

#![allow(clippy::unwrap_used)]

mod clouds;

use delaunay_core::geo_predicates::{Sign, in_circle, in_circle_perturbed, orient2d};
use delaunay_core::{BuildError, Delaunay2, Inserted, Location, VertexId};
use glam::DVec2;
use proptest::prelude::*;
use rand::RngExt;
use std::collections::BTreeSet;

fn built(points: &[DVec2]) -> Delaunay2 {
    Delaunay2::build(points).unwrap()
}

/// The triangles as coordinates, comparable whatever the numbering.
fn triangles(delaunay: &Delaunay2) -> BTreeSet<[[u64; 2]; 3]> {
    let bits = |p: DVec2| [p.x.to_bits(), p.y.to_bits()];
    let canonical = delaunay.faces().map(|f| {
        let mut corners = delaunay.triangle(f).map(bits);
        while corners[0] > corners[1] || corners[0] > corners[2] {
            corners.rotate_left(1);
        }
        corners
    });
    canonical.collect()
}

fn distinct(points: &[DVec2]) -> usize {
    let places = points
        .iter()
        .map(|p| (*p + DVec2::ZERO).to_array().map(f64::to_bits));
    places.collect::<BTreeSet<_>>().len()
}

/// No vertex is inside any circumcircle, ties included.
fn assert_empty_circles(delaunay: &Delaunay2) {
    for f in delaunay.faces() {
        let [a, b, c] = delaunay.triangle(f);
        for v in delaunay.vertices() {
            let p = delaunay.point(v);
            assert_ne!(in_circle(a, b, c, p), Sign::Positive, "{f} {v}");
            assert!(!in_circle_perturbed(a, b, c, p), "{f} {v}");
        }
    }
}

#[test]
fn every_circumcircle_is_empty() {
    for (name, points) in clouds::hard_cases() {
        let delaunay = built(&points);
        assert_eq!(delaunay.check(), Ok(()), "{name}");
        assert_eq!(delaunay.vertex_count(), distinct(&points), "{name}");
        assert_empty_circles(&delaunay);
    }
}

#[test]
fn input_point_i_is_vertex_i_and_each_is_a_vertex_or_a_duplicate() {
    for (name, points) in clouds::hard_cases() {
        let delaunay = built(&points);
        assert_eq!(delaunay.points(), points, "{name}");
        for i in 0..points.len() {
            let v = VertexId::new(i);
            let first = points.iter().position(|p| *p == points[i]).unwrap();
            let expected = (first != i).then(|| VertexId::new(first));
            assert_eq!(delaunay.duplicates().representative(v), expected, "{name}");
            assert_eq!(delaunay.contains_vertex(v), first == i, "{name}");
        }
    }
}

#[test]
fn twenty_orders_of_insertion_give_the_same_triangles() {
    let mut rng = clouds::rng(7);
    for (name, points) in clouds::hard_cases() {
        let expected = triangles(&built(&points));
        for round in 0..20 {
            let shuffled = clouds::shuffled(&points, &mut rng);
            assert_eq!(triangles(&built(&shuffled)), expected, "{name} {round}");
        }
    }
}

#[test]
fn inserting_one_by_one_gives_the_mesh_of_the_bulk_build() {
    for (name, points) in clouds::hard_cases() {
        let bulk = built(&points);
        let triangle = bulk.mesh().face_vertices(bulk.faces().next().unwrap());
        let mut single = built(&triangle.map(|v| bulk.point(v)));
        for &p in &points {
            let v = single.insert(p).unwrap().vertex();
            assert_eq!(single.point(v), p + DVec2::ZERO);
        }
        assert_eq!(single.check(), Ok(()), "{name}");
        assert_eq!(triangles(&single), triangles(&bulk), "{name}");
    }
}

#[test]
fn removing_and_inserting_restores_the_mesh_bit_for_bit() {
    for (name, points) in clouds::hard_cases() {
        let mut delaunay = built(&points);
        let before = delaunay.mesh().canonical();
        let vertices: Vec<VertexId> = delaunay.vertices().collect();
        for v in vertices {
            if delaunay.remove(v).is_err() {
                assert_eq!(delaunay.mesh().canonical(), before, "{name} {v}");
                continue;
            }
            assert_eq!(delaunay.check(), Ok(()), "{name} {v}");
            assert!(!delaunay.contains_vertex(v));
            let inserted = delaunay.insert(points[v.index()]).unwrap();
            assert_eq!(inserted, Inserted::New(v), "{name}");
            assert_eq!(delaunay.mesh().canonical(), before, "{name} {v}");
        }
    }
}

#[test]
fn removing_down_to_a_triangle_stays_delaunay_and_ids_come_back_last_first() {
    for (name, points) in clouds::hard_cases() {
        let mut delaunay = built(&points);
        let before = delaunay.mesh().canonical();
        let mut removed = Vec::new();
        let vertices: Vec<VertexId> = delaunay.vertices().collect();
        for v in vertices {
            if delaunay.remove(v).is_ok() {
                removed.push(v);
            }
            assert_eq!(delaunay.check(), Ok(()), "{name} {v}");
        }
        assert_eq!(delaunay.vertex_count(), 3, "{name}");
        for v in removed.into_iter().rev() {
            assert_eq!(
                delaunay.insert(points[v.index()]),
                Ok(Inserted::New(v)),
                "{name}"
            );
        }
        assert_eq!(delaunay.mesh().canonical(), before, "{name}");
    }
}

/// Where brute force finds `p`.
fn assert_location(delaunay: &Delaunay2, p: DVec2, location: Location) {
    let mesh = delaunay.mesh();
    let side = |h| {
        let [a, b] = [mesh.origin(h), mesh.target(h)].map(|v| delaunay.point(v));
        orient2d(a, b, p)
    };
    match location {
        Location::Face(f) => {
            assert!(f.half_edges().iter().all(|&h| side(h) == Sign::Positive));
        }
        Location::Edge(h) => {
            assert_eq!(side(h), Sign::Zero);
            assert_eq!([side(h.next()), side(h.prev())], [Sign::Positive; 2]);
        }
        Location::Vertex(v) => assert_eq!(delaunay.point(v), p),
        Location::Outside(h) => {
            assert_eq!(side(h), Sign::Negative);
            assert!(mesh.is_ghost_face(mesh.twin(h).face()));
            assert!(!mesh.is_ghost_face(h.face()));
        }
    }
}

fn queries(points: &[DVec2]) -> Vec<DVec2> {
    let middles = points.windows(2).map(|w| w[0].midpoint(w[1]));
    let outside = points.iter().map(|p| *p * 1.5);
    points
        .iter()
        .copied()
        .chain(middles)
        .chain(outside)
        .collect()
}

#[test]
fn every_located_point_is_where_the_answer_says() {
    for (_, points) in clouds::hard_cases() {
        let delaunay = built(&points);
        let mut rng = clouds::rng(11);
        for p in queries(&points) {
            assert_location(&delaunay, p, delaunay.locate(p).unwrap());
            let hint = VertexId::new(rng.random_range(0..2 * points.len()));
            assert_location(&delaunay, p, delaunay.locate_near(p, hint).unwrap());
            assert_location(
                &delaunay,
                p,
                delaunay.locate_near(p, VertexId::GHOST).unwrap(),
            );
        }
    }
}

#[test]
fn the_nearest_vertex_is_as_near_as_brute_force_finds() {
    for (name, points) in clouds::hard_cases() {
        let delaunay = built(&points);
        for p in queries(&points) {
            let least = points
                .iter()
                .map(|q| q.distance(p))
                .fold(f64::MAX, f64::min);
            let v = delaunay.nearest_vertex(p).unwrap();
            let found = delaunay.point(v).distance(p);
            assert!(found <= least * (1.0 + 1e-15), "{name} {p} {v}");
            assert_eq!(
                delaunay.nearest_vertex_near(p, VertexId::new(1)),
                Ok(v),
                "{name}"
            );
        }
    }
}

#[test]
fn the_cavity_is_all_faces_whose_circle_holds_the_point() {
    for (name, points) in clouds::hard_cases() {
        let delaunay = built(&points);
        for p in queries(&points) {
            let cavity = delaunay.cavity(p).unwrap();
            let found: BTreeSet<_> = cavity.faces().iter().copied().collect();
            assert_eq!(found.len(), cavity.faces().len(), "{name}: a face twice");
            for f in delaunay.faces() {
                let [a, b, c] = delaunay.triangle(f);
                assert_eq!(
                    in_circle_perturbed(a, b, c, p),
                    found.contains(&f),
                    "{name} {p}"
                );
            }
            if !cavity.faces().is_empty() {
                assert_eq!(cavity.rim().len(), cavity.faces().len() + 2, "{name}");
            }
            for (edge, end) in cavity.rim().iter().zip(cavity.vertices().cycle_from(1)) {
                assert_eq!(delaunay.mesh().target(edge.outer), edge.origin);
                assert_eq!(delaunay.mesh().origin(edge.outer), end);
                assert!(!found.contains(&edge.outer.face()));
            }
        }
    }
}

trait CycleFrom: Iterator {
    fn cycle_from(self, start: usize) -> impl Iterator<Item = Self::Item>;
}

impl<I: Iterator> CycleFrom for I {
    fn cycle_from(self, start: usize) -> impl Iterator<Item = I::Item> {
        let all: Vec<I::Item> = self.collect();
        let (head, tail): (Vec<_>, Vec<_>) =
            all.into_iter().enumerate().partition(|&(i, _)| i < start);
        tail.into_iter().chain(head).map(|(_, item)| item)
    }
}

#[test]
fn the_hull_has_every_vertex_on_its_left_and_holds_all_that_lie_on_it() {
    for (name, points) in clouds::hard_cases() {
        let delaunay = built(&points);
        let mesh = delaunay.mesh();
        let mut doubled_area = 0.0;
        for h in delaunay.hull() {
            let [a, b] = [mesh.origin(h), mesh.target(h)].map(|v| delaunay.point(v));
            doubled_area += (a - points[0]).perp_dot(b - points[0]);
            for v in delaunay.vertices() {
                let side = orient2d(a, b, delaunay.point(v));
                assert_ne!(side, Sign::Negative, "{name}");
                assert!(side == Sign::Positive || mesh.is_on_hull(v), "{name} {v}");
            }
        }
        let border: Vec<VertexId> = delaunay.hull_vertices().collect();
        assert!(border.iter().all(|&v| mesh.is_on_hull(v)), "{name}");
        let on_hull = delaunay.vertices().filter(|&v| mesh.is_on_hull(v)).count();
        assert_eq!(border.len(), on_hull, "{name}");
        let sum: f64 = delaunay
            .faces()
            .map(|f| {
                let [a, b, c] = delaunay.triangle(f);
                (b - a).perp_dot(c - a)
            })
            .sum();
        let extent = points
            .iter()
            .map(|p| p.distance(points[0]))
            .fold(0.0, f64::max);
        assert!(
            (sum - doubled_area).abs() <= 1e-14 * extent * extent,
            "{name}: {sum} {doubled_area}"
        );
    }
}

#[test]
fn ghosts_included_there_are_two_n_less_two_faces() {
    for (name, points) in clouds::hard_cases() {
        let delaunay = built(&points);
        let faces = delaunay.mesh().face_count();
        assert_eq!(faces, 2 * distinct(&points) - 2, "{name}");
        assert_eq!(
            delaunay.faces().count() + delaunay.hull().count(),
            faces,
            "{name}"
        );
    }
}

#[test]
fn star_link_and_neighbors_go_counterclockwise_together() {
    let delaunay = built(&clouds::grid(5, 5));
    let mesh = delaunay.mesh();
    for v in delaunay.vertices() {
        let neighbors: Vec<VertexId> = mesh.neighbors(v).collect();
        for (i, (f, h)) in mesh.star(v).zip(mesh.link(v)).enumerate() {
            assert!(mesh.face_vertices(f).contains(&v));
            assert_eq!(mesh.face(h), f);
            assert_eq!(mesh.origin(h), neighbors[i]);
            assert_eq!(mesh.target(h), neighbors[(i + 1) % neighbors.len()]);
            assert_eq!(
                mesh.find_half_edge(v, neighbors[i]).map(|e| mesh.next(e)),
                Some(h)
            );
        }
    }
    assert_eq!(
        mesh.neighbors(VertexId::GHOST).count(),
        delaunay.hull().count()
    );
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn any_cloud_is_triangulated_or_described(points in clouds::cloud(40)) {
        match Delaunay2::build(&points) {
            Ok(delaunay) => {
                prop_assert_eq!(delaunay.check(), Ok(()));
                prop_assert_eq!(delaunay.vertex_count(), distinct(&points));
                prop_assert_eq!(delaunay.duplicates().len(), points.len() - distinct(&points));
            }
            Err(BuildError::Flat(flat)) => {
                prop_assert_eq!(flat.vertices.len(), distinct(&points));
                prop_assert_eq!(flat.vertices.len() + flat.duplicates.len(), points.len());
                let at = |v: VertexId| points[v.index()];
                for line in flat.vertices.windows(3) {
                    prop_assert_eq!(orient2d(at(line[0]), at(line[1]), at(line[2])), Sign::Zero);
                    prop_assert!(at(line[0]).distance(at(line[2])) >= at(line[0]).distance(at(line[1])));
                }
            }
            Err(other) => prop_assert!(false, "{other}"),
        }
    }

    #[test]
    fn any_sequence_of_insertions_and_removals_ends_at_the_bulk_mesh(
        first in clouds::cloud(20),
        steps in prop::collection::vec((any::<bool>(), clouds::coordinate(), clouds::coordinate(), 0_usize..40), 0..60),
    ) {
        let Ok(mut delaunay) = Delaunay2::build(&first) else { return Ok(()) };
        for (grow, x, y, pick) in steps {
            if grow {
                let v = delaunay.insert_near(DVec2::new(x, y), VertexId::new(pick)).unwrap().vertex();
                prop_assert_eq!(delaunay.point(v), DVec2::new(x, y));
            } else {
                let before = delaunay.vertex_count();
                let removed = delaunay.remove(VertexId::new(pick)).is_ok();
                prop_assert_eq!(delaunay.vertex_count() + usize::from(removed), before);
            }
        }
        prop_assert_eq!(delaunay.check(), Ok(()));
        let left: Vec<DVec2> = delaunay.vertices().map(|v| delaunay.point(v)).collect();
        prop_assert_eq!(triangles(&delaunay), triangles(&built(&left)));
    }

    #[test]
    fn locating_agrees_with_the_signs_of_the_answer(points in clouds::cloud(30), x in clouds::coordinate(), y in clouds::coordinate()) {
        let Ok(delaunay) = Delaunay2::build(&points) else { return Ok(()) };
        let p = DVec2::new(x, y);
        assert_location(&delaunay, p, delaunay.locate(p).unwrap());
    }
}
