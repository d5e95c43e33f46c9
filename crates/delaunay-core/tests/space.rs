//! The triangulation of space: unique, Delaunay and closed on every kind of input.

mod clouds;

use clouds::space::{hard_sets, lattice, rng, skew_lines, sphere, uniform};
use delaunay_core::geo_predicates::{Sign, in_sphere, orient3d};
use delaunay_core::progress::{Progress, silent};
use delaunay_core::{BuildError, BuildOptions, Delaunay3, Extent, TetMesh, VertexId};
use glam::DVec3;
use rand::seq::SliceRandom;
use std::ops::ControlFlow;

/// The points named as in the first order: the canonical mesh over ids that do not depend on it.
fn renamed(mesh: &TetMesh, names: &[usize]) -> Vec<[usize; 4]> {
    let mut tets: Vec<[usize; 4]> = mesh
        .tets()
        .map(|t| {
            let name = |v: VertexId| {
                if v.is_ghost() {
                    usize::MAX
                } else {
                    names[v.index()]
                }
            };
            let mut corners = mesh.tet_vertices(t).map(name);
            corners.sort_unstable();
            corners
        })
        .collect();
    tets.sort_unstable();
    tets
}

#[test]
fn every_hard_set_gives_a_sound_triangulation_of_its_hull() {
    for (name, points) in hard_sets() {
        let delaunay = Delaunay3::build(&points).unwrap();
        assert_eq!(delaunay.check(), Ok(()), "{name}");
        let distinct = points.len() - delaunay.duplicates().len();
        assert_eq!(delaunay.vertex_count(), distinct, "{name}");
    }
}

/// No vertex at all is strictly inside any circumsphere: quadratic, and independent of ties.
#[test]
fn brute_force_finds_no_vertex_in_a_circumsphere() {
    for (name, points) in hard_sets() {
        let delaunay = Delaunay3::build(&points[..points.len().min(120)]);
        let Ok(delaunay) = delaunay else { continue };
        for t in delaunay.tets() {
            let [a, b, c, d] = delaunay.tetrahedron(t);
            assert_eq!(orient3d(a, b, c, d), Sign::Positive, "{name}");
            let mut inside = delaunay
                .points()
                .iter()
                .filter(|&&e| in_sphere(a, b, c, d, e) == Sign::Positive);
            assert_eq!(inside.next(), None, "{name}: {t}");
        }
    }
}

#[test]
fn the_order_of_the_points_does_not_show() {
    for (name, points) in hard_sets() {
        // Of equal points the smallest id stands for all: name them by place.
        let first = |p: DVec3| points.iter().position(|&q| q == p).unwrap();
        let names: Vec<usize> = points.iter().map(|&p| first(p)).collect();
        let expected = renamed(Delaunay3::build(&points).unwrap().mesh(), &names);
        let mut order: Vec<usize> = (0..points.len()).collect();
        for seed in 0..5 {
            order.shuffle(&mut rng(seed));
            let shuffled: Vec<DVec3> = order.iter().map(|&i| points[i]).collect();
            let names: Vec<usize> = order.iter().map(|&i| names[i]).collect();
            let mesh = Delaunay3::build(&shuffled).unwrap();
            assert_eq!(renamed(mesh.mesh(), &names), expected, "{name}");
        }
    }
}

#[test]
fn a_lattice_is_filled_without_flat_tetrahedra() {
    let delaunay = Delaunay3::build(&lattice([5, 4, 3])).unwrap();
    let volume: f64 = delaunay
        .tets()
        .map(|t| {
            let [a, b, c, d] = delaunay.tetrahedron(t);
            (b - a).cross(c - a).dot(d - a)
        })
        .sum();
    assert_eq!(volume, 6.0 * 4.0 * 3.0 * 2.0);
}

#[test]
fn skew_lines_have_a_tetrahedron_for_each_pair_of_steps() {
    let delaunay = Delaunay3::build(&skew_lines(20)).unwrap();
    assert_eq!(delaunay.tets().count(), 19 * 19);
}

