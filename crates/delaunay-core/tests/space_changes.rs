//! Vertices of a triangulation of space come, go and move.

#![allow(clippy::unwrap_used)]

mod clouds;

use clouds::space::{cloud, hard_sets, lattice, rng, sphere, uniform};
use delaunay_core::{Delaunay3, Inserted, RemoveError, VertexId};
use glam::DVec3;
use proptest::prelude::*;
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

proptest! {
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
