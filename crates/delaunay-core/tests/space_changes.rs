//! Vertices of a triangulation of space come, go and move.

#![allow(clippy::unwrap_used)]

mod clouds;

use clouds::space::{cloud, hard_sets, lattice, rng, sphere, uniform};
use delaunay_core::{Delaunay3, Inserted, MoveError, RemoveError, VertexId};
use glam::DVec3;
use proptest::prelude::*;
use rand::RngExt;
use rand::seq::SliceRandom;

/// The vertices in a scrambled order.
fn scrambled_vertices(delaunay: &Delaunay3, seed: u64) -> Vec<VertexId> {
    let mut vertices: Vec<VertexId> = delaunay.vertices().collect();
    vertices.shuffle(&mut rng(seed));
    vertices
}

#[test]
fn remove_then_insert_restores_every_hard_set_bit_for_bit() {
    for (name, points) in hard_sets() {
        let mut delaunay = Delaunay3::build(&points).unwrap();
        let before = delaunay.mesh().canonical();
        for v in scrambled_vertices(&delaunay, 1).into_iter().take(60) {
            let p = delaunay.point(v);
            match delaunay.remove(v) {
                Ok(()) => {}
                Err(RemoveError::RestIsFlat { .. }) => continue,
                Err(other) => panic!("{name}: {other}"),
            }
            assert_eq!(delaunay.check(), Ok(()), "{name} without {v}");
            assert!(!delaunay.contains_vertex(v));
            assert_eq!(delaunay.insert(p), Ok(Inserted::New(v)), "{name}");
            assert!(delaunay.mesh().canonical() == before, "{name}: {v}");
        }
    }
}

#[test]
fn removing_half_of_the_vertices_leaves_the_triangulation_of_the_others() {
    for (name, points) in hard_sets() {
        let mut delaunay = Delaunay3::build(&points).unwrap();
        if !delaunay.duplicates().is_empty() {
            continue;
        }
        let gone = scrambled_vertices(&delaunay, 2);
        let (gone, kept) = gone.split_at(points.len() / 2);
        for &v in gone {
            assert_eq!(delaunay.remove(v), Ok(()), "{name}: {v}");
        }
        assert_eq!(delaunay.check(), Ok(()), "{name}");
        let mut kept = kept.to_vec();
        kept.sort_unstable();
        let rest: Vec<DVec3> = kept.iter().map(|&v| delaunay.point(v)).collect();
        let expected = Delaunay3::build(&rest).unwrap();
        let tets = |delaunay: &Delaunay3, name: &dyn Fn(VertexId) -> VertexId| {
            let mut tets: Vec<[VertexId; 4]> = delaunay
                .tets()
                .map(|t| {
                    let mut corners = delaunay.mesh().tet_vertices(t).map(name);
                    corners.sort_unstable();
                    corners
                })
                .collect();
            tets.sort_unstable();
            tets
        };
        let expected = tets(&expected, &|v| kept[v.index()]);
        assert_eq!(tets(&delaunay, &|v| v), expected, "{name}");
    }
}

#[test]
fn the_last_vertex_off_a_plane_stays() {
    let mut points = lattice([4, 4, 1]);
    points.push(DVec3::new(1.5, 1.5, 1.0));
    points.push(DVec3::new(1.5, 1.5, 2.0));
    let mut delaunay = Delaunay3::build(&points).unwrap();
    let [low, high] = [16, 17].map(VertexId::new);
    assert_eq!(delaunay.remove(high), Ok(()));
    assert_eq!(delaunay.check(), Ok(()));
    let before = delaunay.mesh().canonical();
    assert_eq!(
        delaunay.remove(low),
        Err(RemoveError::RestIsFlat { vertex: low })
    );
    assert!(delaunay.mesh().canonical() == before);
}

#[test]
fn a_tip_over_a_lattice_is_cut_off_along_the_plane() {
    let mut points = lattice([4, 4, 3]);
    points.push(DVec3::new(1.5, 1.5, 3.0));
    let mut delaunay = Delaunay3::build(&points).unwrap();
    assert_eq!(delaunay.remove(VertexId::new(48)), Ok(()));
    assert_eq!(delaunay.check(), Ok(()));
    let expected = Delaunay3::build(&points[..48]).unwrap();
    let tets = |delaunay: &Delaunay3| delaunay.mesh().canonical().tet_count();
    assert_eq!(tets(&delaunay), tets(&expected));
}