#[test]
fn single_insertions_build_the_same_mesh() {
    for (name, points) in hard_sets() {
        let expected = Delaunay3::build(&points).unwrap();
        let spanning = (4..=points.len()).find(|&n| Delaunay3::build(&points[..n]).is_ok());
        let start = spanning.unwrap();
        let mut delaunay = Delaunay3::build(&points[..start]).unwrap();
        let mut ids: Vec<VertexId> = (0..start).map(VertexId::new).collect();
        for &p in &points[start..] {
            ids.push(delaunay.insert(p).unwrap().vertex());
        }
        assert_eq!(delaunay.check(), Ok(()), "{name}");
        if expected.duplicates().is_empty() {
            assert_eq!(
                delaunay.mesh().canonical(),
                expected.mesh().canonical(),
                "{name}"
            );
        }
    }
}

#[test]
fn flat_sets_are_described() {
    let extent = |points: &[DVec3]| match Delaunay3::build(points) {
        Err(BuildError::Flat(flat)) => flat.extent(),
        other => panic!("{other:?}"),
    };
    assert_eq!(extent(&[]), Extent::Empty);
    assert_eq!(extent(&[DVec3::ONE; 5]), Extent::Point);
    let line: Vec<DVec3> = (0..9)
        .map(|i| DVec3::new(0.1, 0.2, 0.3) * f64::from(i))
        .collect();
    assert_eq!(extent(&line[..2]), Extent::Line);
    assert_eq!(extent(&lattice([7, 1, 1])), Extent::Line);
    assert_eq!(extent(&lattice([4, 5, 1])), Extent::Plane);
    assert_eq!(extent(&lattice([1, 4, 5])), Extent::Plane);
}

/// Sets large enough to be cut into parts.
fn large_sets() -> Vec<(&'static str, Vec<DVec3>)> {
    let scattered = uniform(40_000, 8);
    let clusters = scattered.iter().enumerate().map(|(i, p)| {
        let center = uniform(20, 9)[i % 20];
        center + (*p - 0.5) * [1e-1, 1e-3, 1e-6][i % 3]
    });
    let repeated = scattered.iter().map(|p| (p * 30.0).floor());
    let mut lattice = lattice([32, 32, 32]);
    lattice.shuffle(&mut rng(10));
    vec![
        ("clusters", clusters.collect()),
        ("duplicates", repeated.collect()),
        ("lattice", lattice),
        ("sphere", sphere(20_000, 11)),
        ("uniform", scattered),
    ]
}

#[test]
fn the_number_of_threads_does_not_show() {
    for (name, points) in large_sets() {
        let on = |threads| {
            let options = BuildOptions::on_threads(threads);
            Delaunay3::build_on(&points, options, &mut silent).unwrap()
        };
        let alone = on(1);
        assert_eq!(alone.check(), Ok(()), "{name}");
        let expected = alone.mesh().canonical();
        for threads in [2, 3, 8] {
            let (first, again) = (on(threads), on(threads));
            assert_eq!(
                first.mesh().canonical(),
                expected,
                "{name}, {threads} threads"
            );
            assert_eq!(first.mesh(), again.mesh(), "{name}, {threads} threads");
            assert_eq!(first.duplicates(), alone.duplicates(), "{name}");
        }
    }
}

#[test]
fn a_build_on_several_threads_can_be_stopped_anywhere() {
    let points = uniform(60_000, 12);
    for limit in [0, 5000, 20_000, 40_000, 59_000] {
        let mut report = |progress: Progress| match progress.done >= limit {
            true => ControlFlow::Break(()),
            false => ControlFlow::Continue(()),
        };
        let stopped = Delaunay3::build_on(&points, BuildOptions::on_threads(3), &mut report);
        assert!(matches!(stopped, Err(BuildError::Cancelled(_))), "{limit}");
    }
}
