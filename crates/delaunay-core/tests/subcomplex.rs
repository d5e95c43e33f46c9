//! Parts of triangulations with a fixed boundary: what insertion and removal do to them, and what they leave alone.

#![allow(clippy::unwrap_used)]

mod clouds;

use clouds::space;
use delaunay_core::geo_predicates::{Sign, orient3d};
use delaunay_core::measure::tetrahedron::signed_volume;
use delaunay_core::{Cavity3, Delaunay3, Subcomplex3, TetId, VertexId};
use glam::DVec3;
use proptest::prelude::*;
use std::collections::BTreeMap;

/// How often each boundary facet comes, by its corners in order.
fn boundary(solid: &Subcomplex3) -> BTreeMap<[VertexId; 3], usize> {
    let mut facets = BTreeMap::new();
    for f in solid.boundary() {
        let mut corners = solid.mesh().facet_vertices(f);
        corners.sort_unstable();
        *facets.entry(corners).or_insert(0) += 1;
    }
    facets
}

fn volume(solid: &Subcomplex3) -> f64 {
    let volumes = solid.tets().map(|t| signed_volume(solid.tetrahedron(t)));
    volumes.sum()
}

/// Twins are mutual with opposite corners, also those of ghosts, and tetrahedra have volume.
fn assert_sound(solid: &Subcomplex3) {
    let mesh = solid.mesh();
    for f in mesh.facets() {
        let twin = mesh.twin(f);
        assert!(twin != f && mesh.twin(twin) == f);
        let [a, b, c] = mesh.facet_vertices(f);
        assert!([[a, c, b], [c, b, a], [b, a, c]].contains(&mesh.facet_vertices(twin)));
    }
    for t in solid.tets() {
        let [a, b, c, d] = solid.tetrahedron(t);
        assert_eq!(orient3d(a, b, c, d), Sign::Positive);
    }
}

/// Tetrahedra are Delaunay across inner facets.
fn assert_delaunay(solid: &Subcomplex3) {
    let mesh = solid.mesh();
    for f in solid.tets().flat_map(TetId::facets) {
        let apex = mesh.apex(mesh.twin(f));
        assert!(apex.is_ghost() || !solid.in_conflict(solid.point(apex), f.tet()));
    }
}

proptest! {
    /// Without a part left out the triangulation stays Delaunay, too.
    #[test]
    fn points_come_and_go_inside_a_fixed_boundary(
        points in prop::collection::vec(space::place(), 8..60),
        keep in prop_oneof![Just(vec![true]), prop::collection::vec(prop::bool::weighted(0.8), 40)],
        shares in prop::collection::vec([0.05..1.0, 0.05..1.0, 0.05..1.0, 0.05..1.0_f64], 12),
    ) {
        let Ok(delaunay) = Delaunay3::build(&points) else { return Ok(()) };
        let mut solid = Subcomplex3::of(&delaunay, |t| keep[t.index() % keep.len()]);
        assert_sound(&solid);
        let (facets, size) = (boundary(&solid), volume(&solid));
        let mut cavity = Cavity3::default();
        let mut inserted = Vec::new();
        for (i, shares) in shares.iter().enumerate() {
            let Some(seed) = solid.tets().nth(i * 7) else { continue };
            let total: f64 = shares.iter().sum();
            let corners = solid.tetrahedron(seed).into_iter().zip(shares);
            let p: DVec3 = corners.map(|(corner, share)| corner * (share / total)).sum();
            if solid.in_conflict(p, seed) && solid.dig(p, seed, &mut cavity) {
                inserted.push(solid.fill(p, &mut cavity).unwrap());
                assert_sound(&solid);
            }
        }
        if keep == [true] {
            assert_delaunay(&solid);
        }
        prop_assert_eq!(&boundary(&solid), &facets);
        prop_assert!((volume(&solid) - size).abs() <= 1e-12 * size);
        let vertices = solid.vertex_count();
        let mut removed = 0;
        for &v in &inserted {
            if let Some(patch) = solid.patch(v) && solid.remove(&patch).is_some() {
                removed += 1;
                assert_sound(&solid);
            }
        }
        prop_assert_eq!(solid.vertex_count() + removed, vertices);
        prop_assert_eq!(&boundary(&solid), &facets);
        prop_assert!((volume(&solid) - size).abs() <= 1e-12 * size);
    }
}

#[test]
fn a_whole_triangulation_is_restored_when_its_points_go() {
    let points = space::uniform(300, 5);
    let delaunay = Delaunay3::build(&points).unwrap();
    let mut solid = Subcomplex3::of(&delaunay, |_| true);
    let before = solid.mesh().canonical();
    let mut cavity = Cavity3::default();
    let mut added = Vec::new();
    for t in solid.tets().step_by(9).collect::<Vec<_>>() {
        if solid.mesh().contains_tet(t) && !solid.mesh().is_ghost_tet(t) {
            let corners = solid.tetrahedron(t);
            let p = corners.into_iter().sum::<DVec3>() / 4.0;
            assert!(solid.dig(p, t, &mut cavity));
            added.push(solid.fill(p, &mut cavity).unwrap());
        }
    }
    assert!(added.len() > 50);
    for v in added.into_iter().rev() {
        let patch = solid.patch(v).unwrap();
        assert!(solid.remove(&patch).is_some());
    }
    let after = solid.mesh().canonical();
    let corners = |mesh: &delaunay_core::TetMesh| -> Vec<_> {
        mesh.tets().map(|t| mesh.tet_vertices(t)).collect()
    };
    assert_eq!(corners(&after), corners(&before));
}

#[test]
fn what_is_not_inside_cannot_be_inserted() {
    let cube: Vec<DVec3> = (0..8_u32)
        .map(|i| DVec3::new(f64::from(i & 1), f64::from(i >> 1 & 1), f64::from(i >> 2)))
        .collect();
    let solid = Subcomplex3::of(&Delaunay3::build(&cube).unwrap(), |_| true);
    let mut cavity = Cavity3::default();
    for seed in solid.tets() {
        for p in [DVec3::ZERO, DVec3::splat(2.0), DVec3::new(0.5, 0.5, 0.0)] {
            assert!(!solid.dig(p, seed, &mut cavity), "{p}");
        }
    }
    assert!(solid.patch(VertexId::new(0)).is_none());
}