#[test]
fn what_is_no_vertex_is_not_removed() {
    let mut points = lattice([3, 3, 3]);
    points.push(points[4]);
    let mut delaunay = Delaunay3::build(&points).unwrap();
    assert_eq!(delaunay.remove(VertexId::new(5)), Ok(()));
    for vertex in [
        VertexId::GHOST,
        VertexId::new(5),
        VertexId::new(27),
        VertexId::new(1000),
    ] {
        let refused = Err(RemoveError::NoSuchVertex { vertex });
        assert_eq!(delaunay.remove(vertex), refused);
    }
    assert_eq!(delaunay.duplicates().len(), 1);
    assert_eq!(delaunay.remove(VertexId::new(4)), Ok(()));
    assert!(delaunay.duplicates().is_empty());
    assert_eq!(delaunay.check(), Ok(()));
}

/// The hub's link has all vertices, more than are triangulated one after the other.
#[test]
fn the_center_of_a_sphere_is_removed_and_comes_back() {
    let mut points = sphere(2000, 8);
    points.push(DVec3::ZERO);
    let mut delaunay = Delaunay3::build(&points).unwrap();
    let hub = VertexId::new(2000);
    assert_eq!(delaunay.mesh().neighbors(hub).count(), 2000);
    let before = delaunay.mesh().canonical();
    assert_eq!(delaunay.remove(hub), Ok(()));
    assert_eq!(delaunay.check(), Ok(()));
    assert_eq!(delaunay.insert(DVec3::ZERO).map(Inserted::vertex), Ok(hub));
    assert!(delaunay.mesh().canonical() == before);
}

#[test]
fn all_but_four_vertices_can_go() {
    let mut delaunay = Delaunay3::build(&uniform(200, 9)).unwrap();
    for v in scrambled_vertices(&delaunay, 3).into_iter().skip(4) {
        assert_eq!(delaunay.remove(v), Ok(()));
    }
    assert_eq!((delaunay.tets().count(), delaunay.check()), (1, Ok(())));
}

#[test]
fn brute_force_agrees_on_the_nearest_vertex() {
    let queries = [uniform(30, 10), lattice([3, 3, 3])].concat();
    for (name, points) in hard_sets() {
        let delaunay = Delaunay3::build(&points).unwrap();
        let spread = points
            .iter()
            .map(|p| p.abs().max_element())
            .fold(0.0, f64::max);
        for &query in &queries {
            let p = query * spread;
            let distance = |v: VertexId| delaunay.point(v).distance_squared(p);
            let by_distance = |a: &VertexId, b: &VertexId| distance(*a).total_cmp(&distance(*b));
            let nearest = delaunay.vertices().min_by(by_distance).unwrap();
            let found = delaunay.nearest_vertex(p).unwrap();
            assert!(
                distance(found) <= distance(nearest) * (1.0 + 1e-15),
                "{name}: {found} {nearest}"
            );
            assert_eq!(
                delaunay.nearest_vertex_near(p, nearest),
                Ok(found),
                "{name}"
            );
        }
    }
}

/// Whether `delaunay` is the triangulation of `points` bit for bit, which are all distinct.
fn is_of(delaunay: &Delaunay3, points: &[DVec3]) -> bool {
    let rebuilt = Delaunay3::build(points).unwrap();
    delaunay.points() == points && delaunay.mesh().canonical() == rebuilt.mesh().canonical()
}

#[test]
fn moves_near_and_far_end_in_the_triangulation_of_the_new_places() {
    for (name, mut points) in hard_sets() {
        let mut delaunay = Delaunay3::build(&points).unwrap();
        if !delaunay.duplicates().is_empty() {
            continue;
        }
        let mut rng = rng(4);
        let targets = points.clone();
        for v in scrambled_vertices(&delaunay, 5).into_iter().take(40) {
            let towards = targets[rng.random_range(0..targets.len())];
            let step = [1e-14, 1e-3, 0.3, 0.5][rng.random_range(0..4)];
            let p = points[v.index()].lerp(towards, step);
            match delaunay.move_vertex(v, p) {
                Ok(()) => points[v.index()] = p,
                Err(MoveError::Occupied { vertex, other }) => {
                    assert_eq!((vertex, points[other.index()]), (v, p), "{name}");
                }
                Err(other) => panic!("{name}: {other}"),
            }
            assert_eq!(delaunay.check(), Ok(()), "{name}");
        }
        assert!(is_of(&delaunay, &points), "{name}");
    }
}

#[test]
fn a_short_move_inside_the_hull_changes_no_tetrahedron() {
    let points = uniform(500, 11);
    let mut delaunay = Delaunay3::build(&points).unwrap();
    let before = delaunay.mesh().clone();
    let hull = delaunay.hull_vertices();
    let inner: Vec<VertexId> = delaunay.vertices().filter(|v| !hull.contains(v)).collect();
    for &v in &inner {
        let p = delaunay.point(v) + DVec3::new(1e-9, -1e-9, 1e-9);
        assert_eq!(delaunay.move_vertex(v, p), Ok(()));
    }
    assert!(inner.len() > 300 && *delaunay.mesh() == before);
    assert_eq!(delaunay.check(), Ok(()));
}

#[test]
fn a_tetrahedron_turns_inside_out_but_does_not_become_flat() {
    let corners = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z];
    let mut delaunay = Delaunay3::build(&corners).unwrap();
    let v = VertexId::new(3);
    let flat = Err(MoveError::Remove(RemoveError::RestIsFlat { vertex: v }));
    assert_eq!(delaunay.move_vertex(v, DVec3::new(3.0, 1.0, 0.0)), flat);
    assert_eq!(delaunay.move_vertex(v, DVec3::NEG_Z), Ok(()));
    assert!(is_of(
        &delaunay,
        &[DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::NEG_Z]
    ));
    assert_eq!(
        delaunay.insert(DVec3::ONE),
        Ok(Inserted::New(VertexId::new(4)))
    );
}

#[test]
fn moves_that_cannot_be_are_refused() {
    let points = lattice([3, 3, 3]);
    let mut delaunay = Delaunay3::build(&points).unwrap();
    let [v, other] = [13, 14].map(VertexId::new);
    let occupied = Err(MoveError::Occupied { vertex: v, other });
    assert_eq!(delaunay.move_vertex(v, points[14]), occupied);
    assert!(matches!(
        delaunay.move_vertex(v, DVec3::NAN),
        Err(MoveError::Coordinate(_))
    ));
    let vertex = VertexId::GHOST;
    let missing = Err(MoveError::Remove(RemoveError::NoSuchVertex { vertex }));
    assert_eq!(delaunay.move_vertex(vertex, DVec3::ONE), missing);
    assert_eq!(delaunay.move_vertex(v, points[13]), Ok(()));
    assert!(is_of(&delaunay, &points));
}

proptest! {
    #[test]
    fn a_vertex_of_any_cloud_moves_anywhere(
        points in cloud(20),
        target in clouds::space::place(),
        pick in any::<prop::sample::Index>(),
    ) {
        let Ok(mut delaunay) = Delaunay3::build(&points) else { return Ok(()) };
        let mut places: Vec<DVec3> = delaunay.vertices().map(|v| delaunay.point(v)).collect();
        let Ok(mut distinct) = Delaunay3::build(&places) else { return Ok(()) };
        let v = VertexId::new(pick.index(places.len()));
        let moved = distinct.move_vertex(v, target);
        if moved.is_ok() {
            places[v.index()] = target;
        }
        prop_assert_eq!(distinct.check(), Ok(()));
        prop_assert!(is_of(&distinct, &places));
        if let Err(MoveError::Remove(_)) = moved {
            places[v.index()] = target;
            prop_assert!(Delaunay3::build(&places).is_err());
        }
        let v = delaunay.vertices().next().unwrap();
        let _ = delaunay.move_vertex(v, target);
        prop_assert_eq!(delaunay.check(), Ok(()));
    }

    #[test]
    fn a_vertex_of_any_cloud_goes_and_comes_back(points in cloud(24), pick in any::<prop::sample::Index>()) {
        let Ok(mut delaunay) = Delaunay3::build(&points) else { return Ok(()) };
        let before = delaunay.mesh().canonical();
        let v = *pick.get(&delaunay.vertices().collect::<Vec<_>>());
        let rest: Vec<DVec3> = delaunay.vertices().filter(|&w| w != v).map(|w| delaunay.point(w)).collect();
        let removed = delaunay.remove(v);
        prop_assert_eq!(removed.is_ok(), Delaunay3::build(&rest).is_ok());
        prop_assert_eq!(delaunay.check(), Ok(()));
        if removed.is_ok() {
            prop_assert_eq!(delaunay.insert(delaunay.point(v)), Ok(Inserted::New(v)));
        }
        prop_assert!(delaunay.mesh().canonical() == before);
    }
}
